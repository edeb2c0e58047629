# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: equal builds have equal digests of all scenes, and a scene that differs, or is in one file only, is named.

require 'minitest/autorun'
require 'tmpdir'
require_relative '../../tools/digests/digests'

class TestDigests < Minitest::Test
  CHUNKS = [['bench2', 'random', 1, 2], ['bench2', 'jogs', 1, 2]].freeze

  def test_SWR_TOOL_482_the_same_build_has_the_same_digest_of_each_scene_and_another_one_of_each_other
    in_folder do |first, second|
      [first, second].each { |file| Digests.play(file, CHUNKS) }
      scenes = Digests.read(first)
      assert_equal [4, 4], [scenes.size, scenes.values.uniq.size]
      assert_empty Digests.differences(scenes, Digests.read(second))
    end
  end

  def test_SWR_TOOL_482_a_file_that_was_begun_is_continued
    in_folder do |file, _|
      Digests.play(file, CHUNKS)
      lines = File.readlines(file)
      File.write(file, lines.first(2).join)
      Digests.play(file, CHUNKS)
      assert_equal lines, File.readlines(file)
    end
  end

  def test_SWR_TOOL_482_a_scene_with_another_digest_and_one_that_is_missing_are_named
    before = { 'neuro random 1 4000' => '0a', 'neuro random 2 4000' => '0b' }
    assert_equal ['neuro random 1 4000 differs', 'neuro random 2 4000 is in one file only'],
                 Digests.differences(before, 'neuro random 1 4000' => '0c')
  end

  def test_SWR_TOOL_482_the_scenes_are_of_each_robot_and_each_play
    plan = Digests.plan(Digests::SCENES)
    assert_operator plan.sum(&:last), :>=, Digests::SCENES
    assert_equal Digests::ROBOTS.keys.product(Digests::PLAYS), plan.map { |row| row.first(2) }.uniq
  end

  def test_SWR_TOOL_482_a_wrong_command_line_ends_the_program_with_2
    assert_equal 2, Open3.capture3(Digests::PROGRAM, 'neuro', 'nothing', '1', '1', '1').last.exitstatus
  end

  private

  def in_folder
    Dir.mktmpdir { |folder| yield File.join(folder, 'first'), File.join(folder, 'second') }
  end
end

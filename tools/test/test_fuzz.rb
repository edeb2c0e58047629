# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rules under test: a find of the fuzzer is kept and reported with how to play it again; a scene of words is its bytes and
# back, and a word that it does not have is refused.

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../fuzz/scenes'

class TestFuzzTool < Minitest::Test
  TOOL = File.expand_path('../fuzz.rb', __dir__)
  WORDS = Fuzz::Words.new(File.expand_path('../../verification/fuzz/words.yml', __dir__))
  SCENES = YAML.safe_load_file(File.expand_path('../../verification/fuzz/scenes.yml', __dir__))

  # A target that finds `input` as libFuzzer would say it.
  def search(input)
    Dir.mktmpdir do |folder|
      FileUtils.mkdir_p("#{folder}/bin")
      File.write("#{folder}/bin/dialect", <<~SHELL, perm: 0o755)
        #!/bin/sh
        for word; do case $word in -artifact_prefix=*) prefix=${word#*=} ;; esac; done
        #{input ? "printf '#{input}' >${prefix}crash-1; echo 'does not hold: STOP is not lost'; exit 77" : 'exit 0'}
      SHELL
      output, status = Open3.capture2e('ruby', TOOL, folder, '0.01', '7', chdir: File.expand_path('../..', __dir__))
      yield output, status, Dir["#{folder}/found/*"]
    end
  end

  def test_SWR_TOOL_017_what_breaks_a_target_is_kept_and_reported_with_how_to_play_it_again
    search('\2\1\0\0\0') do |output, status, found|
      refute status.success?
      assert_equal ["\2\1\0\0\0"], found.map { |file| File.binread(file) }
      assert_includes output, "bin/dialect #{found.first}"
      assert_includes output, 'STOP is not lost'
      assert_includes output, 'connect 0 2013 v1'
    end
  end

  def test_SWR_TOOL_017_a_search_without_a_find_ends_well
    search(nil) do |output, status, found|
      assert status.success?, output
      assert_empty found
    end
  end

  def test_SWR_TOOL_018_every_scene_is_its_bytes_and_back
    SCENES.each do |name, lines|
      bytes = Fuzz::Scene.new(WORDS, name, lines).bytes
      assert_equal lines.map(&:to_s), Fuzz.show(WORDS, bytes.bytes), name
    end
  end

  def test_SWR_TOOL_018_what_a_scene_cannot_mean_is_refused_with_scene_and_line
    { 'leave 0' => 'has no operation leave', 'connect 0 2013' => 'lacks version',
      'string 0 CMD_# 1 HALT' => 'does not know the text "HALT"', 'wait 256' => 'does not know the cycles "256"',
      'bytes 0 2 1' => 'does not have as many bytes', 'wait 1 2' => 'has more than cycles' }.each do |line, reason|
      error = assert_raises(Fuzz::Refused) { Fuzz::Scene.new(WORDS, 'a', ['dark', line]).bytes }
      assert_match(/\Ascene "a": #{Regexp.escape(reason)}.*\(#{Regexp.escape(line)}\)\z/, error.message)
    end
  end
end

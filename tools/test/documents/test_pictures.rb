# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: each picture of the documents is made by a test or a source that is named, and none is left over.

require 'minitest/autorun'
require 'open3'
require_relative '../../pictures'

class TestPictures < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  COMPLETE = { 'tools/documents/pictures.yml' => "- {by: robot.dot, command: cp robot.dot FOLDER/robot.svg, pictures: [robot.svg]}\n",
               'robot.dot' => 'a robot', 'docs/images/robot.svg' => 'an old robot',
               'docs/manual.md' => "![A robot](images/robot.svg)\n" }.freeze

  def in_project(changes = {})
    Dir.mktmpdir do |root|
      COMPLETE.merge(changes).compact.each do |file, text|
        FileUtils.mkdir_p(File.dirname(File.join(root, file)))
        File.write(File.join(root, file), text)
      end
      yield root
    end
  end

  def assert_complaint(expected, changes)
    in_project(changes) { |root| assert_equal [expected], Pictures.new(root).complaints }
  end

  def test_SWR_TOOL_033_each_picture_of_this_project_is_made_and_shown
    assert_empty Pictures.new(ROOT).complaints
  end

  def test_SWR_TOOL_033_a_picture_that_nothing_makes_or_shows_is_found
    assert_complaint 'docs/images/cat.png: nothing makes it, see tools/documents/pictures.yml', 'docs/images/cat.png' => ''
    assert_complaint 'docs/images/robot.svg: no document shows it', 'docs/manual.md' => 'A robot.'
  end

  def test_SWR_TOOL_033_a_picture_or_a_source_that_is_not_there_is_found
    assert_complaint 'tools/documents/pictures.yml: docs/images/robot.svg is not there', 'docs/images/robot.svg' => nil
    assert_complaint 'tools/documents/pictures.yml: there is no robot.dot', 'robot.dot' => nil
    assert_complaint 'tools/documents/pictures.yml: docs/images/robot.svg is made twice',
                     'tools/documents/pictures.yml' => COMPLETE['tools/documents/pictures.yml'] * 2
  end

  def test_SWR_TOOL_033_what_is_made_takes_the_place_of_the_old_one
    in_project do |root|
      assert_output("robot.dot: robot.svg\n") { Pictures.new(root).make('') }
      assert_equal 'a robot', File.read(File.join(root, 'docs/images/robot.svg'))
    end
  end

  # Its places depend on the fonts of the machine.
  def test_SWR_TOOL_033_a_diagram_says_what_its_source_says
    Dir.glob("#{ROOT}/docs/images/*.dot") do |file|
      drawn, status = Open3.capture2('dot', '-Tsvg', file)
      assert status.success?
      assert_equal texts(drawn), texts(File.read(file.sub(/dot\z/, 'svg'))), "run ruby tools/pictures.rb --make #{File.basename(file)}"
    end
  end

  def texts(drawing)
    drawing.scan(%r{>([^<]+)</text>}).flatten
  end
end

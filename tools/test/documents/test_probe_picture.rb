# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the picture of the probes' lengths is of the robots' files as they are, and to scale.

require 'minitest/autorun'
require_relative '../../documents/probe_picture'

class TestProbePicture < Minitest::Test
  NEURO = { 'treatment_to_tip_mm' => 20, 'robot_to_entry_mm' => 10, 'cannula_to_treatment_mm' => 5, 'robot_to_treatment_mm' => 60 }.freeze

  def test_SWR_TOOL_039_the_picture_of_the_manual_is_of_the_robots_as_they_are
    assert_equal ProbePicture.new.svg, File.read(File.join(ProbePicture::ROOT, 'docs/images/probe.svg')),
                 'ruby tools/documents/probe_picture.rb docs/images/probe.svg'
  end

  def test_SWR_TOOL_039_each_length_is_drawn_with_its_name_its_value_and_its_share
    svg = ProbePicture.new('neuro' => NEURO).svg
    NEURO.each { |name, length| assert_includes svg, ">#{name}: #{length}</text>" }
    ways = svg.scan(/x1="([\d.]+)" y1="\d+" x2="([\d.]+)" y2="\d+" stroke="#005a8c"/).map { |from, to| to.to_f - from.to_f }
    assert_equal([20, 10, 5, 60], ways.map { |way| (way * 60 / ways.last).round })
    assert_in_delta 80.0 / 60, 640 / ways.last
  end

  def test_SWR_TOOL_039_each_length_of_each_robot_is_in_the_picture
    svg = ProbePicture.new.svg
    Dir.glob(File.join(ProbePicture::ROOT, 'core/robot/*/robot.yml')).each do |file|
      Psych.safe_load_file(file).fetch('probe').each_key { |name| assert_match(/>#{name}: /, svg, file) }
    end
  end

  def test_SWR_TOOL_039_a_length_that_is_not_in_the_file_is_no_picture
    assert_raises(KeyError) { ProbePicture.new('neuro' => NEURO.except('robot_to_treatment_mm')).svg }
  end
end

# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the steering of a robot's file is compiled with the largest curvature that its slowest rotation leaves, or
# refused with line and field.

require 'minitest/autorun'
require 'stringio'
require 'tmpdir'
require_relative '../../compile/robot_compiler'

class TestRobotSteering < Minitest::Test
  WHOLE = File.read(File.expand_path('../../../core/robot/prostate/robot.yml', __dir__))
  LINE = WHOLE.lines.index { |line| line.start_with?('steering:') } + 1

  def compile(text)
    Dir.mktmpdir do |directory|
      path = File.join(directory, 'robot.yml')
      File.write(path, text)
      errors = StringIO.new
      status = Robot::Command.run([path, File.join(directory, 'out')], errors: errors)
      [status, errors.string, status.zero? ? File.read(File.join(directory, 'out/robot_prostate.c')) : nil]
    end
  end

  # The slowest word gives 26 / 255 of the full speed, 15.8 percent of the most of the law: alpha 0.842 lies between the points of 1.0
  # and 1.6 per m.
  def test_SWR_STEER_003_the_largest_curvature_is_that_of_the_slowest_rotation
    assert_includes compile(WHOLE).last, '.steering = {.axis = 5U, .points = 7U, .most_per_km = 1253U,'
    assert_includes compile(WHOLE.sub('speed_ticks_per_s: 1285 ', 'speed_ticks_per_s: 1928 ')).last, '.most_per_km = 1569U,'
    assert_includes compile(WHOLE.sub('alpha: [0, 0.5, 0.8, 0.9, 0.95, 0.98, 1]', 'alpha: [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6]')).last,
                    '.most_per_km = 4100U,'
  end

  # 5 mm in a turn of 2.93 s are 28 percent of 6 mm/s.
  def test_SWR_STEER_011_the_needle_is_so_slow_that_a_turn_advances_it_little
    assert_includes compile(WHOLE).last, '.needle_percent = 28U,'
  end

  def test_SWR_STEER_003_a_robot_without_points_is_not_steered
    assert_includes compile(WHOLE.sub(/^steering:.*\n/, '')).last,
                    '.steering = {.axis = 0U, .points = 0U, .most_per_km = 0U, .needle_percent = 0U,'
  end

  REFUSALS = {
    'points that fall' => ['0.7, 1.0, 1.6', '0.7, 1.6, 1.0', 'steering.curvature_per_m: does not rise from 0 on'],
    'equal strengths' => ['0.5, 0.8', '0.8, 0.8', 'steering.alpha: does not rise from 0 on'],
    'a first point that is not 0' => ['alpha: [0, 0.5', 'alpha: [0.1, 0.5', 'steering.alpha: does not rise from 0 on'],
    'a strength above 1' => ['0.98, 1]', '0.98, 1.1]', 'expected 0 to 1'],
    'points without a partner' => ['0.98, 1]', '0.98]', 'steering.alpha: has 6 points; expected 7, one for each curvature'],
    'a single point' => ['[0, 0.7, 1.0, 1.6, 2.2, 2.4, 4.1]', '[0]', 'steering.curvature_per_m: has 1 points; expected 2 to 8']
  }.freeze

  def assert_refused(text, reason)
    status, errors, = compile(text)
    assert_equal 1, status
    assert_match(/robot\.yml:#{LINE}: .*#{Regexp.escape(reason)}/, errors)
  end

  REFUSALS.each do |what, (old, new, reason)|
    define_method("test_SWR_STEER_003_refuses_#{what.tr(' ', '_')}") do
      assert_includes WHOLE, old
      assert_refused(WHOLE.sub(old, new), reason)
    end
  end

  def test_SWR_STEER_003_refuses_a_range_without_room_for_a_turn_and_its_ramps
    short = WHOLE.sub(/minimum_ticks: -8073 .*/, 'minimum_ticks: -1000').sub(/maximum_ticks: 8073 .*/, 'maximum_ticks: 1000')
    assert_refused(short, 'needs 2023 ticks of rotation, which has 2000; expected one turn and two ramps')
  end
end

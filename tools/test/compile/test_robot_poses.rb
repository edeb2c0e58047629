# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the poses of a robot file are compiled to ticks, or refused with line and field.

require 'minitest/autorun'
require_relative 'changed_robot'

class TestRobotPoses < Minitest::Test
  include ChangedRobot

  HOME = { head: '-20 mm', feet: '-1575 ticks', lateral: '-7 ticks', insertion: '2083 ticks', rotation: '0 rad',
           pitch: '0.1 rad', yaw: '-300 ticks' }.freeze

  def with_pose(home)
    "#{TEXT}poses:\n  home:\n#{home.map { |axis, place| "    #{axis}: #{place}\n" }.join}"
  end

  def assert_no_pose(axis, place, message)
    assert_refused(with_pose(HOME.merge(axis => place)), "poses.home.#{axis}: is #{message}",
                   at: "    #{axis}: #{place}")
  end

  def test_SWR_ROBOT_023_the_table_holds_a_pose_in_ticks
    assert_includes compile(TEXT).last, '.pose_mask = 0U'
    table = compile(with_pose(HOME)).last
    assert_includes table, '.pose_mask = 1U'
    assert_includes table, '[POSE_HOME] = {.ticks = {[0] = -1575, [1] = -1575, [2] = -7, [3] = 2083, [4] = 0, [5] = 80, [6] = -300}, .seal = 0x'
    assert_equal 0, compile(with_pose(HOME.merge(insertion: '368 ticks'))).first
  end

  def test_SWR_ROBOT_023_a_pose_of_other_axes_or_another_name_is_refused
    assert_refused(with_pose(HOME.except(:yaw)), 'poses.home.yaw: is missing', at: "  home:\n")
    tuck = with_pose(HOME).sub("\n  home:\n", "\n  tuck:\n")
    assert_refused(tuck, 'poses.tuck: is unknown; expected home, park, draping, egress', at: '  tuck:')
  end

  def test_SWR_ROBOT_023_a_place_that_is_no_place_is_refused
    expected = 'expected a number and ticks or'
    assert_no_pose(:head, '-20', "-20; #{expected} mm")
    assert_no_pose(:head, '-20 rad', "-20 rad; #{expected} mm")
    assert_no_pose(:head, '-20.5 ticks', "-20.5 ticks; #{expected} mm")
    assert_no_pose(:head, 'far mm', "far mm; #{expected} mm")
    assert_no_pose(:pitch, '1 mm', "1 mm; #{expected} rad")
  end

  def test_SWR_ROBOT_023_a_place_beyond_a_limit_or_at_a_switch_is_refused
    assert_no_pose(:feet, '-5513 ticks', '-5513 ticks; expected -5512 to 5906')
    assert_no_pose(:lateral, '-6 ticks', '-6 ticks; expected -2337 to -7')
    assert_no_pose(:insertion, '367 ticks', '367 ticks; expected 368 to 2083')
  end

  def test_SWR_ROBOT_023_a_pose_with_the_needle_in_is_refused
    assert_no_pose(:insertion, '2084 ticks', '2084 ticks; expected 368 to 2083')
  end

  def test_SWR_POSE_005_the_needle_has_no_part_in_a_pose_but_that_of_start_up
    park = ->(home) { with_pose(home).sub("\n  home:\n", "\n  park:\n") }
    table = compile(park.(HOME.except(:insertion))).last
    assert_includes table, '.pose_mask = 2U'
    assert_includes table, '[POSE_PARK] = {.ticks = {[0] = -1575, [1] = -1575, [2] = -7, [3] = 0, [4] = 0, '
    assert_refused(park.(HOME), 'poses.park.insertion: is unknown; expected head, feet, lateral, rotation, pitch, yaw',
                   at: '    insertion: 2083')
    assert_refused(with_pose(HOME.except(:insertion)), 'poses.home.insertion: is missing', at: "  home:\n")
  end

  def test_SWR_POSE_005_a_pose_beyond_a_limit_that_axes_share_is_refused
    far = HOME.merge(head: '-88 mm')
    assert_refused(with_pose(far), 'poses.home: has separation at 75.004; expected 75.200 to 145.800', at: "  home:\n")
    assert_equal 0, compile(with_pose(far.merge(feet: '-20.3 mm'))).first
    near = HOME.merge(head: '-1 mm', feet: '-4 mm')
    assert_refused(with_pose(near), 'poses.home: has separation at 145.997; expected 75.200 to 145.800', at: "  home:\n")
    with_coupled_limits('separation' => limits_of_neuro['separation'].merge('value' => 'sqrt(head)')) do
      assert_refused(with_pose(HOME), 'poses.home: has no separation; expected axes that can be there together',
                     at: "  home:\n")
    end
  end

  def test_SWR_POSE_005_every_robot_here_has_the_poses_of_its_file
    assert_includes compile(WHOLE).last, '.pose_mask = 14U'
    assert_includes compile(WHOLE).last, '[POSE_DRAPING] = {.ticks = {[0] = -3543, [1] = 0, [2] = -1167, [3] = 0, [4] = 0, [5] = 358, [6] = -597}'
  end

  def test_SWR_POSE_005_a_formula_is_computed_or_refused
    values = { 'a' => 7, 'b' => 2 }
    { 'a - b - 1' => 4, '2 * (a + -b) / 4' => 2.5, 'sqrt(square(3) + square(b * 2))' => 5, 'atan(a, a)' => 45,
      '1.5' => 1.5 }.each { |text, value| assert_in_delta value, Robot::Formula.new(text).value(values), 1e-12, text }
    ['', 'a +', 'c', 'a b', '(a', 'atan(a)', 'a ^ b', 'sqrt a'].each do |text|
      assert_match(/is not a formula/, assert_raises(ArgumentError, text) { Robot::Formula.new(text).value(values) }.message)
    end
    assert_match(/has no value/, assert_raises(ArgumentError) { Robot::Formula.new('sqrt(b - a)').value(values) }.message)
  end
end

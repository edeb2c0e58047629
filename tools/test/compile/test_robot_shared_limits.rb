# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: limits that axes share and axes that follow others are compiled, or refused with line and field.

require 'minitest/autorun'
require_relative 'changed_robot'

class TestRobotSharedLimits < Minitest::Test
  include ChangedRobot

  # The initializers of the coupled limit.
  def limit_in(text)
    table = compile(text).last
    refute_nil table, compile(text)[1]
    table[/\.coupled_limits = \{\n +\[0\] = \{(.*)\}\n/, 1]
  end

  def test_SWR_ROBOT_002_a_coupled_limit_has_the_range_of_its_geometry_or_its_own
    entry = '.name = "separation", .unit = (uint8_t)AXIS_UNIT_MM, .refusal = 16U, .is_curved = 0U, .reserved = 0U, ' \
            '.axes = 0x003U, .minimum = %d, .maximum = %d'
    assert_equal format(entry, 75_000_000, 146_000_000), limit_in(TEXT)
    assert_equal format(entry, 75_000_000, 144_500_000),
                 limit_in(with('maximum_separation_mm: 146', 'maximum_separation_mm: 144.5'))
    assert_equal format(entry, -1_500_000, 146_000_000),
                 limit_in(with('minimum: minimum_separation_mm', 'minimum: -1.5'))
  end

  def test_SWR_ROBOT_021_a_coupled_limit_may_be_an_angle_of_any_axes
    about = { 'axes' => %w[feet yaw], 'unit' => 'deg', 'curved' => true, 'refusal' => 'SINGULAR_PITCH',
              'value' => 'yaw' }
    text = with('minimum: minimum_separation_mm', 'minimum: -10').sub('maximum: maximum_separation_mm', 'maximum: 10.5')
    with_coupled_limits('separation' => about) do
      assert_equal '.name = "separation", .unit = (uint8_t)AXIS_UNIT_RAD, .refusal = 13U, .is_curved = 1U, ' \
                   '.reserved = 0U, .axes = 0x042U, .minimum = -119304647, .maximum = 125269879', limit_in(text)
      assert_refused(TEXT, 'coupled_limits[0].minimum: is minimum_separation_mm; expected a number such as 18.32',
                     at: 'minimum: minimum_separation_mm')
      assert_refused(text.sub('maximum: 10.5', 'maximum: 181'), 'coupled_limits[0].maximum: is 181; expected -180 to 180',
                     at: 'maximum: 181')
      assert_refused(text.sub('maximum: 10.5', 'maximum: -9.8'),
                     'coupled_limits[0].maximum: is -9.8; expected more than -9.8', at: 'maximum: -9.8')
    end
  end

  def test_SWR_ROBOT_021_coupled_limits_that_do_not_hold_together_are_refused
    message = 'coupled_limits: are distance; expected separation'
    assert_refused(with('name: separation', 'name: distance'), message, at: 'coupled_limits:')
    assert_refused(with("    maximum: maximum_separation_mm\n", ''), 'coupled_limits[0].maximum: is missing',
                   at: '- name: separation')
    assert_refused(with('maximum: maximum_separation_mm', 'maximum: 75.4'),
                   'coupled_limits[0].maximum: is 75.4; expected more than 75.4', at: 'maximum: 75.4')
    { { 'refusal' => 'NOT_SO' } => 'has the refusal NOT_SO; expected one of refusals',
      { 'axes' => %w[head toe] } => 'is of toe; expected of head, feet, ',
      { 'axes' => %w[head insertion] } => 'is of insertion; expected of head, feet, lateral, rotation, ' }.each do |changed, reason|
      with_coupled_limits('separation' => limits_of_neuro['separation'].merge(changed)) do
        assert_match(/kinematics\.yml: coupled_limits\.separation: #{Regexp.escape(reason)}/, compile(TEXT)[1])
      end
    end
  end

  # The head homes in the third stage, and `axis` follows it.
  def with_follower(axis, leaders, text = TEXT)
    text = text.sub('home_stage: 2', 'home_stage: 3')
    head, mark, tail = text.partition("- name: #{axis}\n")
    head + mark + tail.sub('    home_stage: ') { "    follows: {#{leaders}}\n    home_stage: " }
  end

  def assert_no_leader(text, field, message, axis: 'feet')
    assert_refused(text, "#{field}: #{message}", at: 'follows:', axis: axis)
  end

  def test_SWR_ROBOT_022_the_table_holds_who_follows_whom_in_which_stage
    assert_equal ['{0U, 0U, 0U, 0U}'], compile(TEXT).last.scan(/\.leaders = (\{.*\})/).flatten.uniq
    leaders = compile(with_follower('feet', '3: head')).last.scan(/\.leaders = (\{.*\})/).flatten
    assert_equal '{0U, 0U, 1U, 0U}', leaders.delete_at(1)
    assert_equal ['{0U, 0U, 0U, 0U}'], leaders.uniq
  end

  def test_SWR_ROBOT_022_a_leader_that_does_not_home_in_that_stage_by_its_switch_is_refused
    field = 'axes[1].follows.3'
    assert_no_leader(with_follower('feet', '3: tail'), field, 'is tail; expected an axis of this robot')
    expected = 'expected an axis that homes in stage 3 by its switch'
    assert_no_leader(with_follower('feet', '3: lateral'), field, "is lateral; #{expected}")
    rotation = with_follower('feet', '3: rotation').sub(/(name: rotation.*?)home_stage: 2/m, '\1home_stage: 3')
    assert_no_leader(rotation, field, "is rotation; #{expected}")
    assert_no_leader(with_follower('feet', '4: head'), 'axes[1].follows.4',
                     'is head; expected an axis that homes in stage 4 by its switch')
    assert_no_leader(with_follower('feet', '5: head'), 'axes[1].follows.5', 'is unknown; expected 1, 2, 3, 4')
  end

  def test_SWR_ROBOT_022_who_homes_in_a_stage_follows_nobody_in_it_so_there_is_no_chain
    assert_no_leader(with_follower('head', '3: head'), 'axes[0].follows.3',
                     'follows in stage 3, in which head homes itself; expected another stage', axis: 'head')
    assert_no_leader(with_follower('feet', '2: lateral'), 'axes[1].follows.2',
                     'follows in stage 2, in which feet homes itself; expected another stage')
  end

  def test_SWR_ROBOT_022_axes_that_cannot_travel_as_one_are_refused
    field = 'axes[1].follows.3'
    feet = ->(before, after) { with_follower('feet', '3: head').sub(/(name: feet.*?)#{before}/m, "\\1#{after}") }
    other = 'is head, whose ticks are others; expected the unit and ticks of feet'
    assert_no_leader(feet['ticks_per_mm: 78.74', 'ticks_per_mm: 78.7'], field, other)
    assert_no_leader(with_follower('pitch', '3: head'), 'axes[5].follows.3', other.sub('feet', 'pitch'), axis: 'pitch')
    assert_no_leader(feet['home_speed_ticks_per_s: 196', 'home_speed_ticks_per_s: 195'], field,
                     'is head with home_speed_ticks_per_s 196; expected at most the 195 of feet')
    assert_no_leader(feet['acceleration_ticks_per_s2: 3150', 'acceleration_ticks_per_s2: 3149'], field,
                     'is head with acceleration_ticks_per_s2 3150; expected at most the 3149 of feet')
  end

  def test_SWR_ROBOT_022_the_needle_follows_nobody_and_nobody_follows_it
    needle = 'expected two axes across the needle'
    assert_no_leader(with_follower('insertion', '3: head'), 'axes[3].follows.3', "ties insertion to head; #{needle}",
                     axis: 'insertion')
    assert_no_leader(with_follower('feet', '1: insertion'), 'axes[1].follows.1', "ties feet to insertion; #{needle}")
    assert_no_leader(with_follower('rotation', '3: head'), 'axes[4].follows.3', "ties rotation to head; #{needle}",
                     axis: 'rotation')
  end
end

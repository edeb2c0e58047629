# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a robot file is compiled to the same table each time, or refused with line and field.

require 'minitest/autorun'
require_relative 'changed_robot'

class TestRobotCompiler < Minitest::Test
  include ChangedRobot

  def test_SWR_ROBOT_002_the_same_file_gives_the_same_bytes
    status, errors, table = compile(TEXT)
    assert_equal [0, ''], [status, errors]
    assert_equal table, compile(TEXT).last
  end

  def test_SWR_ROBOT_002_the_table_carries_the_crc_of_the_file
    assert_includes compile(TEXT).last, ".crc = 0x#{format('%08X', Robot::Crc.of(TEXT))}U"
    refute_includes compile("#{TEXT}# changed\n").last, ".crc = 0x#{format('%08X', Robot::Crc.of(TEXT))}U"
    assert_equal 0xE3069283, Robot::Crc.of('123456789')
  end

  def test_SWR_ROBOT_002_the_table_holds_the_values_in_the_units_of_the_core
    table = compile(TEXT).last
    assert_includes table, '[NEURO_RCM_HOME_X] = 18320000'
    assert_includes table, '[NEURO_PROBE_ROBOT_TO_TREATMENT] = 41000000}}'
    assert_includes table, "INT64_C(#{(1_000_000 * 65_536 / 78.74).round})"
    assert_in_delta (2**32) / (2 * Math::PI) * 65_536 / 795.8, table.scan(/INT64_C\((\d+)\)/).last.first.to_i, 1
    assert_equal 3, table.scan('(uint8_t)CARD_TYPE_PWM').size
    assert_equal 2, table.scan('(uint8_t)HOME_IN_PLACE').size
    assert_equal 1, table.scan('(uint8_t)LIMIT_SWITCH_LOWER').size
    assert_equal 3, table.scan('(uint8_t)AXIS_UNIT_RAD').size
  end

  def test_SWR_ROBOT_002_the_places_of_axes_and_lengths_carry_their_kinematics
    compile(TEXT)
    names = @header.scan(/#define (\w+) \d+U/).flatten
    assert_includes @header, '#define NEURO_AXIS_HEAD 0U'
    assert_includes @header, '#define NEURO_AXIS_INSERTION 3U'
    assert_empty(names.reject { |name| name.start_with?('NEURO_') })
  end

  CARDS = "cards: [{slot: 8, card: sensor}, {slot: 0, card: sensor}]\n"

  def test_SWR_ROBOT_025_the_table_knows_the_slots_of_cards_without_an_axis
    assert_includes compile(TEXT).last, '.sensor_slots = 0x000U'
    assert_includes compile(TEXT + CARDS).last, '.sensor_slots = 0x101U'
  end

  def test_SWR_ROBOT_025_a_slot_is_given_once
    assert_refused(TEXT + CARDS.sub('8', '7'), 'cards[0].slot: is 7, which head has; expected another', at: 'cards:')
    assert_refused(TEXT + CARDS.sub('0', '8'), 'cards[1].slot: is 8, which sensor has; expected another', at: 'cards:')
    assert_refused(TEXT + CARDS.sub('8', '10'), 'cards[0].slot: is 10; expected 0 to 9', at: 'cards:')
  end

  def test_SWR_ROBOT_025_a_card_that_drives_needs_an_axis
    assert_refused(TEXT + CARDS.sub('sensor', 'pwm'), 'cards[0].card: is pwm; expected sensor', at: 'cards:')
    assert_refused("#{TEXT}cards: [{slot: 8}]\n", 'cards[0].card: is missing', at: 'cards:')
  end

  def test_SWR_ROBOT_001_the_command_line_needs_a_file_and_a_directory
    errors = StringIO.new
    assert_equal 2, Robot::Command.run([], errors: errors)
    assert_match(/\Ausage: /, errors.string)
  end

  def test_SWR_ROBOT_001_a_file_that_is_not_there_is_refused
    errors = StringIO.new
    assert_equal 1, Robot::Command.run(['/nowhere/robot.yaml', '/nowhere'], errors: errors)
    assert_includes errors.string, '/nowhere/robot.yaml'
  end

  def test_SWR_ROBOT_001_a_file_that_is_not_yaml_is_refused
    assert_refused("name: neuro\naxes: [\n", 'file: is not YAML: did not find expected node content while parsing ' \
                                             'a flow node', line: 3)
    assert_refused('', 'file: is empty; expected a robot', line: 1)
    assert_refused("- neuro\n", 'file: is not a mapping of keys to values', line: 1)
  end

  def test_SWR_ROBOT_001_an_unknown_key_is_refused
    assert_refused(with('kinematics: neuro', "kinematics: neuro\ncolour: red"),
                   'colour: is unknown; expected name, kinematics, card_firmware, geometry, probe, coupled_limits, ' \
                   'axes, cards, force, hand, poses, reported, steering', at: 'colour')
    text = with('    slot: 4', "    slot: 4\n    slat: 4", axis: 'lateral')
    status, errors, = compile(text)
    assert_equal 1, status
    assert_match(/\Arobot.yaml:#{line_of(text, 'slat', 'lateral')}: axes\[2\]\.slat: is unknown; expected name/, errors)
  end

  def test_SWR_ROBOT_001_a_key_given_twice_is_refused
    text = with('  side_link_mm: 60', "  side_link_mm: 60\n  side_link_mm: 61")
    assert_refused(text, 'geometry.side_link_mm: is given twice', at: 'side_link_mm: 61')
  end

  def test_SWR_ROBOT_001_a_missing_key_is_refused
    assert_refused(with("kinematics: neuro\n", ''), 'kinematics: is missing', at: 'name: neuro')
    assert_refused(with("  top_width_mm: 30\n", ''), 'geometry.top_width_mm: is missing', at: 'geometry:')
    assert_refused(with("    home_stage: 2\n", '', axis: 'feet'), 'axes[1].home_stage: is missing', axis: 'feet',
                                                                                                    at: 'name: feet')
  end

  def test_SWR_ROBOT_001_a_wrong_type_is_refused
    assert_refused(with('slot: 7', 'slot: seven'), 'axes[0].slot: is seven; expected a whole number', at: 'slot: seven')
    assert_refused(with('slot: 7', 'slot: 07'), 'axes[0].slot: is 07; expected a whole number', at: 'slot: 07')
    assert_refused(with('slot: 7', 'slot: "7"'), 'axes[0].slot: is not a plain value', at: 'slot: "7"')
    assert_refused(with('slot: 7', 'slot:'), 'axes[0].slot: is not a plain value', at: '    slot:')
    assert_refused(with('slot: 7', 'slot: [7]'), 'axes[0].slot: is not a plain value', at: 'slot: [7]')
    assert_refused(with('18.32', '1e3'), 'geometry.rcm_home_x_mm: is 1e3; expected a number such as 18.32', at: '1e3')
    assert_refused(with('name: neuro', 'name: Neuro!'), 'name: is Neuro!; expected 1 to 11 of a-z, 0-9 and _',
                   at: 'name: Neuro!')
    assert_refused(with('1.2.0', '1.2'), 'card_firmware: is 1.2; expected a version such as 1.2.0', at: 'card_firmware')
    assert_refused("#{TEXT[/\A.*^axes:/m]} 7\n", 'axes: is not a list', at: 'axes: 7')
    assert_refused("#{TEXT[/\A.*^axes:/m]}\n  - 7\n", 'axes[0]: is not a mapping of keys to values', at: '  - 7')
  end

  def test_SWR_ROBOT_001_a_number_out_of_range_is_refused
    assert_refused(with('slot: 7', 'slot: 10'), 'axes[0].slot: is 10; expected 0 to 9', at: 'slot: 10')
    assert_refused(with('slot: 7', 'slot: -1'), 'axes[0].slot: is -1; expected 0 to 9', at: 'slot: -1')
    assert_refused(with('home_stage: 2', 'home_stage: 5'), 'axes[0].home_stage: is 5; expected 1 to 4',
                   at: 'home_stage: 5')
    assert_refused(with('side_link_mm: 60', 'side_link_mm: 0.5'),
                   'geometry.side_link_mm: is 0.5; expected 1 to 1000', at: 'side_link_mm')
    assert_refused(with('78.74', '0.1'), 'axes[0].ticks_per_mm: is 0.1; expected 1 to 100000', at: 'ticks_per_mm: 0.1')
    assert_refused(with('maximum_duty: 131071', 'maximum_duty: 8388608'),
                   'axes[3].maximum_duty: is 8388608; expected 1 to 8388607', at: 'maximum_duty: 8388608')
  end

  def test_SWR_PROFILE_271_an_acceleration_that_changes_no_speed_in_a_cycle_is_refused
    least = Robot::Limit.of('acceleration_least_ticks_per_s2')
    cycles_per_s = 1_000_000 / Robot::Limit.of('cycle_us')
    assert_equal [0, 1], [least - 1, least].map { |one| one * 256 / cycles_per_s }
    text = TEXT.sub(/acceleration_ticks_per_s2: \d+/, "acceleration_ticks_per_s2: #{least - 1}")
    assert_refused(text, "axes[0].acceleration_ticks_per_s2: is #{least - 1}; expected #{least} to " \
                         "#{Robot::Limit.of('acceleration_most_ticks_per_s2')}",
                   at: "acceleration_ticks_per_s2: #{least - 1}")
  end

  def test_SWR_PROFILE_511_an_axis_whose_cycles_would_not_fit_is_refused
    most = Robot::Limit.of('travel_time_most_s')
    travel = %w[maximum minimum].map { |end_of| TEXT[/#{end_of}_ticks: (-?\d+)/, 1].to_i }.inject(:-)
    cycles = most * (1_000_000 / Robot::Limit.of('cycle_us')) * 100 * 100 / Robot::Limit.of('profile_speed_percent')
    assert_operator 2 * cycles, :<, 2**31
    least = (travel / most.to_r).ceil
    text = TEXT.sub(/\bspeed_ticks_per_s: \d+/, "speed_ticks_per_s: #{least - 1}")
               .sub(/home_speed_ticks_per_s: \d+/, 'home_speed_ticks_per_s: 1')
    assert_refused(text, "axes[0].speed_ticks_per_s: is #{least - 1}; expected at least #{least}, with which the travel takes #{most} s",
                   at: "speed_ticks_per_s: #{least - 1}")
  end

  def test_SWR_TRAJ_025_an_acceleration_whose_ways_do_not_fit_is_refused
    most = Robot::Limit.of('acceleration_most_ticks_per_s2')
    text = TEXT.sub(/acceleration_ticks_per_s2: \d+/, "acceleration_ticks_per_s2: #{most + 1}")
    least = Robot::Limit.of('acceleration_least_ticks_per_s2')
    assert_refused(text, "axes[0].acceleration_ticks_per_s2: is #{most + 1}; expected #{least} to #{most}",
                   at: "acceleration_ticks_per_s2: #{most + 1}")
  end

  def test_SWR_ROBOT_001_a_wrong_word_is_refused
    assert_refused(with('kinematics: neuro', 'kinematics: scara'), 'kinematics: is scara; expected ' \
                                                                  "#{Robot::Kinematics.names.join(' or ')}",
                   at: 'scara')
    assert_refused(with('card: non_pwm', 'card: steam'),
                   'axes[0].card: is steam; expected pwm or non_pwm or high_frequency or analog', at: 'steam')
    assert_refused(with('home: switch', 'home: sweet'), 'axes[0].home: is sweet; expected switch or in_place',
                   at: 'sweet')
    assert_refused(with('limit_switch: upper', 'limit_switch: both'),
                   'axes[0].limit_switch: is both; expected none or lower or upper', at: 'both')
    assert_refused(with('motor_inverted: true', 'motor_inverted: yes'),
                   'axes[0].motor_inverted: is yes; expected true or false', at: 'motor_inverted: yes')
  end

  def test_SWR_ROBOT_001_an_axis_needs_exactly_one_unit
    assert_refused(with("    ticks_per_mm: 78.74\n", '', axis: 'feet'),
                   'axes[1]: has no unit; expected ticks_per_mm or ticks_per_rad', axis: 'feet', at: 'name: feet')
    assert_refused(with("    ticks_per_mm: 78.74\n", "    ticks_per_mm: 78.74\n    ticks_per_rad: 1\n", axis: 'feet'),
                   'axes[1]: has two units; expected ticks_per_mm or ticks_per_rad', axis: 'feet', at: 'name: feet')
    assert_refused(with('ticks_per_rad', 'ticks_per_mm', axis: 'yaw'),
                   'axes[6].name: is yaw in mm; expected ticks_per_rad', axis: 'yaw', at: 'name: yaw')
    assert_refused(with('ticks_per_mm', 'ticks_per_rad', axis: 'head'),
                   'axes[0].name: is head in rad; expected ticks_per_mm', axis: 'head', at: 'name: head')
  end

  def test_SWR_ROBOT_001_a_pwm_card_has_duties_a_smaller_and_a_larger
    assert_refused(with("    minimum_duty: 13107\n", ''), 'axes[3]: has no minimum_duty; expected 1 to 8388607',
                   axis: 'insertion', at: 'name: insertion')
    assert_refused(with('minimum_duty: 13107', 'minimum_duty: 131071'),
                   'axes[3].minimum_duty: is 131071; expected less than maximum_duty (131071)',
                   at: 'minimum_duty: 131071')
  end

  def test_SWR_ROBOT_001_a_pwm_card_has_a_gain
    assert_refused(with("    gain_per_s: 90\n", '', axis: 'yaw'), 'axes[6]: has no gain_per_s; expected 1 to 200',
                   axis: 'yaw', at: 'name: yaw')
    assert_refused(with('gain_per_s: 90', 'gain_per_s: 201'), 'axes[3].gain_per_s: is 201; expected 1 to 200',
                   at: 'gain_per_s: 201')
  end

  # The file whose first axis, which has a non_pwm card, says this as well.
  def head_with(*lines)
    with("    jump_ticks: 40\n", ['jump_ticks: 40', *lines].map { |line| "    #{line}\n" }.join)
  end

  def test_SWR_ROBOT_001_a_non_pwm_card_has_magnitudes_and_a_gain_or_none_of_them
    whole = ['minimum_duty: 5', 'maximum_duty: 50', 'gain_per_s: 70']
    assert_match(/minimum_duty = 5U,\s*\.maximum_duty = 50U,\s*\.gain_per_s = 70U/, compile(head_with(*whole)).last)
    assert_equal 4, compile(TEXT).last.scan(/minimum_duty = 0U,\s*\.maximum_duty = 0U,\s*\.gain_per_s = 0U/).size
    { 'minimum_duty' => '1 to 8388607', 'maximum_duty' => '1 to 8388607', 'gain_per_s' => '1 to 200' }.each do |key, range|
      assert_refused(head_with(*whole.grep_v(/#{key}/)), "axes[0]: has no #{key}; expected #{range}", at: 'name: head')
    end
  end

  def test_SWR_ROBOT_001_magnitudes_of_a_non_pwm_card_are_checked_as_duties_are
    assert_refused(head_with('minimum_duty: 50', 'maximum_duty: 50', 'gain_per_s: 70'),
                   'axes[0].minimum_duty: is 50; expected less than maximum_duty (50)', at: 'minimum_duty: 50')
    assert_refused(head_with('minimum_duty: 0', 'maximum_duty: 50', 'gain_per_s: 70'),
                   'axes[0].minimum_duty: is 0; expected 1 to 8388607', at: 'minimum_duty: 0')
  end

  def test_SWR_ROBOT_001_data_of_a_switch_belong_to_axes_with_one
    assert_refused(with('    jump_ticks: 40', "    jump_ticks: 40\n    home_time_ms: 5000", axis: 'feet'),
                   'axes[1].home_time_ms: does not belong to an axis without a switch; expected none',
                   at: 'home_time_ms: 5000', axis: 'feet')
    assert_refused(with("    over_travel_ticks: 60\n", '', axis: 'yaw'),
                   'axes[6]: has no over_travel_ticks; expected 0 to 10000', axis: 'yaw', at: 'name: yaw')
  end

  def test_SWR_AXIS_013_homing_goes_away_over_travel_hysteresis_and_a_little_more_but_the_needle_a_fifth_of_a_millimetre
    ways = compile(TEXT).last.scan(/home_way_ticks = (\d+)/).flatten.map(&:to_i)
    assert_equal [60 + 8 + 8, 0, 60 + 5 + 5, 666, 0, 60 + 6 + 5, 60 + 6 + 5], ways
    small = with('switch_hysteresis_ticks: 334', 'switch_hysteresis_ticks: 100')
    assert_includes compile(small).last, ".home_way_ticks = #{60 + 100 + 334},"
  end

  def test_SWR_AXIS_020_targets_keep_clear_of_the_switch_and_its_hysteresis
    table = compile(TEXT).last
    assert_equal [-11_418, -5512, -2337, 368, -8073, -370, -1222], ticks(table, 'target_minimum')
    assert_equal [-10, 5906, -7, 133_334, 8073, 508, 0], ticks(table, 'target_maximum')
    fine = with('ticks_per_mm: 3333.34', 'ticks_per_mm: 4000')
    assert_includes compile(fine).last, ".target_minimum_ticks = #{334 + 40}," # 0.01 mm, whatever a tick is
  end

  def ticks(table, name)
    table.scan(/\.#{name}_ticks = (-?\d+)/).flatten.map(&:to_i)
  end

  def test_SWR_IGTL_038_the_order_of_lists_is_the_file_s_or_that_of_the_axes
    assert_equal [2, 6, 5, 3, 4, 0, 1], joints_reported(TEXT)
    assert_equal (0..6).to_a, joints_reported(with('  joints: [lateral, yaw, pitch, insertion, rotation, head, feet]', ''))
  end

  def joints_reported(text)
    compile(text).last[/\.reported_joints = \{.*?\n    \}/m].scan(/= (\d+)U/).flatten.map(&:to_i)
  end

  def test_SWR_IGTL_038_a_list_without_one_of_the_axes_or_with_one_twice_is_refused
    assert_refused(with('yaw, pitch, insertion', 'yaw, yaw, insertion'),
                   'reported.joints: are lateral, yaw, yaw, insertion, rotation, head, feet; expected each of head, feet, ' \
                   'lateral, insertion, rotation, pitch, yaw once', at: 'joints: [')
    assert_refused(with('[lateral, yaw', '[laterally, yaw'),
                   'reported.joints[0]: is laterally; expected head or feet or lateral or insertion or rotation or pitch ' \
                   'or yaw', at: 'joints: [')
  end

  def test_SWR_PROBE_001_the_table_has_the_ranges_of_the_probe_and_what_it_may_not_exceed
    table = compile(TEXT).last
    rows = %w[probe_minimum probe_maximum probe_within].map do |row|
      table[/\.#{row} = \{+(.*?)\}/, 1].scan(/= (\d+)/).flatten.map(&:to_i)
    end
    assert_equal [[0, 0, 0, 10_000_000], [60_000_000, 60_000_000, 60_000_000, 100_000_000], [0, 4, 4, 0]], rows
    assert_includes table, '[1] = "robot_to_entry"'
  end

  def test_SWR_PROBE_001_a_length_outside_of_its_range_is_refused
    line = 'robot_to_treatment_mm: {value: 41, minimum: 10, maximum: 100}'
    { 'value: 9.5' => 'is 9.5; expected 10 to 100', 'value: 100.5' => 'is 100.5; expected 10 to 100' }.each do |value, why|
      assert_refused(with(line, line.sub('value: 41', value)), "probe.robot_to_treatment_mm.value: #{why}", at: value)
    end
    assert_refused(with(line, line.sub('100', '1001')),
                   'probe.robot_to_treatment_mm.maximum: is 1001; expected -1000 to 1000', at: 'maximum: 1001')
    assert_refused(with(line, line.sub(', maximum: 100', '')), 'probe.robot_to_treatment_mm.maximum: is missing',
                   at: 'robot_to_treatment_mm: {')
  end

  def test_SWR_PROBE_001_a_length_that_exceeds_another_is_refused
    assert_refused(with('robot_to_entry_mm: {value: 5,', 'robot_to_entry_mm: {value: 41.5,'),
                   'probe: has a longer robot_to_entry_mm than robot_to_treatment_mm; expected at most the same',
                   at: "probe:\n")
  end

  def test_SWR_IGTL_039_lengths_that_are_reported_have_the_value_of_their_length
    reported = compile(with('robot_to_entry_mm: {value: 5,', 'robot_to_entry_mm: {value: 5.25,')).last[/\.reported_lengths.*/m]
    assert_includes reported, '{.name = "robot_to_entry", .length_nm = 5250000, .probe = 2U}'
    assert_includes reported, '{.name = "robot_treatment_home", .length_nm = 41000000, .probe = 4U}'
  end

  def test_SWR_IGTL_039_wrong_lengths_to_be_reported_are_refused
    at = 'name: robot_to_entry, length'
    assert_refused(with('name: robot_to_entry,', 'name: treatment_to_tip,'),
                   'reported.lengths[2].name: is treatment_to_tip, which another has; expected another',
                   line: line_of(TEXT, at, nil))
    assert_refused(with('name: robot_to_entry,', "name: #{'a' * 21},"),
                   "reported.lengths[2].name: is #{'a' * 21}; expected 1 to 20 of a-z, 0-9 and _", at: 'aaaa')
    assert_refused(with("    - {#{at}", "    - {name: a, length: robot_to_entry_mm}\n    - {#{at}"),
                   'reported.lengths: are 5; expected at most 4', at: '  lengths:')
    assert_match(/reported.lengths\[2\].length: is depth; expected side_link_mm or /,
                 compile(with('length: robot_to_entry_mm', 'length: depth'))[1])
  end

  def test_SWR_ROBOT_001_limits_that_cross_are_refused
    assert_refused(with('minimum_ticks: -370', 'minimum_ticks: 516'),
                   'axes[5].minimum_ticks: is 516; expected less than maximum_ticks (516)', at: 'minimum_ticks: 516')
  end

  def test_SWR_ROBOT_001_a_home_outside_the_limits_is_refused
    assert_refused(with('home_ticks: 516', 'home_ticks: 517'),
                   'axes[5].home_ticks: is 517; expected -370 to 516', at: 'home_ticks: 517')
    assert_refused(with('home_ticks: 516', 'home_ticks: -371'),
                   'axes[5].home_ticks: is -371; expected -370 to 516', at: 'home_ticks: -371')
  end

  def test_SWR_ROBOT_001_a_simulated_axis_that_starts_outside_the_limits_is_refused
    assert_refused(with('start_ticks: 100', 'start_ticks: 517'), 'axes[5].start_ticks: is 517; expected -370 to 516',
                   at: 'start_ticks: 517')
    starts = compile(TEXT).last[/\.start_ticks = {.*?}/m]
    assert_equal([-1575, 0, -1181, 3333, 0, 100, -300], starts.scan(/\] = (-?\d+)/).flatten.map(&:to_i))
  end

  def test_SWR_ROBOT_001_homing_to_a_switch_needs_a_switch
    assert_refused(with('home: in_place', 'home: switch'),
                   'axes[1].home: is switch, but the axis has none; expected in_place',
                   axis: 'feet', at: 'home: switch')
  end

  def test_SWR_ROBOT_001_speeds_and_windows_that_contradict_each_other_are_refused
    assert_refused(with('full_speed_ticks_per_s: 984', 'full_speed_ticks_per_s: 786'),
                   'axes[0].speed_ticks_per_s: is 787; expected at most full_speed_ticks_per_s (786)',
                   at: ' speed_ticks_per_s: 787')
    assert_refused(with('deadband_ticks: 0', 'deadband_ticks: 197'),
                   'axes[0].deadband_ticks: is 197; expected less than following_error_ticks (197)',
                   at: 'deadband_ticks: 197')
    assert_refused(with('jump_ticks: 520', 'jump_ticks: 25'),
                   'axes[3].jump_ticks: is 25; expected more than the 25 of a cycle at full speed',
                   at: 'jump_ticks: 25')
  end

  def test_SWR_ROBOT_001_homing_faster_than_an_axis_may_be_before_it_is_homed_is_refused
    assert_equal 25, Robot::Limit.of('unhomed_speed_percent')
    assert_refused(with('home_speed_ticks_per_s: 196', 'home_speed_ticks_per_s: 197'),
                   'axes[0].home_speed_ticks_per_s: is 197; expected at most 196, 25 percent of speed_ticks_per_s (787)',
                   at: 'home_speed_ticks_per_s: 197')
    assert_equal 0, compile(with('home_speed_ticks_per_s: 196', 'home_speed_ticks_per_s: 195')).first
  end

  def test_SWR_AXIS_060_less_time_than_homing_takes_over_all_of_the_travel_is_refused
    assert_refused(with('home_time_ms: 75000', 'home_time_ms: 72818'),
                   'axes[0].home_time_ms: is 72818; expected at least 72819, ' \
                   '125 percent of what the travel takes at home_speed_ticks_per_s', at: 'home_time_ms: 72818')
    assert_equal 0, compile(with('home_time_ms: 75000', 'home_time_ms: 72819')).first
  end

  def test_SWR_ROBOT_001_two_axes_on_one_slot_are_refused
    assert_refused(with('slot: 6', 'slot: 7'), 'axes[1].slot: is 7, which head has; expected another',
                   axis: 'feet', at: 'slot: 7')
  end

  def test_SWR_ROBOT_001_two_axes_of_one_name_are_refused
    assert_refused(with('name: feet', 'name: head'), 'axes[1].name: is head, which head has; expected another',
                   line: line_of(TEXT, 'name: feet', nil))
  end

  def test_SWR_ROBOT_001_axes_other_than_those_of_the_kinematics_are_refused
    assert_refused(with('name: feet', 'name: foot'),
                   'axes: are head, foot, lateral, insertion, rotation, pitch, yaw; expected head, feet, lateral, ' \
                   'insertion, rotation, pitch, yaw', line: TEXT.lines.index("axes:\n") + 1)
  end

  def test_SWR_ROBOT_001_a_separation_the_linkage_cannot_take_is_refused
    assert_refused(with('minimum_separation_mm: 75', 'minimum_separation_mm: 30'),
                   'geometry.minimum_separation_mm: is 30; expected between 30 and 146', at: 'minimum_separation_mm')
    assert_refused(with('minimum_separation_mm: 75', 'minimum_separation_mm: 146'),
                   'geometry.minimum_separation_mm: is 146; expected between 30 and 146', at: 'minimum_separation_mm')
    assert_refused(with('maximum_separation_mm: 146', 'maximum_separation_mm: 150'),
                   'geometry.maximum_separation_mm: is 150; expected between 75 and 150', at: 'maximum_separation_mm')
    assert_refused(with('home_separation_mm: 143', 'home_separation_mm: 30'),
                   'geometry.home_separation_mm: is 30; expected between 75 and 146', at: 'home_separation_mm')
  end

  def test_SWR_ROBOT_001_the_needle_is_moved_as_the_kinematics_says
    table = compile(TEXT).last
    assert_includes table, '.needle_axis = 3U'
    assert_equal %w[ACROSS ACROSS ACROSS ALONG ABOUT ACROSS ACROSS], table.scan(/NEEDLE_([A-Z]+),/).flatten
    assert_refused(with('needle: across', 'needle: along', axis: 'yaw'), 'axes[6].needle: is along; expected across',
                   axis: 'yaw', at: 'needle: along')
    assert_refused(with('needle: along', 'needle: about'), 'axes[3].needle: is about; expected along',
                   axis: 'insertion', at: 'needle: about')
  end

  def test_SWR_ROBOT_001_a_kinematics_has_one_axis_along_the_needle
    Dir.mktmpdir do |folder|
      FileUtils.mkdir_p(File.join(folder, 'two'))
      path = File.join(folder, 'two', 'kinematics.yml')
      File.write(path, 'axes: {a: [mm, along], b: [mm, along]}')
      error = assert_raises(Robot::Refused) { Robot::Kinematics.new('two', folder) }
      assert_equal "#{path}: axes: are 2 along the needle; expected 1", error.message
    end
  end

  def test_SWR_TOOL_029_the_needle_goes_in_mm_and_is_turned_by_an_angle
    Dir.mktmpdir do |folder|
      FileUtils.mkdir_p(File.join(folder, 'odd'))
      path = File.join(folder, 'odd', 'kinematics.yml')
      { 'axes: {a: [rad, along]}' => 'axes.a: goes along the needle in rad; expected mm',
        'axes: {a: [mm, along], b: [mm, about]}' => 'axes.b: goes about the needle in mm; expected rad' }.each do |text, reason|
        File.write(path, text)
        error = assert_raises(Robot::Refused) { Robot::Kinematics.new('odd', folder) }
        assert_equal "#{path}: #{reason}", error.message
      end
    end
  end

  def test_SWR_ROBOT_001_a_home_outside_the_separation_limits_is_refused
    assert_refused(with('home_separation_mm: 143', 'home_separation_mm: 146.5'),
                   'geometry.home_separation_mm: is 146.5; expected between 75 and 146',
                   at: 'home_separation_mm')
  end

  def test_SWR_ROBOT_001_an_insertion_that_is_negative_or_too_deep_is_refused
    assert_refused(with('minimum_ticks: 0', 'minimum_ticks: -1', axis: 'insertion'),
                   'axes[3].minimum_ticks: is negative; expected 0 or more, 0 is fully out',
                   axis: 'insertion', at: 'minimum_ticks: -1')
    assert_refused(with('133334', '666669'), 'axes[3].maximum_ticks: is deeper than 200 mm; expected less',
                   at: '666669')
  end

  def test_SWR_ROBOT_001_a_travel_that_does_not_fit_the_numbers_is_refused
    assert_refused(with('-11418', '-157481'), 'axes[0].minimum_ticks: is farther than 2000 mm; expected less',
                   at: '-157481')
    assert_refused(with('5906', '157481'), 'axes[1].maximum_ticks: is farther than 2000 mm; expected less',
                   at: '157481')
  end
end

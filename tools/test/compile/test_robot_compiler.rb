# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a robot file is compiled to the same table each time, or refused with line and field.

require 'minitest/autorun'
require 'minitest/mock'
require 'stringio'
require 'tmpdir'
require_relative '../../compile/robot_compiler'

class TestRobotCompiler < Minitest::Test
  ROBOT = File.expand_path('../../../core/robot/neuro/robot.yml', __dir__)
  WHOLE = File.read(ROBOT)
  TEXT = WHOLE.sub(/^poses:\n(?:  .*\n)+/, '') # Poses are added where they are looked at.

  def compile(text)
    Dir.mktmpdir do |directory|
      path = File.join(directory, 'robot.yaml')
      File.binwrite(path, text)
      errors = StringIO.new
      status = Robot::Command.run([path, File.join(directory, 'out')], errors: errors)
      table = File.join(directory, 'out', 'robot_neuro.c')
      @header = File.join(directory, 'out', 'robot_neuro.h').then { |header| File.read(header) if File.exist?(header) }
      return [status, errors.string.gsub("#{directory}/", ''), File.exist?(table) ? File.read(table) : nil]
    end
  end

  # Refused with this message; the line is that of the first line with `at` (after the axis `axis`, if given).
  def assert_refused(text, message, at: nil, axis: nil, line: nil)
    status, errors, table = compile(text)
    line ||= line_of(text, at, axis)
    assert_equal "robot.yaml:#{line}: #{message}\n", errors
    assert_equal 1, status
    assert_nil table
  end

  def line_of(text, part, axis)
    lines = text.lines
    start = axis ? lines.index { |line| line.include?("- name: #{axis}\n") } : 0
    start + lines[start..].index { |line| line.include?(part) } + 1
  end

  # The file with the first `before` (after the axis `axis`, if given) replaced.
  def with(before, after, axis: nil)
    head, mark, tail = axis ? TEXT.partition("- name: #{axis}\n") : ['', '', TEXT]
    refute_nil tail.index(before), "no #{before} in the file"
    head + mark + tail.sub(before) { after }
  end

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

  FORCE = <<~YAML
    cards: [{slot: 8, card: sensor}]
    force:
      slot: 8
      unit_mn: 10
      hand: {converter: 2, slope: 0.5, offset: -1000, zero_reference: 2100, cutoff_hz: 40, minimum_n: -9, maximum_n: 9}
      needle: {converter: 3, slope: -0.5, offset: 1000, zero_reference: 1900, cutoff_hz: 20, minimum_n: -4, maximum_n: 5}
  YAML

  def channel(table, index)
    table[/\.force = .*?\[#{index}\] = \{(.*?)\}/m, 1].scan(/\.(\w+) = (-?\d+)/).to_h { |name, value| [name, Integer(value)] }
  end

  def test_SWR_FORCE_560_the_table_has_the_force_sensor_in_the_units_of_the_core
    table = compile(TEXT + FORCE).last
    hand, needle = channel(table, 0), channel(table, 1)
    assert_equal [5 * 65_536, 2100, 1, 200, 3800],
                 hand.values_at('mn_per_count_q16', 'zero_count', 'converter', 'minimum_count', 'maximum_count')
    assert_equal [-5 * 65_536, 1900, 2, 1000, 2800],
                 needle.values_at('mn_per_count_q16', 'zero_count', 'converter', 'minimum_count', 'maximum_count')
    assert_equal 1000, hand['step_counts']
    refute_includes compile(TEXT).last, '.force'
  end

  def test_SWR_FORCE_560_the_filter_lets_a_force_that_stays_through
    [channel(compile(TEXT + FORCE).last, 0), channel(compile(TEXT + FORCE).last, 1)].zip([40, 20]) do |filter, hertz|
      b, a1, a2 = filter.values_at('filter_b_q30', 'filter_a1_q30', 'filter_a2_q30')
      assert_equal (2**30) + a1 + a2, 4 * b
      turn = Complex.polar(1, -2 * Math::PI * hertz / 1000)
      gain = b * ((1 + turn)**2) / ((2**30) + (a1 * turn) + (a2 * turn * turn))
      assert_in_delta Math.sqrt(0.5), gain.abs, 1e-6, 'at its corner half of the power'
    end
  end

  def refuse_force(before, after, message)
    refute_nil FORCE.index(before), "no #{before} in the sensor"
    line = TEXT.lines.size + FORCE.lines.index { |one| one.include?(before) } + 1
    assert_refused(TEXT + FORCE.sub(before) { after }, message, line: line)
  end

  def test_SWR_FORCE_560_a_sensor_without_its_card_is_refused
    refuse_force('  slot: 8', '  slot: 9', 'force.slot: is 9, where no card without an axis is; expected a slot of cards')
  end

  def test_SWR_FORCE_560_bad_numbers_are_refused
    refuse_force('slope: 0.5', 'slope: 0.0001', 'force.hand.slope: is 0.0001; expected at least 0.001 from zero')
    refuse_force('slope: 0.5', 'slope: 0', 'force.hand.slope: is 0; expected at least 0.001 from zero')
    refuse_force('converter: 2', 'converter: 5', 'force.hand.converter: is 5; expected 1 to 4')
    refuse_force('converter: 3', 'converter: 2', 'force.needle.converter: is 2, which hand has; expected another')
    refuse_force('cutoff_hz: 40', 'cutoff_hz: 101', 'force.hand.cutoff_hz: is 101; expected 1 to 100')
    refuse_force('unit_mn: 10', 'unit_mn: 0', 'force.unit_mn: is 0; expected 1/10 to 1000')
    refuse_force('zero_reference: 2100', 'zero_reference: 3900',
                 'force.hand.zero_reference: is 3900; expected 200 to 3800, the readings from minimum_n to maximum_n')
  end

  def test_SWR_FORCE_560_forces_that_the_converter_cannot_show_are_refused
    refuse_force('maximum_n: 9', 'maximum_n: 90',
                 'force.hand.maximum_n: is a reading of 20000; expected 1 to 4094, which the converter shows of a whole wire')
    refuse_force('minimum_n: -9', 'minimum_n: 1', 'force.hand.minimum_n: is 1; expected less than 0 and than maximum_n')
    refuse_force('maximum_n: 9', 'maximum_n: -8', 'force.hand.maximum_n: is -8; expected more than 0')
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
                   'axes, cards, force, hand, poses, reported', at: 'colour')
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

  def limits_of_neuro
    Robot::Kinematics.new('neuro').coupled_limits
  end

  # As if the kinematics had said so.
  def with_coupled_limits(limits, &block)
    found = Robot::Kinematics.method(:new)
    changed = lambda do |*arguments|
      found.call(*arguments).tap { |one| one.instance_variable_get(:@parts)['coupled_limits'] = limits }
    end
    Robot::Kinematics.stub(:new, changed, &block)
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

  PROSTATE = File.expand_path('../../../core/robot/prostate/robot.yml', __dir__)
  WAVES = File.read(PROSTATE)

  # The ProstateRobot, whose last axis has a high-frequency card, with the first `before` of that axis replaced.
  def waves(before, after)
    head, mark, tail = WAVES.partition("- name: rotation\n")
    refute_nil tail.index(before), "no #{before} in the file"
    head + mark + tail.sub(before) { after }
  end

  def assert_waves_refused(before, after, message, at: after)
    text = waves(before, after)
    status, errors, = compile(text)
    line = at.empty? ? line_of(text, '- name: rotation', nil) : line_of(text, at.lines.first.chomp, 'rotation')
    assert_equal [1, "robot.yaml:#{line}: axes[5]#{message}\n"], [status, errors]
  end

  def test_SWR_DRIVE_006_the_words_of_waves_fall_and_their_speeds_rise
    Dir.mktmpdir do |directory|
      assert_equal 0, Robot::Command.run([PROSTATE, directory])
      table = File.read(File.join(directory, 'robot_prostate.c'))
      assert_match(/minimum_duty = 1151907042U,\s*\.maximum_duty = 1119421758U/, table)
      assert_includes table, '.speed_curve = {26U, 37U, 50U, 65U, 83U, 107U, 143U, 191U}'
      assert_equal [1, 5], [table.scan('amplitude = 255U').size, table.scan('amplitude = 0U').size]
      assert_equal [1, 5], [table.scan('hz_per_k = 20U').size, table.scan('hz_per_k = 0U').size]
    end
  end

  def test_SWR_DRIVE_006_words_beyond_resonance_or_out_of_the_range_of_waves_are_refused
    assert_waves_refused('fastest_khz: 50.862', 'fastest_khz: 49.4',
                         '.fastest_khz: is the word 1087244600; expected 1089445500 to 1210495000, 49.5 to 55 kHz')
    assert_waves_refused('slowest_khz: 52.338', 'slowest_khz: 55.1',
                         '.slowest_khz: is the word 1212695900; expected 990405000 to 1210495000, 45 to 55 kHz')
    assert_waves_refused('fastest_khz: 50.862', 'fastest_khz: 52.338',
                         '.fastest_khz: is not below slowest_khz; expected less, a motor is faster nearer to its resonance')
  end

  def test_SWR_DRIVE_006_a_curve_that_does_not_rise_to_full_speed_is_refused
    {
      '[10.3, 14.7, 14.7, 25.5, 32.5, 42.0, 55.9, 74.8, 100]' =>
        'does not rise from each speed to the next; expected half a percent at least',
      '[10.3, 100]' => 'has 2 speeds; expected 9',
      '[10.3, 14.7, 19.5, 25.5, 32.5, 42.0, 55.9, 74.8, 99]' => 'ends with 99.0; expected 100 percent of full speed'
    }.each do |curve, reason|
      assert_waves_refused(/\[10\.3.*\]/, curve, ".speed_curve: #{reason}")
    end
  end

  def test_SWR_DRIVE_006_a_card_has_all_of_its_own_words_and_no_others
    assert_waves_refused("    amplitude: 255\n", '', ': has no amplitude; expected 1 to 255', at: '')
    assert_waves_refused("    slowest_khz: 52.338\n", '', ': has no slowest_khz; expected one, its card is high_frequency',
                         at: '')
    assert_waves_refused('amplitude: 255', "amplitude: 255\n    minimum_duty: 5",
                         '.minimum_duty: does not belong to a high_frequency card; expected none', at: '    minimum_duty: 5')
    assert_waves_refused('amplitude: 255', 'amplitude: 256', '.amplitude: is 256; expected 1 to 255')
    assert_waves_refused("    resonance_hz_per_k: 20\n", '', ': has no resonance_hz_per_k; expected 0 to 255', at: '')
    assert_waves_refused('card: high_frequency', 'card: pwm',
                         '.amplitude: does not belong to a pwm card; expected none', at: 'amplitude: 255')
    assert_waves_refused('card: high_frequency', 'card: servo',
                         '.card: is servo; expected pwm or non_pwm or high_frequency or analog')
  end

  def test_SWR_DRIVE_006_a_motor_is_driven_by_its_cards_alone
    assert_waves_refused('motor: shinsei', 'motor: dti', '.card: is high_frequency, which does not drive a dti motor; ' \
                                                         'expected pwm or non_pwm or analog', at: 'card: high_frequency')
    assert_waves_refused('motor: shinsei', 'motor: steam', '.motor: is steam; expected shinsei or piezo or dti')
  end

  def test_SWR_DRIVE_006_a_magnitude_is_one_that_card_and_motor_have
    assert_refused(with('maximum_duty: 131071', 'maximum_duty: 262144'),
                   'axes[3].maximum_duty: is 262144; expected at most 262143, the most of a shinsei motor',
                   at: 'maximum_duty: 262144')
    assert_refused(with('minimum_duty: 13107', 'minimum_duty: 12000'),
                   'axes[3].minimum_duty: is 12000; expected at least 12452, the dead zone of a shinsei motor',
                   at: 'minimum_duty: 12000')
    assert_refused(with('card: pwm', 'card: analog'), 'axes[3].maximum_duty: is 131071; expected 1 to 65535',
                   at: 'maximum_duty: 131071')
    piezo = with("card: pwm\n    motor: shinsei", "card: pwm\n    motor: piezo").sub('minimum_duty: 13107', 'minimum_duty: 2622')
    assert_equal [0, ''], compile(piezo).first(2)
    assert_match(/motor_type = \(uint8_t\)MOTOR_TYPE_PIEZO/, compile(piezo).last)
  end
end

# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the drives of a robot file are compiled to the words of their cards, or refused with line and field.

require 'minitest/autorun'
require_relative 'changed_robot'

class TestRobotWaves < Minitest::Test
  include ChangedRobot

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

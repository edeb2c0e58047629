# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the hand of a robot's file is compiled to ticks, or refused with line and field where it could swing or push by itself.

require 'minitest/autorun'
require_relative 'prostate_file'

class TestRobotHand < Minitest::Test
  include ProstateFile

  def test_SWR_COOP_010_the_table_has_the_hand_in_ticks_and_millinewton
    assert_includes compile(WHOLE).last,
                    '.hand = {.dead_zone_mn = 300U, .gain_q8 = 2133U, .speed_ticks_per_s = 8333U, .stop_ticks_per_s2 = 333334U}'
  end

  def test_SWR_COOP_010_a_robot_without_a_hand_is_moved_by_none
    assert_includes compile(WHOLE.sub(/^hand:.*\n/, '')).last,
                    '.hand = {.dead_zone_mn = 0U, .gain_q8 = 0U, .speed_ticks_per_s = 0U, .stop_ticks_per_s2 = 0U}'
  end

  VIBRATION = /, vibration: \{[^}]*\}/

  # 116 of 116.67 ticks; of 125 ms a stroke has what a rest of 15 ms leaves.
  def test_SWR_VIB_706_the_table_has_the_vibration_in_ticks_and_cycles
    assert_includes compile(WHOLE).last,
                    '.vibration = {.amplitude_ticks = 116U, .stroke_cycles = 110U, .dwell_cycles = 15U, .periods = 3U}'
  end

  def test_SWR_VIB_706_a_hand_without_a_vibration_has_none
    assert_match VIBRATION, WHOLE
    none = '.vibration = {.amplitude_ticks = 0U, .stroke_cycles = 0U, .dwell_cycles = 0U, .periods = 0U}'
    assert_includes compile(WHOLE.sub(VIBRATION, '')).last, none
    assert_includes compile(WHOLE.sub(/^hand:.*\n/, '')).last, none
  end

  # The most that may stand there is not refused: 0.1 mm need 130 ms a stroke.
  def test_SWR_VIB_706_the_fastest_that_fits_is_taken
    slow = WHOLE.sub('amplitude_mm: 0.07, frequency_hz: 4', 'amplitude_mm: 0.1, frequency_hz: 3.44')
    assert_includes compile(slow).last, '.vibration = {.amplitude_ticks = 166U, .stroke_cycles = 130U'
  end

  def assert_refused(old, new, reason)
    assert_includes WHOLE, old
    assert_refused_at('hand', WHOLE.sub(old, new), reason)
  end

  VIBRATION_REFUSALS = {
    'more than 0.1 mm' => ['amplitude_mm: 0.07', 'amplitude_mm: 0.101', 'hand.vibration.amplitude_mm: is 0.101; expected 0.01 to 0.1'],
    'strokes above the acceleration of the axis' =>
      ['frequency_hz: 4', 'frequency_hz: 6', 'hand.vibration.frequency_hz: leaves a stroke 68 ms of 108; expected 4.06 at most'],
    'a vibration without a number of periods' => [', periods: 3', '', 'periods'],
    'a train without an end' => ['periods: 3', 'periods: 11', 'hand.vibration.periods: is 11; expected 1 to 10']
  }.freeze

  VIBRATION_REFUSALS.each do |what, (old, new, reason)|
    define_method("test_SWR_VIB_706_refuses_#{what.tr(' .', '_')}") do
      assert_refused(old, new, reason)
    end
  end

  # 2.5 s and a rest.
  def test_SWR_VIB_751_refuses_a_vibration_that_lasts_too_long
    assert_refused 'periods: 3', 'periods: 10', 'hand.vibration.periods: takes 2515 ms with its rests; expected 2000 at most'
    assert_includes compile(WHOLE.sub('periods: 3', 'periods: 7')).last, '.periods = 7U'
  end

  # 0.07 mm of the needle's axis are 116 ticks.
  def test_SWR_VIB_751_refuses_a_vibration_within_the_deadband
    deadband = /deadband_ticks: 3( +# 1\.8 um)/
    assert_match deadband, WHOLE
    assert_includes compile(WHOLE.sub(deadband, 'deadband_ticks: 58\1')).last, '.amplitude_ticks = 116U'
    assert_refused_at('hand', WHOLE.sub(deadband, 'deadband_ticks: 59\1'),
                      'amplitude_mm: is 116 ticks beside a deadband of 59; expected 118 at least')
  end

  def test_SWR_VIB_706_refuses_strokes_above_the_speed_of_the_axis
    text = WHOLE.gsub('acceleration_ticks_per_s2: 40000', 'acceleration_ticks_per_s2: 1000000')
    assert_refused_at('hand', text.sub('frequency_hz: 4', 'frequency_hz: 20'),
                      'frequency_hz: leaves a stroke 10 ms of 24; expected 12.82 at most')
  end

  # [what is written, what is written instead, what the refusal says]
  REFUSALS = {
    'a hand that a tremor moves' => ['dead_zone_n: 0.3', 'dead_zone_n: 0.09', 'hand.dead_zone_n: is 0.09; expected 0.1 to 2'],
    'a gain that swings' => ['gain_mm_per_s_n: 5', 'gain_mm_per_s_n: 8.1', 'hand.gain_mm_per_s_n: is 8.1; expected 0.1 to 8'],
    'a speed above that of any hand' => ['speed_mm_per_s: 5', 'speed_mm_per_s: 5.1', 'hand.speed_mm_per_s: is 5.1; expected 0.1 to 5'],
    'a slope that stops late' => ['stop_mm_per_s2: 200', 'stop_mm_per_s2: 199', 'hand.stop_mm_per_s2: is 199; expected 200 to 1000'],
    'a hand without a dead zone' => ['dead_zone_n: 0.3, ', '', 'dead_zone_n']
  }.freeze

  REFUSALS.each do |what, (old, new, reason)|
    define_method("test_SWR_COOP_010_refuses_#{what.tr(' ', '_')}") do
      assert_refused(old, new, reason)
    end
  end

  def test_SWR_COOP_010_refuses_a_speed_above_that_of_the_axis
    needle = WHOLE[/^  - name: insertion\n(?:    .*\n)+/]
    slow = { ' speed_ticks_per_s' => 5000, 'home_speed_ticks_per_s' => 1250, 'home_time_ms' => 300_000 }
           .reduce(needle) { |text, (key, value)| text.sub(/#{key}: \d+/, "#{key}: #{value}") }
    assert_refused_at('hand', WHOLE.sub(needle, slow).sub(VIBRATION, ''), 'hand.speed_mm_per_s: is 5; expected 0.1 to 2.999')
  end

  def test_SWR_COOP_010_refuses_a_filter_that_delays_the_force
    status, errors, = compile(WHOLE.sub('cutoff_hz: 40', 'cutoff_hz: 39'))
    assert_equal 1, status
    assert_match(/force\.hand\.cutoff_hz: is 39; expected at least 40 where a hand moves the needle/, errors)
  end

  def test_SWR_COOP_010_refuses_a_hand_of_a_robot_without_a_force_sensor
    without = WHOLE.sub(/^cards:.*\n/, '').sub(/^force:\n(?:  .*\n)+/, '')
    status, errors, = compile(without)
    assert_equal 1, status
    assert_match(/hand: is of a robot without a force sensor; expected one/, errors)
  end
end

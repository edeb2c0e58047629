# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the force sensor of a robot file is compiled to the units of the core, or refused with line and field.

require 'minitest/autorun'
require_relative 'changed_robot'

class TestRobotForce < Minitest::Test
  include ChangedRobot

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
end

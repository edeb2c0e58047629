# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the list of Eva's alarms is exactly what Eva reports, each with a reason, and no more of them are open
# than before.

require 'minitest/autorun'
require 'tmpdir'
require_relative '../eva/alarm_list'
require_relative '../eva/analysis'
require_relative '../eva/reasons'

class TestAlarmList < Minitest::Test
  KNOWN = { 'gate.c' => { 'open_gate' => { 'index_bound: i < 10U' => 'the caller has refused it',
                                           'shift: 0 ≤ i < 32' => 'open' } } }.freeze

  def test_SWR_TOOL_230_the_alarms_of_the_list_are_no_problem
    assert_empty list.problems('neuro', alarms)
  end

  def test_SWR_TOOL_230_an_alarm_that_is_not_listed_is_a_problem
    assert_equal ['new alarm: gate.c: close_gate: shift: 0 ≤ n < 32'],
                 list.problems('neuro', alarms << alarm('close_gate', 'shift: 0 ≤ n < 32'))
  end

  def test_SWR_TOOL_230_one_more_place_of_a_listed_alarm_is_a_problem
    twice = [alarms.first, alarm('open_gate', 'shift: 0 ≤ i < 32', 2)]
    assert_includes list.problems('neuro', twice), 'new alarm: gate.c: open_gate: 2 x shift: 0 ≤ i < 32'
  end

  def test_SWR_TOOL_230_a_listed_alarm_that_is_gone_is_a_problem
    assert_equal ['listed, but gone: gate.c: open_gate: shift: 0 ≤ i < 32'], list.problems('neuro', alarms.take(1))
  end

  def test_SWR_TOOL_230_an_alarm_without_a_reason_is_a_problem
    assert_includes list(reason: '').problems('neuro', alarms), 'without a reason: gate.c: open_gate: index_bound: i < 10U'
  end

  def test_SWR_TOOL_232_more_open_alarms_than_the_ceiling_are_a_problem
    assert_equal ['2 alarms of neuro are open, more than the ceiling of 1'], list(reason: 'open').problems('neuro', alarms)
  end

  def test_SWR_TOOL_232_a_ceiling_above_the_open_alarms_is_a_problem
    assert_equal ['1 alarms of neuro are open: lower its ceiling from 2'], list(ceiling: 2).problems('neuro', alarms)
  end

  def test_SWR_TOOL_232_a_list_that_is_written_anew_keeps_reasons_and_does_not_raise_the_ceiling
    Dir.mktmpdir do |folder|
      written = list(file: "#{folder}/alarms.yml")
      written.replace('neuro', alarms << alarm('close_gate', 'shift: 0 ≤ n < 32'))
      written.save
      assert_equal ['2 alarms of neuro are open, more than the ceiling of 1'],
                   Eva::AlarmList.read("#{folder}/alarms.yml").problems('neuro', alarms << alarm('close_gate', 'shift: 0 ≤ n < 32'))
    end
  end

  def test_SWR_TOOL_500_a_reason_whose_line_is_there_is_no_problem
    assert_empty problems_of_reason('i was compared: gate.c `if (i < 10U)`', "if (i <\n    10U) {\n")
  end

  def test_SWR_TOOL_500_a_reason_whose_line_has_changed_is_a_problem
    assert_equal ['line of a reason is gone: gate.c: open_gate: index: gate.c `if (i < 10U)`'],
                 problems_of_reason('i was compared: gate.c `if (i < 10U)`', "if (i < 11U) {\n")
  end

  def test_SWR_TOOL_500_a_reason_without_a_line_is_a_problem
    assert_equal ['reason without a line of a source: gate.c: open_gate: index'], problems_of_reason('it cannot be', '')
  end

  private

  def problems_of_reason(reason, source)
    Dir.mktmpdir do |folder|
      File.write("#{folder}/gate.c", source)
      Eva::Reasons.new(folder).problems('gate.c: open_gate: index' => reason)
    end
  end

  def list(reason: nil, ceiling: 1, file: '')
    known = Marshal.load(Marshal.dump(KNOWN))
    known['gate.c']['open_gate']['index_bound: i < 10U'] = reason if reason
    Eva::AlarmList.new(file, 'ceiling' => { 'neuro' => ceiling }, 'alarms' => { 'neuro' => known })
  end

  def alarms
    [alarm('open_gate', 'index_bound: i < 10U'), alarm('open_gate', 'shift: 0 ≤ i < 32')]
  end

  def alarm(function, text, times = 1)
    Eva::Alarm.new(file: 'gate.c', function: function, text: text, times: times)
  end
end

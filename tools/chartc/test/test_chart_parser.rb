# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require_relative '../lib/read/parser'

# What the parser makes of a file: the model that interpreter and emitters share.
class TestChartParser < Minitest::Test
  NAMESPACES = 'xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0"'
  REQ = 'bs:req="SWR-CHART-001"'

  def test_SWR_CHART_001_events_stand_in_order_of_first_appearance
    chart = engine('<state id="a"><transition event="b.x"/><onentry><raise event="c"/></onentry></state>' \
                   '<state id="d"><transition event="a b.x"/></state>', extra: %w[z c])
    assert_equal %w[b.x c a z], chart.events
  end

  def test_SWR_CHART_001_an_event_means_itself_and_what_it_begins
    chart = engine('<state id="a"><transition event="error"/><transition event="error.*"/><transition event="err"/>' \
                   '<transition event="error.io other"/><transition event="*"/></state>', extra: %w[errors])
    every = %w[error err error.io other errors]
    assert_equal [%w[error error.io], %w[error error.io], %w[err], %w[error.io other], every],
                 chart.transitions.map(&:events)
  end

  def test_SWR_CHART_001_a_wildcard_alone_is_not_eventless
    refute engine('<state id="a"><transition event="*" target="a"/></state>').transitions.first.eventless?
  end

  def test_SWR_CHART_001_done_events_exist_where_something_waits_for_them
    states = '<parallel id="p"><state id="a"><final id="x"/></state><state id="b"><final id="y"/></state>' \
             '<transition event="%s"/></parallel>'
    assert_equal %w[go], engine(format(states, 'go')).events
    assert_equal %w[done.state.a], engine(format(states, 'done.state.a')).internal_events
    assert_equal %w[done.state.p done.state.a done.state.b], engine(format(states, '*')).events
  end

  def test_SWR_CHART_001_events_of_timers_are_internal_unless_the_scenario_sends_them
    states = '<state id="a"><onentry><send event="late" delay="1s"/></onentry><transition event="late"/></state>'
    assert_equal %w[late], engine(states).internal_events
    assert_empty engine(states, extra: %w[late]).internal_events
  end

  def test_SWR_CHART_001_transitions_are_numbered_as_they_stand
    chart = engine('<state id="a"><state id="b"><transition event="x"/></state><transition event="x"/></state>')
    assert_equal [[1, 'T1', 'b'], [2, 'T2', 'a']], chart.transitions.map { |one| [one.number, one.id, one.source.id] }
  end

  def test_SWR_CHART_001_states_without_id_get_one
    assert_equal ["a", "final of line 1"], engine('<state id="a"/><final/>').states.map(&:id)
  end

  def test_SWR_CHART_001_watchdogs_round_down_and_hold_offs_up
    assert_equal [:down, 9000], timer('watchdog', '10ms')
    assert_equal [:up, 12_000], timer('hold_off', '10ms')
    assert_equal [:down, 9000], timer('watchdog', '9ms')
    assert_equal [:up, 9000], timer('hold_off', '9ms')
    assert_equal [:up, 3000], timer('hold_off', '1us')
  end

  def test_SWR_CHART_001_a_send_without_delay_lasts_one_tick_and_an_internal_one_is_raised
    chart = engine('<state id="a"><onentry><send event="x"/><send event="y" target="#_internal"/></onentry></state>')
    sent, raised = chart.states.first.entry
    assert_equal [0, 1000, :up], [sent.timer.delay_us, sent.timer.threshold_us, sent.timer.rounding]
    assert_equal 'y', raised.event
  end

  def test_SWR_CHART_001_delays_are_whole_microseconds_in_any_unit
    { 'delay="1.5s"' => 1_500_000, 'delay=".5s"' => 500_000, 'delay="0.25ms"' => 250, 'delay="3us"' => 3,
      %q(delayexpr="'1s'") => 1_000_000, %q(delayexpr='".5s"') => 500_000 }.each do |delay, microseconds|
      assert_equal microseconds, delay_of(delay), delay
    end
    ['delay="0.5us"', 'delay="1.s"', 'delay="1.2.3s"', 'delay="-1s"', 'delayexpr="1s"', %q(delayexpr="'1s"),
     'delayexpr="Var1"'].each { |delay| assert_equal 15, assert_raises(Chart::Refusal) { delay_of(delay) }.rule, delay }
  end

  def test_SWR_CHART_001_actions_come_before_the_other_content
    chart = engine('<state id="a"><transition event="x" bs:do="beep ring"><raise event="y"/></transition></state>')
    assert_equal [Chart::Act, Chart::Act, Chart::Raise], chart.transitions.first.content.map(&:class)
  end

  def test_SWR_CHART_001_the_safe_configuration_of_a_suite_chart_is_its_first
    states = '<parallel id="p"><state id="a"><state id="a1"/><state id="a2"/></state>' \
             '<state id="b" initial="h"><history id="h" type="deep"><transition target="b21"/></history>' \
             '<state id="b1"/><state id="b2"><state id="b20"/><state id="b21"/></state></state></parallel>'
    assert_equal %w[a1 b21], engine(states).safe.map(&:id)
    assert_equal %w[a2 b20], engine(states, root: 'initial="a2 b20"').safe.map(&:id)
  end

  def test_SWR_CHART_001_a_history_is_never_active
    chart = engine('<state id="a"><history id="h"><transition target="b"/></history><state id="b">' \
                   '<transition cond="!In(\'h\')" event="x"/></state></state>')
    assert_equal [:not, [:boolean, false]], chart.transitions.first.guard
  end

  def test_SWR_CHART_001_data_have_bounds
    data = '<datamodel><data id="i" expr="-1" bs:min="-5"/><data id="b" expr="true"/>' \
           '<data id="in" expr="false" bs:input="true"/></datamodel>'
    chart = engine("#{data}<state id=\"a\"/>")
    assert_equal [[:integer, -1, -5, 32_767], [:boolean, true, nil, nil], [:input, false, nil, nil]],
                 chart.variables.map { |one| [one.kind, one.initial, one.minimum, one.maximum] }
    assert_equal %w[in], chart.inputs.map(&:name)
  end

  def test_SWR_CHART_001_expressions_bind_as_in_ecmascript
    { '!a && b || c' => [:or, [:and, [:not, [:variable, 'a']], [:variable, 'b']], [:variable, 'c']],
      '1 + 2 - 3 < 4 === true' =>
        [:compare, '==', [:compare, '<', [:subtract, [:add, [:number, 1], [:number, 2]], [:number, 3]], [:number, 4]],
         [:boolean, true]],
      "!(In('x.1-2') != false)" => [:not, [:compare, '!=', [:in, 'x.1-2'], [:boolean, false]]] }.each do |text, tree|
      assert_equal tree, Chart::Expression.parse(text)
    end
  end

  def test_SWR_CHART_001_expressions_have_the_value_of_ecmascript
    { '1 - 2 - 3 == -4' => true, 'n -1 >= 4' => true, '2 < 1 || b && !false' => true, 'b !== true' => false,
      'n + -2 <= 2' => false }.each do |text, value|
      found = Chart::Expression.value(Chart::Expression.parse(text)) { |_kind, name| { 'n' => 5, 'b' => true }[name] }
      assert_equal value, found, text
    end
  end

  def test_SWR_CHART_003_expressions_are_at_most_32_deep
    { '!' => '', '(' => ')', 'a && ' => '', '(a || ' => ')', '1 < ' => '' }.each do |before, after|
      deep = ->(count) { "#{before * count}1#{after * count}" }
      assert_kind_of Array, Chart::Expression.parse(deep.call(32))
      [33, 20_000].each do |count|
        assert_raises(Chart::Expression::TooDeep, before) { Chart::Expression.parse(deep.call(count)) }
      end
    end
  end

  def test_SWR_CHART_003_elements_are_at_most_32_deep
    nested = ->(count) { "#{'<state>' * count}#{'</state>' * count}" }
    assert_equal 31, engine(nested.call(31)).states.length
    [32, 20_000].each { |count| assert_equal 19, assert_raises(Chart::Refusal) { engine(nested.call(count)) }.rule }
  end

  def test_SWR_CHART_003_what_c_would_read_differently_is_no_expression
    ['', '1 +', '01', '1.5', 'a = b', 'a & b', 'i++', '--i', 'f(1)', 'a.b', 'a[0]', '_event', "'x'", "In(x)", 'a b',
     '((a)'].each do |text|
      assert_raises(Chart::Expression::Unsupported, text) { Chart::Expression.parse(text) }
    end
  end

  def test_SWR_CHART_001_a_prefix_for_scxml_and_attributes_of_others_do_no_harm
    text = '<s:scxml xmlns:s="http://www.w3.org/2005/07/scxml" xmlns:o="urn:other" version="1.0">' \
           '<s:state id="a" o:x="1"/></s:scxml>'
    assert_equal %w[a], Chart::Parser.parse('c.scxml', text, {}, mode: :engine).states.map(&:id)
  end

  def test_SWR_CHART_003_a_product_chart_has_nothing_of_others
    text = "<scxml #{NAMESPACES} xmlns:o=\"urn:other\"/>"
    refusal = assert_raises(Chart::Refusal) { Chart::Parser.parse('c.scxml', text, {}) }
    assert_equal 3, refusal.rule
  end

  private

  def engine(states, extra: [], root: '')
    text = "<scxml #{NAMESPACES} #{root}>#{states}</scxml>"
    Chart::Parser.parse('c.scxml', text, {}, mode: :engine, extra_events: extra)
  end

  def delay_of(attribute)
    engine("<state id=\"a\"><onentry><send event=\"x\" #{attribute}/></onentry></state>").timers.first.delay_us
  end

  # Rounding and threshold of a timer, with ticks of 3 ms.
  def timer(kind, delay)
    states = "<state id=\"a\" #{REQ}><onentry><send id=\"t\" event=\"x\" delay=\"#{delay}\" bs:limit=\"l_us\" " \
             "bs:kind=\"#{kind}\"/></onentry></state>"
    root = 'datamodel="ecmascript" name="c" initial="a" bs:safe="a" bs:tick="3ms"'
    limit = delay.to_i * (delay.end_with?('ms') ? 1000 : 1)
    limits = { 'cycle_us' => 3000, 'l_us' => limit }
    chart = Chart::Parser.parse('c.scxml', "<scxml #{NAMESPACES} #{root}>#{states}</scxml>", limits)
    [chart.timers.first.rounding, chart.timers.first.threshold_us]
  end
end

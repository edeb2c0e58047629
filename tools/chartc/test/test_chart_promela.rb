# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require_relative '../proof/spin'
require_relative '../lib/compiled'

# The Promela of a chart under SPIN against the walk: same configurations, same pairs, same outcome of each.
class TestChartPromela < Minitest::Test
  HEAD = '<scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" ' \
         'datamodel="ecmascript">'
  LIMITS = { 'cycle_us' => 1000, 'short_us' => 500_000, 'heat_limit_us' => 2_000_000 }.freeze

  # Shallow and deep history, with and without record, on the way to it and as an initial state.
  HISTORY = <<~XML
    <state id="on">
      <initial><transition target="lately"><raise event="again"/></transition></initial>
      <history id="lately"><transition target="a"><raise event="first"/></transition></history>
      <history id="deeply" type="deep"><transition target="b2"/></history>
      <transition event="off" target="rest"/>
      <state id="a"><transition event="next first" target="b"/></state>
      <state id="b" initial="b1">
        <state id="b1"><transition event="next" target="b2"/><transition event="again" target="b2"/></state>
        <state id="b2"><transition event="next" target="a"/><onexit><raise event="first"/></onexit></state>
      </state>
    </state>
    <state id="rest">
      <transition event="shallow" target="lately"/>
      <transition event="deep" target="deeply"/>
      <transition event="plain" target="on"/>
    </state>
  XML

  # Transitions that leave a common state, done events of nested parallels, the end of the chart.
  REGIONS = <<~XML
    <parallel id="p">
      <transition event="e" target="q"/>
      <transition event="done.state.p" target="q"/>
      <state id="r" initial="r1">
        <state id="r1"><transition event="e" cond="In('s2')" target="r2"/><transition event="f" target="r2"/></state>
        <final id="r2"/>
      </state>
      <parallel id="n">
        <state id="s" initial="s1">
          <state id="s1"><transition event="f" target="s2"/><transition event="e" target="t3 s2"/></state>
          <state id="s2"><transition event="g" target="s3"/></state>
          <final id="s3"/>
        </state>
        <state id="t" initial="t1">
          <state id="t1"><transition event="g" target="t2"/><transition event="e f" target="t3"/></state>
          <final id="t2"/>
          <state id="t3"><transition event="h" target="p"/><transition event="g" target="end"/></state>
        </state>
      </parallel>
    </parallel>
    <state id="q"><transition event="f" target="n"/></state>
    <final id="end"/>
  XML

  # Integers and booleans of the chart's own, eventless transitions, names that Promela must change.
  DATA = <<~XML
    <datamodel>
      <data id="count" expr="0" bs:min="-1" bs:max="3"/><data id="is_odd" expr="false"/>
      <data id="is_free" expr="false" bs:input="true"/>
    </datamodel>
    <state id="a.b">
      <transition event="up" cond="count &lt; 3 &amp;&amp; is_free" target="a.b">
        <assign location="count" expr="count + 1"/><assign location="is_odd" expr="!is_odd"/>
      </transition>
      <transition event="down" cond="count - 1 &gt;= -1"><assign location="count" expr="count - 1"/></transition>
      <transition cond="count == 3 &amp;&amp; is_odd" target="a-b"/>
    </state>
    <state id="a-b"><transition event="down" target="a.b"><assign location="count" expr="0"/></transition></state>
  XML

  # One region of five: a timer that its own event stops and the event of the next one starts again.
  TIMED = <<~XML
    <state id="s%<n>d">
      <state id="w%<n>d">
        <onentry><send id="t%<n>d" event="e%<n>d" delay="1s"/></onentry><onexit><cancel sendid="t%<n>d"/></onexit>
        <transition event="e%<n>d" target="z%<n>d"/><transition event="e%<next>d" target="w%<n>d"/>
      </state>
      <state id="z%<n>d"/>
    </state>
  XML
  TIMERS = "<parallel id=\"p\">#{(1..5).map { |n| format(TIMED, n: n, next: (n % 5) + 1) }.join}</parallel>"

  def test_SWR_CHART_001_spin_agrees_on_every_construct_of_the_product_profile
    file = File.join(__dir__, 'charts', 'sample.scxml')
    assert_agreed Chart::Parser.parse(file, File.read(file), LIMITS)
  end

  def test_SWR_CHART_001_spin_agrees_on_histories
    assert_agreed engine(HISTORY)
  end

  def test_SWR_CHART_001_spin_agrees_on_nested_parallels_and_done_events
    assert_agreed engine(REGIONS)
  end

  def test_SWR_CHART_001_spin_agrees_on_data_and_eventless_transitions
    assert_agreed engine(DATA)
  end

  def test_SWR_CHART_001_spin_agrees_on_timers_that_expire_together
    assert_agreed engine(TIMERS)
  end

  def test_SWR_CHART_001_a_chart_without_events_has_one_configuration
    agreed = assert_agreed engine('<state id="a"><transition target="b"/></state><state id="b"/>')
    assert_equal [1, 0], [agreed.configurations, agreed.pairs]
  end

  # Each is a wrong reading of the standard.
  FAULTS = {
    'a history that is not recorded' => [/^  past_lately_b = .*\n/, ''],
    'content of the wrong default' => ['recall_lately && !(past_lately_a || past_lately_b)', 'recall_lately'],
    'a state that is not left' => [/^  in_b2 = in_b2 && .*\n/, ''],
    'an exit without its content' => ['put(EVENT_first)', 'skip'],
    'a wrong target' => [/enter_rest = fate\[1\] == TAKEN/, 'enter_rest = fate[2] == TAKEN'],
    'another transition number' => ['(in_a -> 2', '(in_a -> 3'],
    'an event that is lost' => [':: first < last ->', ':: false ->'],
    'an event that is never sent' => [/      :: in_chart ->\n          stimulus = EVENT_deep\n/, '']
  }.freeze

  def test_SWR_CHART_001_a_wrong_model_is_found
    document = engine(HISTORY)
    walk = Chart::Walk.new(document).run
    text = Chart::Promela.new(document).emit
    FAULTS.each do |name, (right, wrong)|
      refute_equal text, text.sub(right, wrong), name
      refute_empty Spin.new.compare(document, walk, text.sub(right, wrong)).differences, name
    end
  end

  def test_SWR_CHART_001_a_difference_is_reported_in_names
    document = engine(HISTORY)
    text = Chart::Promela.new(document).emit.sub('(in_a -> 2', '(in_a -> 3')
    differences = Spin.new.compare(document, Chart::Walk.new(document).run, text).differences
    assert_equal 'start: taken is ["T2"] here and ["T3"] with SPIN', differences.first
    assert_includes differences, 'in_on in_a in_b2, next: only SPIN comes here'
  end

  def test_SWR_CHART_002_a_violated_property_gives_the_events_that_lead_there
    { "<bs:invariant id=\"P-I01\" expr=\"!In('s3')\"/>" => 'g',
      "<bs:response id=\"P-I02\" on=\"f\" from=\"In('r1')\" expr=\"!In('s2')\"/>" => 'f',
      "<bs:only id=\"P-I03\" on=\"e h\" from=\"In('p')\" expr=\"In('end')\"/>" => 'g' }.each do |property, last|
      found = compared(engine(REGIONS + property))
      assert_equal [1, property[/P-I\d+/], []], [found.errors, found.violation, found.differences]
      assert_equal ['start', last], [found.trail.first, found.trail.last]
    end
  end

  ACTS = <<~XML
    <datamodel><data id="is_free" expr="false" bs:input="true"/></datamodel>
    <state id="a"><transition event="go" cond="is_free" target="b" bs:do="one two"/><transition event="no" bs:do="two"/>
      <transition event="go" cond="!is_free" bs:do="one"/></state>
    <state id="b"><onentry><send id="t" event="end" delay="1s"/></onentry><onexit><cancel sendid="t"/></onexit>
      <transition event="go" target="b"/><transition event="end" target="a"/></state>
  XML

  def test_SWR_CHART_033_what_a_step_does_is_asserted_too
    { 'on="go" from="is_free &amp;&amp; In(\'a\')" does="one"' => 'go with is_free', 'on="no" does=""' => 'no',
      'on="end" starts="t"' => 't expired', 'on="go" from="In(\'b\')" stays="true"' => 'go' }.each do |response, last|
      found = compared(engine("#{ACTS}<bs:response id=\"P-I01\" #{response}/>"))
      assert_equal [1, 'P-I01', last], [found.errors, found.violation, found.trail.last], response
    end
  end

  def test_SWR_CHART_033_what_a_step_does_as_it_should_is_not_violated
    assert_agreed engine(ACTS + ['on="go" from="is_free &amp;&amp; In(\'a\')" does="one two" starts="t"',
                                 'on="no" from="In(\'a\')" does="two" stays="true"', 'on="go" from="In(\'b\')" starts="t"',
                                 'on="go" from="!is_free &amp;&amp; In(\'a\')" does="one" stays="true"']
      .each_with_index.map { |response, number| "<bs:response id=\"P-I0#{number}\" #{response}/>" }.join)
  end

  def test_SWR_CHART_002_properties_that_hold_are_not_violated
    properties = "<bs:response id=\"P-I01\" on=\"done.state.p\" expr=\"In('q')\"/>" \
                 "<bs:only id=\"P-I02\" on=\"g\" from=\"In('p')\" expr=\"In('end')\"/>" \
                 "<bs:invariant id=\"P-I03\" expr=\"!In('q') || !In('p')\"/>" \
                 "<bs:reachable id=\"P-I04\" expr=\"In('end')\"/>" \
                 "<bs:start id=\"P-I05\" expr=\"In('p')\" does=\"\"/><bs:damaged id=\"P-I06\" expr=\"In('p')\"/>"
    assert_agreed engine(REGIONS + properties)
  end

  def test_SWR_CHART_001_the_same_chart_gives_the_same_bytes
    assert_equal Chart::Promela.new(engine(HISTORY)).emit, Chart::Promela.new(engine(HISTORY)).emit
  end

  def test_SWR_CHART_001_what_spin_cannot_read_is_no_agreement
    document = engine(HISTORY)
    walk = Chart::Walk.new(document).run
    assert_raises(SpinVerifier::Failed) { Spin.new.compare(document, walk, 'active proctype a() { nonsense }') }
  end

  private

  def engine(body)
    Chart::Parser.parse('chart.scxml', "#{HEAD}#{body}</scxml>", {}, mode: :engine)
  end

  def compared(document)
    Spin.new.compare(document, Chart::Walk.new(document).run)
  end

  def assert_agreed(document)
    walk = Chart::Walk.new(document).run
    found = Spin.new.compare(document, walk)
    assert_empty found.differences
    assert_equal [walk.reached.length, walk.pair_count], [found.configurations, found.pairs]
    assert_equal [walk.reached.length + 1, 0, nil], [found.stored, found.errors, found.violation]
    found
  end
end

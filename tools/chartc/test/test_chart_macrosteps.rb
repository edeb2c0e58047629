# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require_relative 'own_charts'

# The interpreter against the rules of the SCXML recommendation: which transitions are taken, and in which order.
class TestChartMacrosteps < Minitest::Test
  include OwnCharts

  # --- selection --------------------------------------------------------------------------------------------------

  def test_SWR_CHART_001_a_descendant_goes_before_its_ancestor_and_document_order_decides_in_a_state
    start('<state id="a"><transition event="go" target="c"/><state id="a1">
           <transition event="go" cond="false" target="a"/><transition event="go" target="b"/>
           <transition event="go" target="c"/></state></state><state id="b"/><state id="c"/>')
    event('go')
    assert_equal %w[b], leaves
  end

  def test_SWR_CHART_001_an_ancestor_steps_in_when_no_guard_of_the_descendant_holds
    start('<state id="a"><transition event="go" target="b"/><state id="a1">
           <transition event="go" cond="In(\'b\')" target="a"/></state></state><state id="b"/>')
    event('go')
    assert_equal %w[b], leaves
  end

  def test_SWR_CHART_001_of_two_regions_that_leave_the_parallel_the_first_wins
    start('<parallel id="p"><state id="a"><transition event="go" target="x"/></state>
           <state id="b"><transition event="go" target="y"/></state></parallel><state id="x"/><state id="y"/>')
    assert_equal %w[T1], event('go').taken.map(&:id)
    assert_equal %w[x], leaves
  end

  # Region a selects the parallel's own transition; region b has one of its own, which is deeper in the tree.
  def test_SWR_CHART_001_a_deeper_source_wins_over_the_parallel_although_it_comes_later
    start('<parallel id="p"><transition event="go" target="x"/><state id="a"/>
           <state id="b"><state id="b1"><transition event="go" target="b2"/></state><state id="b2"/></state></parallel>
           <state id="x"/>')
    assert_equal %w[T2], event('go').taken.map(&:id)
    assert_equal %w[a b2], leaves
  end

  def test_SWR_CHART_001_regions_without_conflict_step_together
    start('<parallel id="p"><state id="a"><state id="a1"><transition event="go" target="a2"/></state><state id="a2"/>
           </state><state id="b"><state id="b1"><transition event="go" target="b2"/></state><state id="b2"/></state>
           </parallel>')
    assert_equal [%w[T1 T2], 1], [event('go').taken.map(&:id), @outcome.microsteps]
    assert_equal %w[a2 b2], leaves
  end

  def test_SWR_CHART_001_a_transition_that_two_regions_select_is_taken_once
    start('<parallel id="p"><transition event="go"><raise event="one"/></transition><state id="a"/><state id="b"/>
           </parallel>')
    assert_equal [%w[one], 1], [event('go').raised, @outcome.taken.length]
  end

  def test_SWR_CHART_001_guards_see_states_and_data_from_before_the_step
    start('<datamodel><data id="x" expr="0"/></datamodel><parallel id="p">
           <state id="a"><state id="a1"><transition event="go" target="a2"><assign location="x" expr="1"/></transition>
           </state><state id="a2"/></state>
           <state id="b"><state id="b1"><transition event="go" cond="x == 0 &amp;&amp; In(\'a1\')" target="b2"/></state>
           <state id="b2"/></state></parallel>')
    event('go')
    assert_equal [%w[a2 b2], { 'x' => 1 }], [leaves, @outcome.after.data]
  end

  # --- macrosteps -------------------------------------------------------------------------------------------------

  def test_SWR_CHART_001_eventless_transitions_go_before_raised_events_and_those_in_their_order
    start('<state id="a"><transition event="go" target="b"><raise event="one"/><raise event="two"/></transition></state>
           <state id="b"><transition target="c"/><transition event="one" target="x"/></state>
           <state id="c"><transition event="two" target="x"/><transition event="one" target="d"/></state>
           <state id="d"><transition event="two" target="e"/></state><state id="e"/><state id="x"/>')
    assert_equal %w[T1 T2 T5 T6], event('go').taken.map(&:id)
    assert_equal %w[e], leaves
    assert_equal [4, 3, 2], [@outcome.microsteps, @outcome.rounds, @outcome.queued]
  end

  def test_SWR_CHART_001_a_raised_event_that_nobody_takes_counts_as_a_round
    start('<state id="a"><transition event="go"><raise event="one"/></transition></state>
           <state id="b"><transition event="one"/></state>')
    assert_equal [1, 1, 1], [event('go').microsteps, @outcome.rounds, @outcome.queued]
  end

  def test_SWR_CHART_001_an_internal_event_from_outside_does_nothing
    document = engine('<state id="a"><onentry><send id="t" event="late"/></onentry>
                       <transition event="late" target="b"/></state><state id="b"/>')
    assert_equal %w[late], document.internal_events
    interpreter = Chart::Interpreter.new(document)
    outcome = interpreter.dispatch(interpreter.start.after, 'late', {})
    assert_equal [%w[a], [], []], [outcome.after.leaves, outcome.taken, outcome.events]
  end

  def test_SWR_CHART_001_assignments_follow_each_other_and_say_when_they_leave_the_range
    start('<datamodel><data id="x" expr="1" bs:min="0" bs:max="5"/><data id="y" expr="false"/></datamodel>
           <state id="a"><transition event="go"><assign location="x" expr="x + 1"/><assign location="x" expr="x + x"/>
           <assign location="y" expr="x == 4"/></transition></state>')
    assert_equal({ 'x' => 4, 'y' => true }, event('go').after.data)
    assert_empty @outcome.faults
    assert_equal [[34, '"x" becomes 10']], event('go').faults.map { |fault| [fault.rule, fault.words] }
  end

  def test_SWR_CHART_001_an_endless_macrostep_names_the_transitions_that_turn
    start('<state id="a"><transition event="go" target="b"/></state><state id="b"><transition target="c"/></state>
           <state id="c"><transition target="b"/></state>')
    assert_equal %w[T2 T3], assert_raises(Chart::Endless) { event('go') }.cycle.map(&:id).sort
    start('<state id="a"><transition event="go"><raise event="go"/></transition></state>')
    assert_raises(Chart::Endless) { event('go') }
  end

  def test_SWR_CHART_001_a_macrostep_is_endless_too_when_its_queue_grows_for_ever
    start('<state id="a"><transition event="go"><raise event="go"/><raise event="go"/></transition></state>')
    assert_raises(Chart::Endless) { event('go') }
  end

  def test_SWR_CHART_001_a_long_macrostep_that_ends_is_not_endless
    start('<datamodel><data id="x" expr="0"/></datamodel><state id="a"><transition event="go" target="b"/></state>
           <state id="b"><transition cond="x &lt; 100" target="b"><assign location="x" expr="x + 1"/></transition>
           <transition cond="x == 100" target="c"/></state><state id="c"/>')
    assert_equal 102, event('go').microsteps
    assert_equal %w[c], leaves
  end

  # --- timers -----------------------------------------------------------------------------------------------------

  TIMERS = <<~CHART
    <state id="a"><onentry><send id="slow" event="slow" delay="2s"/><send id="fast" event="fast"/></onentry>
      <transition event="slow"><cancel sendid="fast"/></transition><transition event="fast" target="b"/></state>
    <state id="b"><transition event="slow" target="a"/></state>
  CHART

  def test_SWR_CHART_001_a_send_starts_a_timer_also_without_delay
    start(TIMERS)
    assert_equal [%w[a], %w[slow fast]], [leaves, @outcome.after.armed]
    assert_equal %w[slow fast], @outcome.started
    expire('fast')
    assert_equal [%w[b], %w[slow], %w[fast]], [leaves, @outcome.after.armed, @outcome.events]
  end

  def test_SWR_CHART_001_timers_that_expire_together_go_in_document_order_unless_cancelled_by_an_earlier_one
    start(TIMERS)
    expire('fast', 'slow')
    assert_equal [%w[a], [], %w[slow]], [leaves, @outcome.after.armed, @outcome.events]
  end

  def test_SWR_CHART_001_a_timer_started_again_by_an_earlier_expiry_does_not_expire
    start('<state id="a"><onentry><send id="one" event="one"/><send id="two" event="two"/></onentry>
           <transition event="one" target="a"><cancel sendid="two"/></transition>
           <transition event="two" target="b"/></state><state id="b"/>')
    expire('one', 'two')
    assert_equal [%w[a], %w[one two], %w[one]], [leaves, @outcome.started, @outcome.events]
  end

  def test_SWR_CHART_001_a_timer_that_is_not_armed_does_not_expire
    start(TIMERS)
    expire('fast')
    expire('fast')
    assert_equal [%w[b], []], [leaves, @outcome.events]
  end

  def test_SWR_CHART_001_a_timer_started_again_is_a_fault_unless_it_was_cancelled
    chart = '<state id="a"><onentry><send id="t" event="late"/></onentry>CANCEL' \
            '<transition event="go" target="a"/></state>'
    start(chart.sub('CANCEL', '<onexit><cancel sendid="t"/></onexit>'))
    assert_equal [%w[t], []], [event('go').started, @outcome.faults]
    start(chart.sub('CANCEL', ''))
    assert_equal [33], event('go').faults.map(&:rule)
  end

  def test_SWR_CHART_001_a_timer_started_and_cancelled_in_one_macrostep_is_not_started
    start('<state id="a"><transition event="go" target="b"/></state>
           <state id="b"><onentry><send id="t" event="late"/></onentry><transition target="c"/></state>
           <state id="c"><onentry><cancel sendid="t"/></onentry></state>')
    assert_equal [[], []], [event('go').started, @outcome.after.armed]
  end

  # --- inputs -----------------------------------------------------------------------------------------------------

  def test_SWR_CHART_001_an_outcome_names_the_inputs_that_were_read
    start('<datamodel><data id="x" expr="false" bs:input="true"/><data id="y" expr="false" bs:input="true"/></datamodel>
           <state id="a"><transition event="go" cond="x &amp;&amp; y" target="b"/></state><state id="b"/>')
    assert_equal %w[x], event('go', 'x' => false, 'y' => true).reads
    assert_equal %w[x y], event('go', 'x' => true, 'y' => true).reads
    assert_equal %w[b], leaves
  end
end

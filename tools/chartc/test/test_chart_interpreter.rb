# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require_relative 'own_charts'

# The interpreter against the rules of the SCXML recommendation: what a step leaves, enters and finishes.
class TestChartInterpreter < Minitest::Test
  include OwnCharts

  # --- entering and leaving ---------------------------------------------------------------------------------------

  def test_SWR_CHART_001_starts_in_the_initial_states_of_all_regions
    start('<parallel id="p"><state id="a"><state id="a1"/><state id="a2"/></state>
           <state id="b" initial="b2"><state id="b1"/><state id="b2"/></state></parallel>')
    assert_equal %w[a1 b2], leaves
  end

  def test_SWR_CHART_001_leaves_inner_states_first_then_acts_then_enters_outer_states_first
    start(<<~CHART)
      <state id="a">#{notes('a')}<parallel id="p">#{notes('p')}<state id="x">#{notes('x')}</state>
        <state id="y">#{notes('y')}</state></parallel>
        <transition event="go" target="b1"><raise event="content"/></transition></state>
      <state id="b">#{notes('b')}<state id="b1">#{notes('b1')}</state></state>
    CHART
    assert_equal %w[in_a in_p in_x in_y], @outcome.raised
    assert_equal %w[out_y out_x out_p out_a content in_b in_b1], event('go').raised
  end

  def test_SWR_CHART_001_an_initial_element_acts_after_the_entry_of_its_parent
    start(<<~CHART)
      <state id="a">#{notes('a')}<initial><transition target="a2"><raise event="default"/></transition></initial>
        <state id="a1"/><state id="a2">#{notes('a2')}</state></state>
    CHART
    assert_equal %w[a2], leaves
    assert_equal %w[in_a default in_a2], @outcome.raised
  end

  def test_SWR_CHART_001_several_targets_enter_their_regions_and_the_others_by_default
    start('<state id="off"><transition event="go" target="a2 c2"/></state><parallel id="p">
           <state id="a"><state id="a1"/><state id="a2"/></state><state id="b"><state id="b1"/><state id="b2"/></state>
           <state id="c"><state id="c1"/><state id="c2"/></state></parallel>')
    event('go')
    assert_equal %w[a2 b1 c2], leaves
  end

  def test_SWR_CHART_001_an_external_transition_leaves_its_source_and_an_internal_one_does_not
    start(<<~CHART)
      <state id="a">#{notes('a')}<transition event="out" target="a2"/>
        <transition event="in" target="a2" type="internal"/><state id="a1"/><state id="a2"/></state>
    CHART
    assert_equal %w[out_a in_a], event('out').raised
    assert_empty event('in').raised
    assert_equal %w[a2], leaves
  end

  def test_SWR_CHART_001_an_internal_transition_to_the_outside_is_an_external_one
    start("<state id='a'>#{notes('a')}<transition event='go' target='a' type='internal'/><state id='a1'/></state>")
    assert_equal %w[out_a in_a], event('go').raised
  end

  # A parallel is no compound state: no transition stays inside one.
  def test_SWR_CHART_001_an_external_transition_of_a_region_leaves_the_whole_parallel
    start("<parallel id='p'>#{notes('p')}<state id='a'><transition event='go' target='a'/></state>
           <state id='b'>#{notes('b')}</state></parallel>")
    assert_equal %w[out_b out_p in_p in_b], event('go').raised
  end

  def test_SWR_CHART_001_a_targetless_transition_acts_and_leaves_nothing
    start("<state id='a'>#{notes('a')}<transition event='go'><raise event='done'/></transition></state>")
    assert_equal %w[done], event('go').raised
    assert_equal [%w[a], 1], [leaves, @outcome.taken.length]
  end

  # --- histories --------------------------------------------------------------------------------------------------

  HISTORY = <<~CHART
    <state id="out"><transition event="back" target="h"/></state>
    <state id="a"><transition event="leave" target="out"/>
      <onentry><raise event="in_a"/></onentry>
      <history id="h" type="DEPTH"><transition target="a2"><raise event="default"/></transition></history>
      <state id="a1"><state id="a11"><transition event="on" target="a12"/></state><state id="a12"/></state>
      <state id="a2"><onentry><raise event="in_a2"/></onentry><transition event="on" target="a12"/></state>
    </state>
  CHART

  def test_SWR_CHART_001_a_history_without_record_takes_its_default_after_the_entry_of_its_parent
    start(HISTORY.sub('DEPTH', 'deep'))
    assert_equal %w[in_a default in_a2], event('back').raised
    assert_equal %w[a2], leaves
  end

  def test_SWR_CHART_001_a_shallow_history_brings_back_the_child_and_its_initial_state
    start(HISTORY.sub('DEPTH', 'shallow'))
    %w[back on leave].each { |name| event(name) }
    assert_equal({ 'h' => %w[a1] }, @outcome.after.history)
    assert_equal %w[in_a], event('back').raised
    assert_equal %w[a11], leaves
  end

  def test_SWR_CHART_001_a_deep_history_brings_back_the_leaf
    start(HISTORY.sub('DEPTH', 'deep'))
    %w[back on leave].each { |name| event(name) }
    assert_equal({ 'h' => %w[a12] }, @outcome.after.history)
    event('back')
    assert_equal %w[a12], leaves
  end

  def test_SWR_CHART_001_histories_of_a_parallel_remember_all_its_regions
    %w[deep shallow].zip([%w[a2 b2], %w[a1 b1]]) do |depth, expected|
      start(<<~CHART)
        <parallel id="p"><history id="h" type="#{depth}"><transition target="a"/></history>
          <state id="a"><state id="a1"><transition event="on" target="a2"/></state><state id="a2"/></state>
          <state id="b"><state id="b1"><transition event="on" target="b2"/></state><state id="b2"/></state>
          <transition event="leave" target="out"/></parallel>
        <state id="out"><transition event="back" target="h"/></state>
      CHART
      %w[on leave back].each { |name| event(name) }
      assert_equal expected, leaves, depth
    end
  end

  def test_SWR_CHART_001_a_record_leaves_nothing_of_the_default
    start(<<~CHART)
      <state id="a"><history id="h" type="deep"><transition target="a12"/></history>
        <transition event="leave" target="b"/><state id="a1">#{notes('a1')}<state id="a11"/><state id="a12"/></state>
        <state id="a2"/><transition event="on" target="a2"/></state>
      <state id="b"><transition event="back" target="h"/></state>
    CHART
    %w[on leave].each { |name| event(name) }
    assert_equal [[], %w[a2]], [event('back').raised, leaves]
  end

  # --- done events ------------------------------------------------------------------------------------------------

  DONE = <<~CHART
    <parallel id="p"><transition event="done.state.p" target="end"/>
      <state id="a"><transition event="done.state.a"/><state id="a1"><transition event="go" target="a2"/></state>
        <final id="a2"/></state>
      <state id="b"><state id="b1"><transition event="on" target="b2"/></state><final id="b2"/></state></parallel>
    <final id="end"><onentry><raise event="on"/></onentry></final>
  CHART

  def test_SWR_CHART_001_a_final_state_raises_the_done_event_of_its_parent
    start(DONE)
    assert_equal %w[done.state.a], event('go').raised
    assert_equal %w[a2 b1], leaves
  end

  def test_SWR_CHART_001_a_done_event_that_nobody_waits_for_is_not_raised
    start('<state id="a"><state id="a1"><transition event="go" target="a2"/></state><final id="a2"/></state>')
    assert_equal [[], 0], [event('go').raised, @outcome.queued]
  end

  def test_SWR_CHART_001_a_parallel_is_done_with_its_last_region
    start(DONE)
    event('on')
    assert_equal %w[done.state.a done.state.p on], event('go').raised
    assert_equal %w[end], leaves
  end

  def test_SWR_CHART_001_a_chart_at_its_end_takes_nothing
    start(DONE)
    %w[go on].each { |name| event(name) }
    assert_empty event('go').taken
    assert_equal %w[end], leaves
  end

  private

  # Says by raised events when a state is entered and left.
  def notes(id)
    "<onentry><raise event='in_#{id}'/></onentry><onexit><raise event='out_#{id}'/></onexit>"
  end
end

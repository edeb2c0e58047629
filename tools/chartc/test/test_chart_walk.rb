# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require_relative 'own_charts'

# The walk, and the rules that it decides: one small chart that passes, and what breaks each rule.
class TestChartWalk < Minitest::Test
  include OwnCharts

  # --- the walk ---------------------------------------------------------------------------------------------------

  def test_SWR_CHART_002_the_walk_finds_every_configuration_and_pair
    walk = walk_of(CHART)
    assert_equal [%w[closed off], %w[open off], %w[closed warming], %w[closed on]], walk.reached.keys.map(&:leaves)
    assert_equal (4 * 4 + 1) * 4, walk.pair_count
    assert_equal 'start with is_allowed, warm_up expires', walk.path_to(walk.reached.keys.last)
    assert_equal [[:event, 'start'], { 'is_allowed' => true, 'is_kept' => false }],
                 walk.steps_to(walk.reached.keys.last).first
    assert_equal [1, 0, 0], [walk.most_microsteps, walk.most_rounds, walk.most_raised]
  end

  def test_SWR_CHART_002_legal_configurations_that_are_never_reached_are_stepped_and_count_for_nothing
    walk = walk_of(CHART)
    unreached = walk.pairs.reject(&:reachable)
    assert_equal [%w[open warming], %w[open on]], unreached.map { |pair| pair.before.leaves }.uniq
    assert_equal [%w[warm_up], []], unreached.map { |pair| pair.before.armed }.uniq
    assert_equal walk.pairs.length, walk.reachable_pairs.length + unreached.length
    assert_equal %w[LAMP-T02], taken(unreached.find { |pair| pair.stimulus.last == 'shut' })
  end

  def test_SWR_CHART_002_inputs_that_nobody_read_share_one_run
    walk = walk_of(CHART)
    start = walk.pairs.find { |pair| pair.stimulus == [:event, 'start'] }
    assert_equal [[], %w[LAMP-T03], [], %w[LAMP-T03]], start.outcomes.map { |one| one.taken.map(&:id) }
    assert_equal [2, 1], [start, walk.pairs.first].map { |pair| pair.outcomes.uniq(&:object_id).length }
  end

  def test_SWR_CHART_002_armed_timers_expire_in_every_combination
    sends = ->(count) { (1..count).map { |n| "<send id='t#{n}' event='e#{n}' delay='1s'/>" }.join }
    [[3, 7], [4, 15], [5, 5 + 10]].each do |count, expected|
      walk = Chart::Walk.new(engine("<state id='a'><onentry>#{sends.call(count)}</onentry></state>")).run
      first = walk.pairs.select { |pair| pair.before.armed.length == count }
      assert_equal expected, first.length
    end
  end

  def test_SWR_CHART_002_the_walk_of_a_conformance_chart_explores_its_data_and_histories
    walk = Chart::Walk.new(engine(<<~BODY)).run
      <datamodel><data id="x" expr="0" bs:min="0" bs:max="3"/></datamodel>
      <state id="a"><history id="h"><transition target="a1"/></history><transition event="leave" target="b"/>
        <state id="a1"><transition event="go" target="a2"/></state>
        <state id="a2"><transition event="go" cond="x &lt; 3" target="a1"><assign location="x" expr="x + 1"/>
        </transition></state></state>
      <state id="b"><transition event="back" target="h"/></state>
    BODY
    assert_equal [0, 1, 2, 3], walk.reached.keys.map { |snapshot| snapshot.data['x'] }.uniq
    assert_equal [{}, { 'h' => %w[a1] }, { 'h' => %w[a2] }], walk.reached.keys.map(&:history).uniq
    assert walk.pairs.all?(&:reachable)
  end

  def test_SWR_CHART_002_a_chart_with_too_many_configurations_is_refused
    data = %w[x y].map { |id| "<data id='#{id}' expr='0' bs:min='0' bs:max='9'/>" }.join
    steps = %w[x y].map do |id|
      "<transition event='#{id}' cond='#{id} &lt; 9'><assign location='#{id}' expr='#{id} + 1'/></transition>"
    end
    document = engine("<datamodel>#{data}</datamodel><state id='a'>#{steps.join}</state>")
    assert_equal 100, Chart::Walk.new(document, 100).run.reached.length
    assert_equal 19, assert_raises(Chart::Refusal) { Chart::Walk.new(document, 99).run }.rule
  end

  # --- the rules --------------------------------------------------------------------------------------------------

  def test_SWR_CHART_002_refuses_a_macrostep_without_end
    refusal = refusal_of([%r{(event="pull" target="open" [^>]*)/>}, '\1><raise event="shut"/></transition>'],
                         [%r{(event="shut" target="closed" [^>]*)/>}, '\1><raise event="pull"/></transition>'])
    assert_equal 11, refusal.rule
    assert_match(/LAMP-T0[12], LAMP-T0[12] lead back to where they began, reached by: pull;/, refusal.message)
  end

  def test_SWR_CHART_002_refuses_a_state_that_is_never_reached
    refusal = refusal_of(['target="on"', 'target="off"'], *[[/ *<bs:.*\n/, '']] * 5)
    assert_equal [20, line_of('id="on"')], [refusal.rule, refusal.line]
  end

  def test_SWR_CHART_002_refuses_a_history_that_is_never_entered
    history = '<history id="memory" type="deep"><transition target="off"/></history>'
    refusal = refusal_of(['<state id="power" initial="off">', "\\0#{history}"])
    assert_equal 20, refusal.rule
    assert_match(/"memory"/, refusal.message)
  end

  # Such a state is left before the macrostep ends.
  def test_SWR_CHART_002_a_state_passed_through_is_reached
    passed = '<state id="passed" bs:req="SWR-CHART-001">' \
             '<transition bs:id="LAMP-T10" target="on" bs:req="SWR-CHART-001"/></state>'
    changes = [['target="on"', 'target="passed"'], [/(?=<state id="on")/, passed]]
    assert_sound(*changes)
    walk = walk_of(changed(*changes))
    refute_includes walk.pairs.flat_map { |pair| pair.before.leaves }, 'passed'
    assert_equal [2, 1, 0], [walk.most_microsteps, walk.most_rounds, walk.most_raised]
  end

  def test_SWR_CHART_002_refuses_a_transition_that_is_never_taken
    refusal = refusal_of([/(?=<transition bs:id="LAMP-T05")/, transition('event="shut" cond="In(\'open\')"')])
    assert_equal 21, refusal.rule
    assert_match(/LAMP-T10 is never taken/, refusal.message)
  end

  def test_SWR_CHART_002_refuses_two_transitions_of_one_state_that_are_enabled_together
    refusal = refusal_of([/(?=<transition bs:id="LAMP-T03")/, transition('event="start" cond="is_kept"')])
    assert_equal 22, refusal.rule
    assert_match(/LAMP-T03 and LAMP-T10 .* by "start" in closed off is_allowed is_kept, reached by: start with/,
                 refusal.message)
  end

  def test_SWR_CHART_002_a_state_may_take_what_the_state_around_it_would_take
    assert_sound(['<state id="power" initial="off">', "\\0#{transition('event="stop"')}"],
                 ['bs:ignores="start stop"', 'bs:ignores="start"'])
  end

  def test_SWR_CHART_002_refuses_an_event_that_is_neither_taken_nor_ignored
    refusal = refusal_of([' bs:ignores="start stop"', ' bs:ignores="stop"'])
    assert_equal [25, line_of('id="closed"')], [refusal.rule, refusal.line]
    assert_match(/"start" does nothing in closed off with !is_allowed, reached by: [a-z, ]+;/, refusal.message)
  end

  def test_SWR_CHART_002_refuses_a_timer_that_expires_for_nothing
    refusal = refusal_of(['event="is_warm" target', 'event="is_warm" cond="is_kept" target'])
    assert_equal 25, refusal.rule
    assert_match(/"is_warm" does nothing in closed warming with !is_kept, reached by: [a-z_, ]+;/, refusal.message)
  end

  def test_SWR_CHART_002_an_ignore_speaks_for_the_states_inside
    assert_sound(['<state id="power"', '\\0 bs:ignores="start"'], ['bs:ignores="start stop"', 'bs:ignores="stop"'],
                 [/(id="warming".*) bs:ignores="start"/, '\1'], [/(id="on".*) bs:ignores="start"/, '\1'])
  end

  def test_SWR_CHART_002_refuses_an_ignore_that_nothing_needs
    refusal = refusal_of(['bs:ignores="shut"', 'bs:ignores="shut pull"'])
    assert_equal [26, line_of('id="closed"')], [refusal.rule, refusal.line]
    inside = refusal_of(['<state id="power"', '\\0 bs:ignores="stop start"'])
    assert_equal [26, line_of('id="off"')], [inside.rule, inside.line]
  end

  def test_SWR_CHART_002_refuses_a_timer_that_is_started_while_it_runs
    document = engine('<state id="a"><onentry><send id="t" event="late" delay="1s"/></onentry>
                       <transition event="go" target="a"/></state>')
    refusal = assert_raises(Chart::Refusal) { Chart::Walk.new(document).run }
    assert_equal 33, refusal.rule
    assert_match(/"t" is started while it runs, reached by: go;/, refusal.message)
  end

  def test_SWR_CHART_002_refuses_a_value_out_of_range
    document = engine('<datamodel><data id="x" expr="0" bs:min="0" bs:max="1"/></datamodel>
                       <state id="a"><transition event="go"><assign location="x" expr="x + 1"/></transition></state>')
    refusal = assert_raises(Chart::Refusal) { Chart::Walk.new(document).run }
    assert_equal [34, 2], [refusal.rule, refusal.line]
    assert_match(/"x" becomes 2, reached by: go, go;/, refusal.message)
  end

  def test_SWR_CHART_002_refuses_a_guard_that_is_never_false
    refusal = refusal_of(['event="is_warm" target', 'event="is_warm" cond="In(\'closed\')" target'])
    assert_equal [35, line_of('LAMP-T04')], [refusal.rule, refusal.line]
    assert_match(/LAMP-T04 is never false/, refusal.message)
  end

  def test_SWR_CHART_002_a_conformance_chart_may_overlap_ignore_and_hold_dead_states
    document = engine('<state id="a"><transition event="go" cond="true"/><transition event="go"/></state>
                       <state id="b"/>')
    Chart::WalkChecks.run(document, Chart::Walk.new(document).run)
    pass
  end

  private

  def taken(pair)
    pair.outcomes.first.taken.map(&:id)
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require_relative '../chart/command'

# The interpreter against the rules of the SCXML recommendation, and the walk against both.
class TestChartInterpreter < Minitest::Test
  FILE = File.join(__dir__, 'charts', 'sample.scxml')
  LIMITS = { 'short_us' => 500_000, 'heat_limit_us' => 2_000_000 }.freeze
  NOTHING = { 'is_allowed' => false, 'is_strong' => false }.freeze
  ALLOWED = { 'is_allowed' => true, 'is_strong' => false }.freeze
  STRONG = { 'is_allowed' => true, 'is_strong' => true }.freeze

  def setup
    @document = Chart::Parser.parse(FILE, File.read(FILE), LIMITS)
    @interpreter = Chart::Interpreter.new(@document)
  end

  def test_SWR_CHART_001_starts_in_the_initial_state_of_every_region
    assert_equal [%w[cold idle], []], configuration(@interpreter.start)
  end

  def test_SWR_CHART_001_a_guard_sees_the_configuration_before_the_step
    outcome = dispatch(%w[cold idle], [], 'warm', ALLOWED)
    assert_equal %w[cold idle], outcome.leaves
    assert_equal %w[low fast], dispatch(%w[cold slow], [], 'warm', ALLOWED).leaves
  end

  def test_SWR_CHART_001_a_raised_event_is_taken_in_the_same_macrostep_by_the_other_region
    outcome = dispatch(%w[cold slow], [], 'warm', ALLOWED)
    assert_equal %w[SAMPLE-T02 SAMPLE-T11], outcome.taken.map(&:id)
    assert_equal %w[heat_limit fast_end], outcome.armed
  end

  def test_SWR_CHART_001_a_chain_of_raised_events_runs_to_its_end
    outcome = @interpreter.expire(%w[low slow], %w[heat_limit], %w[heat_limit], NOTHING)
    assert_equal %w[SAMPLE-T03 SAMPLE-T12 SAMPLE-T01], outcome.taken.map(&:id)
    assert_equal [%w[cold idle], []], configuration(outcome)
    assert_equal %w[report], outcome.actions
  end

  def test_SWR_CHART_001_a_descendant_goes_before_its_ancestor
    armed = %w[heat_limit boost_end]
    assert_equal %w[SAMPLE-T09], dispatch(%w[high idle], armed, 'adjust', STRONG).taken.map(&:id)
    assert_equal %w[SAMPLE-T04], dispatch(%w[high idle], armed, 'adjust', ALLOWED).taken.map(&:id)
  end

  def test_SWR_CHART_001_an_internal_transition_keeps_the_timer_of_its_source
    outcome = dispatch(%w[high idle], %w[heat_limit boost_end], 'adjust', NOTHING)
    assert_equal [%w[low idle], %w[heat_limit]], configuration(outcome)
    assert_empty outcome.started
  end

  def test_SWR_CHART_001_an_external_transition_restarts_the_timer_of_its_source
    outcome = dispatch(%w[high idle], %w[heat_limit boost_end], 'warm', NOTHING)
    assert_equal [%w[low idle], %w[heat_limit]], configuration(outcome)
    assert_equal %w[heat_limit], outcome.started
  end

  def test_SWR_CHART_001_a_transition_without_target_leaves_nothing
    outcome = @interpreter.expire(%w[high idle], %w[heat_limit boost_end], %w[boost_end], NOTHING)
    assert_equal [%w[high idle], %w[heat_limit]], configuration(outcome)
    assert_equal %w[beep], outcome.actions
  end

  def test_SWR_CHART_001_timers_that_expire_together_go_in_document_order
    outcome = @interpreter.expire(%w[high fast], %w[heat_limit boost_end fast_end], %w[heat_limit fast_end], NOTHING)
    assert_equal %w[SAMPLE-T03 SAMPLE-T12 SAMPLE-T01], outcome.taken.map(&:id)
  end

  def test_SWR_CHART_001_an_internal_event_from_outside_does_nothing
    outcome = dispatch(%w[cold slow], [], 'started', ALLOWED)
    assert_equal %w[cold slow], outcome.leaves
    assert_empty outcome.taken
  end

  # The domain of an external transition that starts at a region is the whole chart: a parallel is no
  # compound state. The compiler refuses such a transition (rule 17), the interpreter obeys the standard.
  def test_SWR_CHART_001_an_external_transition_of_a_region_leaves_all_regions
    text = File.read(FILE).sub('target="cold" type="internal"', 'target="cold"')
    document = Chart::Parser.parse(FILE, text, LIMITS)
    outcome = Chart::Interpreter.new(document).dispatch(%w[low fast], %w[heat_limit fast_end], 'trip', NOTHING)
    assert_equal [%w[cold idle], []], configuration(outcome)
  end

  def test_SWR_CHART_001_the_walk_finds_every_configuration_and_pair
    walk = Chart::Walk.new(@document).run
    assert_equal 9, walk.legal_configurations.length
    assert_equal 8, walk.reached.length
    assert_equal 360, walk.pair_count
    assert_equal 'begin', walk.path_to([%w[cold slow], []])
  end

  def test_SWR_CHART_001_the_bound_of_raised_events_is_the_longest_chain
    assert_equal 2, Chart::Flat.new(@document).raise_bound
    most = Chart::Walk.new(@document).run.pairs.flat_map(&:outcomes).map(&:raised_count).max
    assert_equal 2, most
  end

  private

  def dispatch(leaves, armed, event, inputs)
    @interpreter.dispatch(leaves, armed, event, inputs)
  end

  def configuration(outcome)
    [outcome.leaves, outcome.armed]
  end
end

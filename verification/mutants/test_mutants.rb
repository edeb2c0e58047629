# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: an element left out of a product chart, or replaced there, is refused by a rule or a property.
# A mutant that is not refused stands in equivalent.yml with its reason, and does on every pair what the chart does. Those that
# were once accepted are refused by name; some of them weaken several places, so that they fit each other.
# One of the actions that may be added to a place is tried; `make mutants` tries all.

require 'etc'
require 'minitest/autorun'
require 'yaml'
require_relative 'judge'
require_relative 'mutants'

class TestMutants < Minitest::Test
  LISTED = YAML.safe_load_file(File.join(__dir__, 'equivalent.yml'))
  CHARTS = ProductCharts::ALL.to_h { |file, chart| [chart.document.name, [file, chart]] }.freeze
  TREES = CHARTS.transform_values { |file, _chart| Chart.tree(file) }

  # With every action in every place.
  WHOLE = ENV.key?('WHOLE')

  def self.mutants(tree)
    Mutants.of(tree, ProductCharts::LIMITS, whole: WHOLE)
  end

  # name of a chart => { name of a mutant => the rule that refuses it, :same or :different }
  def self.verdicts
    @verdicts ||= begin
      all = TREES.flat_map { |name, tree| mutants(tree).map { |mutant| [name, mutant] } }
      shares = all.each_with_index.group_by { |_one, number| number % Etc.nprocessors }.values
      shares.map { |share| Judge.beside { share.map { |(name, one), _number| [name, one.name, of(name, one)] } } }
            .flat_map(&:value).group_by(&:first).transform_values { |rows| rows.to_h { |row| row.drop(1) } }
    end
  end

  def self.of(name, mutant)
    file, chart = CHARTS.fetch(name)
    refusal, mutated = Judge.judge(file, mutant.tree)
    return refusal.rule if refusal

    Judge.behaviour(mutated) == Judge.behaviour(chart) ? :same : :different
  end

  CHARTS.each_key do |name|
    define_method("test_SWR_CHART_030_SWR_CHART_041_every_mutant_of_#{name}_is_refused_or_listed") do
      verdicts = TestMutants.verdicts.fetch(name)
      listed = LISTED.fetch(name, []).flat_map { |row| row.fetch('mutants') }
      accepted = verdicts.reject { |_mutant, verdict| verdict.is_a?(Integer) }
      assert_empty accepted.keys - listed, 'nothing refuses these: say in a property what they violate'
      assert_empty listed - accepted.keys, 'these are refused, or are no mutants; remove them from equivalent.yml'
      assert_empty accepted.select { |_mutant, verdict| verdict == :different }.keys, 'these are not equivalent'
    end
  end

  def test_SWR_CHART_030_reasons_are_listed_for_charts_that_there_are
    assert_empty LISTED.keys - CHARTS.keys
    LISTED.each_value { |rows| rows.each { |row| assert_match(/\S\.\z/, row.fetch('because')) } }
  end

  def test_SWR_CHART_030_a_mutant_that_no_property_speaks_of_is_found
    file, chart = CHARTS.fetch('loop_guard')
    tree = Chart.tree(file, File.read(file).sub(/^.*id="LOOP-I05".*\n/, ''))
    mutant = Mutants.of(tree, ProductCharts::LIMITS).find { |one| one.name == 'LOOP-T03 does not count_overrun' }
    refusal, mutated = Judge.judge(file, mutant.tree)
    assert_nil refusal
    refute_equal Judge.behaviour(chart), Judge.behaviour(mutated)
  end

  Minitest.after_run do
    counts = verdicts.values.flat_map(&:values).partition { |verdict| verdict.is_a?(Integer) }.map(&:length)
    puts format('mutants         %<refused>d refused, %<same>d the same', refused: counts.first, same: counts.last)
  end

  # name => [chart, the property that refuses it, changes]
  ONCE_ACCEPTED = {
    'a_pedal_that_opens_again_without_a_release' =>
      ['pedal_gate', 'PEDAL-I06', ['event="both_closed" target="unproven"', 'event="both_closed" target="pressed"']],
    'a_pedal_that_was_never_seen_released' =>
      ['pedal_gate', 'PEDAL-I06', ['bs:ignores="both_closed renew reset"', 'bs:ignores="renew reset"'],
       [/(?=<transition bs:id="PEDAL-T02")/,
        '<transition bs:id="MUTANT-T01" event="both_closed" target="pressed" bs:req="SWR-PEDAL-003"/>']],
    'a_renewal_that_is_ignored' =>
      ['pedal_gate', 'PEDAL-I07', [/^.*PEDAL-T08.*\n/, ''], ['id="closing" bs:ignores="', '\0renew ']],
    'a_reset_while_the_e_stop_is_pulled' =>
      ['estop_latch', 'ESTOP-I06', ['bs:ignores="opened reset"', 'bs:ignores="opened"'],
       [/(?=<transition bs:id="ESTOP-T02")/,
        '<transition bs:id="MUTANT-T01" event="reset" target="clear" bs:req="SWR-ESTOP-002"/>']],
    'a_stall_that_is_timed_anew_in_every_cycle' =>
      ['stall_watchdog', 'STALL-I06', ['bs:ignores="driven reset"', 'bs:ignores="reset"'],
       [/(?=<transition bs:id="STALL-T02")/,
        '<transition bs:id="MUTANT-T01" event="driven" target="watching" bs:req="SWR-STALL-001"/>']],
    'a_late_cycle_that_is_not_counted' =>
      ['loop_guard', 'LOOP-I05', [/(LOOP-T03.*) bs:do="count_overrun"/, '\1']],
    'a_move_without_homing' =>
      ['workphase', 'PHASE-I23', [/(PHASE-T19.*) &amp;&amp; is_homed/, '\1'], [/^.*PHASE-T21.*\n/, ''],
       [/(PHASE-T22.*) &amp;&amp; is_homed/, '\1']],
    'a_move_with_a_fault' =>
      ['workphase', 'PHASE-I24', [/(PHASE-T19.*) &amp;&amp; is_able/, '\1'], [/^.*PHASE-T22.*\n/, '']],
    'a_card_that_is_back_without_a_fresh_frame' =>
      ['card_link', 'LINK-I07', [' cond="is_fresh"', ''], [/reset(?=" bs:req="SWR-LINK-003)/, '']],
    'a_pedal_fault_that_is_reset_under_a_pressed_pedal' =>
      ['pedal_gate', 'PEDAL-I17', [' cond="is_released"', ''], [/reset(?=" bs:req="SWR-PEDAL-007)/, '']],
    'a_pedal_that_is_pressed_at_the_start' => ['pedal_gate', 'PEDAL-I22', ['initial="unproven"', 'initial="pressed"']],
    'a_damaged_pedal_that_is_pressed' => ['pedal_gate', 'PEDAL-I23', ['bs:safe="fault"', 'bs:safe="pressed"']],
    'an_enabled_axis_that_sets_its_position_when_it_is_enabled' =>
      ['axis', 'AXIS-I47', ['id="enabled" bs:ignores="enable"', 'id="enabled"'],
       [/(?=<transition bs:id="AXIS-T03")/,
        '<transition bs:id="MUTANT-T01" event="enable" bs:do="set_position" bs:req="SWR-AXIS-001"/>']],
    'an_axis_that_is_enabled_with_its_fault' =>
      ['axis', 'AXIS-I21', [/(AXIS-T02.*) cond="!is_fault_present"/, '\1'],
       [/(AXIS-T04.*) cond="!is_fault_present"/, '\1']]
  }.freeze

  ONCE_ACCEPTED.each do |what, (name, property, *changes)|
    define_method("test_SWR_CHART_030_#{what}_is_refused") do
      assert_includes refusal(name, changes).message, " #{property} is violated "
    end
  end

  def test_SWR_CHART_031_the_limit_of_another_requirement_is_refused
    long = ['delay="500ms" bs:limit="stall_time_us"', 'delay="60s" bs:limit="armed_hold_us"']
    assert_match(/CHART-R39 armed_hold_us is a limit of SWR-PEDAL-006/, refusal('stall_watchdog', [long]).message)
    short = ['delay="60s" bs:limit="armed_hold_us"', 'delay="500ms" bs:limit="stall_time_us"']
    assert_match(/CHART-R39 stall_time_us is a limit of SWR-STALL-001/, refusal('arming', [short]).message)
  end

  private

  def refusal(name, changes)
    file, = CHARTS.fetch(name)
    text = changes.reduce(File.read(file, encoding: 'UTF-8')) do |before, (from, to)|
      before.sub(from, to).tap { |after| refute_equal before, after, from.to_s }
    end
    Judge.judge(file, Chart.tree(file, text)).first || flunk('nothing refuses it')
  end
end

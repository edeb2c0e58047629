# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: no call of a product chart, in any reachable pair, needs more instructions, stack or RAM than
# verification/model/worst_case.yml approves. The measured figures are in build/conformance/worst_case.yml.

require 'minitest/autorun'
require_relative 'worst_case_table'

class TestWorstCase < Minitest::Test
  Table = WorstCase::Table
  CHARTS = ProductCharts::ALL.values.to_h { |chart| [chart.document.name, chart] }
  MEASURED = Hash.new { |all, name| all[name] = WorstCase::Measurement.new(CHARTS.fetch(name)) }

  Minitest.after_run { puts measured_table.tap(&:write).summary if MEASURED.length == CHARTS.length }

  def self.measured_table
    Table.new(CHARTS.keys.to_h { |name| [name, MEASURED[name].row] })
  end

  def test_SWR_CHART_008_no_figure_is_above_the_approved_one
    assert_empty self.class.measured_table.complaints(Table.approved)
  end

  CHARTS.each do |name, chart|
    define_method("test_SWR_CHART_008_every_pair_of_#{name}_is_measured_on_both_processors") do
      counts = %w[x86 arm].map { |processor| MEASURED[name].pairs(processor).length }
      assert_equal [chart.walk.pair_count] * 2, counts
    end
  end

  def test_SWR_CHART_008_a_figure_that_grew_is_named_with_its_chart_its_witness_and_the_command
    now = Table.approved
    Table::GATED.each do |key|
      before = lowered('axis', key)
      assert_equal 1, now.complaints(before).length
      assert_match(/\Aaxis: #{key} grew from #{before.rows['axis'][key]} to .*: make worst-case-approve\z/,
                   now.complaints(before).first)
    end
    assert_includes now.complaints(lowered('axis', 'arm_instructions')).first, "(#{now.rows['axis']['arm_witness']})"
  end

  def test_SWR_CHART_008_a_chart_that_came_or_went_must_be_approved
    now = Table.approved
    less = Table.new(now.rows.reject { |name, _row| name == 'axis' })
    assert_equal ['axis is not approved; if it must be, approve it anew: make worst-case-approve'], now.complaints(less)
    assert_equal ['axis is approved, but no chart; if it must be, approve it anew: make worst-case-approve'],
                 less.complaints(now)
  end

  def test_SWR_CHART_008_code_that_does_more_raises_the_figures
    longer = WorstCase::Measurement.new(CHARTS.fetch('card_link')) do |source|
      with(source, "if (card_link_is_intact(self)) {\n",
           "volatile uint32_t more[8];\n    more[0] = 1U;\n    if (card_link_is_intact(self) && (more[0] != 0U)) {\n")
    end
    complaints = Table.new('card_link' => longer.row).complaints(Table.new('card_link' => MEASURED['card_link'].row))
    assert_equal %w[x86_instructions arm_instructions stack_bytes],
                 complaints.map { |line| line[/\Acard_link: (\w+) grew/, 1] }
  end

  def test_SWR_CHART_008_counts_are_the_same_on_every_run
    again = WorstCase::Measurement.new(CHARTS.fetch('pedal_gate'))
    %w[x86 arm].each { |processor| assert_equal MEASURED['pedal_gate'].pairs(processor), again.pairs(processor) }
    assert_equal MEASURED['pedal_gate'].row, again.row
  end

  # "Give 0" and "return": nothing that prepares a call counts.
  def test_SWR_CHART_008_a_check_that_checks_nothing_counts_two_instructions
    idle = WorstCase::Measurement.new(CHARTS.fetch('card_link')) do |source|
      with(source, 'if (!card_link_is_intact(self) || !card_link_is_in_leaves(self)) {', 'if (false) {')
    end
    assert_equal [2, 2], idle.row.values_at('x86_check_instructions', 'arm_check_instructions')
  end

  def test_SWR_CHART_008_the_stack_is_that_of_the_deepest_path
    graph = <<~GRAPH
      node: { title: "dispatch" label: "dispatch\\na.c:9:1\\n40 bytes (static)" }
      node: { title: "a.c:step" label: "step\\na.c:5:1\\n16 bytes (static)" }
      node: { title: "a.c:take.part.0" label: "take.part.0\\na.c:1:1\\n8 bytes (static)" }
      node: { title: "contract_broken" label: "contract_broken\\na.h:1:1" shape : ellipse }
      edge: { sourcename: "dispatch" targetname: "a.c:take.part.0" label: "a.c:10:5" }
      edge: { sourcename: "dispatch" targetname: "a.c:step" label: "a.c:11:5" }
      edge: { sourcename: "a.c:step" targetname: "a.c:take.part.0" label: "a.c:6:5" }
      edge: { sourcename: "a.c:step" targetname: "contract_broken" label: "a.c:7:5" }
    GRAPH
    assert_equal 64, WorstCase::Stack.new(graph).deepest(%w[dispatch])
    dynamic = WorstCase::Stack.new(graph.sub('(static)', '(dynamic)'))
    error = assert_raises(WorstCase::Failed) { dynamic.deepest(%w[dispatch]) }
    assert_equal 'the stack of dispatch is unknown', error.message
  end

  def test_SWR_CHART_008_a_function_that_gcc_made_one_with_its_like_needs_the_stack_of_that
    graph = <<~GRAPH
      node: { title: "dispatch" label: "dispatch\\na.c:9:1\\n40 bytes (static)" }
      node: { title: "a.c:one" label: "one\\na.c:5:1\\n16 bytes (static)" }
      edge: { sourcename: "dispatch" targetname: "a.c:two" label: "a.c:11:5" }
    GRAPH
    places = { 'dispatch' => [0, 8], 'one' => [8, 4], 'two' => [8, 4], 'three' => [12, 4] }
    assert_equal 56, WorstCase::Stack.new(graph, places).deepest(%w[dispatch])
    [graph.gsub('two', 'three'), graph.gsub('two', 'four')].each do |strange|
      assert_raises(WorstCase::Failed) { WorstCase::Stack.new(strange, places).deepest(%w[dispatch]) }
    end
  end

  def test_SWR_CHART_008_a_call_that_does_other_than_the_walk_says_is_not_counted
    error = assert_raises(WorstCase::Failed) do
      WorstCase::Measurement.new(CHARTS.fetch('card_link')) do |source|
        with(source, "    chart_trace_add(&self->trace, self->now_us, 2U);\n", '')
      end
    end
    assert_match(/gave 3/, error.message)
  end

  private

  def lowered(name, key)
    rows = Table.approved.rows
    Table.new(rows.merge(name => rows.fetch(name).merge(key => rows[name][key] - 1)))
  end

  def with(source, old, new)
    assert_includes source, old
    source.sub(old, new)
  end
end

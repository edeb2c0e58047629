# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../lib/compiled'
require_relative '../lib/emit/c/header'
require_relative '../lib/emit/c/source'
require_relative '../lib/emit/tests/paths_test'
require_relative '../proof/generated_test'
require_relative 'own_charts'

# Rule under test: the generated test of the paths drives the compiled chart through every transition, both outcomes of
# every guard and every pair of successive transitions, and each of its tests goes red for its own fault.
class TestChartPaths < Minitest::Test
  include OwnCharts

  SAMPLE = File.join(__dir__, 'charts', 'sample.scxml')
  SAMPLE_LIMITS = { 'cycle_us' => 1000, 'short_us' => 500_000, 'heat_limit_us' => 2_000_000 }.freeze
  CHART = Chart::Compiled.from(SAMPLE, File.read(SAMPLE), SAMPLE_LIMITS)
  CODE = Chart::C::Source.new(CHART.document, CHART.walk).emit
  # Conditions of guards, in the functions that choose a transition.
  GUARD = /(?<=if \()(?=!?\(?(?:inputs|before)->)(.*)(?=\) \{)/

  class << self
    attr_reader :folder

    # Compiled once for all tests; each fault then compiles the chart alone.
    def built
      @built ||= begin
        @folder = Dir.mktmpdir
        Minitest.after_run { FileUtils.remove_entry(@folder) }
        File.write(File.join(@folder, 'sample_chart.h'), Chart::C::Header.new(CHART.document, CHART.walk).emit)
        test = File.join(@folder, 'test_sample_paths.c')
        File.write(test, Chart::PathsTest.new(CHART.document, CHART.walk).emit)
        GeneratedTest.new(test, @folder, @folder)
      end
    end
  end

  def test_SWR_CHART_009_the_sample_chart_passes
    assert_empty red(CODE)
  end

  CHART.document.transitions.each do |transition|
    name = transition.id.downcase.tr('-', '_')
    define_method("test_SWR_CHART_009_#{name}_dropped_is_noticed_by_its_own_test") do
      refute_empty red(broken(/(?<!void )take_#{name}\([^)]*\);/, '')).grep(/_#{name}_is_taken/)
    end
  end

  CODE.scan(GUARD).each_with_index do |(guard), index|
    define_method("test_SWR_CHART_009_guard_#{index + 1}_turned_is_noticed") do
      refute_empty red(CODE.sub(/(?<=if \()#{Regexp.escape(guard)}(?=\) \{)/, "!(#{guard})")), guard
    end
  end

  { 'a_swapped_target' => ['sample_enter_heat(self, SAMPLE_HEAT_HIGH);', 'sample_enter_heat(self, SAMPLE_HEAT_LOW);'],
    'a_lost_action' => ['    run->actions |= SAMPLE_ACTION_REPORT;', ''],
    'a_lost_raise' => ['sample_raise_event(run, SAMPLE_EVENT_HALT);', ''],
    'a_timer_not_stopped' => ['    sample_stop_fast_end(self);', ''],
    'a_timer_too_long' => ['SAMPLE_FAST_END_DELAY_US 500000U', 'SAMPLE_FAST_END_DELAY_US 500001U'],
    'a_wrong_number_in_the_trace' => ['now_us, 7U)', 'now_us, 6U)'] }.each do |name, (right, wrong)|
    define_method("test_SWR_CHART_009_#{name}_is_noticed") do
      refute_empty red(broken(right, wrong))
    end
  end

  # From the cold start: work first, so that the guard can hold; then each way in which it cannot.
  def test_SWR_CHART_009_a_guard_is_asked_with_all_that_it_reads
    found = Chart::Paths.new(CHART.document, CHART.walk).found
    values = found.keys.select { |kind, number, _values| kind == :guard && number == 2 }.map(&:last)
    assert_equal [[false, false], [false, true], [true, false], [true, true]], values.sort_by(&:to_s)
  end

  def test_SWR_CHART_009_a_path_is_the_shortest
    walk = walk_of(OwnCharts::CHART)
    found = Chart::Paths.new(parse(OwnCharts::CHART), walk).found
    assert_equal nearest(walk), parse(OwnCharts::CHART).transitions.map { |transition| shortest(found, transition) }
  end

  def test_SWR_CHART_009_a_second_run_writes_the_same_bytes
    texts = Array.new(2) { Chart::PathsTest.new(CHART.document, CHART.walk).emit }
    assert_equal(*texts)
  end

  private

  # How many steps before the one that takes each transition.
  def nearest(walk)
    steps = walk.reachable_pairs.flat_map { |pair| pair.outcomes.flat_map(&:taken).map { |one| [one.number, pair] } }
    steps.group_by(&:first).sort.map { |_number, all| all.map { |_, pair| walk.steps_to(pair.before).length }.min }
  end

  def shortest(found, transition)
    paths = found.values.select { |_place, step| step.outcome.taken.any? { |one| one.number == transition.number } }
    paths.map { |place, _step| place.steps.length }.min
  end

  def broken(right, wrong)
    found = CODE.gsub(right, wrong)
    refute_equal CODE, found, 'the fault no longer fits the generated code'
    found
  end

  # Names of the tests that fail.
  def red(code)
    built = self.class.built
    file = File.join(self.class.folder, 'sample_chart.c')
    File.write(file, code)
    output, status = Open3.capture2e(built.program(file))
    failed = output.scan(/:(test_\w+):FAIL/).flatten
    assert_equal failed.empty?, status.success?, output
    failed
  end
end

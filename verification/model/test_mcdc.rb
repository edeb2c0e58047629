# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: the generated tests of a chart reach every line, every branch and every modified condition/decision
# of its generated C. Included code is no part of it: the contracts in core/base/chart.h cannot be broken by a
# chart; verification/unit/base/test_chart.c fires them. The figures are printed and stand in build/conformance/mcdc.md.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative 'chart_coverage'
require_relative 'product_charts'

class TestMcdc < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  CHARTS = File.join(ROOT, 'build/gen/charts')
  NAMES = ProductCharts::ALL.values.map { |chart| chart.document.name }
  REPORT = File.join(ROOT, 'build/conformance/mcdc.md')
  FOUND = {}

  NAMES.each do |name|
    define_method("test_SWR_CHART_010_the_tests_of_#{name}_reach_every_condition") do
      FOUND[name] = coverage(name, tests(name))
      assert_empty FOUND[name].gaps
      assert FOUND[name].complete?, FOUND[name].words
    end
  end

  def test_SWR_CHART_010_a_missing_test_is_seen
    found = coverage('axis', tests('axis').grep(/_paths/))
    refute_predicate found, :complete?
    assert_match(/line \d+, column \d+ is never true/, found.gaps.join("\n"))
  end

  def test_SWR_CHART_010_a_condition_that_never_matters_is_seen
    found = coverage('axis', tests('axis')) do |code|
      code.sub('(event == AXIS_EVENT_FAILED)', '((event == AXIS_EVENT_FAILED) && (self->trace.count < 1000000U))')
    end
    assert_match(/: condition 2 of 2 is not shown to matter/, found.gaps.join("\n"))
  end

  Minitest.after_run do
    FileUtils.mkdir_p(File.dirname(REPORT))
    rows = FOUND.sort.map do |name, found|
      figures = found.figures.values.map { |covered, count| "#{covered} of #{count}" }
      "| #{name} | #{figures.join(' | ')} |"
    end
    File.write(REPORT, ['# What the generated tests reach of the generated C', '',
                        "| Chart | #{ChartCoverage::WHAT.values.join(' | ')} |", '| --- | --- | --- | --- |', *rows,
                        ''].join("\n"))
    FOUND.sort.each { |name, found| puts format('%-15<name>s %<words>s', name: name, words: found.words) }
  end

  private

  def tests(name)
    Dir[File.join(ROOT, "build/gen/tests/test_#{name}_*.c")].sort
  end

  # The block may change the code before.
  def coverage(name, tests)
    file = "#{name}_chart.c"
    code = File.read(File.join(CHARTS, file))
    changed = block_given? ? yield(code) : code
    refute_equal(code, changed) if block_given?
    Dir.mktmpdir do |folder|
      File.write(File.join(folder, file), changed)
      ChartCoverage.new(File.join(folder, file), CHARTS, tests, folder)
    end
  end
end

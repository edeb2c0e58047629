# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: whatever construct a chart uses, in the shape that it gets, its C has no finding of MISRA. The product
# charts are checked with the core (`make misra`); these hold what they do not.

require 'minitest/autorun'
require_relative '../lib/emit/c/header'
require_relative '../lib/emit/c/source'
require_relative '../faults/subject'
require_relative '../proof/chart_misra'

class TestChartMisra < Minitest::Test
  # What is special in each: guards, inputs, actions and timers; histories; parallels in parallels; ends of both; own
  # data; raises among eventless transitions; timers that start anew; nothing to take at all.
  CHARTS = %w[sample history_deep history_of_parallel nested_parallel done_of_parallel done_of_compound
              data_between_regions raise_before_outside raise_at_start timer_tie_restarted initial_of_several
              conflict_preempts_sibling timer_between_regions].freeze

  CHARTS.each do |name|
    subject = Faults::Subject.named(name)
    define_method("test_SWR_CHART_014_#{name}_has_no_finding") { assert_empty findings(subject) }
  end

  def test_SWR_CHART_014_both_shapes_of_code_are_looked_at
    shapes = CHARTS.map { |name| Chart::C::Source.shape(Faults::Subject.named(name).document) }
    assert_equal %i[direct staged], shapes.uniq.sort
  end

  def test_SWR_CHART_014_a_finding_is_seen
    found = findings(Faults::Subject.named('sample')) do |code|
      code.sub('(run->taken < run->raised)', '(run->taken < run->raised && true)')
    end
    assert_includes found, 'misra-c2012-12.1'
  end

  private

  # The block may change the code.
  def findings(subject)
    document = subject.document
    source = Chart::C::Source.new(document, subject.walk).emit
    source = yield source if block_given?
    header = Chart::C::Header.new(document, subject.walk).emit
    ChartMisra.findings(document.name, header, source).map { |finding| block_given? ? finding.rule : finding.to_s }
  end
end

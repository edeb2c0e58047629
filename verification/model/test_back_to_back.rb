# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: every reachable pair of configuration and stimulus of every product chart gives the same in compiled
# C, in the interpreter and in SCION. SPIN runs all of them together (test_composition.rb). The numbers are printed.

require 'minitest/autorun'
require 'tmpdir'
require_relative 'product_charts'

class TestBackToBack < Minitest::Test
  ProductCharts::ALL.each do |file, chart|
    name = chart.document.name
    CompiledChart::KINDS.each_key do |compiler|
      define_method("test_SWR_CHART_001_#{name}_by_#{compiler.tr('-', '_')}_equals_the_interpreter") do
        pairs = Pairs.new(chart.document, chart.walk)
        Dir.mktmpdir do |folder|
          CompiledChart.write(folder, chart)
          program = CompiledChart.build(folder, name, kind: compiler)
          assert_empty pairs.compare(program.run(pairs.commands)).first(3)
        end
      end
    end

    define_method("test_SWR_CHART_001_#{name}_by_scion_equals_the_interpreter") do
      comparison = Scion.new.compare(chart.document, file, chart.walk)
      assert_empty comparison.differences.first(3)
      assert_equal chart.walk.pair_count, comparison.pairs
    end
  end

  Minitest.after_run do
    ProductCharts::ALL.each_value do |chart|
      puts format('%-15<name>s %3<reached>d configurations, %5<pairs>d pairs: gcc, clang, Cortex-A9 by both, ' \
                  'interpreter, SCION',
                  name: chart.document.name, reached: chart.walk.reached.length, pairs: chart.walk.pair_count)
    end
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: each chart of the product is entered, checked, advanced and given events by its module, and by no
# other. That the controller calls each module in every cycle, the integration tests show.

require 'minitest/autorun'
require_relative 'product_charts'

class TestChartModules < Minitest::Test
  CALLS = %w[advance check dispatch init].freeze
  CORE = Dir[File.join(ProductCharts::ROOT, 'core/**/*.{c,h}')].sort.to_h { |file| [file, File.read(file)] }.freeze

  # Function => modules that call it.
  def self.callers(chart, core = CORE)
    calls = core.flat_map do |file, text|
      text.scan(/\b#{chart}_chart_(#{CALLS.join('|')})\(/).flatten.map { |call| [call, File.basename(file, '.*')] }
    end
    calls.uniq.group_by(&:first).transform_values { |pairs| pairs.map(&:last) }
  end

  ProductCharts::ALL.each_value do |chart|
    name = chart.document.name
    define_method("test_SWR_CORE_004_#{name}_is_checked_and_advanced_by_its_module_alone") do
      callers = self.class.callers(name)
      assert_equal CALLS, callers.keys.sort
      assert_equal 1, callers.values.flatten.uniq.length, callers.inspect
    end
  end

  def test_SWR_CORE_004_a_chart_that_another_module_calls_is_found
    core = { 'core/a/gate.c' => '(void)gate_chart_check(&one);', 'core/b/other.h' => 'gate_chart_check(&one)' }
    assert_equal({ 'check' => %w[gate other] }, self.class.callers('gate', core))
  end
end

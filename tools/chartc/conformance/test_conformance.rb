# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: compiled charts mean what the W3C's SCXML 1.0 says. The charts of SCION's test framework (the W3C's
# own tests among them) and cases of our own run as compiled C; the report is build/conformance/report.md.

require 'minitest/autorun'
require_relative 'report'

class TestConformance < Minitest::Test
  # So many charts of each folder fit the profile; with fewer the suite would have shrunk.
  FITTING = {
    'actionSend' => 10, 'atom3-basic-tests' => 4, 'basic' => 3, 'cond-js' => 4, 'default-initial-state' => 2,
    'delayedSend' => 3, 'documentOrder' => 1, 'hierarchy' => 3, 'hierarchy+documentOrder' => 2, 'history' => 7,
    'in' => 1, 'internal-transitions' => 1, 'misc' => 1, 'more-parallel' => 15, 'multiple-events-per-transition' => 1,
    'parallel' => 4, 'parallel+interrupt' => 34, 'scxml-prefix-event-name-matching' => 3, 'targetless-transition' => 1,
    'w3c-ecma' => 45
  }.freeze
  OWN_CASES = 60

  SUITE = Conformance::Suite.new
  PASSED = []
  Minitest.after_run { puts Conformance::Report.new(SUITE, PASSED).write }

  SUITE.scenarios.each do |scenario|
    define_method("test_SWR_CHART_004_#{scenario.name}") do
      assert_empty SUITE.faults(scenario), scenario.says
      PASSED << scenario.name
    end
  end

  # SCION is a third opinion on our own cases; where it does otherwise the case says why, and only there.
  SUITE.own.select(&:interpretable?).each do |scenario|
    define_method("test_SWR_CHART_004_#{scenario.name}_with_scion") do
      faults = SUITE.scion_faults(scenario)
      scenario.scion ? refute_empty(faults, scenario.scion) : assert_empty(faults)
    end
  end

  def test_SWR_CHART_004_no_conformance_chart_is_lost
    found = SUITE.framework.scenarios.map { |scenario| Conformance::Framework.folder(scenario.file) }.tally
    assert_equal FITTING, found.sort.to_h
    assert_equal OWN_CASES, SUITE.own.length
  end
end

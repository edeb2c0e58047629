# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: no finding without a deviation, no deviation without a finding.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../misra'

class TestMisra < Minitest::Test
  DEVIATIONS = <<~YAML
    - id: DEV-001
      rule: misra-c2012-15.5
      where: all
      why: reads better
      risk: work left undone
      guard: review
  YAML

  COMPLETE = {
    'verification/misra/deviations.yml' => DEVIATIONS,
    'verification/misra/suppressions.txt' => "# comment\nmisra-c2012-15.5:*  # DEV-001\n",
    'core/gate/gate.c' => "int x;\n"
  }.freeze

  EARLY_RETURN = MisraFinding.new(rule: 'misra-c2012-15.5', file: 'core/gate/gate.c', line: 3, message: 'return 1;')

  def test_SWR_CORE_001_accepts_what_a_deviation_allows
    assert_empty problems
  end

  def test_SWR_CORE_001_reports_a_finding_without_deviation
    finding = MisraFinding.new(rule: 'misra-c2012-10.4', file: 'core/gate/gate.c', line: 4, message: 'a + b')
    assert_equal ['core/gate/gate.c:4: misra-c2012-10.4 a + b'], problems(findings: [EARLY_RETURN, finding])
  end

  def test_SWR_CORE_001_a_deviation_holds_only_for_its_files_and_line
    list = ->(entry) { { 'verification/misra/suppressions.txt' => "misra-c2012-15.5:#{entry}  # DEV-001\n" } }
    assert_empty problems(list.call('core/gate/*.c'))
    assert_empty problems(list.call('core/gate/gate.c:3'))
    assert_includes problems(list.call('core/axis/*.c')), EARLY_RETURN.to_s
    assert_includes problems(list.call('core/gate/gate.c:4')), EARLY_RETURN.to_s
  end

  def test_SWR_CORE_001_reports_a_deviation_that_allows_nothing
    assert_equal ['verification/misra/suppressions.txt:2: accepts nothing any more',
                  'verification/misra/deviations.yml:1: DEV-001 accepts nothing'], problems(findings: [])
  end

  def test_SWR_CORE_001_reports_a_suppression_without_deviation
    assert_includes problems({ 'verification/misra/suppressions.txt' => "misra-c2012-15.5:*\n" }),
                    'verification/misra/suppressions.txt:1: a suppression names no deviation DEV-nnn'
    assert_includes problems({ 'core/gate/gate.c' => "/* cppcheck-suppress misra-c2012-10.4 */\nint x;\n" }),
                    'core/gate/gate.c:1: a suppression names no deviation DEV-nnn'
  end

  def test_SWR_CORE_001_reports_a_deviation_without_record
    assert_equal ['core/gate/gate.c:1: DEV-009 has no record'],
                 problems({ 'core/gate/gate.c' => "/* cppcheck-suppress misra-c2012-10.4 ; DEV-009 */\nint x;\n" })
  end

  def test_SWR_CORE_001_reports_an_incomplete_or_repeated_record
    assert_equal ['verification/misra/deviations.yml:1: DEV-001 lacks guard'],
                 problems({ 'verification/misra/deviations.yml' => DEVIATIONS.sub("  guard: review\n", '') })
    assert_equal ['verification/misra/deviations.yml:7: DEV-001 is used twice'],
                 problems({ 'verification/misra/deviations.yml' => DEVIATIONS * 2 })
  end

  def test_SWR_CORE_001_counts_by_rule
    in_project({}) do |root|
      check = MisraCheck.new(root, [EARLY_RETURN] * 2, [])
      assert_equal ['  misra-c2012-15.5            2  DEV-001'], check.table
    end
  end

  def test_SWR_CORE_001_cppcheck_finds_violations_and_stale_comments
    source = <<~C
      #include <stdint.h>
      int32_t gate(int32_t a);
      int32_t gate(int32_t a)
      {
          /* cppcheck-suppress misra-c2012-15.6 ; DEV-001 */
          int32_t b = a;
          if (a > 0) b = 2;
          return b;
      }
    C
    library = File.expand_path('../../verification/misra/contract.cfg', __dir__)
    in_project('core/gate/gate.c' => source, 'verification/misra/contract.cfg' => File.read(library)) do |root|
      found = Cppcheck.new(root).findings.map { |finding| [finding.rule, finding.line] }
      assert_includes found, ['misra-c2012-15.6', 7]
      assert_includes found, ['unmatchedSuppression', 6]
    end
  end

  private

  def problems(changes = {}, findings: [EARLY_RETURN])
    in_project(changes) { |root| MisraCheck.new(root, findings, ['core/gate/gate.c']).problems }
  end

  def in_project(changes)
    Dir.mktmpdir do |root|
      COMPLETE.merge(changes).each do |name, text|
        FileUtils.mkdir_p(File.dirname(File.join(root, name)))
        File.write(File.join(root, name), text)
      end
      yield root
    end
  end
end

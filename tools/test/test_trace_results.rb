# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the matrix shows each requirement with its verdict, and only results of this tree on this machine count.

require 'csv'
require_relative 'trace_project'

class TestTraceResults < Minitest::Test
  include TraceProject

  def test_SWR_TRACE_001_matrix_gives_the_worst_result_as_verdict
    results = JSON.generate(
      [{ test: 'test_SWR_PEDAL_001_waits(1)', file: 'verification/unit/test_gate.c', result: 'pass' },
       { test: 'SWR-PEDAL-001 is <shown>', file: 'app/console/a.test.ts', result: 'fail' }]
    )
    in_project('build/results/unit.json' => results) do |root|
      output, status = trace('matrix', root)
      assert status.success?, output
      assert_includes output, "SWR-PEDAL-001  FAIL  Shut gate\n    from   RC-001\n" \
                              "    by     gate shut (statecharts/gate.scxml:2)\n"
      assert_includes output, '    tested fail   SWR-PEDAL-001 is <shown> (app/console/a.test.ts)'
      assert_includes output, "SWR-PEDAL-002  NOT VERIFIED  Open gate\n    from   derived: someone must get through\n"
      assert_includes output, '2 requirements: 0 pass, 1 fail, 1 not verified'
    end
  end

  def test_SWR_TRACE_001_matrix_is_written_for_machine_sheet_and_auditor
    in_project do |root|
      trace('matrix', root)
      rows = JSON.parse(File.read(File.join(root, 'build/trace.json'))).fetch('requirements')
      assert_equal [%w[SWR-PEDAL-001 pass], %w[SWR-PEDAL-002 pass]], rows.map { |row| row.values_at('id', 'verdict') }
      assert_equal 'While the gate is shut, the controller shall wait 7 us.', rows.first['text']
      assert_equal 'HAZ-001', rows.first.dig('parents', 0, 'hazards', 0, 'id')
      sheet = CSV.read(File.join(root, 'build/trace.csv'))
      assert_equal 'gate_open (core/gate/gate.h:4)', sheet[5][4].lines.first.chomp
      html = File.read(File.join(root, 'build/trace.html'))
      assert_match(/<details id="SWR-PEDAL-001" data-verdict="pass">.*test_SWR_PEDAL_001_waits\(1\)/m, html)
      refute_match(/(?:src|href)\s*=/, html, 'the page needs no other file')
    end
  end

  def test_SWR_TOOL_283_the_matrix_shows_the_proofs_of_each_function
    files = { 'verification/proof/proved.yml' => "core/gate/gate.c:\n  gate_open: cbmc eva\n  gate_shut: open\n",
              'verification/proof/proofs.yml' => "- {file: gate/prove_gate.c, sources: [core/gate/gate.c, verification/proof/contract/crc.c], " \
                                                 "proves: [gate_open], mutants: []}\n",
              'verification/proof/gate/prove_gate.c' => "void prove_SWR_PEDAL_002_opens(void)\n{\n    PROVE(true, \"SWR-PEDAL-002: it opens\");\n}\n" }
    in_project(files) do |root|
      trace('matrix', root)
      rows = CSV.read(File.join(root, 'build/proved.csv')).drop(1)
      assert_equal ['core/gate/gate.c', 'gate_open', 'cbmc eva', 'verification/proof/gate/prove_gate.c',
                    'verification/proof/contract/crc.c', 'SWR-PEDAL-002', ''], rows.first
      assert_equal ['core/gate/gate.c', 'gate_shut', 'open', '', '', '', ''], rows.last
      assert_includes File.read(File.join(root, 'build/trace.html')), '<td>gate_open</td><td>cbmc eva</td>'
    end
  end

  def test_SWR_TRACE_003_results_of_another_tree_do_not_count
    in_project do |root|
      File.write(File.join(root, 'core/gate/new.c'), "int x;\n")
      assert_doubt(root, 'for they were made of commit 1234567890ab, tree \h{12} at 2026-01-02T03:04:05Z, which is not ' \
                         'what stands here')
    end
  end

  def test_SWR_TRACE_003_results_of_another_checkout_or_machine_do_not_count
    in_project({}, 'checkout' => 'elsewhere') do |root|
      assert_doubt(root, 'for they come from another checkout or machine: Abacus, 3 cores, Kernel 1, System 2')
    end
  end

  def test_SWR_TRACE_003_results_without_an_origin_do_not_count
    [{ 'tree' => nil }, { 'checkout' => nil }].each do |run|
      in_project({}, run) { |root| assert_doubt(root, 'for they do not say where they come from') }
    end
    in_project do |root|
      File.write(File.join(root, 'build/results/unit.json'), COMPLETE.fetch('build/results/unit.json'))
      assert_doubt(root, 'for they do not say where they come from')
    end
  end

  def test_SWR_TRACE_003_a_requirement_with_one_doubtful_result_is_not_verified
    in_project do |root|
      more = [{ test: 'test_SWR_PEDAL_001_waits(1)', file: 'verification/unit/test_gate.c', result: 'pass' }]
      File.write(File.join(root, 'build/results/arm.json'), JSON.generate(more))
      output, = trace('matrix', root)
      assert_includes output, "SWR-PEDAL-001  NOT VERIFIED  Shut gate\n    but    arm.json does not count, for they do not"
      assert_includes output, '2 requirements: 1 pass, 0 fail, 1 not verified'
    end
  end

  def test_SWR_TRACE_003_a_failure_elsewhere_is_no_failure_here
    failed = COMPLETE.fetch('build/results/unit.json').sub('"pass"', '"fail"')
    in_project({ 'build/results/unit.json' => failed }, 'checkout' => 'elsewhere') do |root|
      assert_includes trace('matrix', root).first, '2 requirements: 0 pass, 0 fail, 2 not verified'
    end
  end

  def test_SWR_TRACE_002_the_matrix_says_once_at_its_head_where_the_results_come_from
    in_project do |root|
      text, = trace('matrix', root)
      head = text.lines(chomp: true).first(3)
      assert_match(/\AResults of commit 1234567890ab, tree \h{12}, from 2026-01-02T03:04:05Z to 2026-01-02T03:04:05Z\z/,
                   head.first)
      assert_equal ['on Abacus, 3 cores, Kernel 1, System 2', 'with gcc 1.2, ruby 3.4'], head.drop(1)
      assert_equal head, CSV.read(File.join(root, 'build/trace.csv')).first(3).map(&:first)
      assert_includes File.read(File.join(root, 'build/trace.html')), head.join("<br>\n")
      origin = JSON.parse(File.read(File.join(root, 'build/trace.json'))).fetch('origin')
      assert_equal [Origin.tree(root), '3.4'], [origin['tree'], origin.dig('tools', 'ruby')]
    end
  end

  private

  # Every requirement is not verified, and why.
  def assert_doubt(root, words)
    output, status = trace('check', root)
    assert_equal 1, status.exitstatus, output
    assert_match(%r{\ATRACE-E18 build/results/unit.json:1: its results do not count, #{words}\ntrace: }, output)
    output, = trace('matrix', root)
    assert_match(%r{^not counted: build/results/unit.json, #{words}$}, output)
    assert_match(/^SWR-PEDAL-001  NOT VERIFIED  Shut gate\n    but    unit.json does not count, #{words}$/, output)
    assert_includes output, '2 requirements: 0 pass, 0 fail, 2 not verified'
  end
end

# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: whatever is missing between hazard and passed test is found, and said in one line.
# Each test breaks one thing in a small project that is complete.

require 'csv'
require 'erb'
require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../origin'
require_relative '../trace'

class TestTrace < Minitest::Test
  TOOLS = File.expand_path('..', __dir__)

  RUN = { 'commit' => '1234567890abcdef', 'time' => '2026-01-02T03:04:05Z',
          'tools' => { 'gcc' => '1.2', 'ruby' => '3.4' },
          'machine' => { 'processor' => 'Abacus', 'cores' => 3, 'kernel' => 'Kernel 1', 'system' => 'System 2' } }.freeze

  # Tests of the results; their origin is added.
  COMPLETE = {
    '.gitignore' => "/build/\n",
    'requirements/risk.yml' => <<~YAML,
      - id: HAZ-001
        title: Motion goes on
        severity: 5
        situation: The probe advances.
        harm: Death
      - id: RC-001
        title: Zero drive
        kind: design
        text: Without permit zero drive words leave.
        parents: [HAZ-001]
    YAML
    'requirements/core/pedal.yml' => <<~YAML,
      - id: SWR-PEDAL-001
        title: Shut gate
        text: While the gate is shut, the controller shall wait {wait_us}.
        parents: [RC-001]
        source: thesis
        limits:
          - {name: wait_us, value: 7, unit: us, status: thesis}
        verification: {method: test, level: unit}
      - id: SWR-PEDAL-002
        title: Open gate
        text: The gate shall open.
        parents: ['derived: someone must get through']
        source: thesis
        verification: {method: test, level: unit}
    YAML
    'core/gate/gate.h' => <<~C,
      /**
       * Opens the gate.
       *
       * @satisfies SWR-PEDAL-002
       */
      void gate_open(gate_t *self);
    C
    'statecharts/gate.scxml' => <<~XML,
      <scxml xmlns:bs="x">
        <state id="shut" bs:req="SWR-PEDAL-001">
          <transition bs:id="GATE-T01" event="a" cond="x > 1" bs:req="SWR-PEDAL-001 SWR-PEDAL-002"
                      bs:hazard="HAZ-001"/>
        </state>
      </scxml>
    XML
    'verification/unit/test_gate.c' => <<~C,
      static void check(int value)
      {
          TEST_ASSERT_EQUAL_INT(1, value);
      }

      TEST_CASE(1)
      void test_SWR_PEDAL_001_waits(int value)
      {
          check(value);
      }

      void test_SWR_PEDAL_002_opens(void)
      {
          EXPECT_CONTRACT("gate", 1U, gate_open(NULL));
      }
    C
    'build/results/unit.json' => JSON.generate(
      [{ test: 'test_SWR_PEDAL_001_waits(1)', file: 'verification/unit/test_gate.c', result: 'pass' },
       { test: 'test_SWR_PEDAL_002_opens', file: 'verification/unit/test_gate.c', result: 'pass' }]
    )
  }.freeze

  def test_SWR_TRACE_001_a_complete_project_has_no_findings
    in_project do |root|
      output, status = trace('check', root)
      assert status.success?, output
      assert_equal "trace: 2 requirements, 2 test results, 0 findings\n", output
    end
  end

  def test_SWR_TRACE_001_the_command_line_ends_as_its_findings_say
    in_project do |root|
      tool = ['ruby', File.join(TOOLS, 'trace.rb')]
      output, status = Open3.capture2e(*tool, 'check', '--root', root)
      assert_equal ["trace: 2 requirements, 2 test results, 0 findings\n", 0], [output, status.exitstatus]
      FileUtils.rm_r("#{root}/build")
      output, status = Open3.capture2e(*tool, 'check', '--root', root)
      assert_equal ['trace: 2 requirements, 0 test results', 1], [output.lines.last[/[^,]*,[^,]*/], status.exitstatus]
    end
  end

  def test_SWR_TRACE_001_e01_unknown_id_in_code_chart_and_test
    assert_finding 'E01 core/gate/gate.h:4: gate_open names the unknown id SWR-GATE-009',
                   'core/gate/gate.h', 'SWR-PEDAL-002', 'SWR-GATE-009'
    assert_finding 'E01 core/gate/gate.h:4: gate_open names the unknown id SWR-PEDAL-002 SWR-PEDAL-001',
                   'core/gate/gate.h', 'SWR-PEDAL-002', 'SWR-PEDAL-002 SWR-PEDAL-001'
    assert_finding 'E01 statecharts/gate.scxml:3: gate GATE-T01 names the unknown id SWR-PEDAL-003',
                   'statecharts/gate.scxml', 'SWR-PEDAL-002', 'SWR-PEDAL-003'
    assert_finding 'E01 verification/unit/test_gate.c:12: test_SWR_PEDAL_009_opens names the unknown id',
                   'verification/unit/test_gate.c', 'SWR_PEDAL_002', 'SWR_PEDAL_009'
  end

  def test_SWR_TRACE_001_e02_test_without_requirement
    assert_finding 'E02 verification/unit/test_gate.c:12: test_opens names no requirement',
                   'verification/unit/test_gate.c', 'SWR_PEDAL_002_', ''
    assert_finding 'E02 app/console/a.test.ts:1: shows it names no requirement', 'build/results/unit.json',
                   ']', ',{"test":"shows it","file":"app/console/a.test.ts","result":"pass"}]'
  end

  def test_SWR_TRACE_001_e03_requirement_without_a_passed_test
    assert_finding 'E03 requirements/core/pedal.yml:1: SWR-PEDAL-001 has no passed test',
                   'build/results/unit.json', '"pass"', '"ignore"'
  end

  def test_SWR_TRACE_001_e04_failed_test
    assert_finding 'E04 verification/unit/test_gate.c:7: test_SWR_PEDAL_001_waits(1) failed',
                   'build/results/unit.json', '"pass"', '"fail"'
    assert_finding 'E04 verification/unit/test_gate.c:7: test_SWR_PEDAL_001_waits(1) has the unknown result "ok"',
                   'build/results/unit.json', '"pass"', '"ok"'
  end

  def test_SWR_TRACE_001_e05_ignored_test
    assert_finding 'E05 verification/unit/test_gate.c:7: test_SWR_PEDAL_001_waits(1) was ignored',
                   'build/results/unit.json', '"pass"', '"ignore"'
  end

  def test_SWR_TRACE_001_e06_test_that_asserts_nothing
    findings = assert_finding 'E06 verification/unit/test_gate.c:7: test_SWR_PEDAL_001_waits asserts nothing',
                              'verification/unit/test_gate.c', 'check(value);', '/* check(value); */'
    assert_includes findings, 'E03 requirements/core/pedal.yml:1: SWR-PEDAL-001 has no passed test'
  end

  def test_SWR_TRACE_001_e06_an_assertion_in_an_included_part_is_one_of_the_test
    test = COMPLETE.fetch('verification/unit/test_gate.c')
    helper = test[/\A.*?^}\n/m]
    files = { 'verification/unit/test_gate.c' => test.sub(helper, %(#include "unit/support/gate_world.inc"\n)) }
    { helper => false, helper.sub('TEST_ASSERT_EQUAL_INT(1, value)', '(void)value') => true }.each do |part, is_empty|
      in_project(files.merge('verification/unit/support/gate_world.inc' => part)) do |root|
        assert_equal is_empty, trace('check', root).first.include?('test_SWR_PEDAL_001_waits asserts nothing')
      end
    end
  end

  def test_SWR_TRACE_001_e06_runner_counted_no_assertion
    ruby = { test: 'test_SWR_PEDAL_001_x', file: 'verification/system/test_x.rb', result: 'pass', assertions: 0 }
    assert_finding 'E06 verification/system/test_x.rb:1: test_SWR_PEDAL_001_x asserts nothing',
                   'build/results/unit.json', ']', ",#{JSON.generate(ruby)}]"
  end

  def test_SWR_TRACE_001_e07_requirement_that_nothing_fulfils
    assert_finding 'E07 requirements/core/pedal.yml:1: SWR-PEDAL-001 is fulfilled by no function or chart',
                   'statecharts/gate.scxml', /SWR-PEDAL-001(.*)SWR-PEDAL-001/m, 'SWR-PEDAL-002\\1'
  end

  def test_SWR_TRACE_001_e08_id_used_twice
    assert_finding 'E08 requirements/core/pedal.yml:9: SWR-PEDAL-001 is already used at requirements/core/pedal.yml:1',
                   'requirements/core/pedal.yml', 'SWR-PEDAL-002', 'SWR-PEDAL-001'
  end

  def test_SWR_TRACE_001_e09_unknown_parent
    assert_finding 'E09 requirements/core/pedal.yml:1: SWR-PEDAL-001 has the unknown parent RC-002',
                   'requirements/core/pedal.yml', 'RC-001', 'RC-002'
    assert_finding 'E09 requirements/risk.yml:6: RC-001 has the unknown parent HAZ-002',
                   'requirements/risk.yml', '[HAZ-001]', '[HAZ-002]'
  end

  def test_SWR_TRACE_001_e10_not_exactly_one_shall
    assert_finding 'E10 requirements/core/pedal.yml:9: SWR-PEDAL-002 says shall 2 times',
                   'requirements/core/pedal.yml', 'shall open', 'shall open and shall close'
    assert_finding 'E10 requirements/core/pedal.yml:9: SWR-PEDAL-002 says shall 0 times',
                   'requirements/core/pedal.yml', 'shall open', 'will open'
  end

  def test_SWR_TRACE_001_e11_risk_control_without_requirement
    assert_finding 'E11 requirements/risk.yml:6: RC-001 is carried out by no requirement',
                   'requirements/core/pedal.yml', '[RC-001]', "['derived: so']"
  end

  def test_SWR_TRACE_001_e12_hazard_without_risk_control
    assert_finding 'E12 requirements/risk.yml:1: HAZ-001 has no risk control',
                   'requirements/risk.yml', 'parents: [HAZ-001]', 'parents: []'
  end

  LIMIT = "- id: LIM-001\n  title: No jump\n  text: It cannot jump.\n  shown_by: [test_SWR_PEDAL_002_opens]\n"

  def test_SWR_TOOL_031_e19_known_limit_without_a_test_that_is_there
    in_project('requirements/known_limits.yml' => LIMIT) { |root| assert_empty trace('check', root).first.lines[0..-2] }
    in_project('requirements/known_limits.yml' => LIMIT.sub('opens', 'shuts')) do |root|
      assert_includes trace('check', root).first,
                      'TRACE-E19 requirements/known_limits.yml:1: LIM-001 is shown by test_SWR_PEDAL_002_shuts, which is not there'
    end
  end

  def test_SWR_TOOL_031_e15_known_limit_that_names_no_test
    ['[]', ''].each do |none|
      in_project('requirements/known_limits.yml' => LIMIT.sub('[test_SWR_PEDAL_002_opens]', none)) do |root|
        assert_includes trace('check', root).first, 'TRACE-E15 requirements/known_limits.yml:1: LIM-001 lacks shown_by'
      end
    end
  end

  def test_SWR_TRACE_001_e13_test_without_result_and_result_without_test
    findings = assert_finding 'E13 verification/unit/test_gate.c:12: test_SWR_PEDAL_002_closes was not executed',
                              'verification/unit/test_gate.c', 'test_SWR_PEDAL_002_opens', 'test_SWR_PEDAL_002_closes'
    assert_includes findings, 'E13 verification/unit/test_gate.c:1: test_SWR_PEDAL_002_opens has a result but is not'
  end

  def test_SWR_TRACE_001_e14_requirement_without_parent
    assert_finding 'E14 requirements/core/pedal.yml:9: SWR-PEDAL-002 has neither a parent nor',
                   'requirements/core/pedal.yml', "['derived: someone must get through']", '[]'
  end

  def test_SWR_SITE_019_a_hazard_has_a_whole_scene_or_a_reason
    reported = 'E15 requirements/risk.yml:1: HAZ-001 has neither a scene and what it expects nor a reason'
    whole = "scene: robot=neuro&seed=7&inputs= 5:pedal,press; 9:JOG,axis=3\n  expects: [9 off]"
    ["scene: robot=neuro&seed=7\n  expects: [9 off]", whole.sub(/\n.*/, ''), "#{whole}\n  no_scene: So.", 'expects: [9 off]']
      .each { |fields| assert_finding reported, 'requirements/risk.yml', 'severity: 5', "severity: 5\n  #{fields}" }
    [whole, 'no_scene: It has no bus.'].each do |fields|
      risk = COMPLETE.fetch('requirements/risk.yml').sub('severity: 5', "severity: 5\n  #{fields}")
      in_project('requirements/risk.yml' => risk) { |root| refute_includes trace('check', root).first, 'E15' }
    end
  end

  def test_SWR_SITE_019_the_matrix_has_the_link_of_a_scene_or_the_reason_why_there_is_none
    scene = 'robot=neuro&seed=7&inputs=5:estop,pull'
    fields = "severity: 5\n  scene: #{scene.sub('5:', ' 5:')}\n  expects: [9 off]"
    { fields => "<a href=\"site/page/index.html##{ERB::Util.html_escape(scene)}\">Motion goes on</a>",
      "severity: 5\n  no_scene: It has no bus." => '<td>Motion goes on</td><td>It has no bus.</td>' }.each do |risk, shown|
      in_project('requirements/risk.yml' => COMPLETE.fetch('requirements/risk.yml').sub('severity: 5', risk)) do |root|
        trace('matrix', root)
        assert_includes File.read("#{root}/build/trace.html"), shown
      end
    end
  end

  def test_SWR_TRACE_001_e15_malformed_items
    { ['  source: thesis', ''] => 'SWR-PEDAL-001 lacks source',
      ['{wait_us}', '{wait_ms}'] => 'SWR-PEDAL-001 speaks of the unknown limit wait_ms',
      ['level: unit', 'level: hope'] => 'SWR-PEDAL-001 has the unknown level "hope"',
      ['While the', 'As the'] => 'SWR-PEDAL-001 does not begin with While, When, If, Where or The' }
      .each do |(old, new), text|
        assert_finding "E15 requirements/core/pedal.yml:1: #{text}", 'requirements/core/pedal.yml', old, new
      end
    assert_finding 'E15 requirements/core/pedal.yml:9: REQ-PEDAL-002 is neither HAZ-, RC-, SWR- nor LIM-',
                   'requirements/core/pedal.yml', 'SWR-PEDAL-002', 'REQ-PEDAL-002'
  end

  def test_SWR_TRACE_001_e15_unreadable_files
    assert_finding 'E15 requirements/core/pedal.yml:', 'requirements/core/pedal.yml', '- id: SWR-PEDAL-002', '- id: ['
    assert_finding 'E15', 'build/results/unit.json', ']', ''
  end

  def test_SWR_TRACE_001_e16_tested_only_at_a_smaller_level
    assert_finding 'E16 requirements/core/pedal.yml:1: SWR-PEDAL-001 is to be tested at level system, it is at unit',
                   'requirements/core/pedal.yml', 'level: unit', 'level: system'
    system = { test: 'test_SWR_PEDAL_001_x', file: 'verification/system/test_x.rb', result: 'pass', assertions: 1 }
    items = COMPLETE.fetch('requirements/core/pedal.yml').sub('level: unit', 'level: integration')
    in_project('build/results/system.json' => JSON.generate([system]), 'requirements/core/pedal.yml' => items,
               'verification/system/test_x.rb' => "  def test_SWR_PEDAL_001_x\n") do |root|
      output, status = trace('check', root)
      assert status.success?, output
    end
  end

  def test_SWR_TRACE_200_e20_no_test_stands_in_for_a_proof
    finding = 'E20 requirements/core/pedal.yml:9: SWR-PEDAL-002 is to be proved, and no proof of it has passed'
    items = COMPLETE.fetch('requirements/core/pedal.yml').sub(/test(, level: unit}\n)\z/, 'proof\1')
    assert_finding finding, 'requirements/core/pedal.yml', COMPLETE.fetch('requirements/core/pedal.yml'), items
    harness = 'verification/proof/gate/prove_gate.c'
    proved = { test: 'prove_SWR_PEDAL_002_opens', file: harness, result: 'pass', assertions: 12 }
    proof = "void prove_SWR_PEDAL_002_opens(void)\n{\n    PROVE(gate_open(), \"SWR-PEDAL-002: it is open\");\n}\n"
    in_project('build/results/proof.json' => JSON.generate([proved]), 'requirements/core/pedal.yml' => items, harness => proof) do |root|
      output, status = trace('check', root)
      assert status.success?, output
      assert_includes trace('matrix', root).first, "    proved pass   prove_SWR_PEDAL_002_opens (#{harness})"
    end
  end

  def test_SWR_TRACE_200_a_proof_counts_as_executed_unless_it_is_for_the_night
    harness = 'verification/proof/gate/prove_gate.c'
    files = { harness => "void prove_SWR_PEDAL_002_opens(void)\n{\n    PROVE(gate_open(), \"SWR-PEDAL-002: it is open\");\n}\n" }
    in_project(files) { |root| assert_includes trace('check', root).first, "TRACE-E13 #{harness}:1: prove_SWR_PEDAL_002_opens was not executed" }
    night = { 'verification/proof/proofs.yml' => "- {file: gate/prove_gate.c, night: [prove_SWR_PEDAL_002_opens]}\n" }
    in_project(files.merge(night)) { |root| assert trace('check', root).last.success? }
  end

  def test_SWR_TRACE_200_a_check_of_a_contract_is_an_assertion_of_its_proof_and_a_comment_is_none
    harness = 'verification/proof/gate/prove_gate.c'
    { 'check SWR_PEDAL_002: is_open;' => false, 'is open' => true }.each do |text, is_empty|
      in_project(harness => "void prove_SWR_PEDAL_002_opens(void)\n{\n    /*@ #{text} */\n}\n") do |root|
        assert_equal is_empty, trace('check', root).first.include?("TRACE-E06 #{harness}:1: prove_SWR_PEDAL_002_opens asserts nothing")
      end
    end
  end

  def test_SWR_TRACE_001_e01_unknown_hazard_in_chart
    ['HAZ-009', 'SWR-PEDAL-009'].each do |id|
      assert_finding "E01 statecharts/gate.scxml:3: gate GATE-T01 names the unknown hazard #{id}",
                     'statecharts/gate.scxml', 'HAZ-001', id
    end
  end

  def test_SWR_TRACE_001_e17_hazard_in_chart_that_its_requirements_do_not_control
    finding = 'E17 statecharts/gate.scxml:3: gate GATE-T01 names HAZ-001, which no requirement of it controls'
    assert_finding finding, 'statecharts/gate.scxml', 'SWR-PEDAL-001 SWR-PEDAL-002', 'SWR-PEDAL-002'
    assert_finding finding.sub('HAZ-001', 'SWR-PEDAL-001'), 'statecharts/gate.scxml', 'HAZ-001', 'SWR-PEDAL-001'
  end

  def test_SWR_TRACE_001_static_check_needs_no_results
    in_project('build/results/unit.json' => 'nonsense') do |root|
      output, status = trace('check', root, '--static')
      assert status.success?, output
    end
  end

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

  def test_SWR_TRACE_001_elements_are_named_after_what_follows_the_comment
    sources = { 'a.h' => "/**\n * @satisfies SWR-PEDAL-001\n */\ntypedef struct {\n    int a;\n} gate_t;\n",
                'b.h' => "/**\n * @file\n * @satisfies SWR-PEDAL-001\n */\n#ifndef B_H\n",
                'c.h' => "/**\n * @satisfies SWR-PEDAL-001\n */\nextern const robot_t robot_neuro;\n",
                'd.rb' => "# @satisfies SWR-PEDAL-001\nclass Gate\nend\n",
                'e.ts' => "// @satisfies SWR-PEDAL-001\nexport const gate = 1;\n",
                'f.tsx' => "/** @satisfies SWR-PEDAL-001 */\nexport default function Gate() {\n}\n",
                'g.c' => "/**\n * @satisfies SWR-PEDAL-001\n */\nstatic const char *const names[2] = {0};\n" }
    in_project(sources.transform_keys { |name| "app/gate/#{name}" }) do |root|
      output, = trace('matrix', root)
      names = output.scan(%r{by     (\S+) \(app/gate/(\S+):\d+\)})
      assert_equal %w[gate_t b.h robot_neuro Gate gate Gate names], names.sort_by(&:last).map(&:first)
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

  # Replaces `old` by `new` in one file of the complete project and expects a finding.
  def assert_finding(text, file, old, new)
    changed = COMPLETE.fetch(file).sub(old, new)
    refute_equal COMPLETE.fetch(file), changed
    in_project(file => changed) do |root|
      output, status = trace('check', root)
      assert_equal 1, status.exitstatus, output
      assert_includes output, "TRACE-#{text}"
      return output
    end
  end

  # run: the origin stated by the results, other than the truth.
  def in_project(changes = {}, run = {})
    Dir.mktmpdir do |root|
      results, files = COMPLETE.merge(changes).partition { |name, _text| name.start_with?('build/') }
      files.each { |name, text| write(root, name, text) }
      run = RUN.merge('tree' => Origin.tree(root), 'checkout' => Origin.checkout(root)).merge(run)
      results.each { |name, tests| write(root, name, "{\"run\": #{JSON.generate(run)}, \"tests\": #{tests}}") }
      yield root
    end
  end

  def write(root, name, text)
    path = File.join(root, name)
    FileUtils.mkdir_p(File.dirname(path))
    File.write(path, text)
  end

  Ended = Struct.new(:exitstatus) do
    def success?
      exitstatus.zero?
    end
  end

  # Its output and exit code, without a process of its own.
  def trace(command, root, *options)
    status = nil
    text = capture_io { status = Trace::Command.run([command, '--root', root, *options]) }
    [text.join, Ended.new(status)]
  end

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

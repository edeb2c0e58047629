# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: whatever is missing between hazard and passed test is found, and said in one line.
# Each test breaks one thing in a small project that is complete.

require 'erb'
require 'open3'
require_relative 'trace_project'

class TestTrace < Minitest::Test
  include TraceProject

  TOOLS = File.expand_path('..', __dir__)

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
end

# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../origin'
require_relative '../trace'

# A small project that is complete, and trace run on it.
module TraceProject
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
end

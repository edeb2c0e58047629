# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a function that falls out of proof, is not listed or is gone is named, and the list keeps its proofs.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../eva/alarm_list'
require_relative '../proof/coverage'
require_relative '../proof/proved_list'

class TestProved < Minitest::Test
  OPEN_GATE = ['core/gate/gate.c', 'gate_open'].freeze
  SHUT_GATE = ['core/gate/gate.c', 'gate_shut'].freeze
  IS_OPEN = ['core/gate/gate.h', 'gate_is_open'].freeze
  LISTED = { OPEN_GATE => 'cbmc eva', SHUT_GATE => 'open', IS_OPEN => 'eva' }.freeze
  SOURCE = "int gate_open(int a)\n{\n    return a;\n}\n\nint gate_shut(int a)\n{\n    return a;\n}\n"
  HEADER = "static inline int gate_is_open(int a)\n{\n    return a;\n}\n"
  HARNESS = { 'file' => 'gate/prove_gate.c', 'sources' => ['core/gate/gate.c'], 'proves' => %w[gate_open gate_is_open], 'mutants' => [] }.freeze

  def test_SWR_TOOL_280_the_proofs_of_the_list_are_no_problem
    assert_empty list.problems(LISTED)
  end

  def test_SWR_TOOL_280_a_function_that_falls_out_of_a_proof_is_named
    assert_equal ['no longer proved by eva: core/gate/gate.h: gate_is_open (now open)'], list.problems(LISTED.merge(IS_OPEN => 'open'))
    assert_equal ['no longer proved by cbmc: core/gate/gate.c: gate_open (now eva)'], list.problems(LISTED.merge(OPEN_GATE => 'eva'))
  end

  def test_SWR_TOOL_280_an_open_alarm_takes_its_function_out_of_the_proofs_of_eva
    alarms = { 'alarms' => { 'neuro' => { SHUT_GATE.first => { SHUT_GATE.last => { 'shift: 0 ≤ n < 32' => 'open' },
                                                               OPEN_GATE.last => { 'index_bound: i < 10U' => 'the caller refuses it' } } } } }
    with_open = Eva::AlarmList.new('', alarms).open_functions('neuro')
    assert_equal({ OPEN_GATE => 'eva', SHUT_GATE => 'open', IS_OPEN => 'unreached' },
                 states(reached: [OPEN_GATE, SHUT_GATE], with_open: with_open, harnesses: []))
  end

  def test_SWR_TOOL_280_an_open_alarm_of_what_a_function_ensures_takes_it_out_of_the_proofs_of_eva
    assert_equal({ OPEN_GATE => 'eva', SHUT_GATE => 'open', IS_OPEN => 'unreached' },
                 states(reached: [OPEN_GATE, SHUT_GATE], with_open: [['verification/eva/contracts.h', SHUT_GATE.last]], harnesses: []))
  end

  def test_SWR_TOOL_280_a_function_is_proved_by_the_harness_that_names_it
    assert_equal({ OPEN_GATE => 'cbmc eva', SHUT_GATE => 'unreached', IS_OPEN => 'cbmc' }, states(reached: [OPEN_GATE]))
  end

  def test_SWR_TOOL_280_a_function_is_proved_by_the_contract_that_names_it
    by_contract = Proof::Harness.new(HARNESS.except('proves').merge('by_contract' => ['gate_open']))
    assert_equal({ OPEN_GATE => 'wp eva', SHUT_GATE => 'unreached', IS_OPEN => 'unreached' }, states(reached: [OPEN_GATE], harnesses: [by_contract]))
    assert_equal({ OPEN_GATE => 'cbmc wp', SHUT_GATE => 'unreached', IS_OPEN => 'cbmc' },
                 states(harnesses: [by_contract, Proof::Harness.new(HARNESS)]))
  end

  def test_SWR_TOOL_281_a_function_that_is_not_listed_or_gone_is_named
    assert_equal ['function that is not listed: core/gate/gate.c: gate_lock'], list.problems(LISTED.merge(['core/gate/gate.c', 'gate_lock'] => 'open'))
    assert_equal ['listed function that is gone: core/gate/gate.c: gate_shut'], list.problems(LISTED.except(SHUT_GATE))
  end

  def test_SWR_TOOL_281_a_proof_that_is_not_listed_is_named
    assert_equal ['proved by eva, but not listed so: core/gate/gate.c: gate_shut'], list.problems(LISTED.merge(SHUT_GATE => 'eva'))
    assert_equal ['listed as open, but unreached: core/gate/gate.c: gate_shut'], list.problems(LISTED.merge(SHUT_GATE => 'unreached'))
  end

  def test_SWR_TOOL_281_what_eva_reaches_or_a_harness_names_must_be_a_function_of_the_core
    assert_includes assert_raises(Proof::Refused) { states(reached: [['core/gate/gate.c', 'gate_lock']]) }.message, 'core/gate/gate.c: gate_lock'
    unknown = Proof::Harness.new(HARNESS.merge('proves' => ['gate_lock']))
    assert_includes assert_raises(Proof::Refused) { states(harnesses: [unknown]) }.message, 'gate_lock, which verification/proof/gate/prove_gate.c'
  end

  def test_SWR_TOOL_282_a_list_that_is_written_anew_keeps_its_proofs_and_adds_new_ones
    Dir.mktmpdir do |folder|
      found = { OPEN_GATE => 'eva', SHUT_GATE => 'eva', ['core/gate/gate.c', 'gate_lock'] => 'unreached' }
      written = list("#{folder}/proved.yml")
      written.replace(found)
      written.save
      read = Proof::ProvedList.read("#{folder}/proved.yml")
      assert_equal({ ['core/gate/gate.c', 'gate_lock'] => 'unreached', OPEN_GATE => 'cbmc eva', SHUT_GATE => 'eva' }, read.states)
      assert_equal ['no longer proved by cbmc: core/gate/gate.c: gate_open (now eva)'], read.problems(found)
    end
  end

  def test_SWR_TOOL_283_the_sentence_counts_each_kind
    assert_equal 'Under the assumptions, contracts and limits of SOUNDNESS.md, 2 of 3 functions of the core and of the charts are free of ' \
                 'run-time errors: 1 by CBMC, 0 by WP, 2 by Eva for the robot neuro. 1 have open alarms, 0 are not reached by Eva.', list.summary
  end

  private

  def list(file = '')
    Proof::ProvedList.new(file, LISTED.dup)
  end

  # Of a core of one module.
  def states(reached: [], with_open: [], harnesses: [Proof::Harness.new(HARNESS)])
    Dir.mktmpdir do |root|
      FileUtils.mkdir_p("#{root}/core/gate")
      File.write("#{root}/core/gate/gate.c", SOURCE)
      File.write("#{root}/core/gate/gate.h", HEADER)
      Proof::Coverage.new(reached: reached, with_open: with_open, harnesses: harnesses, root: root).states
    end
  end
end

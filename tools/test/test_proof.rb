# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a proof passes when all of its sentences hold, what it calls possible happens, and each fault that is
# seeded beside it is refuted; whatever else there is, is red and named. By the prover itself, on a unit of one line.

require 'minitest/autorun'
require 'stringio'
require 'tmpdir'
require_relative '../debian/prover'
require_relative '../proof/proof'

class TestProof < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  UNIT = "int half(int value)\n{\n    return (value - 1) / 2;\n}\n"
  PROOF = <<~C
    #include "prove.h"

    int half(int value);

    void prove_SWR_HALF_001_it_is_smaller(void)
    {
        int value;
        assume(value > 0);
        const int is = half(value);
        PROVE(is < value, "SWR-HALF-001: smaller");
        POSSIBLE(is > 5, "a large half");
    }
  C
  # Takes far longer than the test: the factors of a prime number.
  FACTORS = <<~C
    int half(int value)
    {
        const unsigned long long factor = (unsigned int)value;
        unsigned long long other;
        return ((other > 1U) && (other <= 2147483647U) && (factor * other == 1534567891234567949U)) ? 5 : 0;
    }
  C
  SLOW_RUN = 'Proof::Run.new([Proof::Harness.new(JSON.parse(ARGV[0]))], $stdout, at_night: false).call'
  MUTANT = { 'by' => 'prove_SWR_HALF_001_it_is_smaller', 'file' => 'core/half/half.c', 'before' => '/ 2', 'after' => '* 2' }.freeze
  ROW = { 'file' => 'half/prove_half.c', 'sources' => ['core/half/half.c'], 'proves' => ['half'], 'mutants' => [MUTANT] }.freeze
  RUN = <<~C
    #include "exhaustive.h"

    #include "half/half.c"

    void prove_SWR_HALF_001_it_is_smaller(void)
    {
        int larger = 0;
        for (int value = 1; value < 1000; value++) {
            larger |= (half(value) < value) ? 0 : 1;
        }
        POSSIBLE(half(13) > 5, "a large half");
        PROVE(larger == 0, "SWR-HALF-001: smaller");
    }
  C
  RUN_ROW = ROW.except('proves').merge('sources' => [], 'run' => true).freeze
  SHARE = "int half(int value, int part)\n{\n    return (part > 50) ? value - 1 : 0;\n}\n"
  CONTRACT = <<~C
    /*@ requires 1 <= value <= 1000 && 0 <= part <= 100;
        assigns \\nothing;
        ensures SWR_HALF_001: 0 <= \\result < value;
    */
    int half(int value, int part);

    static int value;
    static int part;

    /*@ requires 1 <= value <= 1000 && 0 <= part <= 100;
        assigns \\nothing;
    */
    void prove_SWR_HALF_001_it_is_smaller(void)
    {
        const int is = half(value, part);
        /*@ check SWR_HALF_001: is <= value; */
        (void)is;
    }

    #include "half/half.c"
  C
  BROKEN = MUTANT.merge('in' => 'half', 'before' => '- 1', 'after' => '+ 1').freeze
  BY_CONTRACT = ROW.except('proves').merge('by_contract' => ['half'], 'seconds' => 5, 'mutants' => [BROKEN]).freeze
  # Where a goal must not be proved, the solver would look for it as long as it may.
  REFUTED = BY_CONTRACT.merge('seconds' => 2, 'mutants' => []).freeze

  def test_SWR_TOOL_201_a_proof_that_holds_is_counted_with_its_properties
    text, is_green = run_proof
    assert is_green, text
    assert_match(/^\[[12]\/2\] ok  prove_SWR_HALF_001_it_is_smaller: \d+ properties, \d+\.\d s$/, text)
    assert_match(/^1 of 1 proofs hold with [1-9]\d* properties, 1 of 1 mutants are refuted$/, text)
  end

  def test_SWR_TOOL_201_a_sentence_that_does_not_hold_is_named_with_its_place
    text, is_green = run_proof(proof: PROOF.sub('value > 0', 'value >= 0'))
    refute is_green
    assert_includes text, 'verification/proof/half/prove_half.c:10: does not hold: SWR-HALF-001: smaller'
  end

  def test_SWR_TOOL_201_a_check_of_the_language_is_one_too
    text, is_green = run_proof(unit: UNIT.sub('(value - 1) / 2', 'value / (value - 7)'), row: ROW.merge('mutants' => []))
    refute is_green
    assert_match(%r{core/half/half\.c:3: does not hold: division by zero}, text)
  end

  def test_SWR_TOOL_201_a_loop_whose_end_is_not_seen_is_red
    loops = "int half(int value)\n{\n    int is = 0;\n    while (is + is + 1 < value) {\n        is++;\n    }\n    return is;\n}\n"
    text, is_green = run_proof(unit: loops, row: ROW.merge('mutants' => []))
    refute is_green
    assert_match(/does not hold: unwinding assertion/, text)
  end

  def test_SWR_TOOL_201_who_gives_no_answer_is_red
    text, is_green = run_proof(proof: PROOF.sub('int half(int value);', ''), row: ROW.merge('mutants' => []), unit: 'nonsense')
    refute is_green
    assert_match(/^\[1\/1\] RED/, text)
  end

  def test_SWR_TOOL_620_a_call_without_a_body_is_named_alone
    unit = UNIT.sub("int half", "struct third {\n    int is;\n};\nstruct third *third(void);\nint half").sub('value - 1', 'value - third()->is - third()->is')
    text, is_green = run_proof(unit: unit, row: ROW.merge('mutants' => []))
    refute is_green
    assert_equal ['no body for third, which core/half/half.c:7 calls: verification/proof/proofs.yml names no source or contract of it for ' \
                  'verification/proof/half/prove_half.c'], text.lines.grep(/^    /).map(&:strip)
  end

  def test_SWR_TOOL_620_a_call_that_never_happens_needs_no_body
    unit = UNIT.sub("int half", "int third(void);\nint half").sub("return", "return (value < 1) ? third() :")
    text, is_green = run_proof(unit: unit, row: ROW.merge('mutants' => []))
    assert is_green, text
  end

  def test_SWR_TOOL_621_contracts_that_hold_are_counted_with_their_goals
    text, is_green = run_proof(proof: CONTRACT, unit: SHARE, row: BY_CONTRACT)
    assert is_green, text
    assert_match(/^1 of 1 proofs hold with [1-9]\d* properties, 1 of 1 mutants are refuted$/, text)
  end

  def test_SWR_TOOL_621_what_does_not_hold_is_named_by_its_function
    text, is_green = run_proof(proof: CONTRACT, unit: SHARE.sub('value - 1', 'value / (part - 60)'), row: REFUTED)
    refute is_green
    assert_includes text, 'verification/proof/half/prove_half.c: does not hold: SWR-HALF-001: half_ensures_SWR_HALF_001'
    assert_includes text, 'verification/proof/half/prove_half.c: does not hold: half_assert_rte_division_by_zero'
  end

  def test_SWR_TOOL_621_a_prover_that_gives_no_answer_is_named
    text, is_green = run_proof(proof: CONTRACT, unit: 'nonsense', row: BY_CONTRACT.merge('mutants' => []))
    refute is_green
    assert_match(/^\[1\/1\] RED/, text)
    assert_match(/^    syntax error/, text)
  end

  def test_SWR_TOOL_800_a_lemma_function_that_does_not_hold_is_named
    lemma = "/*@ requires 0 <= a <= 100;\n    assigns \\nothing;\n    ensures a <= 99;\n*/\nstatic void lemma_smaller(int a)\n{\n}\n\n"
    text, is_green = run_proof(proof: CONTRACT.sub('static int value;', "#{lemma}static int value;"), unit: SHARE, row: REFUTED)
    refute is_green
    assert_includes text, 'verification/proof/half/prove_half.c: does not hold: lemma_smaller_ensures'
  end

  def test_SWR_TOOL_801_an_annotation_helps_and_changes_no_code
    loops = "int half(int value, int part)\n{\n    int is = 0;\n    while (is < part) {\n        is++;\n    }\n    return value - 1;\n}\n"
    says = ['loop invariant 0 <= is <= part; loop assigns is; loop variant part - is;']
    row = REFUTED.merge('annotations' => [{ 'file' => 'core/half/half.c', 'before' => 'while (is < part) {', 'says' => says }])
    text, is_green = run_proof(proof: CONTRACT, unit: loops, row: row)
    assert is_green, text
  end

  def test_SWR_TOOL_801_an_annotation_without_its_place_with_code_or_without_proof_is_refused
    annotation = { 'file' => 'core/half/half.c', 'before' => 'return', 'says' => ['assert 0 <= part;'] }
    { annotation.merge('before' => 'while') => 'core/half/half.c has the text of an annotation 0 times instead of once: while',
      annotation.merge('says' => ['assert 0 <= part; */ part = 0; /*']) => 'an annotation of core/half/half.c ends its comment: assert',
      annotation.merge('says' => ['admit part < value;']) => 'an annotation of core/half/half.c is no assert, lemma or loop: admit' }
      .each do |wrong, said|
      text, is_green = run_proof(proof: CONTRACT, unit: SHARE, row: REFUTED.merge('annotations' => [wrong]))
      refute is_green
      assert_includes text, said
    end
  end

  def test_SWR_TOOL_802_a_harness_that_is_run_is_judged_by_what_it_says
    text, is_green = run_proof(proof: RUN, row: RUN_ROW)
    assert is_green, text
    assert_match(/^1 of 1 proofs hold with 1 properties, 1 of 1 mutants are refuted$/, text)
    text, is_green = run_proof(proof: RUN.sub('value = 1', 'value = 0'), row: RUN_ROW.merge('mutants' => []))
    refute is_green
    assert_includes text, 'verification/proof/half/prove_half.c:12: does not hold: SWR-HALF-001: smaller'
  end

  def test_SWR_TOOL_802_a_harness_that_is_no_program_or_does_not_end_by_itself_is_named
    { 'value = 1' => 'value == nonsense', 'value++' => 'value += (*(volatile int *)0)' }.each do |before, after|
      text, is_green = run_proof(proof: RUN.sub(before, after), row: RUN_ROW.merge('mutants' => []))
      refute is_green
      assert_match(/^    (verification.*nonsense|ended by signal 11)/, text)
    end
  end

  def test_SWR_TOOL_202_a_fault_that_breaks_no_contract_is_named
    text, is_green = run_proof(proof: CONTRACT, unit: SHARE, row: BY_CONTRACT.merge('mutants' => [BROKEN.merge('after' => '- 1 + 0')]))
    refute is_green
    assert_includes text, 'the prover does not refute prove_SWR_HALF_001_it_is_smaller (core/half/half.c: - 1 => - 1 + 0)'
  end

  def test_SWR_TOOL_203_assumptions_of_a_contract_that_contradict_each_other_are_named
    text, is_green = run_proof(proof: CONTRACT.gsub('1 <= value <= 1000', '1 <= value <= 0'), unit: SHARE, row: REFUTED)
    refute is_green
    assert_includes text, 'never happens: possible: prove_SWR_HALF_001_it_is_smaller'
  end

  def test_SWR_TOOL_204_a_function_whose_contract_is_in_no_proof_is_named
    text, is_green = run_proof(proof: CONTRACT, unit: SHARE, row: BY_CONTRACT.merge('by_contract' => %w[half third], 'mutants' => []))
    refute is_green
    assert_includes text, "no function 'third'"
  end

  def test_SWR_TOOL_202_a_fault_that_is_not_refuted_is_named
    text, is_green = run_proof(row: ROW.merge('mutants' => [MUTANT.merge('after' => '/ 3')]))
    refute is_green
    assert_includes text, 'the prover does not refute prove_SWR_HALF_001_it_is_smaller (core/half/half.c: / 2 => / 3)'
  end

  def test_SWR_TOOL_202_a_fault_whose_text_is_not_there_once_is_named
    ['/ 5', 'value'].zip([0, 2]).each do |before, count|
      text, is_green = run_proof(row: ROW.merge('mutants' => [MUTANT.merge('before' => before)]))
      refute is_green
      assert_includes text, "core/half/half.c has the text of a mutant #{count} times instead of once: #{before}"
    end
  end

  def test_SWR_TOOL_203_what_never_happens_is_named
    text, is_green = run_proof(proof: PROOF.sub('value > 0', 'value > 0 && value < 0'), row: ROW.merge('mutants' => []))
    refute is_green
    assert_includes text, 'never happens: possible: a large half'
  end

  def test_SWR_TOOL_203_who_calls_nothing_possible_or_says_nothing_is_named
    text, = run_proof(proof: PROOF.sub(/ *POSSIBLE.*\n/, ''), row: ROW.merge('mutants' => []))
    assert_includes text, 'prove_SWR_HALF_001_it_is_smaller says nothing that is possible'
    text, = run_proof(proof: PROOF.sub(/ *PROVE.*\n/, ''), row: ROW.merge('mutants' => []))
    assert_includes text, 'prove_SWR_HALF_001_it_is_smaller has no sentence'
  end

  def test_SWR_TOOL_201_what_is_for_the_night_waits_for_it
    night = ROW.merge('night' => ['prove_SWR_HALF_001_it_is_smaller'])
    error = assert_raises(Proof::Refused) { run_proof(row: night) }
    assert_equal "there is no proof with '' in its name", error.message
    text, is_green = run_proof(row: night, at_night: true)
    assert is_green, text
  end

  def test_SWR_TOOL_204_a_function_that_is_in_no_proof_is_named
    text, is_green = run_proof(row: ROW.merge('proves' => %w[half third]))
    refute is_green
    assert_includes text, 'third is in no proof of verification/proof/half/prove_half.c'
  end

  def test_SWR_TOOL_200_a_package_of_another_content_is_refused
    Dir.mktmpdir do |folder|
      File.write("#{folder}/a_1.deb", 'what was meant')
      digest = Digest::SHA256.hexdigest('what was meant')
      assert_equal "#{folder}/a_1.deb", Prover.checked("#{folder}/a_1.deb", digest)
      File.write("#{folder}/a_1.deb", 'another')
      error = assert_raises(OwnApt::Refused) { Prover.checked("#{folder}/a_1.deb", digest) }
      assert_equal "a_1.deb has the SHA-256 #{Digest::SHA256.hexdigest('another')}, not #{digest}", error.message
    end
  end

  def test_SWR_TOOL_200_each_package_has_a_version_and_a_digest
    lines = File.readlines("#{ROOT}/tools/debian/prover.txt", chomp: true).grep(/^package/)
    assert_includes lines.map { |line| line.split[1] }, 'cbmc'
    assert_empty(lines.grep_v(/\Apackage +\S+ +[\w.:+-]+ +\h{64}( \S+)+\z/))
  end

  # Ended by force, it can end nothing itself.
  def test_SWR_TOOL_510_the_prover_ends_with_it
    in_project(PROOF.sub('is > 5', 'is == 5'), FACTORS) do
      pid = Process.spawn(RbConfig.ruby, '-r', "#{ROOT}/tools/proof/proof", '-e', SLOW_RUN, JSON.generate(ROW), out: File::NULL)
      provers = seen_until('the prover computes') { |found| found.any? { |process| computes?(process) } }
      Process.kill('KILL', pid)
      Process.wait(pid)
      assert_empty(seen_until('the prover has ended', &:empty?), "of #{provers.inspect}")
    end
  end

  private

  # Processes of the prover in this folder, once they are as wanted: two minutes are enough for a busy machine.
  def seen_until(what)
    1200.times do
      found = provers
      return found if yield(found)

      sleep 0.1
    end
    flunk "not seen within two minutes: #{what}"
  end

  def provers
    Dir.glob('/proc/[0-9]*').select do |process|
      File.readlink("#{process}/cwd") == Dir.pwd && File.read("#{process}/cmdline").include?('cbmc')
    rescue SystemCallError
      false
    end
  end

  # For a second: it has no more to say, and would not notice that nothing reads it.
  def computes?(process)
    File.read("#{process}/stat").split(') ').last.split[11].to_i > 100
  rescue SystemCallError
    false
  end

  # What it says, and whether all is green.
  def run_proof(proof: PROOF, unit: UNIT, row: ROW, at_night: false)
    out = StringIO.new
    is_green = in_project(proof, unit) { Proof::Run.new([Proof::Harness.new(row)], out, at_night: at_night).call }
    [out.string, is_green]
  end

  def in_project(proof, unit, &block)
    Dir.mktmpdir do |folder|
      FileUtils.mkdir_p(["#{folder}/verification/proof/half", "#{folder}/core/half"])
      FileUtils.ln_s("#{ROOT}/.tools", "#{folder}/.tools")
      FileUtils.cp(%w[prove.h exhaustive.h].map { |name| "#{ROOT}/verification/proof/#{name}" }, "#{folder}/verification/proof")
      File.write("#{folder}/verification/proof/half/prove_half.c", proof)
      File.write("#{folder}/core/half/half.c", unit)
      Dir.chdir(folder, &block)
    end
  end
end

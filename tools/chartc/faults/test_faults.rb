# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: a fault in the emitter is rejected by the checks on the code that it emits, on every chart on which
# it shows. The faults stand in seeds/, the report is build/conformance/faults.md.

require 'minitest/autorun'
require_relative 'report'
require_relative 'run'

class TestFaults < Minitest::Test
  FAULTS = Faults::Fault.all
  # Fewer would not do.
  FEWEST = 30

  RUN = Faults::Run.new(FAULTS.flat_map(&:charts).uniq)
  RESULTS = RUN.results(FAULTS)
  Minitest.after_run do
    RUN.close
    puts Faults::Report.new(RESULTS).write
  end

  RESULTS.each do |result|
    define_method("test_SWR_CHART_011_#{result.fault.stem}") do
      assert_nil result.unfit
      assert_empty result.accepted, "#{result.fault.says}: no check rejects this"
    end
  end

  def test_SWR_CHART_011_enough_faults_compile_and_behave_wrongly
    assert_operator RESULTS.count(&:behaves_wrongly?), :>=, FEWEST
    assert_equal FAULTS.length, FAULTS.map(&:stem).uniq.length
  end

  def test_SWR_CHART_011_the_untouched_emitter_passes_every_check
    RUN.untouched.each { |version, verdicts| assert_empty verdicts.compact, version }
  end

  def test_SWR_CHART_011_an_edit_without_meaning_is_accepted
    result = try('emit/c/selection.rb', '/* not for this state */', '/* not now */')
    assert_equal ['sample, direct'], result.accepted
    refute result.rejected?
  end

  def test_SWR_CHART_011_an_edit_must_find_its_place_once
    assert_equal 'its place stands 0 times in emit/c/direct.rb', try('emit/c/direct.rb', 'no such text', '').unfit
    assert_match(/\Aits place stands \d\d+ times/, try('emit/c/direct.rb', 'def ', '').unfit)
  end

  def test_SWR_CHART_011_an_edit_must_change_the_code
    assert_equal 'it changes nothing on sample', try('emit/c/expressions.rb', "subtract: '-'", "subtract: '+'").unfit
  end

  def test_SWR_CHART_011_an_edit_must_leave_an_emitter
    assert_match(/\Ait ends the emitter: /, try('emit/c/direct.rb', 'class Direct', 'class').unfit)
  end

  def test_SWR_CHART_011_an_edit_keeps_to_the_emitter
    assert_equal 'walk/walk.rb is no part of the emitter', try('walk/walk.rb', 'class Walk', 'class Walk').unfit
  end

  private

  def try(file, from, to)
    fault = Faults::Fault.new(says: 'a trial', file: file, from: from, to: to, charts: ['sample'])
    RUN.results([fault]).first
  end
end

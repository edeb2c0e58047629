# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../chart/emit/c/header'
require_relative '../chart/emit/c/source'
require_relative 'own_charts'

# The properties of a chart on its walk, and the counterexample of each one that is violated.
class TestChartProperties < Minitest::Test
  include OwnCharts

  UNITY = <<~C
    #include <stdio.h>
    #include <stdlib.h>
    #define TEST_ASSERT_TRUE_MESSAGE(condition, message) \\
        do { if (!(condition)) { puts(message); exit(1); } } while (0)
  C

  MAIN = <<~C
    void contract_broken(const char *module, uint32_t id);
    void contract_broken(const char *module, uint32_t id) { (void)module; (void)id; abort(); }
    int main(void) { TEST(); return 0; }
  C

  def test_SWR_CHART_002_the_chart_passes_and_says_on_how_much_each_property_was_checked
    document = parse(CHART)
    walk = walk_of(CHART)
    Chart::WalkChecks.run(document, walk)
    verdicts = Chart::PropertyChecks.verdicts(document, walk)
    assert_equal %w[LAMP-P01 LAMP-P02 LAMP-P03 LAMP-P04 LAMP-P05], verdicts.map { |one| one.property.id }
    assert_equal [[:holds, 4], [:holds, 4 * 2 * 4], [:holds, 4], [:holds, 2], [:holds, 4]],
                 verdicts.map { |one| [one.verdict, one.checked] }
  end

  BROKEN = {
    'a_violated_invariant' => [23, 'pull, start with is_allowed, warm_up expires', [" &amp;&amp; In('closed')", '']],
    'a_response_that_fails' => [36, 'start with is_allowed, warm_up expires, stop with is_kept',
                                ['event="stop" target="warming"', 'event="stop"']],
    'a_step_by_another_event' => [37, 'start with is_allowed, shut',
                                  [/(?=<transition bs:id="LAMP-T05")/,
                                   '<transition bs:id="LAMP-T10" event="shut" target="on" bs:req="SWR-CHART-001"/>']],
    'a_configuration_too_far_away' => [38, 'pull', ['steps="3"', 'steps="2"']],
    'a_configuration_out_of_reach' => [38, 'start with is_allowed, warm_up expires',
                                       [/ *<bs:invariant.*\n *<bs:response.*\n/, ''],
                                       [/ *<bs:reachable.*\n/, ''], [' steps="1"', ''],
                                       [/(LAMP-T07.*) target="off"/, '\1'],
                                       [/(LAMP-T08.*) target="warming"/, '\1'],
                                       [/(LAMP-T09.*) target="off"/, '\1']]
  }.freeze

  BROKEN.each do |name, (rule, path, *changes)|
    define_method("test_SWR_CHART_013_#{name}_comes_with_the_shortest_list_of_events") do
      refusal = refusal_of(*changes)
      assert_equal rule, refusal.rule, refusal.message
      assert_match(/reached by: #{path};/, refusal.message)
      assert_equal path, refusal.counterexample.words
    end
  end

  def test_SWR_CHART_002_a_property_may_speak_of_raised_events
    changes = [[%r{(event="is_warm" target="on" [^>]*)/>}, '\1><raise event="lit"/></transition>'],
               ['bs:tick="1ms"', '\0 bs:internal="lit"'], ['on="is_warm"', 'on="lit"'],
               [/(?=<transition bs:id="LAMP-T01")/, transition('event="lit"')]]
    assert_sound(*changes)
    walk = walk_of(changed(*changes))
    assert_equal [2, 1, 1], [walk.most_microsteps, walk.most_rounds, walk.most_raised]
  end

  # One that an earlier expiry cancelled has not happened.
  def test_SWR_CHART_002_a_timer_that_was_cancelled_is_no_event_of_the_step
    body = '<state id="a"><onentry><send id="one" event="first" delay="1s"/><send id="two" event="second" delay="1s"/>
            </onentry><transition event="first" target="b"><cancel sendid="two"/></transition>
            <transition event="second" target="c"/></state><state id="b"/><state id="c"/>
            <bs:response id="LAMP-P01" on="second" from="In(\'a\')" expr="In(\'c\')"/>'
    document = engine(body)
    walk = Chart::Walk.new(document).run
    Chart::WalkChecks.run(document, walk)
    assert_equal [1], Chart::PropertyChecks.verdicts(document, walk).map(&:checked)
  end

  def test_SWR_CHART_002_a_property_that_speaks_of_nothing_is_refused
    never = "from=\"In('open') &amp;&amp; In('on')\""
    assert_equal 36, refusal_of(['on="pull stop"', "\\0 #{never}"]).rule
    assert_equal 37, refusal_of(["from=\"!In('on')\"", never]).rule
    assert_match(/LAMP-P04 holds only because/, refusal_of(["from=\"In('off')\"", never]).message)
  end

  # Nothing of a guard is there for nothing: without any of its parts the chart is refused, or does something else.
  def test_SWR_CHART_002_every_part_of_a_guard_shows
    whole = "is_allowed &amp;&amp; In('closed')"
    assert_equal 23, refusal_of([whole, 'is_allowed']).rule
    refute_equal behaviour(CHART), behaviour(changed([whole, "In('closed')"]))
    assert_equal 22, refusal_of([' cond="!is_kept"', '']).rule
    assert_equal 22, refusal_of([' cond="is_kept"', '']).rule
  end

  # --- counterexamples --------------------------------------------------------------------------------------------

  # The test must fail on the broken chart and pass on the sound one.
  BROKEN.each do |name, (_rule, _path, *changes)|
    define_method("test_SWR_CHART_013_#{name}_comes_with_a_test_that_fails") do
      example = refusal_of(*changes).counterexample
      assert_match(/\Atest_lamp_p0\d_counterexample\.c\z/, example.file_name)
      assert_match(/^void test_SWR_CHART_002_lamp_p0\d_holds\(void\)$/, example.test)
      assert(example.test.lines.all? { |line| line.chomp.length <= 100 })
      output, status = run_on(changed(*changes), example.test)
      assert_equal [false, example.test[/"(LAMP-P0\d)"/, 1]], [status.success?, output.chomp]
    end
  end

  GUARDS = {
    'an_overlap' => [22, 'start with is_allowed and is_kept', 'LAMP-T03',
                     [/(?=<transition bs:id="LAMP-T03")/, '<transition bs:id="LAMP-T10" event="start" cond="is_kept" ' \
                                                          'bs:req="SWR-CHART-001"/>']],
    'a_forgotten_event' => [25, 'start', 'closed-start', [' bs:ignores="start stop"', ' bs:ignores="stop"']],
    'a_timer_for_nothing' => [25, 'start with is_allowed, warm_up expires', 'closed-is_warm',
                              ['event="is_warm" target', 'event="is_warm" cond="is_kept" target']]
  }.freeze

  # Of wrong guards too: on the broken chart it fails.
  GUARDS.each do |name, (rule, path, id, *changes)|
    define_method("test_SWR_CHART_013_#{name}_comes_with_a_test_that_fails") do
      refusal = refusal_of(*changes)
      example = refusal.counterexample
      assert_equal [rule, path], [refusal.rule, example.words]
      output, status = run_on(changed(*changes), example.test)
      assert_equal [false, id], [status.success?, output.chomp], example.test
    end
  end

  def test_SWR_CHART_013_the_test_of_an_event_that_does_nothing_passes_where_a_transition_takes_it
    _rule, _path, _id, *changes = GUARDS.fetch('a_timer_for_nothing')
    output, status = run_on(CHART, refusal_of(*changes).counterexample.test)
    assert status.success?, output
  end

  def test_SWR_CHART_013_the_test_of_a_counterexample_passes_on_the_repaired_chart
    %w[a_violated_invariant a_response_that_fails a_step_by_another_event].each do |name|
      _rule, _path, *changes = BROKEN.fetch(name)
      output, status = run_on(CHART, refusal_of(*changes).counterexample.test)
      assert status.success?, "#{name}: #{output}"
    end
  end

  private

  def behaviour(text)
    walk_of(text).pairs.map do |pair|
      [pair.before, pair.stimulus, pair.outcomes.map { |one| [one.after, one.taken.map(&:id)] }]
    end
  end

  # Compiles the chart, whatever its checks say, with the test of a counterexample.
  def run_on(text, test)
    Dir.mktmpdir do |folder|
      document = parse(text)
      walk = walk_of(text)
      files = { 'lamp_chart.h' => Chart::C::Header.new(document, walk).emit, 'unity.h' => UNITY,
                'lamp_chart.c' => Chart::C::Source.new(document, walk).emit,
                'test.c' => test + MAIN.sub('TEST', test[/^void (test_\w+)/, 1]) }
      files.each { |name, content| File.write(File.join(folder, name), content) }
      compile(folder)
      Open3.capture2e(File.join(folder, 'test'))
    end
  end

  def compile(folder)
    core = File.join(__dir__, '..', '..', 'core')
    output, status = Open3.capture2e('gcc', '-std=c99', '-Wall', '-Wextra', '-Werror', "-I#{folder}", "-I#{core}",
                                     *Dir[File.join(folder, '*.c')], '-o', File.join(folder, 'test'))
    assert status.success?, output
  end
end

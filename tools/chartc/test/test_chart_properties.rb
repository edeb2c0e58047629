# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../lib/emit/c/header'
require_relative '../lib/emit/c/source'
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

  # The lamp without properties that say the same.
  WITHOUT = [[/ *<bs:invariant.*\n *<bs:response.*\n *<bs:only.*\n *<bs:reachable.*\n *<bs:reachable.*\n/, '']].freeze

  # A change of the chart: one more response.
  def self.added(attributes)
    ['</scxml>', "<bs:response id=\"LAMP-P06\" bs:req=\"SWR-CHART-002\" #{attributes}/>\n</scxml>"]
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
                                       [/(LAMP-T09.*) target="off"/, '\1']],
    'a_response_that_fails_with_an_input' => [36, 'start with is_allowed, warm_up expires, stop with is_kept',
                                              added('on="stop" from="In(\'on\') &amp;&amp; is_kept" expr="In(\'off\')"')],
    'an_action_that_is_not_done' => [36, 'start with is_allowed, warm_up expires', ['bs:id="LAMP-T03"', '\0 bs:do="light"'],
                                     added('on="is_warm" does="light"')],
    'an_action_that_is_done' => [36, 'start with is_allowed', ['bs:id="LAMP-T03"', '\0 bs:do="light"'],
                                 added('on="start" does=""')],
    'a_timer_that_is_not_started' => [36, 'start with is_allowed, start',
                                      added('on="start" from="In(\'warming\')" starts="warm_up"')],
    'a_state_that_is_left' => [36, 'start with is_allowed, stop', added('on="stop" from="In(\'warming\')" stays="true"')],
    'a_state_that_is_entered_again' => [36, 'start with is_allowed, start',
                                        [/bs:ignores="start"(?=>\n *<onentry>)/, ''],
                                        [/(?=<transition bs:id="LAMP-T04")/, '<transition bs:id="LAMP-T10" event="start" ' \
                                                                             'target="warming" bs:req="SWR-CHART-001"/>'],
                                        added('on="start" from="In(\'warming\')" stays="true"')]
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

  def test_SWR_CHART_033_a_property_may_say_what_a_step_does
    light = ['bs:id="LAMP-T03"', '\0 bs:do="light"']
    assert_sound(light, added('on="start" from="In(\'off\') &amp;&amp; is_allowed &amp;&amp; In(\'closed\')" does="light" ' \
                              'starts="warm_up"'))
    assert_sound(light, added('on="start" from="!In(\'off\') || !is_allowed" does="" stays="true"'))
  end

  def test_SWR_CHART_040_a_property_may_say_where_a_chart_starts_and_where_it_goes_when_it_is_damaged
    start = '<bs:start id="LAMP-P06" bs:req="SWR-CHART-040" expr="In(\'off\')" does=""/>'
    damaged = '<bs:damaged id="LAMP-P07" bs:req="SWR-CHART-040" expr="In(\'off\') &amp;&amp; !In(\'on\')"/>'
    own = ['</scxml>', "#{start}\n#{damaged}\n</scxml>"]
    assert_sound(own)
    { 40 => ['initial="off"', 'initial="on"'],
      41 => ['bs:safe="closed off"', 'bs:safe="closed on"'] }.each do |rule, change|
      assert_match(/R#{rule} LAMP-P0[67] is violated in closed on, /, refusal_of(own, change, *WITHOUT).message)
    end
    refusal = assert_raises(Chart::Refusal) { parse(changed(own, ["amp; !In('on')\"/>", 'amp; is_kept"/>'])) }
    assert_includes refusal.message, 'R14 the data of a damaged chart may be anything; remove "is_kept"'
  end

  # What only acts, stays.
  def test_SWR_CHART_033_a_transition_without_target_stays
    assert_sound([/bs:ignores="start"(?=>\n *<onentry>)/, ''],
                 [/(?=<transition bs:id="LAMP-T04")/, transition('event="start" bs:do="warn"')],
                 added('on="start" from="In(\'warming\')" does="warn" stays="true"'))
  end

  def test_SWR_CHART_033_what_a_property_cannot_say_is_refused
    { 'on="stop"' => 'the property demands nothing; add one of: expr, does, starts, stays',
      'on="stop" does="sing"' => '"sing" is no action; ', 'on="stop" starts="tea"' => '"tea" is no timer; write one of: warm_up',
      'on="stop" stays="no"' => 'stays="no" is not in the profile',
      'on="stop" expr="is_kept"' => 'a property reads no input' }.each do |attributes, words|
      refusal = assert_raises(Chart::Refusal) { parse(changed(added(attributes))) }
      assert_includes refusal.message, words
    end
  end

  # Neither words nor remedy lead away from the guard.
  def test_SWR_CHART_032_a_guard_that_is_missing_is_not_advised_away
    message = refusal_of([/(LAMP-T03.*) cond="[^"]*"/, '\1'], [/ *<bs:invariant.*\n/, '']).message
    assert_match(/R26 "start" is always taken in "off", by LAMP-T03; give what SWR-CHART-001 asks for as a guard/, message)
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

  def added(attributes)
    self.class.added(attributes)
  end

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
    core = File.join(__dir__, '..', '..', '..', 'core')
    output, status = Open3.capture2e('gcc', '-std=c99', '-Wall', '-Wextra', '-Werror', "-I#{folder}", "-I#{core}",
                                     *Dir[File.join(folder, '*.c')], '-o', File.join(folder, 'test'))
    assert status.success?, output
  end
end

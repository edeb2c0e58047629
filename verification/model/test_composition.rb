# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: the charts of one card and two axes, connected as the controller connects them, do the same on every
# reachable pair in any order, and every property of the whole holds. A pair is made of steps of charts: each step
# is taken by code of gcc and of clang, here and on ARM, and compared with the interpreter's. Every pair is made of them by
# an explorer of gcc's; with one axis (a twelfth of the configurations) by explorers of all four, and with two axes and
# fewer stimuli by one of clang's. One of two configurations in which the axes have changed places is explored for both:
# that this is right is checked on all that composition.yml says, and on every pair.
# SPIN, with one axis, comes into as many configurations and violates no property. The controller itself, on the
# simulated box with an operator and a world that do anything, comes into no configuration and permits nothing that the
# composition lacks. SCION has no part of its own here: on every pair of every chart it does what the interpreter does
# (test_back_to_back.rb). The reasons against motion are compared by name: composition.yml, permit_decide() and what the
# running controller shows have the same reasons.

require 'minitest/autorun'
require 'tmpdir'
require_relative 'composition/composed_chart'
require_relative 'composition/explorer'

class TestComposition < Minitest::Test
  SPIN_DEPTH = 4_000_000

  def composition(axes)
    @@compositions ||= {} # rubocop:disable Style/ClassVars
    @@compositions[axes] ||= in_words { Composition.new(axes: axes) }
  end

  # A chart that no longer fits the others fails here in words: a name that composition.yml still says, or code that
  # ends early.
  def in_words
    yield
  rescue Composition::Wrong, CompiledChart::Failed => e
    flunk "#{Composition::FILE}: #{e.message}"
  end

  def explore(axes, kind, what = composition(axes), **options, &mutate)
    in_words { Dir.mktmpdir { |folder| Explorer.new(what).run(folder, kind: kind, **options, &mutate) } }
  end

  # Explores until it is found.
  def assert_found(finding, axes, what = composition(axes), **options, &mutate)
    report = explore(axes, 'gcc', what, wanted: finding, **options, &mutate)
    assert_match finding, report.findings.join("\n")
  end

  # With authority, and the needs of the armed order.
  def commands
    @@commands ||= in_words { Composition.new(axes: 1, commands: true) } # rubocop:disable Style/ClassVars
  end

  def sound(axes, kind)
    @@reports ||= {} # rubocop:disable Style/ClassVars
    @@reports[[axes, kind]] ||= explore(axes, kind, asked: controller_run).tap do |report|
      assert_empty report.findings.first(3)
    end
  end

  def report_counts(report, who)
    puts "composition     #{report.configurations} configurations (#{report.explored} explored), " \
         "#{report.pairs} pairs (#{report.explored_pairs} explored): #{who}"
  end

  def test_SWR_CHART_012_one_card_and_two_axes_equal_the_interpreter_and_keep_every_property
    report = sound(2, 'gcc')
    assert_operator report.configurations, :>, 300_000
    report_counts(report, 'gcc, interpreter (two axes)')
  end

  # Without these stimuli two axes can be explored without exchanging them.
  RARE = %w[loop.late pedal.differ scanner.on plan.register axis_N.home workphase.request_planning
            workphase.request_manual workphase.request_motion].freeze
  NEVER = "when: In('plan.empty') && In('plan.targeted')"
  UNCHANGED = Class.new(Exchange) do
    def name(text)
      text
    end
  end

  def two_axes_in_short(from = '', to = '', exchange: Exchange)
    text = File.read(Composition::FILE)
    assert_includes text, from
    short = text.sub(from, to).gsub(/\{send: (#{Regexp.union(RARE)})\b.*$/, "{send: \\1, #{NEVER}}")
    written(short, axes: 2, exchange: exchange)
  end

  def in_short(kind)
    @@in_short ||= {} # rubocop:disable Style/ClassVars
    @@in_short[kind] ||= explore(2, kind, two_axes_in_short)
  end

  def test_SWR_CHART_012_exchanging_the_axes_saves_configurations_and_loses_none
    all = explore(2, 'gcc', two_axes_in_short(exchange: UNCHANGED))
    half = in_short('gcc')
    assert_equal [all.configurations, all.pairs], [half.configurations, half.pairs]
    assert_equal [all.explored, all.explored_pairs], [all.configurations, all.pairs]
    assert_operator half.explored, :<, half.configurations * 0.6
  end

  def test_SWR_CHART_012_code_of_clang_does_what_code_of_gcc_does
    here = sound(1, 'gcc')
    assert_equal here, sound(1, 'clang')
    assert_equal in_short('gcc'), in_short('clang')
    report_counts(here, 'gcc, clang, interpreter (one axis)')
  end

  def test_SWR_CHART_012_axes_that_are_not_alike_are_found
    assert_found(/^the axes are not alike: .*card\./, 2, two_axes_in_short) do |name, source|
      name == 'composition' ? source.gsub(', true},', ', false},') : source
    end
  end

  {
    'a_reaction_of_one_axis_that_is_not_said_to_be' => ['of: axis_1, ', '', /\Areaction card enters lost axis_1/],
    'a_condition_on_one_axis' => ['when: permit_N', 'when: permit_1', /\Astimulus stall_1\.driven/],
    'an_input_from_one_axis' => ["workphase.has_target: In('plan.targeted')", "workphase.has_target: In('axis_1.homed')",
                                 /\Ainput workphase\./],
    'a_fact_of_one_axis' => ["is_homed: In('axis_N.homed')", "is_homed: In('axis_1.homed')", /\Afacts permit_1/],
    'a_property_of_one_axis' => ["In('stall_N.stalled') || !In('axis_N", "In('stall_N.stalled') || !In('axis_1",
                                 /\Aproperty COMP-I02/]
  }.each do |what, (from, to, finding)|
    define_method("test_SWR_CHART_012_#{what}_is_refused") do
      assert_match finding, assert_raises(Composition::Wrong) { two_axes_in_short(from, to) }.message
    end
  end

  def test_SWR_CHART_012_one_axis_on_a_cortex_a9_does_what_it_does_here
    here = sound(1, 'gcc')
    assert_equal here, sound(1, 'arm-gcc')
    assert_equal here, sound(1, 'arm-clang')
    report_counts(here, 'gcc, interpreter, Cortex-A9 by gcc and clang (one axis)')
  end

  # The one state more is that before the start.
  def test_SWR_CHART_012_spin_reaches_the_same_configurations_and_violates_nothing
    model = Chart.promela(composed(composition(1)))
    report = SpinVerifier.verify(model, SPIN_DEPTH)
    assert_equal [sound(1, 'gcc').configurations + 1, 0, nil], report.to_a.first(3)
    puts "composition     #{report.stored - 1} configurations: SPIN (one axis)"
  end

  # composition.yml is a reading of the controller's code; here the code itself is asked.
  def test_SWR_CHART_012_the_controller_comes_into_no_configuration_and_permits_nothing_that_the_composition_lacks
    assert_operator controller_run.length, :>, 1000
    assert_empty sound(2, 'gcc').findings
    puts "composition     #{controller_run.length} configurations of it seen in the controller on the simulated box"
  end

  def test_SWR_CHART_012_a_composition_that_lacks_something_of_the_controller_is_found
    lacking = changed('  - {send: pedal.differ}', "  - {send: pedal.differ, when: In('pedal.fault')}")
    assert_found(/^not reached: /, 1, lacking, asked: controller_run)
  end

  # The permit is the same without this reason: there are others whenever it stands.
  def test_SWR_CHART_034_a_controller_that_forgets_a_reason_is_found
    seen = ControllerRun.seen(commands, episodes: 40) do |code|
      code.sub(/(?<=is_pedal_unproven = ).*(?=,)/, 'false')
    end
    assert_found(/^other reasons: /, 1, asked: seen)
  end

  def test_SWR_CHART_034_a_reason_that_is_another_one_is_found
    other = changed("NOTHING_ARMED: In('arming.none')", "NOTHING_ARMED: In('arming.none') && In('estop.clear')")
    findings = explore(1, 'gcc', other, asked: controller_run).findings.join("\n")
    assert_match(/^permit_decide\(\) gives other reasons: /, findings)
    assert_match(/^other reasons: /, findings)
  end

  # Contents that do not fit, and the words of their refusal.
  {
    'no_yaml' => ['axes: 2', 'axes: [2', /did not find expected/], 'no_section' => [/^axes: 2\n/, '', /has no axes/],
    'a_section_of_another_kind' => ['axes: 2', 'axes: two', /axes is no Integer/],
    'a_stimulus_without_event' => ['- {send: pedal.differ}', '- {when: permit_1}', /stimuli: it has no send/],
    'a_word_that_means_nothing' => ['{send: pedal.differ}', '{send: pedal.differ, whem: permit_1}', /whem means nothing/],
    'an_event_that_is_none' => ['- {send: pedal.differ}', '- {send: pedal.differs}', /pedal\.differs: no such event/],
    'a_state_that_is_none' => ["SCANNER_ACTIVE: In('scanner.active')", "SCANNER_ACTIVE: In('scanner.on')",
                               /scanner\.on: no such state/],
    'a_member_that_is_none' => ['- {send: pedal.differ}', '- {send: pedals.differ}', /no member pedals/],
    'a_chart_that_is_none' => ['statecharts/loop_guard.scxml', 'statecharts/loop.scxml', /No such file/],
    'an_input_that_is_none' => ['workphase.is_able: >-', 'workphase.is_idle: >-', /workphase\.is_idle: no such input/],
    'a_condition_that_cannot_be_read' => ['when: permit_N', "when: In('pedal.pressed') and", /In\('pedal\.pressed'\) and: /],
    'a_condition_on_anything' => ['when: permit_N', 'when: any', /a condition reads any/],
    'an_axis_that_is_none' => ['when: permit_N', 'when: permit_3', /a condition reads permit_3/],
    'a_comparison' => ['when: permit_N', 'when: 1 < 2', /may not hold compare/],
    'a_property_without_what_holds' => [', then: "!permit_N"}', '}', /COMP-I04 has no then/],
    'a_property_of_two_kinds' => ['always: "!In(\'stall_N', 'reaches: permit_1, always: "!In(\'stall_N', /COMP-I02 says/]
  }.each do |what, (from, to, words)|
    define_method("test_SWR_CHART_012_#{what}_is_told_in_words") do
      text = File.read(Composition::FILE)
      other = text.sub(from, to)
      refute_equal text, other
      assert_match words, assert_raises(Composition::Wrong) { written(other, axes: 2) }.message
    end
  end

  def controller_run
    @@controller_run ||= in_words { ControllerRun.seen(commands) } # rubocop:disable Style/ClassVars
  end

  def composed(composition)
    text = ComposedChart.new(composition).emit
    tree = Chart.tree('composition.scxml', text)
    Chart.document('composition.scxml', ProductCharts::LIMITS, mode: :engine, tree: tree)
  end

  # A composition.yml with one line changed.
  def changed(from, to, **options)
    text = File.read(Composition::FILE)
    assert_equal 1, text.scan(from).length, "#{from} stands once"
    written(text.sub(from, to), axes: 1, **options)
  end

  def written(text, **options)
    Dir.mktmpdir do |folder|
      file = File.join(folder, 'composition.yml')
      File.write(file, text)
      return Composition.new(file: file, **options)
    end
  end

  def test_SWR_CHART_012_with_who_commands_and_what_the_order_needs_every_property_holds
    report = explore(1, 'gcc', commands, asked: controller_run)
    assert_empty report.findings.first(3)
    assert_operator report.configurations, :>, 300_000
    report_counts(report, 'gcc, interpreter (one axis, with authority and what the order needs)')
  end

  {
    'authority does discard_order, send: [arming.discard]' => /^COMP-I27: .*authority\.lose$/,
    'workphase does arm_order, send: [authority.take]' => /^COMP-I27: .*request_start_up\b[^,]*$/,
    'arming does renew_pedal, send: [need.armed]' => /^COMP-I31/
  }.each do |row, finding|
    define_method("test_SWR_CHART_012_without_#{row[/\w+ \w+ \w+/].tr(' ', '_')}_#{row[/(?<=\[)\w+/]}_a_property_is_violated") do
      assert_found(finding, 1, changed(row, row.sub(/\[.*\]/, '[plan.forget]'), commands: true))
    end
  end

  def test_SWR_CHART_012_a_motion_of_all_axes_that_is_armed_without_one_is_found
    lacking = changed("any && (!In('need.asking') || In('axis_N.homed'))", 'any', commands: true)
    assert_found(/^COMP-I26\.1: .*need\.ask_mo/, 1, lacking)
  end

  # Acts that the controller might forget, and the property that shows it with the shortest way there.
  {
    'arming does renew_pedal, send: [pedal.renew]' => /^COMP-I11\.1: .*workphase\.request_start_up/,
    'workphase does discard_order, send: [arming.discard]' => /^COMP-I10\.1: .*workphase\.request_stop$/,
    'stall_N does report_stall, send: [axis_N.failed]' => /^COMP-I02\.1: .*stall_1\.no_progress$/,
    'estop enters pulled, send: [axis_N.disable, workphase.estop]' => /^COMP-I05\.1: .*estop\.opened$/,
    'axis_N hears failed, send: [plan.forget, arming.fault]' => /^COMP-I09\.1: .*axis_1\.failed$/
  }.each do |row, finding|
    define_method("test_SWR_CHART_012_without_#{row[/\w+ \w+ \w+/].tr(' ', '_')}_a_property_is_violated") do
      assert_found(finding, 1, changed(row, row.sub(/\[.*\]/, '[plan.forget]')))
    end
  end

  def test_SWR_CHART_012_a_permit_that_forgets_the_pedal_is_found
    forgetful = changed("is_pedal_pressed: In('pedal.pressed')", "is_pedal_pressed: \"!In('pedal.unproven')\"")
    assert_found(/permit_decide\(\) is not the permit: .*pedal/, 1, forgetful)
  end

  def test_SWR_CHART_012_a_chart_compiled_wrongly_is_found_with_the_way_there
    assert_found(/\Adifference: .*request_start_up.*, estop\.opened$/, 1) do |name, source|
      name == 'estop_latch' ? source.sub('(self, ESTOP_LATCH_STATE_PULLED)', '(self, ESTOP_LATCH_STATE_CLEAR)') : source
    end
  end
end

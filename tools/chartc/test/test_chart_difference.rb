# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: the difference of two versions of a chart names every change of its meaning, and nothing else.

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'rbconfig'
require 'tmpdir'
require_relative '../lib/compiled'
require_relative '../lib/difference'

class TestChartDifference < Minitest::Test
  COMPILER = File.expand_path('../chartc', __dir__)
  LIMITS = { 'cycle_us' => 1000, 'wait_us' => 20_000, 'slow_us' => 30_000 }.freeze
  GATE = <<~XML
    <!-- A gate and its lamp. -->
    <scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" datamodel="ecmascript" name="gate" bs:tick="1ms" initial="all" bs:safe="shut dark">
      <parallel id="all">
        <state id="gate" initial="shut">
          <state id="shut" bs:req="SWR-CHART-001" bs:ignores="push">
            <transition bs:id="GATE-T01" event="pull" target="ajar" cond="is_free" bs:do="creak squeak" bs:req="SWR-CHART-001"/>
            <transition bs:id="GATE-T02" event="pull" cond="!is_free" bs:do="creak" bs:req="SWR-CHART-001"/>
          </state>
          <state id="ajar" bs:req="SWR-CHART-001" bs:ignores="pull">
            <onentry><send id="wait" event="slam" delay="20ms" bs:limit="wait_us" bs:kind="watchdog"/></onentry>
            <onexit><cancel sendid="wait"/></onexit>
            <transition bs:id="GATE-T03" event="slam" target="shut" bs:req="SWR-CHART-001"/>
            <transition bs:id="GATE-T04" event="push" target="shut" bs:req="SWR-CHART-001"/>
          </state>
        </state>
        <state id="lamp" initial="dark">
          <state id="dark" bs:req="SWR-CHART-001"/>
        </state>
      </parallel>
      <datamodel>
        <!-- Nothing blocks it. -->
        <data id="is_free" expr="false"/>
      </datamodel>
      <bs:invariant id="GATE-I01" bs:req="SWR-CHART-002" expr="In('shut') || In('ajar')"/>
    </scxml>
  XML

  def test_SWR_CHART_006_layout_comments_and_order_of_attributes_mean_nothing
    other = GATE.gsub(/<!--.*?-->/m, '<!-- Other words. -->').gsub(/^ +/, "\n  ")
    other = other.gsub(/ target="(\w+)"( cond="[^"]*")?/, "\\2\n target=\"\\1\"")
    other = other.sub("') || In", "')||(In").sub("ajar')\"", "ajar'))\"")
    refute_equal GATE, other
    assert_equal "gate: no difference in meaning\n", difference(other)
  end

  def test_SWR_CHART_006_the_place_of_states_and_of_unlike_transitions_means_nothing
    moved = swap(GATE, 'GATE-T03', 'GATE-T04').sub('initial="shut"', 'initial="shut" ')
    assert_equal "gate: no difference in meaning\n", difference(moved)
    shut = GATE[%r{ *<state id="shut".*?</state>\n}m]
    ajar = GATE[%r{ *<state id="ajar".*?</state>\n}m]
    assert_equal "gate: no difference in meaning\n", difference(GATE.sub(shut + ajar, ajar + shut))
  end

  def test_SWR_CHART_006_the_order_of_transitions_that_hear_the_same_event_is_reported
    assert_equal ['~ order of pull in shut: GATE-T01, GATE-T02 -> GATE-T02, GATE-T01'],
                 changes(swap(GATE, 'GATE-T01', 'GATE-T02'))
  end

  def test_SWR_CHART_006_an_order_that_only_lost_or_won_an_element_is_no_news
    assert_equal ['- transition GATE-T02: source shut, events pull, guard !is_free, actions creak, ' \
                  'requirements SWR-CHART-001'],
                 changes(GATE.sub(/ *#{Regexp.escape(transition('GATE-T02'))}\n/, ''), checked: false)
  end

  def test_SWR_CHART_006_the_order_of_regions_is_reported
    gate = GATE[%r{ *<state id="gate".*?^    </state>\n}m]
    lamp = GATE[%r{ *<state id="lamp".*?^    </state>\n}m]
    assert_equal ['~ order of regions in all: gate, lamp -> lamp, gate'], changes(GATE.sub(gate + lamp, lamp + gate))
  end

  def test_SWR_CHART_006_a_change_of_a_transition_names_what_changed
    assert_equal ['~ transition GATE-T04 targets: shut -> ajar'],
                 changes(GATE.sub('event="push" target="shut"', 'event="push" target="ajar"'))
    assert_equal ['~ transition GATE-T01 actions: creak, squeak -> squeak'],
                 changes(GATE.sub('"creak squeak"', '"squeak"'))
    assert_equal ['~ transition GATE-T03 requirements: + SWR-CHART-002'],
                 changes(GATE.sub(/(GATE-T03.*)SWR-CHART-001/, '\1SWR-CHART-001 SWR-CHART-002'))
    assert_equal ["~ transition GATE-T01 guard: is_free -> is_free && In('dark')"],
                 changes(GATE.sub('cond="is_free"', "cond=\"is_free &amp;&amp; In('dark')\""), checked: false)
    moved = GATE.sub(/^ +(<transition bs:id="GATE-T04".*\n)/, '')
                .sub('<state id="shut"', "#{transition('GATE-T04')}<state id=\"shut\"")
    assert_equal ['~ transition GATE-T04 source: ajar -> gate'], changes(moved, checked: false)
  end

  def test_SWR_CHART_006_what_came_and_what_went_is_reported_in_one_line_each
    added = GATE.sub('<state id="dark" bs:req="SWR-CHART-001"/>',
                     '<state id="dark" bs:req="SWR-CHART-001" bs:ignores="off"><transition bs:id="GATE-T05" ' \
                     'event="on" target="lit" bs:req="SWR-CHART-001"/></state><state id="lit" bs:ignores="on" ' \
                     'bs:req="SWR-CHART-001" bs:hazard="HAZ-01"><transition bs:id="GATE-T06" event="off" ' \
                     'target="dark" bs:req="SWR-CHART-001"/></state>')
    came = ['+ event on: caused by outside', '+ event off: caused by outside', '~ state dark ignores: + off',
            '+ state lit: kind atomic, in lamp, ignores on, requirements SWR-CHART-001, hazards HAZ-01',
            '+ transition GATE-T05: source dark, events on, targets lit, requirements SWR-CHART-001',
            '+ transition GATE-T06: source lit, events off, targets dark, requirements SWR-CHART-001',
            '~ configurations: 2 -> 4', '~ pairs: 10 -> 36']
    assert_equal came, changes(added)
    went = text(added, GATE)
    assert_includes went, "\n  - state lit: kind atomic"
    assert_includes went, "\n  ~ configurations: 4 -> 2"
  end

  def test_SWR_CHART_006_timers_and_their_limits
    slow = GATE.sub('delay="20ms" bs:limit="wait_us"', 'delay="30ms" bs:limit="slow_us"')
    assert_equal ['~ timer wait delay: 20 ms -> 30 ms', '~ timer wait limit: wait_us -> slow_us',
                  '~ timer wait threshold: 20 ms -> 30 ms'], changes(slow)
    assert_equal ['~ timer wait rounds: down -> up'], changes(GATE.sub('watchdog', 'hold_off'))
  end

  def test_SWR_CHART_006_properties_and_what_holds_for_the_chart
    assert_equal ["~ property GATE-I01 expression: In('shut') || In('ajar') -> In('all')"],
                 changes(GATE.sub("In('shut') || In('ajar')", "In('all')"))
    assert_equal ["~ property GATE-I01 expression: In('shut') || In('ajar') -> " \
                  "In('shut') || In('ajar') || (In('all') && In('lamp'))"],
                 changes(GATE.sub("In('ajar')\"", "In('ajar') || In('all') &amp;&amp; In('lamp')\""))
    assert_equal ['~ safe: - shut, + ajar'], changes(GATE.sub('bs:safe="shut', 'bs:safe="ajar'))
    assert_equal ['~ state gate initial: shut -> ajar'], changes(GATE.sub('initial="shut"', 'initial="ajar"'))
  end

  def test_SWR_CHART_006_the_worst_case_is_compared_where_both_versions_have_one
    old = { 'charts' => { 'gate' => { 'x86_instructions' => 50, 'x86_witness' => 'pull', 'ram_bytes' => 90 } } }
    new = { 'charts' => { 'gate' => { 'x86_instructions' => 52, 'x86_witness' => 'push', 'ram_bytes' => 90 } } }
    assert_equal "gate\n  ~ worst case x86-64 instructions: 50 -> 52 (push)\n",
                 between([compiled(GATE)], [compiled(GATE)], old, new)
    assert_equal "gate: no difference in meaning\n", between([compiled(GATE)], [compiled(GATE)], old, nil)
  end

  def test_SWR_CHART_006_folders_are_compared_chart_by_chart
    gate = compiled(GATE)
    door = compiled(GATE.sub('name="gate"', 'name="door"'), file: 'door.scxml')
    assert_equal "- chart door\ngate: no difference in meaning\n", between([gate, door], [gate])
    assert_equal "+ chart door\n", between([], [door])
    assert_equal "gate -> door: no difference in meaning\n", between([gate], [door])
  end

  # --- the command line ---

  def test_SWR_CHART_006_the_command_line_ends_as_diff_does
    with_versions(GATE, GATE) do |old, new|
      assert_equal ["gate: no difference in meaning\n", '', 0], diff(old, new)
      assert_equal ["gate: no difference in meaning\n", '', 0], diff(File.join(old, 'gate.scxml'), new)
      assert_equal ["gate: no difference in meaning\n", '', 0], diff(*[old, new].map { |one| "#{one}/gate.scxml" })
    end
    with_versions(GATE, GATE.sub('"creak squeak"', '"squeak"')) do |old, new|
      assert_equal ["gate\n  ~ transition GATE-T01 actions: creak, squeak -> squeak\n", '', 1], diff(old, new)
      output, errors, status = diff(old, "#{new}/none")
      assert_equal ['', "#{new}/none is no chart, and no folder with charts\n", 2], [output, errors, status]
    end
    with_versions(GATE, GATE.sub('target="ajar"', 'target="open"')) do |old, new|
      assert_match(/CHART-R07 target "open" is no state/, diff(old, new)[1])
      assert_equal 2, diff(old, new).last
    end
  end

  def test_SWR_CHART_006_trouble_with_files_is_reported_in_one_line
    with_versions(GATE, GATE) do |old, new|
      FileUtils.mkdir_p("#{new}/door.scxml")
      words = "#{new}/door.scxml: Is a directory; correct the path, or what stands there\n"
      assert_equal ['', words, 2], diff(old, new)
      File.write('build/gen/limits/limits.json', '{')
      _output, errors, status = diff(old, new)
      assert_match(%r{\Abuild/gen/limits/limits\.json:1: CHART-R15 the file is no JSON; [^\n]*\n\z}, errors)
      assert_equal 2, status
    end
  end

  def test_SWR_CHART_006_of_a_folder_only_the_chart_of_the_file_is_compared
    with_versions(GATE, GATE) do |old, new|
      File.write(File.join(new, 'door.scxml'), GATE.sub('name="gate"', 'name="door"').gsub('GATE-', 'DOOR-'))
      assert_equal "+ chart door\ngate: no difference in meaning\n", diff(old, new).first
      assert_equal "gate: no difference in meaning\n", diff("#{old}/gate.scxml", new).first
      assert_equal "gate: no difference in meaning\n", diff(new, "#{old}/gate.scxml").first
    end
  end

  # What a version of another time lacks, or has besides, or how else it is refused; and what is reported of it.
  REFUSED = {
    'without_ignores' => [/ bs:ignores="push"/, '', 'CHART-R25', '~ state shut ignores: + push'],
    'without_rounding' => [' bs:kind="watchdog"', '', 'CHART-R32', '~ timer wait rounds: none -> down'],
    'without_a_tick' => [' bs:tick="1ms"', '', 'CHART-R04', '~ tick: none -> 1 ms'],
    'with_an_old_limit' => ['delay="20ms"', 'delay="15ms"', 'CHART-R15', '~ timer wait delay: 15 ms -> 20 ms'],
    'without_a_requirement' => [/(GATE-T04.*) bs:req="SWR-CHART-001"/, '\1', 'CHART-R09',
                                '~ transition GATE-T04 requirements: + SWR-CHART-001'],
    'with_an_old_attribute' => ['bs:tick', 'bs:period="2ms" bs:tick', 'CHART-R03', 'gate: no difference in meaning'],
    'without_inputs_read' => [/ cond="!?is_free"/, '', 'CHART-R24', '~ transition GATE-T02 guard: none -> !is_free']
  }.freeze

  REFUSED.each do |name, (pattern, replacement, rule, words)|
    define_method("test_SWR_CHART_006_a_version_#{name}_is_compared_nevertheless") do
      old_text = GATE.gsub(pattern, replacement)
      refute_equal GATE, old_text
      with_versions(old_text, GATE) do |old, new|
        output, errors, = diff(old, new)
        assert_match(/\Arefused by today's profile: #{old}.*: #{rule} /, output)
        assert_includes output.lines(chomp: true).map(&:strip), words
        assert_empty errors
      end
    end
  end

  def test_SWR_CHART_006_the_worst_case_is_that_of_the_table_beside_each_folder
    with_versions(GATE, GATE) do |old, new|
      write_worst_case(old, 90)
      assert_equal "gate: no difference in meaning\n", diff(old, new).first
      write_worst_case(new, 94)
      assert_equal "gate\n  ~ worst case RAM bytes: 90 -> 94\n", diff(old, new).first
    end
  end

  private

  # Some changes here would leave a rule broken elsewhere.
  def compiled(text, checked: true, file: 'gate.scxml')
    return Chart::Compiled.from(file, text, LIMITS) if checked

    document = Chart::Parser.parse(file, text, LIMITS)
    Chart::Compiled.new(document, Chart::Walk.new(document).run)
  end

  def text(old, new, checked: true)
    between([compiled(old)], [compiled(new, checked: checked)])
  end

  def between(*versions)
    Chart::Difference.between(*versions).join
  end

  # Two folders of charts, each in a folder of its own, with the limits beside them.
  def with_versions(old, new)
    Dir.mktmpdir do |folder|
      FileUtils.mkdir_p(File.join(folder, 'build/gen/limits'))
      listed = LIMITS.map { |name, value| { name: name, value: value, requirement: 'SWR-CHART-006' } }
      File.write(File.join(folder, 'build/gen/limits/limits.json'), JSON.generate(listed))
      Dir.chdir(folder) do
        yield(*{ 'old' => old, 'new' => new }.map { |version, text| write_chart(version, text) })
      end
    end
  end

  def write_chart(version, text)
    folder = File.join(version, 'statecharts')
    FileUtils.mkdir_p(folder)
    File.write(File.join(folder, 'gate.scxml'), text)
    folder
  end

  def write_worst_case(folder, bytes)
    file = File.join(folder, Chart::Version::WORST_CASE)
    FileUtils.mkdir_p(File.dirname(file))
    File.write(file, Psych.dump('charts' => { 'gate' => { 'ram_bytes' => bytes } }))
  end

  def diff(old, new)
    output, errors, status = Open3.capture3(RbConfig.ruby, COMPILER, 'diff', old, new)
    [output, errors, status.exitstatus]
  end

  def difference(new)
    text(GATE, new)
  end

  def changes(new, checked: true)
    lines = text(GATE, new, checked: checked).lines(chomp: true)
    assert_equal 'gate', lines.first
    lines.drop(1).map { |line| line.delete_prefix('  ') }
  end

  def transition(id)
    GATE[/<transition bs:id="#{id}".*/]
  end

  def swap(text, one, other)
    first = text[/ *<transition bs:id="#{one}".*\n/]
    second = text[/ *<transition bs:id="#{other}".*\n/]
    text.sub(first + second, second + first)
  end
end

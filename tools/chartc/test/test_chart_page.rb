# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: people see of a chart all that it is, in a drawing, on a page and in charts.json.

require 'cgi'
require 'json'
require 'minitest/autorun'
require 'rexml/document'
require_relative '../lib/compiled'
require_relative '../lib/emit/page'
require_relative '../lib/emit/table'

class TestChartPage < Minitest::Test
  # Every construct once: several targets, history, final, eventless and targetless transitions, entry, exit, a timer.
  KILN = <<~XML
    <!-- A kiln and its door, hot & shut. -->
    <scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" datamodel="ecmascript" name="kiln" bs:tick="1ms" initial="off" bs:safe="off" bs:internal="lost">
      <state id="off" bs:req="SWR-CHART-001" bs:ignores="cool stop open close">
        <transition bs:id="KILN-T01" event="start" target="low shut" cond="is_closed" bs:do="greet" bs:req="SWR-CHART-001"/>
        <transition bs:id="KILN-T02" event="start" cond="!is_closed" bs:do="complain" bs:req="SWR-CHART-002" bs:hazard="HAZ-01"/>
        <transition bs:id="KILN-T03" event="resume" target="before" bs:req="SWR-CHART-001"/>
      </state>
      <parallel id="on" bs:req="SWR-CHART-001" bs:ignores="start resume">
        <onentry bs:do="lamp_on"/>
        <onexit bs:do="lamp_off"/>
        <transition bs:id="KILN-T04" event="stop" target="off" bs:req="SWR-CHART-001"/>
        <history id="before" type="deep"><transition target="low shut"/></history>
        <state id="heat" initial="low">
          <transition bs:id="KILN-T05" event="done.state.heat" target="off" bs:req="SWR-CHART-001"/>
          <state id="low" bs:ignores="cool" bs:req="SWR-CHART-001" bs:hazard="HAZ-01">
            <onentry><send id="warming" event="warm" delay="2500us" bs:limit="warm_us" bs:kind="hold_off"/></onentry>
            <onexit><cancel sendid="warming"/></onexit>
            <transition bs:id="KILN-T06" event="warm" target="high" bs:req="SWR-CHART-001"/>
          </state>
          <state id="high" bs:req="SWR-CHART-001">
            <transition bs:id="KILN-T07" event="cool" target="cold" bs:req="SWR-CHART-001"/>
            <transition bs:id="KILN-T08" target="low" cond="In('ajar')" bs:req="SWR-CHART-001"/>
          </state>
          <final id="cold" bs:req="SWR-CHART-001"/>
        </state>
        <state id="door" initial="shut">
          <state id="shut" bs:req="SWR-CHART-001" bs:ignores="close">
            <transition bs:id="KILN-T09" event="open" target="ajar" bs:req="SWR-CHART-001"><raise event="lost"/></transition>
          </state>
          <state id="ajar" bs:ignores="open" bs:req="SWR-CHART-001">
            <transition bs:id="KILN-T10" event="close" target="shut" bs:req="SWR-CHART-001"/>
            <transition bs:id="KILN-T11" event="lost" bs:do="complain" bs:req="SWR-CHART-001"/>
          </state>
        </state>
      </parallel>
      <datamodel>
        <!-- The door is closed. -->
        <data id="is_closed" expr="false"/>
      </datamodel>
      <bs:invariant id="KILN-I01" bs:req="SWR-CHART-002" expr="!In('high') || In('shut')"/>
      <bs:response id="KILN-P02" bs:req="SWR-CHART-002" bs:hazard="HAZ-01" on="stop" expr="In('off')"/>
      <bs:only id="KILN-P03" bs:req="SWR-CHART-002" on="start resume" from="In('off')" expr="In('on')"/>
      <bs:reachable id="KILN-P04" bs:req="SWR-CHART-002" expr="In('off')" steps="1"/>
    </scxml>
  XML

  # Three states share their way to one; two events of one state lead to the same.
  LAMP = <<~XML
    <!-- A lamp. -->
    <scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" datamodel="ecmascript" name="lamp" initial="off" bs:safe="off">
      <state id="off" bs:req="SWR-CHART-001" bs:ignores="out cut">
        <transition bs:id="LAMP-T01" event="dim" target="low" bs:req="SWR-CHART-001"/>
        <transition bs:id="LAMP-T02" event="bright" target="high" bs:req="SWR-CHART-001"/>
      </state>
      <state id="low" bs:req="SWR-CHART-001" bs:ignores="dim">
        <transition bs:id="LAMP-T03" event="bright" target="high" bs:req="SWR-CHART-001"/>
        <transition bs:id="LAMP-T04" event="out" target="off" bs:req="SWR-CHART-001"/>
        <transition bs:id="LAMP-T05" event="cut" target="off" bs:req="SWR-CHART-001"/>
      </state>
      <state id="high" bs:req="SWR-CHART-001" bs:ignores="dim out cut">
        <transition bs:id="LAMP-T06" event="bright" target="high" bs:req="SWR-CHART-001"/>
      </state>
    </scxml>
  XML

  # A way back into a frame from inside it; decisions that inner states take from outer ones.
  NEST = <<~XML
    <scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" datamodel="ecmascript" name="nest">
      <datamodel><data id="bright" expr="false" bs:input="true"/></datamodel>
      <state id="outer" initial="inner" bs:ignores="rest">
        <transition event="go" target="last"/>
        <state id="inner">
          <transition event="go" cond="bright" target="last"/>
          <transition event="go" cond="!bright"/>
          <transition event="rest" target="outer"/>
        </state>
        <state id="last"/>
      </state>
    </scxml>
  XML

  WORST = { 'charts' => { 'kiln' => { 'x86_instructions' => 1234, 'x86_witness' => 'open in high',
                                      'x86_check_instructions' => 17, 'stack_bytes' => 48,
                                      'ram_bytes' => 320 } } }.freeze

  def self.compiled(name, text)
    (@compiled ||= {})[name] ||= Chart::Compiled.from("#{name}.scxml", text, { 'cycle_us' => 1000, 'warm_us' => 2500 })
  end

  # --- the drawing ---

  def test_SWR_CHART_005_the_drawing_has_an_element_for_every_state_and_transition
    ids = REXML::XPath.match(REXML::Document.new(svg(kiln)), '//@id').map(&:value)
    assert_equal ids.uniq, ids
    kiln.document.states.each { |state| assert_includes ids, "kiln-#{state.id}" }
    marks = Chart::Diagram.new(kiln.document).marks
    assert_equal kiln.document.transitions.map(&:id), marks.keys
    assert_empty marks.values.flatten - ids
  end

  def test_SWR_CHART_005_what_happens_without_leaving_a_state_stands_inside_it
    assert_match(/\[!is_closed\].*complain/m, element(kiln, 'KILN-T02'))
    assert_includes element(kiln, 'kiln-off'), element(kiln, 'KILN-T02')
    assert_includes element(kiln, 'kiln-off'), 'ignores cool, stop, open, close'
    assert_includes element(kiln, 'kiln-low'), 'after 2500 us: warm'
  end

  def test_SWR_CHART_005_an_arrow_reports_event_guard_work_and_requirements
    arrow = element(kiln, 'KILN-T01')
    ['start', '[is_closed]', '/ greet', 'KILN-T01 SWR-CHART-001 line 4'].each { |words| assert_includes arrow, words }
    assert_includes element(kiln, 'KILN-T08'), 'at once'
  end

  def test_SWR_CHART_005_transitions_that_mean_the_same_are_drawn_once
    marks = Chart::Diagram.new(lamp.document).marks
    assert_equal 'LAMP-T02', marks.fetch('LAMP-T06').first
    assert_equal 'LAMP-T04', marks.fetch('LAMP-T05').first
    assert_includes element(lamp, 'LAMP-T02'), 'from off, low, high'
    assert_includes element(lamp, 'LAMP-T04'), 'out, cut'
    assert_includes element(lamp, 'lamp-off'), 'on to high'
  end

  def test_SWR_CHART_005_from_inside_an_arrow_leads_to_where_the_frame_begins
    dot = Chart::Diagram.new(nest).dot
    assert_match(/"start of outer" -> "way T4" .*dir=back/, dot)
    assert_match(/"start of outer" -> "inner"/, dot)
  end

  def test_SWR_CHART_005_the_drawing_is_the_same_on_every_run_and_free_of_styles
    assert_equal svg(kiln), svg(kiln)
    refute_match(/style=|<script|<!--|href=/, svg(kiln))
  end

  # --- the page ---

  def test_SWR_CHART_005_the_page_reports_all_of_every_state_and_transition
    assert_row 'States', 'low', 'heat', 'atomic', 'start warming', 'stop warming', 'cool', 'SWR-CHART-001',
               'HAZ-01', '15'
    assert_row 'Transitions', 'KILN-T02', '2', 'off', 'start', '!is_closed', 'stays', 'complain', 'SWR-CHART-002',
               'HAZ-01', '5'
    assert_row 'Transitions', 'KILN-T01', '1', 'off', 'start', 'is_closed', 'low, shut', 'greet',
               'SWR-CHART-001', '', '4'
    assert_row 'Transitions', 'KILN-T09', '9', 'shut', 'open', '', 'ajar', 'raise lost', 'SWR-CHART-001', '', '28'
  end

  def test_SWR_CHART_005_the_page_reports_how_timers_round
    assert_row 'Timers', 'warming', 'warm', 'low', '2500 us', 'warm_us', 'up (hold-off)', '3', '16'
  end

  def test_SWR_CHART_005_the_page_gives_each_property_its_verdict_and_what_it_was_checked_on
    reached = kiln.walk.reached.length
    assert_row 'Properties', 'KILN-I01', "always !In('high') || In('shut')", 'holds', "#{reached} configurations",
               'SWR-CHART-002', '', '40'
    steps = Chart::PropertyChecks.verdicts(kiln.document, kiln.walk)[1].checked
    assert_row 'Properties', 'KILN-P02', "after stop: In('off')", 'holds', "#{steps} steps", 'SWR-CHART-002',
               'HAZ-01', '41'
    assert_row 'Properties', 'KILN-P04', "In('off') can be reached in 1 step", 'holds', "#{reached} configurations"
  end

  def test_SWR_CHART_005_the_page_reports_which_elements_stand_for_a_requirement_or_a_hazard
    assert_row 'Requirements and hazards', 'SWR-CHART-002', '', 'KILN-T02', 'KILN-I01, KILN-P02, KILN-P03, KILN-P04'
    assert_row 'Requirements and hazards', 'HAZ-01', 'low', 'KILN-T02', 'KILN-P02'
  end

  def test_SWR_CHART_005_the_decisions_of_a_region_name_what_every_event_does
    page = text(part('Decisions'))
    assert_match(/off \[is_closed\] →.low, shut \[!is_closed\] complain →.before ignored/, page)
    assert_match(/high .*\[In\('ajar'\)\] →.low/, page)
  end

  def test_SWR_CHART_005_decisions_end_where_one_is_always_taken
    rows = Chart::DecisionTable.new(nest, Chart::Regions.of(nest).first).table.to_s.scan(%r{<tr>(.*?)</tr>}m)
    assert_equal ["inner [bright] →\u00a0last [!bright] taken →\u00a0outer", "last →\u00a0last ignored"],
                 rows.drop(1).map { |(row)| text(row) }
  end

  def test_SWR_CHART_005_the_page_gives_sizes_bounds_and_the_worst_case
    assert_row 'Size and bounds', 'Configurations reached', kiln.walk.reached.length.to_s
    assert_row 'Size and bounds', 'Microsteps of one macrostep, at most', kiln.walk.most_microsteps.to_s
    bounds = part('Size and bounds', WORST)
    assert_includes text(bounds), 'x86-64 instructions 1 234 open in high'
    assert_includes text(bounds), 'Stack bytes 48 RAM bytes 320 x86-64 instructions of the check 17'
    refute_includes bounds, 'ARM'
    refute_includes page(nil), 'instructions'
  end

  def test_SWR_CHART_005_the_page_needs_nothing_beside_it
    refute_match(%r{<script|<link|<img|@import|url\(|src=|https?://(?!www\.w3\.org)}, page(WORST))
    links = page(WORST).scan(/href="([^"#]*)"/).flatten.uniq.reject(&:empty?)
    assert_equal %w[kiln.svg lamp.svg], links
  end

  def test_SWR_CHART_005_every_link_of_the_page_leads_somewhere_and_no_id_stands_twice
    ids = page(WORST).scan(/ id="([^"]*)"/).flatten
    assert_equal ids.uniq, ids
    assert_empty page(WORST).scan(/href="#([^"]*)"/).flatten - ids
  end

  def test_SWR_CHART_005_the_page_escapes_what_charts_say
    assert_includes page(nil), 'A kiln and its door, hot &amp; shut.'
  end

  # --- charts.json ---

  def test_SWR_CHART_005_the_table_leads_from_live_values_to_the_drawing
    ids = REXML::XPath.match(REXML::Document.new(svg(kiln)), '//@id').map(&:value)
    leaves = table.fetch('regions').flat_map { |region| region.fetch('leaves') }
    assert_empty leaves.map { |leaf| leaf.fetch('svg_id') } - ids
    assert_equal [*1..11], table.fetch('transitions').map { |one| one.fetch('number') }
    assert_empty table.fetch('transitions').flat_map { |one| one.fetch('svg_ids') } - ids
  end

  def test_SWR_CHART_005_the_table_numbers_leaves_without_gaps_and_says_what_stands_for_none
    regions = table.fetch('regions').to_h { |region| [region.fetch('name'), region] }
    assert_equal %w[state heat door], regions.keys
    regions.each_value do |region|
      assert_equal [*0...region.fetch('leaves').length], region.fetch('leaves').map { |leaf| leaf.fetch('value') }
    end
    assert_equal [nil, 'on', 3], [regions['state']['outer'], regions['heat']['outer'], regions['heat']['none']]
  end

  def test_SWR_CHART_005_the_table_has_timers_properties_ignores_hazards_and_bounds
    timer = table.fetch('timers').first
    assert_equal ['warm_us', 'up', 3, %w[low]], timer.values_at('limit', 'rounding', 'ticks', 'states')
    property = table.fetch('properties').first
    assert_equal ['KILN-I01', 'holds', kiln.walk.reached.length], property.values_at('id', 'verdict', 'checked')
    low = table.fetch('states').find { |state| state.fetch('id') == 'low' }
    assert_equal [%w[cool], %w[HAZ-01], ['start warming']], low.values_at('ignores', 'hazards', 'entry')
    assert_equal [kiln.walk.most_microsteps, kiln.walk.most_raised],
                 table.fetch('bounds').values_at('most_microsteps', 'most_queued')
  end

  private

  def kiln
    self.class.compiled('kiln', KILN)
  end

  def lamp
    self.class.compiled('lamp', LAMP)
  end

  def nest
    @nest ||= Chart::Parser.parse('nest.scxml', NEST, {}, mode: :engine)
  end

  def svg(chart)
    Chart::Diagram.svg(Chart::Diagram.new(chart.document).dot)
  end

  # The element with this id, with all in it.
  def element(chart, id)
    found = REXML::XPath.first(REXML::Document.new(svg(chart)), "//*[@id='#{id}']")
    assert found, "#{id} is not in the drawing"
    found.to_s
  end

  def page(worst)
    (@pages ||= {})[worst] ||= Chart::Page.new([kiln, lamp], worst).emit
  end

  # The part of the kiln below this heading.
  def part(title, worst = nil)
    page(worst)[%r{<h3 id="chart-kiln-[^"]*">#{Regexp.escape(title)}</h3>(.*?)<(?:h3|/section)}m, 1]
  end

  def text(html)
    CGI.unescapeHTML(html.gsub(/<[^>]*>/, ' ')).gsub(/[ \n]+/, ' ').strip
  end

  def assert_row(title, *cells)
    rows = part(title).scan(%r{<tr>(.*?)</tr>}m).map do |(row)|
      row.scan(%r{<t[hd][^>]*>(.*?)</t[hd]>}m).map { |(cell)| text(cell) }
    end
    found = rows.find { |row| row.first == cells.first }
    assert_equal cells, found.take(cells.length)
  end

  def table
    JSON.parse(Chart::Table.emit([kiln])).fetch('charts').first
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: the generated tests of a chart with histories put into place what these remember, pass on the
# code that is generated beside them, and go red when it remembers, forgets or goes back wrongly. A region that is always
# active is never "none", though a history may say so of it.

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../lib/compiled'
require_relative '../proof/generated_test'

class TestChartHistories < Minitest::Test
  FILE = File.join(__dir__, 'charts', 'player.scxml')
  PLAYER = Chart::Compiled.from(FILE, File.read(FILE), {})
  # One region, which a history remembers.
  LIFT = Chart::Compiled.from('lift.scxml', <<~XML, {})
    <scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" datamodel="ecmascript" name="lift" initial="stopped" bs:safe="stopped">
      <state id="stopped" bs:ignores="call" bs:req="SWR-CHART-039">
        <transition bs:id="LIFT-T01" event="key" target="floor" bs:req="SWR-CHART-039"/>
      </state>
      <state id="served" initial="below">
        <history id="floor"><transition target="below"/></history>
        <transition bs:id="LIFT-T02" event="key" target="stopped" bs:req="SWR-CHART-039"/>
        <state id="below" bs:req="SWR-CHART-039"><transition bs:id="LIFT-T03" event="call" target="above" bs:req="SWR-CHART-039"/></state>
        <state id="above" bs:req="SWR-CHART-039"><transition bs:id="LIFT-T04" event="call" target="below" bs:req="SWR-CHART-039"/></state>
      </state>
    </scxml>
  XML

  [PLAYER, LIFT].each do |chart|
    define_method("test_SWR_CHART_038_the_tests_of_the_#{chart.document.name}_pass_on_its_code") { assert_empty red(chart) }
  end

  # What is changed, and how.
  {
    'a_deep_history_that_records_nothing' => ['self->last_memory_tray = self->tray;', ''],
    'a_deep_history_that_records_another_region' => ['self->last_memory_source = self->source;',
                                                     'self->last_memory_source = PLAYER_SOURCE_DISC;'],
    'a_shallow_history_that_records_nothing' => [/^ *self->channel_memory = self->source;$/, ''],
    'a_history_that_is_not_asked' => ['switch (self->channel_memory) {', 'switch (PLAYER_SOURCE_FM) {'],
    'a_history_that_a_repair_keeps' => ['self->last_memory_tray = PLAYER_TRAY_NONE;',
                                        'self->last_memory_tray = PLAYER_TRAY_TRAY_OUT;']
  }.each do |what, (from, to)|
    define_method("test_SWR_CHART_038_#{what}_is_found") do
      refute_empty(red(PLAYER) { |code| code.gsub(from, to) })
    end
  end

  def test_SWR_CHART_039_none_in_a_region_that_is_always_active_is_damage
    assert_includes LIFT.header, 'LIFT_STATE_NONE'
    assert_match(/is_in_leaves[^}]*<= \(uint32_t\)LIFT_STATE_ABOVE\b/, LIFT.source)
    found = red(LIFT) { |code| code.sub('<= (uint32_t)LIFT_STATE_ABOVE', '<= (uint32_t)LIFT_STATE_NONE') }
    assert_match(/a_leaf_that_does_not_exist_goes_to_the_safe_state:FAIL/, found.join)
  end

  private

  # Lines of the generated test of every pair. The block changes the code.
  def red(chart)
    name = chart.document.name
    Dir.mktmpdir do |folder|
      source = chart.source
      changed = block_given? ? yield(source) : source
      refute_equal source, changed if block_given?
      files = chart.files.merge(chart.tests, "#{name}_chart.c" => changed)
      files.each { |file, text| File.write(File.join(folder, file), text) }
      test = GeneratedTest.new("#{folder}/test_#{name}_walk.c", folder, folder)
      Open3.capture2e(test.program("#{folder}/#{name}_chart.c")).first.lines.grep(/:FAIL/)
    end
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: the console is told of a chart what its walk has seen, and where it stands in its drawing.

require 'json'
require 'minitest/autorun'
require_relative '../lib/compiled'
require_relative '../lib/emit/console'
require_relative 'own_charts'

class TestChartConsole < Minitest::Test
  include OwnCharts

  def setup
    @chart = Chart::Compiled.from(FILE, CHART, LIMITS)
    @svg = Chart::Diagram.svg(Chart::Diagram.new(@chart.document).dot)
    @told = Chart::Console.new(@chart, @svg).to_h
  end

  def changes(region)
    @told.fetch('regions').find { |one| one.fetch('name') == region }.fetch('changes')
  end

  def test_SWR_CON_031_each_change_has_the_transitions_of_its_region_that_may_make_it
    assert_equal({ 'closed open' => ['LAMP-T01'], 'open closed' => ['LAMP-T02'] }, changes('door'))
    assert_equal({ 'off warming' => ['LAMP-T03'], 'warming on' => ['LAMP-T04'], 'warming off' => %w[LAMP-T05 LAMP-T06],
                   'on off' => %w[LAMP-T07 LAMP-T09], 'on warming' => ['LAMP-T08'] }, changes('power'))
  end

  def test_SWR_CON_031_a_transition_has_its_events_and_its_guard
    told = @told.fetch('transitions').fetch('LAMP-T03')
    assert_equal [['start'], "is_allowed && In('closed')"], told.values_at('events', 'guard')
  end

  def test_SWR_CON_031_a_leaf_has_all_that_is_active_with_it
    assert_equal %w[lamp-off lamp-power lamp-all],
                 @told.fetch('regions').find { |one| one.fetch('name') == 'power' }.fetch('leaves').fetch('off')
  end

  def test_SWR_CON_031_the_corner_of_a_state_is_that_of_its_outline
    across, down = @svg[/translate\(([-\d.]+ [-\d.]+)\)/, 1].split.map(&:to_f)
    outline = @svg[/id="lamp-off".*?\n<path[^>]* d="([^"]*)"/, 1].scan(/-?[\d.]+/).map(&:to_f).each_slice(2)
    assert_equal [outline.map(&:first).min + across, outline.map(&:last).min + down].map { |one| one.round(2) },
                 @told.fetch('corners').fetch('lamp-off')
  end

  def test_SWR_CON_031_the_drawing_is_all_of_the_svg_but_its_frame
    assert_equal @svg, "#{@svg[/\A<svg .*?>\n/m]}#{@told.fetch('drawing')}</svg>\n"
  end

  def test_SWR_CON_031_the_script_names_every_chart
    script = Chart::Console.emit([@chart], 'lamp' => @svg)
    assert_includes script, 'export type ChartName = "lamp";'
    assert_equal({ 'lamp' => @told }, JSON.parse(script[/= (\{.*\});\n\z/m, 1]))
  end
end

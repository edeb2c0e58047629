# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: the console gets of a chart what its walk has seen, and where it stands in its drawing.

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
    @reported = Chart::Console.new(@chart, @svg).to_h
  end

  SHAPE = / (?:points|x|y|cx|cy|rx|ry)="([^"]*)"/.freeze

  def without_places(svg)
    svg.gsub(SHAPE, '').gsub(/ d="[^"]*"/, '')
  end

  def tenths(places)
    places.scan(/-?[\d.]+/).map { |number| (Rational(number) * 10).round }
  end

  # Each leg of a path of Graphviz: where it begins, its two bends, where it ends; not those that lead nowhere.
  def absolute(path)
    start, *points = tenths(path).each_slice(2).to_a
    points.each_slice(3).map { |bends| [start, *bends].tap { start = bends.last } }.reject { |leg| leg.uniq.one? }
  end

  # The same of a path by ways.
  def relative(path)
    start = tenths(path[/\AM[^a-z]*/])
    path.scan(/([chvl])([^a-z]*)/).map do |kind, numbers|
      ways = legs(kind, tenths(numbers))
      leg = [start, *ways.map { |way| start.zip(way).map(&:sum) }]
      start = leg.last
      leg
    end
  end

  def legs(kind, numbers)
    whole = { 'h' => [numbers.first, 0], 'v' => [0, numbers.first] }.fetch(kind, numbers)
    kind == 'c' ? numbers.each_slice(2).to_a : [[0, 0], whole, whole]
  end

  def changes(region)
    @reported.fetch('regions').find { |one| one.fetch('name') == region }.fetch('changes')
  end

  def test_SWR_CON_031_each_change_has_the_transitions_of_its_region_that_may_make_it
    assert_equal({ 'closed open' => ['LAMP-T01'], 'open closed' => ['LAMP-T02'] }, changes('door'))
    assert_equal({ 'off warming' => ['LAMP-T03'], 'warming on' => ['LAMP-T04'], 'warming off' => %w[LAMP-T05 LAMP-T06],
                   'on off' => %w[LAMP-T07 LAMP-T09], 'on warming' => ['LAMP-T08'] }, changes('power'))
  end

  def test_SWR_CON_031_a_transition_has_its_events_and_its_guard
    reported = @reported.fetch('transitions').fetch('LAMP-T03')
    assert_equal [['start'], "is_allowed && In('closed')"], reported.values_at('events', 'guard')
  end

  def test_SWR_CON_031_a_leaf_has_all_that_is_active_with_it
    assert_equal %w[lamp-off lamp-power lamp-all],
                 @reported.fetch('regions').find { |one| one.fetch('name') == 'power' }.fetch('leaves').fetch('off')
  end

  def test_SWR_CON_031_the_corner_of_a_state_is_that_of_its_outline
    across, down = @svg[/translate\(([-\d.]+ [-\d.]+)\)/, 1].split.map(&:to_f)
    outline = @svg[/id="lamp-off".*?\n<path[^>]* d="([^"]*)"/, 1].scan(/-?[\d.]+/).map(&:to_f).each_slice(2)
    assert_equal [outline.map(&:first).min + across, outline.map(&:last).min + down].map { |one| one.round(2) },
                 @reported.fetch('corners').fetch('lamp-off')
  end

  def test_SWR_CON_031_the_drawing_is_all_of_the_svg_but_its_frame_its_font_and_its_places
    font = / (?:text-anchor|font-family|font-size)="[^"]*"/
    assert_equal without_places(@svg.gsub(font, '')), "#{@svg[/\A<svg .*?>\n/m]}#{without_places(@reported.fetch('drawing'))}</svg>\n"
  end

  def test_SWR_CON_031_lines_and_shapes_are_where_the_svg_has_them
    svg, reported = [@svg, @reported.fetch('drawing')].map { |one| [one.scan(/ d="([^"]*)"/).flatten, one.scan(SHAPE).flatten] }
    refute_empty svg.flatten
    assert_equal(svg.first.map { |path| absolute(path) }, reported.first.map { |path| relative(path) })
    assert_equal(svg.last.map { |places| tenths(places) }, reported.last.map { |places| tenths(places) })
  end

  def test_SWR_CON_031_the_script_names_every_chart
    script = Chart::Console.emit([@chart], 'lamp' => @svg)
    assert_includes script, 'export type ChartName = "lamp";'
    assert_equal({ 'lamp' => @reported }, JSON.parse(script[/= (\{.*\});\n\z/m, 1]))
  end
end

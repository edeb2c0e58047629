# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require_relative '../lib/compiled'

# Each file in tools/chartc/test/charts whose name starts with a rule breaks that rule once. The line that breaks it says so,
# with the beginning of the message. All are made from the base charts, which are accepted.
class TestChartRefusals < Minitest::Test
  FOLDER = File.join(__dir__, 'charts')
  REFUSED = Dir[File.join(FOLDER, 'r[0-9][0-9]_*.scxml')].sort.freeze
  ACCEPTED = Dir[File.join(FOLDER, 'base*.scxml')].sort.freeze
  LIMITS = { 'short_us' => 1000, 'tiny_us' => 500, 'endless_us' => 7_200_000_000, 'cycle_us' => 1000 }.freeze
  MARK = /<!-- refused( in engine mode)?: (CHART-R(\d\d) .+) -->/
  REMEDY = /; (?:in|of|write|add|remove|choose|declare|name|give|cancel|keep|save|split|correct|close|guard|at most)/

  REFUSED.each do |file|
    define_method("test_SWR_CHART_003_refuses_#{File.basename(file, '.scxml')}") do
      text = File.read(file)
      line = text.lines.index { |one| one.match?(MARK) } + 1
      refusal = assert_raises(Chart::Refusal) { compiled(file, text) }
      assert_equal [file, line, text[MARK, 3].to_i], [refusal.file, refusal.line, refusal.rule], refusal.message
      assert refusal.message.start_with?("#{file}:#{line}: #{text[MARK, 2]}"), refusal.message
      assert_match REMEDY, refusal.message
    end
  end

  def test_SWR_CHART_003_the_charts_that_the_refused_ones_are_made_from_are_accepted
    assert_equal 7, ACCEPTED.length
    ACCEPTED.each { |file| assert_operator compiled(file, File.read(file)).walk.pair_count, :>, 1, file }
  end

  def test_SWR_CHART_003_every_message_of_the_xml_reader_says_what_to_write_instead
    messages = File.read(File.join(__dir__, '../lib/read/xml_reader.rb')).scan(/refuse\((["'])(.+?)(?<!\\)\1[,)]/)
    assert_operator messages.length, :>=, 12
    messages.each { |_quote, message| assert_match REMEDY, message }
  end

  def test_SWR_CHART_003_every_rule_has_a_refused_file
    assert_equal Chart::RULES.keys, REFUSED.map { |file| File.basename(file)[1, 2].to_i }.uniq.sort
  end

  def test_SWR_CHART_003_the_page_says_the_same_rules
    page = File.read(File.join(__dir__, '..', '..', '..', 'docs', 'charts.md'))
    rows = page.scan(/^\| CHART-R(\d\d) \| (.+) \|$/)
    assert_equal Chart::RULES, rows.to_h { |number, words| [number.to_i, words.delete('`\\\\')] }
  end

  def test_SWR_CHART_003_the_page_says_every_element_and_attribute
    page = File.read(File.join(__dir__, '..', '..', '..', 'docs', 'charts.md'))
    Chart::Profile::PRODUCT.each do |path, form|
      element = path.split('/').last
      rows = page.lines.grep(/^\| [^|]*`#{element}`/).join
      (form.required + form.optional).each { |name| assert_match(/\b#{name}\b/, rows, "#{element} #{name}") }
    end
  end

  def test_SWR_CHART_003_a_violated_invariant_comes_with_the_shortest_list_of_events
    assert_match(/violated in on open, reached by: go, pull;/, refusal_of('r23_invariant_violated').message)
  end

  def test_SWR_CHART_003_a_tick_that_no_requirement_states_is_refused
    text = chart('base_timer')
    refusal = assert_raises(Chart::Refusal) do
      Chart::Compiled.from('base_timer.scxml', text, LIMITS.reject { |name, _value| name == 'cycle_us' })
    end
    assert_equal [15, text.lines.index { |line| line.include?('<scxml') } + 1], [refusal.rule, refusal.line]
    assert_match(/no requirement states cycle_us, which bs:tick must equal; add the limit/, refusal.message)
  end

  def test_SWR_CHART_003_a_long_way_is_reported_in_few_words
    text = chart('r34_value_too_large_engine')
    assert_match(/becomes 32768, reached by: (go, halt, ){6}\(65511 more\), halt, (go, halt, ){5}go;/,
                 refusal_in('r34_value_too_large_engine', text.sub('bs:max="3"', 'bs:max="32767"')).message)
  end

  def test_SWR_CHART_003_at_most_32_timers_fit
    sends = (0..32).map { |n| send_of("late_#{n}") }
    cancels = (0..32).map { |n| "<cancel sendid=\"late_#{n}\"/>" }
    text = chart('base_timer').sub(/<onentry>.*/, "<onentry>#{sends.join}</onentry>")
                              .sub(/<onexit>.*/, "<onexit>#{cancels.join}</onexit>")
    assert_match(/CHART-R19 the chart has 33 timers; at most 32 fit/, refusal_in('base_timer', text).message)
  end

  def test_SWR_CHART_003_at_most_64_regions_fit
    regions = (0..64).map { |n| "<state id=\"part_#{n}\" bs:req=\"SWR-CHART-003\"/>" }
    text = chart('base').sub(/bs:safe="[^"]*"/, "bs:safe=\"#{(0..64).map { |n| "part_#{n}" }.join(' ')}\"")
                        .sub('initial="off"', 'initial="all"')
                        .sub(%r{^  <state.*</state>}m, "<parallel id=\"all\">#{regions.join}</parallel>")
    assert_match(/CHART-R19 the chart has 65 regions; at most 64 fit/, refusal_in('base', text).message)
  end

  def test_SWR_CHART_003_a_file_that_is_not_utf_8_is_refused
    assert_match(/:1: CHART-R01 the file is not UTF-8/, refusal_in('base', "<scxml name=\"\xff\"/>").message)
  end

  private

  # Charts of conformance suites say so in their name, or in the mark.
  def compiled(file, text)
    engine = text.scrub[MARK, 1] || file.end_with?('_engine.scxml')
    owners = LIMITS.transform_values { 'SWR-CHART-003' }
    Chart::Compiled.from(file, text, LIMITS, mode: engine ? :engine : :product, owners: owners)
  end

  def chart(name)
    File.read(File.join(FOLDER, "#{name}.scxml"))
  end

  def send_of(id)
    "<send id=\"#{id}\" event=\"halt\" delay=\"1ms\" bs:limit=\"short_us\" bs:kind=\"watchdog\"/>"
  end

  def refusal_of(name)
    refusal_in(name, chart(name))
  end

  def refusal_in(name, text)
    assert_raises(Chart::Refusal) { compiled(File.join(FOLDER, "#{name}.scxml"), text) }
  end
end

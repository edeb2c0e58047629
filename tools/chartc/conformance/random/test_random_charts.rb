# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: what the compiler makes of any chart, of its engine's mode or of a product, does what the W3C's
# appendix D says, in the shape of code that they get, and what it refuses by what running shows, does show it. The charts are
# random, and appendix D is written a second time for this (appendix_d.rb). `make charts-fuzz COUNT=1000 SEED=1` looks
# further.

require 'minitest/autorun'
require 'minitest/mock'
require 'tmpdir'
require_relative '../own_cases'
require_relative 'hunt'
require_relative 'second_opinion'

class TestRandomCharts < Minitest::Test
  LEAST = 100
  SECONDS = 45
  # Charts for SCION, and what must be clear of them.
  SEEDS = 120
  STEPS = 500

  def test_SWR_CHART_015_random_charts_do_what_appendix_d_says
    ends = Process.clock_gettime(Process::CLOCK_MONOTONIC) + SECONDS
    hunt = RandomCharts::Hunt.new(1).run do |one|
      one.accepted >= LEAST && Process.clock_gettime(Process::CLOCK_MONOTONIC) >= ends
    end
    puts hunt
    assert_empty(hunt.found.map { |one| "#{one.file}.scxml: #{one.differences.join('; ')}" })
    # Of all kinds, in the first hundred already.
    assert_operator hunt.products, :>=, 20
    %i[direct staged].each { |shape| assert_operator hunt.shapes[shape], :>=, 20 }
    assert_operator hunt.judged, :>=, 30
  end

  # Two states that lead to each other at once; with a guard that is never true they do not.
  ENDLESS = '<state id="a"><transition event="go" target="b"/></state><state id="b"><transition cond="%s" target="c"/>' \
            '</state><state id="c"><transition cond="%s" target="b"/></state>'
  STARTED = '<state id="a"><onentry><send id="t" event="late" delay="1ms"/></onentry><transition event="go" target="%s"/>' \
            '</state><state id="b"><transition event="go" target="a"/><onentry>%s</onentry></state>'
  SURVEYED = {
    'an_endless_macrostep' => [11, ENDLESS, ["In('b')", "In('c')"], ["In('b')", "In('a')"]],
    'a_timer_that_is_started_twice' => [33, STARTED, ['b', ''], ['b', '<cancel sendid="t"/>']]
  }.freeze

  SURVEYED.each do |name, (rule, body, broken, sound)|
    define_method("test_SWR_CHART_045_#{name}_is_seen_by_the_survey_and_is_not_where_there_is_none") do
      machines = [broken, sound].map { |words| RandomCharts::Survey.new(chart(format(body, *words))) }
      assert_equal([true, false], machines.map { |one| one.breaks?(rule, 100) })
      assert_nil machines.last.breaks?(rule, 1)
    end
  end

  # A compiler that refuses what is sound.
  def test_SWR_CHART_045_a_refusal_for_nothing_is_found
    Dir.mktmpdir do |folder|
      hunt = RandomCharts::Hunt.new(1, keep: folder)
      node = Struct.new(:xml, :attributes).new(chart(format(STARTED, 'b', '<cancel sendid="t"/>')), {})
      refusal = Chart::Refusal.new('x.scxml', 1, 33, 'timer "t" is started while it runs, reached by: go')
      hunt.send(:judge, 7, node, refusal)
      assert_match(/\Arefused for nothing: .* CHART-R33 /, hunt.found.first.differences.first)
      assert_equal node.xml, File.read("#{folder}/seed_7.scxml")
    end
  end

  # What differs stands where conformance reads its cases, of both kinds.
  def test_SWR_CHART_045_what_differs_is_a_case
    [1, 2].each do |kind|
      seed = (0..).lazy.map { |one| kind + (one * 2) }.find { |one| trial(one) }
      Dir.mktmpdir do |folder|
        hunt = RandomCharts::Hunt.new(seed, keep: folder)
        hunt.stub(:differing, ->(trials) { trials }) do
          hunt.stub(:words, ->(chart, steps) { kept(chart, steps).length > 3 ? ['other'] : [] }) do
            hunt.send(:compare, [hunt.send(:trial, seed)])
          end
        end
        scenario = Conformance::OwnCases.new("#{folder}/seed_#{seed}.scxml").scenario
        assert_equal 4, scenario.steps.length
        assert_equal kind == 2 ? :product : :engine, scenario.chart.document.mode
      end
    end
  end

  # The same charts of products, with what their code alone knows.
  def test_SWR_CHART_045_the_generator_makes_charts_of_products
    charts = (1..200).map { |seed| RandomCharts::ProductGenerator.new(seed).chart.xml }
    assert_equal(charts, (1..200).map { |seed| RandomCharts::ProductGenerator.new(seed).chart.xml })
    text = charts.join
    %w[<parallel <final <history <raise <send <cancel bs:internal type="internal" bs:kind="watchdog" bs:kind="hold_off"
       delay="60s" delay="4294967ms" In(' done.state.].each { |word| assert_includes text, word }
  end

  # Always the same charts.
  def test_SWR_CHART_037_the_interpreter_does_what_appendix_d_says_and_scion_does
    opinions = RandomCharts::SecondOpinions.new
    (1..SEEDS).each { |seed| opinions.judge(seed) }
    puts opinions
    assert_empty opinions.differences
    assert_operator opinions.agreed, :>=, STEPS
  ensure
    opinions&.close
  end

  # The same seed is the same chart, and the generator makes all that the profile has.
  def test_SWR_CHART_015_the_generator_uses_the_whole_profile
    charts = (1..200).map { |seed| RandomCharts::Generator.new(seed).chart.xml }
    assert_equal(charts, (1..200).map { |seed| RandomCharts::Generator.new(seed).chart.xml })
    text = charts.join
    %w[<parallel <final <history <initial> <raise <assign <send <cancel <onentry <onexit type="deep" type="shallow"
       type="internal" bs:input="true" bs:kind="watchdog" In(' done.state. event="*" event="go.*" bs:do=].each do |word|
      assert_includes text, word
    end
    assert_match(/target="\w+ \w+"/, text)
    assert_match(/<transition (?!event)[^>]*cond/, text)
    assert_includes text, 'delay="4294967ms"'
  end

  # A chart that fails because one element stands in it becomes that element and what holds it.
  def test_SWR_CHART_015_a_failure_is_made_small
    chart = RandomCharts::Generator.new(3).chart
    steps = (0..20).to_a
    small, few = RandomCharts::Minimiser.new(chart, steps) do |one, some|
      one.all.any? { |node| node.name == 'raise' } && some.include?(0) && some.include?(13)
    end.run
    assert_equal [0, 13], few
    assert_operator small.all.length, :<=, 4
    assert_equal ['raise'], small.all.map(&:name).last(1)
  end

  private

  def chart(body)
    '<scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" ' \
      "datamodel=\"ecmascript\">#{body}</scxml>"
  end

  # Those of the steps that a chart knows; none of one that is refused.
  def kept(chart, steps)
    RandomCharts::Trial.new('small', chart.xml, steps).steps
  rescue Chart::Refusal, KeyError
    []
  end

  # nil for a chart that the compiler refuses.
  def trial(seed)
    RandomCharts::Hunt.new(seed).send(:trial, seed)
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: what the compiler makes of any chart of its engine's mode does what the W3C's appendix D says, in
# every shape of code. The charts are random, and appendix D is written a second time for this (appendix_d.rb).
# `make charts-fuzz COUNT=1000 SEED=1` looks further.

require 'minitest/autorun'
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
end

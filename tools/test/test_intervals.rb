# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the report of real time counts each recorded cycle once, and none that was not recorded.

require 'minitest/autorun'
require_relative '../intervals'

class TestIntervals < Minitest::Test
  def intervals(*lines)
    Intervals.new(1500).tap { |all| lines.each { |line| all.add("#{line}\n") } }
  end

  def test_SWR_CHECK_006_each_interval_is_counted
    all = intervals('time_s,interval_us,longest_stage', '0.001,1000,WAKE', '0.002,990,STEP', '0.003,1000,WAKE')
    assert_equal({ 1000 => 2, 990 => 1 }, all.counts)
    assert_equal "interval_us,cycles\n990,1\n1000,2\n", all.histogram_csv
    assert_equal [3, 0, 0], [all.cycles, all.late, all.missing]
  end

  def test_SWR_CHECK_006_the_first_cycle_comes_after_nothing
    assert_equal({ 1001 => 1 }, intervals('0.000,0,WAKE', '0.001,1001,WAKE').counts)
  end

  def test_SWR_CHECK_006_each_second_has_its_shortest_mean_and_longest
    all = intervals('0.998,900,WAKE', '0.999,1100,WAKE', '1.000,1000,WAKE', '1.001,1003,STEP')
    assert_equal "second,shortest_us,mean_us,longest_us\n0,900,1000.0,1100\n1,1000,1001.5,1003\n", all.seconds_csv
  end

  def test_SWR_CHECK_006_what_is_late_is_reported_with_its_stage
    all = intervals('0.001,1500,WAKE', '0.002,1501,WAKE', '0.003,4000,STEP', '0.004,1000,STEP')
    assert_equal 2, all.late
    assert_equal({ 'WAKE' => 1, 'STEP' => 1 }, all.late_stages)
  end

  # A new file begins with the cycle that follows, unless some were lost.
  def test_SWR_CHECK_006_what_no_recording_has_is_counted
    all = intervals('time_s,interval_us,longest_stage', '0.001,1000,WAKE', 'time_s,interval_us,longest_stage', '0.005,1000,WAKE', '0.006,1000,WAKE')
    assert_equal [3, 3], [all.cycles, all.missing]
  end

  def test_SWR_CHECK_006_quantiles_are_of_all_cycles
    all = intervals(*(1..100).map { |i| format('0.%03d,%d,WAKE', i, 1000 + i) })
    assert_equal [1050, 1099, 1100], [0.5, 0.99, 1.0].map { |share| all.quantile(share) }
    assert_nil Intervals.new(1500).quantile(0.5)
  end

  def test_SWR_CHECK_012_each_stage_has_its_classes
    stages = [{ 'name' => 'WAKE', 'counts' => [0, 5, 2, 1] }, { 'name' => 'STEP', 'counts' => [1, 0, 7, 0] }]
    assert_equal "from_us,wake,step\n0,0,1\n1,5,0\n2,2,7\n4,1,0\n", StageTimes.csv(stages)
  end
end

# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Intervals between the cycles of the control loop, as boresight-replay --loop prints them, added up as they come.
#
# @satisfies SWR-CHECK-006
class Intervals
  # Intervals of one second.
  Second = Struct.new(:shortest, :longest, :sum, :count) do
    def add(interval)
      self.shortest = [shortest, interval].min
      self.longest = [longest, interval].max
      self.sum += interval
      self.count += 1
    end

    def mean
      sum.fdiv(count)
    end
  end

  # How often each interval was: us => cycles.
  attr_reader :counts
  # By their number.
  attr_reader :seconds
  # Cycles between the first and the last one that are in no recording.
  attr_reader :missing
  # Which stage was the longest before a late cycle: name => cycles.
  attr_reader :late_stages

  def initialize(late_us)
    @late_us = late_us
    @counts = Hash.new(0)
    @seconds = {}
    @late_stages = Hash.new(0)
    @missing = 0
  end

  # A row of the table; its head is none. The first cycle comes after nothing.
  def add(line)
    time, interval, stage = line.chomp.split(',')
    return if time == 'time_s'

    cycle = (Float(time) * 1000).round
    @missing += cycle - @last - 1 if @last
    count(cycle, Integer(interval, 10), stage) if @last || cycle.positive?
    @last = cycle
  end

  def cycles
    @counts.values.sum
  end

  def late
    @counts.sum { |interval, count| interval > @late_us ? count : 0 }
  end

  # The smallest interval that `share` of the cycles do not exceed.
  def quantile(share)
    wanted = (cycles * share).ceil
    @counts.sort.each do |interval, count|
      wanted -= count
      return interval if wanted <= 0
    end
    nil
  end

  def histogram_csv
    ['interval_us,cycles', *@counts.sort.map { |row| row.join(',') }, ''].join("\n")
  end

  def seconds_csv
    rows = @seconds.sort.map { |number, one| format('%<n>d,%<low>d,%<mean>.1f,%<high>d', n: number, low: one.shortest, mean: one.mean, high: one.longest) }
    ['second,shortest_us,mean_us,longest_us', *rows, ''].join("\n")
  end

  private

  def count(cycle, interval, stage)
    @counts[interval] += 1
    @late_stages[stage] += 1 if interval > @late_us
    (@seconds[cycle / 1000] ||= Second.new(interval, interval, 0, 0)).add(interval)
  end
end

# Durations of the stages of the cycles, as the status of a running Boresight reports them.
#
# @satisfies SWR-CHECK-012
module StageTimes
  # Cycles of each class, by its shortest time; each is twice as wide as the one before.
  def self.csv(stages)
    rows = stages.map { |stage| stage['counts'] }.transpose.each_with_index.map { |row, index| [index.zero? ? 0 : 2**(index - 1), *row] }
    [['from_us', *stages.map { |stage| stage['name'].downcase }], *rows].map { |row| "#{row.join(',')}\n" }.join
  end
end

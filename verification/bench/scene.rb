# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'support'

# Cycles of one scene of the whole controller, played on the simulated box in simulated time (samples.c): the same
# bytes on every run.
class Scene
  PROGRAM = File.join(ROOT, 'build/gcc/bin/bench-samples')

  Sample = Struct.new(:is_even, :cycle, :mode, :label)

  attr_reader :samples, :file

  # Without a play, its workflow.
  def initialize(robot = 'neuro', *play)
    @file = File.join(BENCH_OUT, "#{['samples', robot, *play].join('-')}.bin")
    said, errors, status = Open3.capture3(PROGRAM, @file, robot, *play)
    raise BenchFailed, errors unless status.success?

    @samples = said.lines(chomp: true).map do |line|
      kind, cycle, mode, label = line.split("\t", 4)
      Sample.new(kind == 'even', cycle.to_i, mode, label)
    end
  end

  def numbers
    samples.each_index.to_a
  end

  # The median is of the evenly spaced cycles, the worst of all.
  def figures(counts, stage)
    worst = counts.keys.max_by { |i| counts[i][stage] }
    evens = counts.keys.select { |i| samples[i].is_even }
    { median: median(evens.map { |i| counts[i][stage] }), worst: counts[worst][stage],
      worst_cycle: samples[worst].cycle, worst_with: samples[worst].label }
  end
end

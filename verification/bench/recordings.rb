# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'support'

# How large recordings are, in simulated time. The limits are held by verification/integration/recording/test_recording_size.c.
class Recordings
  PROGRAM = File.join(ROOT, 'build/gcc/bin/bench-recordings')
  FILE = File.join(BENCH_OUT, 'recording.bsr')
  RESULT = File.join(BENCH_OUT, 'recordings.json')
  CYCLES_PER_H = 3_600_000
  HEAD = ['robot, scene', 'cycles', 'bytes a cycle', 'MB an hour', 'limit', 'of the limit', 'smaller by'].freeze

  # Returns the table.
  def run
    puts 'Sizes of recordings'
    said, errors, status = Open3.capture3(PROGRAM, FILE)
    raise BenchFailed, errors unless status.success?

    rows = said.lines(chomp: true).map { |line| row(*line.split("\t")) }
    File.write(RESULT, "#{JSON.pretty_generate(rows.map { |cells| HEAD.zip(cells).to_h })}\n")
    ['Recordings: what a cycle takes in the file, and how many times smaller that is than the cycle',
     Table.render(HEAD, rows)].join("\n")
  end

  private

  def row(robot, scene, *numbers)
    cycles, bytes, whole, limit = numbers.map(&:to_i)
    mb_per_h = bytes.fdiv(cycles) * CYCLES_PER_H / 1e6
    ["#{robot} #{scene}", cycles, bytes.fdiv(cycles).round(2), mb_per_h.round(2), limit,
     format('%.0f %%', 100 * mb_per_h / limit), whole / bytes]
  end
end

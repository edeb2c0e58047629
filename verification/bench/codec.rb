# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'tmpdir'
require_relative 'support'

# Cost of a TRANSFORM in our OpenIGTLink codec, beside the standard's own library: ns and instructions, each for a
# message to bytes and back.
class Codec
  PROGRAM = File.join(ROOT, 'build/gcc/bin/bench-codec')
  WAYS = %w[pack unpack].product(%w[ours kept new]).map { |way| way.join('_') }.freeze
  SAYS = { 'ours' => 'ours', 'kept' => 'libOpenIGTLink, object kept', 'new' => 'libOpenIGTLink, new object' }.freeze
  ROUNDS = 400
  CALLS = 500
  COUNTED = 500
  CALL = /^cfn=(#{WAYS.join('|')})\ncalls=(\d+) .*\n\S+ (\d+)$/

  # Returns the table.
  def run
    puts 'OpenIGTLink: a TRANSFORM from a matrix to bytes and back'
    @times = times
    @instructions = instructions
    [title, table].join("\n")
  end

  # Way => ns per message, the median of rounds in turn.
  def times
    output(PROGRAM, ROUNDS, CALLS).scan(/^(\w+) ([\d.]+)$/).to_h { |way, time| [way, Float(time)] }
  end

  # Way => instructions per message, with everything it calls. Symbols are bound before, so that each call costs the same.
  def instructions
    Dir.mktmpdir('codec') do |directory|
      output('valgrind', '--tool=callgrind', "--callgrind-out-file=#{directory}/out", '--compress-strings=no',
             '--compress-pos=no', PROGRAM, 1, COUNTED)
      per_call(File.read(File.join(directory, 'out')))
    end
  end

  # Share of the library's instructions at its best, in percent.
  def self.percent(instructions, what)
    100.0 * instructions.fetch("#{what}_ours") / instructions.fetch("#{what}_kept")
  end

  private

  def output(*command)
    text, status = Open3.capture2e({ 'LD_BIND_NOW' => '1' }, *command.map(&:to_s))
    raise BenchFailed, "bench-codec: #{text.lines.last(5).join}" unless status.success?

    text
  end

  def per_call(dump)
    calls = Hash.new(0)
    costs = Hash.new(0)
    dump.scan(CALL) do |way, count, cost|
      calls[way] += count.to_i
      costs[way] += cost.to_i
    end
    raise BenchFailed, 'callgrind did not see every way' unless WAYS.all? { |way| calls[way] > COUNTED }

    WAYS.to_h { |way| [way, (costs[way].to_f / calls[way]).round] }
  end

  def title
    "OpenIGTLink, a TRANSFORM: median of #{ROUNDS} rounds in turn, all bytes equal; ratios to the library's best"
  end

  def table
    rows = WAYS.map do |way|
      what, who = way.split('_')
      best = "#{what}_kept"
      [what, SAYS[who], @times[way], @times[way] / @times[best], @instructions[way],
       @instructions[way].to_f / @instructions[best]]
    end
    Table.render(%w[way codec ns ratio instructions ratio], rows, left: [0, 1])
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'English'
require 'tmpdir'
require_relative 'worst_case_program'

module WorstCase
  # The instructions of each call of a program, in order: from the entry of the chart's function to its return, so
  # that nothing which prepares a call counts.
  module Counters
    module_function

    def count(processor, program, functions)
      processor == 'x86' ? callgrind(program, functions) : emulator(program, functions)
    end

    # Cost of the calls of each line; there is one a line.
    def callgrind(program, functions)
      Dir.mktmpdir do |folder|
        costs = File.join(folder, 'costs')
        Program.execute('valgrind', '--tool=callgrind', "--callgrind-out-file=#{costs}", '--compress-strings=no',
                        '--compress-pos=no', program.file)
        calls = File.read(costs).scan(/^cfn=(\w+)\ncalls=1 .*\n(\d+) (\d+)$/)
        calls.filter_map { |name, line, cost| [line.to_i, cost.to_i] if functions.include?(name) }.sort.map(&:last)
      end
    end

    # The emulator names the address of every instruction executed within the chart's code.
    def emulator(program, functions)
      symbols = symbols(program.file).slice(*symbols(program.object).keys)
      entries = symbols.values_at(*functions).map(&:first)
      counts = []
      trace(program, symbols.values) do |address|
        counts << 0 if entries.include?(address)
        counts[-1] += 1
      end
      counts
    end

    # Name => address and size; the lowest bit of an address only says that the code is Thumb.
    def symbols(file)
      text = Program.execute('arm-linux-gnueabihf-nm', '-S', '--defined-only', file)
      text.scan(/^(\h{8}) (\h{8}) [Ttb] (\S+)$/).to_h do |start, size, name|
        [name, [start.to_i(16) & ~1, size.to_i(16)]]
      end
    end

    # A line is "Trace 0: HOST [FLAGS/ADDRESS/...] SYMBOL".
    def trace(program, places)
      range = format('%#x..%#x', places.map(&:first).min, places.map(&:sum).max - 1)
      command = ['qemu-arm', '-cpu', 'cortex-a9', '-singlestep', '-d', 'exec,nochain', '-dfilter', range, program.file]
      IO.popen([*command, { err: %i[child out] }]) do |lines|
        lines.each_line { |line| yield line[%r{\[\h+/(\h+)/}, 1].to_i(16) if line.start_with?('Trace') }
      end
      return if $CHILD_STATUS.success?

      raise Failed, "#{program.file} gave #{$CHILD_STATUS.exitstatus} on the emulated Cortex-A9"
    end
  end
end

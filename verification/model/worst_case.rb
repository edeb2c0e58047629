# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'tmpdir'
require_relative 'worst_case_calls'
require_relative 'worst_case_counters'
require_relative 'worst_case_stack'

module WorstCase
  # Cost of one chart: instructions of every call, and bytes.
  class Measurement
    PROCESSORS = Program::CONFIGS.keys

    # The block may change the chart's C before it is compiled.
    def initialize(chart, &change)
      @calls = Calls.new(chart)
      Dir.mktmpdir do |folder|
        programs = PROCESSORS.to_h { |name| [name, Program.new(folder, chart, @calls, name, &change)] }
        @counts = programs.to_h { |name, program| [name, counted(name, program)] }
        @bytes = bytes(programs.fetch('arm'))
      end
    end

    # The instructions of every pair, in the walk's order.
    def pairs(processor)
      @counts.fetch(processor).take(@calls.pairs.length)
    end

    # The chart's row of the table.
    def row
      { 'pairs' => @calls.pairs.length }.merge(*PROCESSORS.map { |processor| instructions(processor) }, @bytes)
    end

    private

    def counted(processor, program)
      counts = Counters.count(processor, program, @calls.functions)
      return counts if counts.length == @calls.all.length

      raise Failed, "#{counts.length} calls counted on #{processor}, not #{@calls.all.length}"
    end

    def instructions(processor)
      pairs = pairs(processor)
      checks = @counts.fetch(processor).drop(pairs.length)
      { "#{processor}_instructions" => pairs.max,
        "#{processor}_witness" => @calls.pairs[pairs.index(pairs.max)].witness,
        "#{processor}_check_instructions" => checks.max }
    end

    def bytes(program)
      places = Counters.symbols(program.object)
      { 'stack_bytes' => Stack.new(program.call_graph, places).deepest(@calls.functions),
        'ram_bytes' => Counters.symbols(program.file).fetch('chart').last }
    end
  end
end

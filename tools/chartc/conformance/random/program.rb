# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'open3'
require_relative '../../lib/emit/c/header'
require_relative '../../lib/emit/c/source'
require_relative '../../lib/emit/vector'
require_relative 'appendix_d'

module RandomCharts
  # One chart as C, with what is to be done to it.
  class Machine
    attr_reader :name, :shape

    # document: the chart under a name that no other machine of the program has.
    def initialize(document, walk, steps)
      @document = document.dup.tap { |one| one.name = "#{document.name}_code" }
      @walk = walk
      @shape = ::Chart::C::Source.shape(document)
      @steps = steps
      @names = ::Chart::C::Names.new(@document)
      @vector = ::Chart::Vector.new(@document)
    end

    # All of it in one piece: header, code, the steps, and what shows the chart after each.
    def lines
      [without_include(::Chart::C::Header.new(@document, @walk).emit),
       without_include(::Chart::C::Source.new(@document, @walk).emit), show, run].join("\n")
        .gsub(/\btake_/, "#{@document.name}_take_")
    end

    def call
      "    #{@document.name}_run();"
    end

    # The lines that the program has printed about this machine, as what the chart showed.
    def seen(lines)
      lines.map { |line| line.start_with?('contract') ? line : read(line) }
    end

    private

    def without_include(text)
      text.gsub(/^#include.*\n/, '')
    end

    def show
      fields = @vector.fields.map { |field| "    printf(\"%ld \", (long)chart->#{field.name});" }
      ["static void #{@document.name}_show(const #{@names.chart_type} *chart, uint32_t actions, uint32_t before)", '{',
       *fields, '    show(&chart->trace, actions, before);',
       "    printf(\"%d\\n\", #{@names.chart_function('is_sound')}(chart) ? 1 : 0);", '}', '']
    end

    def run
      ["static void #{@document.name}_run(void)", '{', "    #{@names.chart_type} chart;", '    uint32_t before;',
       "    puts(\"#{@document.name}\");", '    if (setjmp(broken) != 0) {', '        return;', '    }',
       "    memset(&chart, 0x55, sizeof chart);", *@steps.flat_map { |step| taken(step) }, '}', '']
    end

    def taken(step)
      before = step.kind == :start ? '0U' : 'chart.trace.count'
      ["    before = #{before};", "    #{@document.name}_show(&chart, #{action(step)}, before);"]
    end

    def action(step)
      return "(#{@names.chart_function('init')}(&chart), 0U)" if step.kind == :start
      return dispatched(step, @names.event(step.value)) if step.kind == :event
      return dispatched(step, "(#{@names.event_type})#{@document.events.length}") if step.kind == :stray

      function = @names.chart_function('advance')
      @document.timers.empty? ? "#{function}(&chart, #{step.value}U)" : called(function, step, "#{step.value}U")
    end

    def dispatched(step, event)
      called(@names.chart_function('dispatch'), step, event)
    end

    def called(function, step, last)
      return "#{function}(&chart, #{last})" if @document.inputs.empty?

      rows = @document.inputs.map { |input| ".#{@names.field(input.name)} = #{step.inputs.fetch(input.name, false)}" }
      "#{function}(&chart, &(const #{@names.inputs_type}){#{rows.join(', ')}}, #{last})"
    end

    def read(line)
      vector, actions, taken, sound = line.split('|').map(&:strip)
      return line unless sound == '1'

      found = @vector.decode(vector.split.map(&:to_i)).to_h
      AppendixD::Seen.new(**found, actions: named(actions.to_i), taken: taken.split.map(&:to_i))
    end

    def named(bits)
      @document.actions.each_with_index.filter_map { |action, bit| action if bits[bit] == 1 }.sort
    end
  end

  # Many machines in one program, compiled at once.
  class Program
    # The compiler refused the code.
    class Refused < StandardError; end

    ROOT = File.expand_path('../../../..', __dir__)
    FLAGS = %w[-std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum
               -Wcast-qual -O0].freeze
    HEAD = <<~C
      #include "base/chart.h"

      #include <setjmp.h>
      #include <stdbool.h>
      #include <stdio.h>
      #include <string.h>

      static jmp_buf broken;

      void contract_broken(const char *module, uint32_t id)
      {
          printf("contract %s %u\\n", module, (unsigned)id);
          longjmp(broken, 1);
      }

      static void show(const chart_trace_t *trace, uint32_t actions, uint32_t before)
      {
          const uint32_t count = trace->count;
          printf("| %u |", (unsigned)actions);
          for (uint32_t i = (count - before > CHART_TRACE_LENGTH) ? count - CHART_TRACE_LENGTH : before; i < count; i++) {
              printf(" %u", (unsigned)trace->steps[i % CHART_TRACE_LENGTH].transition);
          }
          printf(" | ");
      }

    C

    def initialize(folder, machines)
      @folder = folder
      @machines = machines
    end

    # One list of what was seen for each machine.
    def run
      build
      output, status = Open3.capture2(File.join(@folder, 'program'))
      raise Refused, "ended by #{status}: #{output.lines.last}" unless status.success?

      found = output.lines(chomp: true).slice_before { |line| line.match?(/\A[a-z]\w*\z/) }.map { |rows| rows.drop(1) }
      @machines.zip(found).map { |machine, rows| machine.seen(rows) }
    end

    private

    def build
      FileUtils.mkdir_p(@folder)
      source = File.join(@folder, 'program.c')
      File.write(source, [HEAD, *@machines.map(&:lines), 'int main(void)', '{', *@machines.map(&:call), '    return 0;',
                          '}', ''].join("\n"))
      output, status = Open3.capture2e('gcc', *FLAGS, '-I', File.join(ROOT, 'core'), source, '-o',
                                       File.join(@folder, 'program'))
      raise Refused, output unless status.success?
    end
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'c/header'
require_relative 'c/layout'
require_relative 'vector'

module Chart
  # A program that runs a compiled chart by line commands from standard input:
  #   init | set V.. | event NUMBER INPUTS | expire MASK INPUTS | advance US INPUTS | corrupt FIELD VALUE | check
  # Each but set and corrupt answers "V.. | ACTIONS | TRANSITIONS | SOUND"; the transitions are the last that the trace
  # holds. A chart has one of these programs for each compiler and processor.
  # @satisfies SWR-CHART-011
  class Driver
    include C::Layout

    def initialize(document, walk)
      @document = document
      @names = C::Parts.new(document, walk).names
      @vector = Vector.new(document)
    end

    def emit
      text([banner(@document, 'Driver'), '', '#include <stdio.h>', '#include <stdlib.h>', '#include <string.h>', '',
            "#include \"#{@document.name}_chart.h\"", '',
            "static #{@names.chart_type} chart;", '', 'void contract_broken(const char *module, uint32_t id)', '{',
            '    printf("contract %s %u\n", module, (unsigned)id);', '    exit(2);', '}', '',
            numbers, inputs, set, answer, expire, obey, main])[0..-2]
    end

    private

    def numbers
      ['static long next(void)', '{', '    const char *const word = strtok(NULL, " \n");',
       '    return (word == NULL) ? 0 : strtol(word, NULL, 10);', '}', '']
    end

    def inputs
      return [] if @document.inputs.empty?

      rows = @document.inputs.each_with_index.map do |input, bit|
        "    inputs.#{@names.field(input.name)} = ((bits >> #{bit}) & 1) != 0;"
      end
      ["static #{@names.inputs_type} inputs_of(long bits)", '{', "    #{@names.inputs_type} inputs;", rows,
       '    return inputs;', '}', '']
    end

    def set
      rows = @vector.fields.map do |field|
        value = field.type == 'bool' ? 'next() != 0' : "(#{field.type})next()"
        inverse = field.kind == :region ? ["    chart.#{@names.inverse(field.part)} = ~(uint32_t)chart.#{field.name};"] : []
        timer = field.kind == :timer ? ["    chart.#{@names.time(field.part)} = 0U;"] : []
        ["    chart.#{field.name} = #{value};", *inverse, *timer]
      end
      ['static void set(void)', '{', rows, '}', '']
    end

    def answer
      rows = @vector.fields.map { |field| "    printf(\"%ld \", (long)chart.#{field.name});" }
      ['static void answer(uint32_t actions, uint32_t before)', '{', rows,
       '    printf("| %u | ", (unsigned)actions);',
       '    const uint32_t count = chart.trace.count;',
       '    uint32_t i = ((count - before) > CHART_TRACE_LENGTH) ? (count - CHART_TRACE_LENGTH) : before;',
       '    for (const char *comma = ""; i < count; i++, comma = ",") {',
       '        printf("%s%u", comma, (unsigned)chart.trace.steps[i % CHART_TRACE_LENGTH].transition);', '    }',
       "    printf(\" | %d\\n\", #{@names.chart_function('is_sound')}(&chart) ? 1 : 0);", '}', '']
    end

    # The timers of the mask reach their threshold in this call, the others do not.
    def expire
      return [] if @document.timers.empty?

      tick = @document.tick_us
      rows = @document.timers.each_with_index.map do |timer, bit|
        start = [timer.threshold_us - tick, 0].max
        "    chart.#{@names.time(timer)} = (((mask >> #{bit}) & 1) != 0) ? #{start}U : 0U;"
      end
      ["static uint32_t expire(long mask#{', long bits' if inputs?})", '{',
       inputs? ? "    const #{@names.inputs_type} inputs = inputs_of(bits);" : [], rows,
       "    return #{advance("#{tick}U")};", '}', '']
    end

    def inputs?
      @document.inputs.any?
    end

    def advance(time)
      "#{@names.chart_function('advance')}(&chart#{', &inputs' if inputs? && @document.timers.any?}, #{time})"
    end

    def obey
      ['static void obey(const char *verb)', '{', '    const uint32_t before = chart.trace.count;',
       '    uint32_t actions = 0U;',
       command('init', ["#{@names.chart_function('init')}(&chart);", 'answer(0U, 0U);', 'return;'], 'if'),
       command('set', ['set();', 'return;']),
       command('corrupt', corrupt),
       command('event', event), command('advance', advance_command), expire_command,
       command('check', ["actions = #{@names.chart_function('check')}(&chart);"]),
       '    answer(actions, before);', '}', '']
    end

    def command(verb, lines, word = '} else if')
      ["    #{word} (strcmp(verb, \"#{verb}\") == 0) {", lines.map { |line| "        #{line}" },
       verb == 'check' ? '    }' : []]
    end

    def corrupt
      regions = @vector.fields.select { |field| field.kind == :region }
      rows = regions.each_with_index.map do |field, index|
        "if (field == #{index}) { chart.#{field.name} = (#{field.type})value; }"
      end
      ['const long field = next();', 'const long value = next();', *rows, 'return;']
    end

    def event
      taken = ["const #{@names.event_type} event = (#{@names.event_type})next();"]
      taken << "const #{@names.inputs_type} inputs = inputs_of(next());" if inputs?
      taken << "actions = #{@names.chart_function('dispatch')}(&chart#{', &inputs' if inputs?}, event);"
    end

    def advance_command
      taken = ['const uint32_t elapsed_us = (uint32_t)next();']
      taken << "const #{@names.inputs_type} inputs = inputs_of(next());" if inputs? && @document.timers.any?
      taken << "actions = #{advance('elapsed_us')};"
    end

    def expire_command
      return [] if @document.timers.empty?

      body = ['actions = expire(next());']
      body = ['const long mask = next();', 'actions = expire(mask, next());'] if inputs?
      command('expire', body)
    end

    def main
      ['int main(void)', '{', '    static char line[4096];', "    #{@names.chart_function('init')}(&chart);",
       '    while (fgets(line, sizeof line, stdin) != NULL) {',
       '        const char *const verb = strtok(line, " \n");', '        if (verb != NULL) {',
       '            obey(verb);', '        }', '    }', '    return 0;', '}', '']
    end
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../c/layout'
require_relative '../c/parts'
require_relative 'cases'
require_relative 'rows'
require_relative 'shared'

module Chart
  # The Unity test of one chart: a table of every pair with what the interpreter says, and the code that
  # runs the compiled chart on it. With the test of the paths it reaches all of the code.
  # @satisfies SWR-CHART-010
  # @satisfies SWR-CHART-038
  class WalkTest
    include C::Layout
    include TestShared

    # proves: as of Compiled#tests.
    def initialize(document, walk, proves = {})
      @document = document
      @proves = proves
      @parts = C::Parts.new(document, walk)
      @names = @parts.names
      @rows = TestRows.new(document, walk, @names)
      @cases = TestCases.new(document, walk, @parts, proves)
    end

    def emit
      text([banner(@document, 'Tests'), about,
            '#include <stdio.h>', '#include <string.h>', '', '#include "unity.h"', '',
            "#include \"#{@document.name}_chart.h\"", '',
            row_type, @rows.tables, 'void setUp(void)', '{', '}', '',
            'void tearDown(void)', '{', '}', '', run_functions, pair_test, invariant_test, @cases.emit])[0..-2]
    end

    private

    def about
      comment('The rule under test: the compiled chart does on every pair of configuration and stimulus what an ' \
              'independent interpreter of the SCXML file does. A row stands for all input values that agree with ' \
              'it; each is run. Rows that no event leads to are run too, but prove no invariant.') + ['']
    end

    def regions
      @parts.regions.to_a
    end

    def memories
      @parts.regions.memories
    end

    def row_type
      fields = regions.map { |region| "    #{@names.region_type(region)} at_#{@names.field(region.name)};" }
      fields += memories.map { |memory| "    #{@names.region_type(memory.region)} at_#{@names.memory(memory)};" }
      fields += ["    uint32_t armed;", "    uint32_t expiring;"] if timers?
      fields << "    #{@names.event_type} event;"
      fields += ['    uint32_t inputs_read;', '    uint32_t inputs;'] if inputs?
      fields += regions.map { |region| "    #{@names.region_type(region)} to_#{@names.field(region.name)};" }
      fields += memories.map { |memory| "    #{@names.region_type(memory.region)} to_#{@names.memory(memory)};" }
      fields += ['    uint32_t next_armed;', '    uint32_t started;'] if timers?
      fields += ['    uint32_t actions;', '    uint32_t last_transition;', '    bool is_reachable;']
      ['typedef struct {', fields, '} pair_t;', '']
    end

    # --- running one row ------------------------------------------------------------------------

    def run_functions
      [last_function, inputs_function, timer_functions, place_function, stimulate_function, compare_function,
       each_function]
    end

    def last_function
      ["static uint32_t last_transition(const #{@names.chart_type} *chart)", '{',
       '    const uint32_t count = chart->trace.count;',
       '    return (count == 0U) ? 0U : chart->trace.steps[(count - 1U) % CHART_TRACE_LENGTH].transition;', '}', '']
    end

    def place_function
      fields = regions.map do |region|
        field = @names.field(region.name)
        ["    chart->#{field} = pair->at_#{field};", "    chart->#{@names.inverse(region)} = ~(uint32_t)pair->at_#{field};"]
      end
      fields += memories.map { |one| "    chart->#{@names.memory(one)} = pair->at_#{@names.memory(one)};" }
      timers = @document.timers.each_with_index.map do |timer, bit|
        ["    chart->#{@names.armed(timer)} = (pair->armed >> #{bit}U) & 1U;",
         "    chart->#{@names.time(timer)} = (chart->#{@names.armed(timer)} != 0U) ? 7U : 0U;",
         "    if ((pair->expiring & #{1 << bit}U) != 0U) {",
         "        chart->#{@names.time(timer)} = #{timer.threshold_us - 1}U;", '    }']
      end
      ["static void place(#{@names.chart_type} *chart, const pair_t *pair)", '{', fields, timers,
       '    chart->now_us = 0U;', '    chart->trace.count = 0U;', '}', '']
    end

    def stimulate_function
      arguments = inputs? ? '&inputs, ' : ''
      values = inputs? ? ', uint32_t bits' : ''
      body = inputs? ? ["    const #{@names.inputs_type} inputs = inputs_from(bits);", ''] : []
      if timers?
        body += ['    if (pair->expiring != 0U) {',
                 "        return #{@names.chart_function('advance')}(chart, #{arguments}1U);",
                 '    }']
      end
      body << "    return #{@names.chart_function('dispatch')}(chart, #{arguments}pair->event);"
      ["static uint32_t stimulate(#{@names.chart_type} *chart, const pair_t *pair#{values})", '{', body, '}', '']
    end

    def members
      regions.map { |one| @names.field(one.name) } + memories.map { |one| @names.memory(one) }
    end

    def compare_function
      [call('static void compare', check_parameters, ''), '{',
       members.map { |one| equal("pair->to_#{one}", "chart->#{one}", 'UINT32') },
       timers? ? [equal('pair->next_armed', 'armed_of(chart)', 'HEX32'), timer_values] : [],
       equal('pair->actions', 'actions', 'HEX32'),
       equal('pair->last_transition', 'last_transition(chart)', 'UINT32'),
       "    TEST_ASSERT_TRUE_MESSAGE(#{@names.chart_function('is_sound')}(chart), place_name);", '}', '']
    end

    def check_parameters
      ["const #{@names.chart_type} *chart", 'const pair_t *pair', 'uint32_t actions', 'const char *place_name']
    end

    def equal(expected, actual, kind)
      "    TEST_ASSERT_EQUAL_#{kind}_MESSAGE(#{expected}, #{actual}, place_name);"
    end

    # A timer started on the way stands at 0; one that ran before goes on from 7, or 8 after an expiry.
    def timer_values
      rows = @document.timers.each_with_index.map do |timer, bit|
        ["    if ((pair->next_armed & ~pair->started & #{1 << bit}U) != 0U) {",
         "        TEST_ASSERT_EQUAL_UINT32_MESSAGE(running_us, chart->#{@names.time(timer)}, place_name);",
         '    } else {', "        TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, chart->#{@names.time(timer)}, place_name);", '    }']
      end
      ['    const uint32_t running_us = (pair->expiring != 0U) ? 8U : 7U;', rows]
    end

    # Calls visit() for every row with every value of the inputs that agrees with it.
    def each_function
      head = 'static void run_pair'
      loop_open = inputs? ? ["    for (uint32_t bits = 0U; bits < #{1 << @document.inputs.length}U; bits++) {",
                             '        if ((bits & pair->inputs_read) != pair->inputs) {', '            continue;',
                             '        }'] : []
      pad = inputs? ? '        ' : '    '
      bits = inputs? ? 'bits' : '0U'
      [call(head, ["#{@names.chart_type} *chart", 'const pair_t *pair', 'unsigned row', 'check_t check'], ''), '{',
       '    char place_name[64];', '', loop_open,
       "#{pad}(void)snprintf(place_name, sizeof place_name, \"row %u, inputs %u\", row, (unsigned)#{bits});",
       "#{pad}place(chart, pair);",
       "#{pad}const uint32_t actions = stimulate(chart, pair#{inputs? ? ', bits' : ''});",
       "#{pad}check(chart, pair, actions, place_name);", inputs? ? '    }' : [], '}', ''].then do |lines|
        [check_type, lines, run_all]
      end
    end

    def check_type
      ["typedef void (*check_t)(const #{@names.chart_type} *chart, const pair_t *pair, uint32_t actions,",
       '                        const char *place_name);', '']
    end

    def run_all
      ['static void run_every_pair(check_t check)', '{', "    #{@names.chart_type} chart;", '',
       '    for (unsigned row = 0U; row < (sizeof pairs / sizeof pairs[0]); row++) {',
       '        run_pair(&chart, &pairs[row], row, check);', '    }', '}', '']
    end

    # --- the two tests over the table -------------------------------------------------------------

    def pair_test
      ["void #{test_name(:behaviour, 'equals_the_interpreter_on_every_pair')}(void)", '{',
       '    run_every_pair(compare);', '}', '']
    end

    def invariant_test
      return [] if @document.invariants.empty?

      checks = @document.invariants.map do |invariant|
        [comment("#{invariant.id} (#{invariant.req.join(' ')}): #{invariant.text}", '    '),
         '    TEST_ASSERT_TRUE_MESSAGE(', "        #{@parts.expressions.text(invariant.expression, 'chart')},",
         '        place_name);']
      end
      [call('static void hold_invariants', check_parameters, ''), '{', '    (void)actions;',
       '    if (!pair->is_reachable) {', '        return;', '    }', checks, '}', '',
       "void #{test_name(:invariants, 'invariants_hold_on_every_pair')}(void)", '{',
       '    run_every_pair(hold_invariants);', '}', '']
    end
  end
end

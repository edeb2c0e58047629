# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../c/layout'
require_relative '../c/names'
require_relative 'paths'
require_relative 'shared'

module Chart
  # The Unity test that drives one chart from its start, through its functions alone, over every transition, both
  # outcomes of every guard and every pair of successive transitions.
  # @satisfies SWR-CHART-009
  class PathsTest
    include C::Layout
    include TestShared

    def initialize(document, walk)
      @document = document
      @walk = walk
      @regions = Regions.new(document)
      @names = C::Names.new(document, @regions)
      @found = Paths.new(document, walk).found
    end

    def emit
      tests = @document.transitions.flat_map { |transition| [taken_test(transition), followed_test(transition)] }
      text([banner(@document, 'Tests of the paths'), about, '#include <stdio.h>', '', '#include "unity.h"', '',
            "#include \"#{@document.name}_chart.h\"", '', step_type, 'void setUp(void)', '{', '}', '',
            'void tearDown(void)', '{', '}', '', inputs_function, timer_functions, expect_functions, run_functions,
            tests])[0..-2]
    end

    private

    def about
      comment('The rule under test: from the start, the shortest list of events that leads to it takes every ' \
              'transition, decides every guard both ways, with all values of what it reads, and takes every pair of ' \
              'successive transitions. The chart is driven by its functions alone.') + ['']
    end

    # --- the tables ---------------------------------------------------------------------------------

    def taken_test(transition)
      says = transition.guard ? 'is_taken_only_if_its_guard_holds' : 'is_taken'
      test(transition, 'taken', says, paths(:guard, transition))
    end

    def followed_test(transition)
      test(transition, 'followed', 'is_followed_by_each_successor', paths(:pair, transition))
    end

    # To the goals of one kind that begin with the transition.
    def paths(kind, transition)
      @goals ||= @found.group_by { |goal, _path| goal.first(2) }
      @goals.fetch([kind, transition.number], []).map(&:last)
    end

    # Rows with the same way stand in one table: first the steps of the way, then the rows.
    def test(transition, what, says, paths)
      return [] if paths.empty?

      name = @names.stem_of(transition.id)
      ways = paths.uniq.group_by(&:first).transform_values { |group| group.map(&:last) }.to_a
      tables = ways.each_with_index.map { |(place, rows), index| table("#{name}_#{what}_#{index + 1}", place, rows) }
      runs = ways.each_with_index.map { |(place, _rows), index| run("#{name}_#{what}_#{index + 1}", place) }
      [tables, "void test_#{transition.req.join('_').tr('-', '_')}_#{name}_#{says}(void)", '{', runs, '}', '']
    end

    def run(table, place)
      "    RUN_ROWS(#{table}, #{place.steps.length}U);"
    end

    def table(name, place, rows)
      way = place.steps
      from = way.empty? ? 'From the start:' : "After #{words(way)}:"
      ["static const step_t #{name}[] = {", way.map { |step| row(step) }, comment(from, '    '),
       rows.map { |step| row(step) }, '};', '']
    end

    def words(steps)
      @walk.words(steps.map { |step| [step.stimulus, step.inputs] })
    end

    def row(step)
      (@rows ||= {})[step] ||= new_row(step)
    end

    def new_row(step)
      after = step.outcome.after
      cells = [@names.event(event_of(step))]
      cells << "#{step.elapsed_us}U" if timers?
      cells << "#{inputs_bits(step.inputs)}U" if inputs?
      cells += @regions.map { |region| @names.value(region, leaf(region, after)) }
      cells << "#{timer_mask(after.armed)}U" if timers?
      "    { #{(cells + result_cells(step.outcome)).join(', ')} },"
    end

    def event_of(step)
      kind, what = step.stimulus
      kind == :event ? what : @document.timers.find { |timer| timer.id == what.first }.event
    end

    def result_cells(outcome)
      numbers = outcome.taken.map { |transition| "#{transition.number}U" }
      [actions_cell(outcome.actions), "#{numbers.length}U", "{ #{numbers.empty? ? '0U' : numbers.join(', ')} }"]
    end

    def inputs_bits(inputs)
      @document.inputs.each_with_index.sum { |input, bit| inputs.fetch(input.name) ? 1 << bit : 0 }
    end

    def leaf(region, snapshot)
      (@leaf ||= {})[[region.name, snapshot.leaves]] ||= begin
        active = snapshot.leaves.map { |id| @document.state(id) }
        region.leaves.find { |leaf| active.any? { |state| state == leaf || state.inside?(leaf) } }
      end
    end

    def most_taken
      @found.each_value.flat_map { |place, last| [*place.steps, last] }.map { |step| step.outcome.taken.length }.max
    end

    # --- running them -------------------------------------------------------------------------------

    def step_type
      fields = ["    #{@names.event_type} event;"]
      fields << '    uint32_t elapsed_us; /* 0U: the event comes from outside */' if timers?
      fields << '    uint32_t inputs;' if inputs?
      fields += @regions.map { |region| "    #{@names.region_type(region)} at_#{@names.field(region.name)};" }
      fields << '    uint32_t armed;' if timers?
      fields += ['    uint32_t actions;', '    uint32_t taken_count;', "    uint32_t taken[#{most_taken}];"]
      ['/* An event with its inputs, and what the chart must be and have done after it. */', 'typedef struct {',
       fields, '} step_t;', '']
    end

    def expect_functions
      regions = @regions.map do |region|
        field = @names.field(region.name)
        "    TEST_ASSERT_EQUAL_UINT32_MESSAGE(step->at_#{field}, chart->#{field}, place);"
      end
      armed = timers? ? ['    TEST_ASSERT_EQUAL_HEX32_MESSAGE(step->armed, armed_of(chart), place);'] : []
      [call('static void expect_configuration', parameters, ''), '{', regions, armed,
       "    TEST_ASSERT_TRUE_MESSAGE(#{@names.chart_function('is_sound')}(chart), place);", '}', '', expect_trace]
    end

    def parameters
      ["const #{@names.chart_type} *chart", 'const step_t *step', 'const char *place']
    end

    # The ring keeps the last ones of a step that takes more than it holds.
    def expect_trace
      [call('static void expect_trace', [*parameters, 'uint32_t before'], ''), '{',
       '    const uint32_t count = step->taken_count;',
       '    const uint32_t lost = (count > CHART_TRACE_LENGTH) ? (count - CHART_TRACE_LENGTH) : 0U;', '',
       '    TEST_ASSERT_EQUAL_UINT32_MESSAGE(before + count, chart->trace.count, place);',
       '    for (uint32_t i = lost; i < count; i++) {',
       '        const chart_step_t *const found = &chart->trace.steps[(before + i) % CHART_TRACE_LENGTH];', '',
       '        TEST_ASSERT_EQUAL_UINT32_MESSAGE(step->taken[i], found->transition, place);',
       '        TEST_ASSERT_EQUAL_UINT64_MESSAGE(chart->now_us, found->now_us, place);', '    }', '}', '']
    end

    def run_functions
      [stimulate, run_step, run_rows]
    end

    def stimulate
      inputs = inputs? ? '&inputs, ' : ''
      values = inputs? ? ["    const #{@names.inputs_type} inputs = inputs_from(step->inputs);", ''] : []
      advance = timers? ? ['    if (step->elapsed_us != 0U) {',
                           "        return #{@names.chart_function('advance')}(chart, #{inputs}step->elapsed_us);",
                           '    }'] : []
      [call('static uint32_t stimulate', ["#{@names.chart_type} *chart", 'const step_t *step'], ''), '{', values,
       advance, "    return #{@names.chart_function('dispatch')}(chart, #{inputs}step->event);", '}', '']
    end

    def run_step
      [call('static void run_step', ["#{@names.chart_type} *chart", *parameters.drop(1)], ''), '{',
       '    const uint32_t before = chart->trace.count;', '',
       '    TEST_ASSERT_EQUAL_HEX32_MESSAGE(step->actions, stimulate(chart, step), place);',
       '    expect_configuration(chart, step, place);', '    expect_trace(chart, step, place, before);', '}', '']
    end

    # Each row goes its way from the start.
    def run_rows
      ['static void run_rows(const char *name, const step_t *steps, size_t way, size_t end)', '{',
       '    char place[64];', '', '    for (size_t row = way; row < end; row++) {',
       "        #{@names.chart_type} chart;", '', "        #{@names.chart_function('init')}(&chart);",
       '        for (size_t i = 0U; i <= way; i++) {', '            const size_t at = (i < way) ? i : row;', '',
       '            (void)snprintf(place, sizeof place, "%s[%zu] for [%zu]", name, at, row);',
       '            run_step(&chart, &steps[at], place);', '        }', '    }', '}', '',
       '#define RUN_ROWS(table, way) run_rows(#table, table, way, sizeof table / sizeof table[0])', '']
    end
  end
end

# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../check/entering'
require_relative '../c/layout'
require_relative 'shared'

module Chart
  # The tests that are not rows of the table: start, unknown event, compound states, damage, timers.
  class TestCases
    include C::Layout
    include TestShared

    def initialize(document, walk, parts, proves)
      @document = document
      @walk = walk
      @parts = parts
      @proves = proves
      @names = parts.names
      @regions = parts.regions
    end

    def emit
      [start_test, unknown_event_test, internal_event_test, clock_test, compound_test, entering_test, damage_functions, damage_test,
       sound_test, timer_tests]
    end

    private

    def test(kind, name, body)
      ["void #{test_name(kind, name)}(void)", '{', body, '}', '']
    end

    def field(region)
      @names.field(region.name)
    end

    # Those that expire.
    def timers(pair)
      @document.timers.select { |timer| pair.stimulus.last.include?(timer.id) }
    end

    def chart
      "    #{@names.chart_type} chart;"
    end

    def dispatch(event)
      "#{@names.chart_function('dispatch')}(&chart, #{inputs? ? '&inputs, ' : ''}#{event})"
    end

    def advance(microseconds)
      inputs = inputs? && timers? ? '&inputs, ' : ''
      "#{@names.chart_function('advance')}(&chart, #{inputs}#{microseconds})"
    end

    def inputs_line
      inputs? ? ["    const #{@names.inputs_type} inputs = inputs_from(0U);"] : []
    end

    def expect_leaves(ids)
      ids.map do |id|
        state = @document.state(id)
        "    TEST_ASSERT_EQUAL_UINT32(#{@names.leaf(state)}, chart.#{field(@regions.of(state))});"
      end
    end

    def expect_forgotten
      @regions.memories.map do |memory|
        "    TEST_ASSERT_EQUAL_UINT32(#{@names.value(memory.region, nil)}, chart.#{@names.memory(memory)});"
      end
    end

    def expect_armed(timers)
      timers? ? ["    TEST_ASSERT_EQUAL_HEX32(#{timer_mask(timers)}U, armed_of(&chart));"] : []
    end

    def start_test
      start = @walk.start.after
      test(:behaviour, 'starts_in_its_initial_configuration',
           [chart, '', '    (void)memset(&chart, 0xA5, sizeof chart);', "    #{@names.chart_function('init')}(&chart);",
            expect_leaves(start.leaves), expect_forgotten, expect_armed(start.armed),
            '    TEST_ASSERT_EQUAL_UINT32(0U, last_transition(&chart));',
            '    TEST_ASSERT_EQUAL_UINT64(0U, chart.now_us);',
            "    TEST_ASSERT_TRUE(#{@names.chart_function('is_sound')}(&chart));"])
    end

    def unknown_event_test
      test(:behaviour, 'ignores_an_unknown_event',
           nothing_everywhere(["(#{@names.event_type})#{@document.events.length}"]))
    end

    # Events that only the chart itself causes do nothing from outside.
    def internal_event_test
      return [] if @document.internal_events.empty?

      test(:behaviour, 'takes_no_internal_event_from_outside',
           nothing_everywhere(@document.internal_events.map { |event| @names.event(event) }))
    end

    # In every place of the table.
    def nothing_everywhere(events)
      rows = events.map do |event|
        ['        place(&chart, &pairs[row]);', "        TEST_ASSERT_EQUAL_HEX32(0U, #{dispatch(event)});",
         @regions.map { |region| unmoved(region) }, '        TEST_ASSERT_EQUAL_UINT32(0U, chart.trace.count);']
      end
      [chart, inputs_line, '', '    for (unsigned row = 0U; row < (sizeof pairs / sizeof pairs[0]); row++) {', rows,
       '    }']
    end

    def unmoved(region)
      "        TEST_ASSERT_EQUAL_UINT32(pairs[row].at_#{field(region)}, chart.#{field(region)});"
    end

    def clock_test
      dispatched = @document.events - @document.internal_events
      calls = dispatched.map { |event| "    (void)#{dispatch(@names.event(event))};" }
      test(:clock, 'dates_its_steps',
           [chart, clock_inputs, '', "    #{@names.chart_function('init')}(&chart);",
            "    (void)#{advance('3000U')};", "    (void)#{advance('4000U')};",
            '    TEST_ASSERT_EQUAL_UINT64(7000U, chart.now_us);', '    chart.trace.count = 0U;', calls,
            '    TEST_ASSERT_NOT_EQUAL_UINT32(0U, chart.trace.count);',
            '    TEST_ASSERT_EQUAL_UINT64(7000U, chart.trace.steps[0].now_us);'])
    end

    # All inputs true, so that some guard lets an event through.
    def clock_inputs
      inputs? ? ["    const #{@names.inputs_type} inputs = inputs_from(#{(1 << @document.inputs.length) - 1}U);"] : []
    end

    def compound_test
      return [] if @parts.compounds.empty?

      rows = @parts.compounds.map do |state|
        region = @regions.of(state)
        region.leaves.map do |leaf|
          expected = state.leaves.include?(leaf).to_s.upcase
          ["    chart.#{field(region)} = #{@names.leaf(leaf)};",
           "    TEST_ASSERT_#{expected}(#{@names.in_function(state)}(&chart));"]
        end
      end
      test(:behaviour, 'names_its_compound_states',
           [chart, '', "    #{@names.chart_function('init')}(&chart);", rows])
    end

    # Each reachable configuration, with every event of bs:enters.
    def entering_test
      return [] if @document.entering.empty?

      rows = @document.entering.flat_map do |event|
        Entering.new(@document, @walk).configurations(event).map do |ids, is_entered|
          [@regions.map { |region| "    chart.#{field(region)} = #{@names.value(region, region.leaves.find { |leaf| ids.include?(leaf.id) })};" },
           "    TEST_ASSERT_#{is_entered.to_s.upcase}(#{@names.enters_function(event)}(&chart));"]
        end
      end
      test(:behaviour, 'says_where_its_events_enter_a_state', [chart, '', "    #{@names.chart_function('init')}(&chart);", rows])
    end

    # --- damage -----------------------------------------------------------------------------------

    def damage_functions
      [repaired_function, frozen_function]
    end

    # Copies that disagree: no event and no timer gets through, and the check repairs.
    def frozen_function
      idle = timers? ? ["    TEST_ASSERT_EQUAL_HEX32(0U, #{advance('UINT32_MAX')});"] : []
      same = @regions.map do |region|
        "    TEST_ASSERT_EQUAL_UINT32(damaged->#{field(region)}, chart.#{field(region)});"
      end
      ["static void expect_frozen_then_safe(const #{@names.chart_type} *damaged)", '{',
       "    #{@names.chart_type} chart = *damaged;", inputs_line, '',
       "    for (uint32_t event = 0U; event < #{@document.events.length}U; event++) {",
       "        TEST_ASSERT_EQUAL_HEX32(0U, #{dispatch("(#{@names.event_type})event")});", '    }',
       idle, same, '    expect_repaired(&chart);', '}', '']
    end

    def repaired_function
      safe = @document.safe.map(&:id)
      lines = [expect_leaves(safe), expect_forgotten, expect_armed(safe_timers)].flatten
      ["static void expect_repaired(#{@names.chart_type} *chart)", '{',
       '    const uint32_t before = chart->trace.count;', '',
       "    TEST_ASSERT_FALSE(#{@names.chart_function('is_sound')}(chart));",
       "    TEST_ASSERT_EQUAL_UINT32(1U, #{@names.chart_function('check')}(chart));",
       lines.map { |line| line.gsub('chart.', 'chart->').gsub('&chart', 'chart') },
       '    TEST_ASSERT_EQUAL_UINT32(before + 1U, chart->trace.count);',
       '    TEST_ASSERT_EQUAL_UINT32(0U, last_transition(chart));',
       "    TEST_ASSERT_TRUE(#{@names.chart_function('is_sound')}(chart));",
       "    TEST_ASSERT_EQUAL_UINT32(0U, #{@names.chart_function('check')}(chart));", '}', '']
    end

    # Timers of the states that the safe configuration is in.
    def safe_timers
      active = @document.safe.flat_map { |leaf| [leaf, *leaf.ancestors] }
      active.reject(&:root?).flat_map(&:entry).grep(Send).map { |send| send.timer.id }
    end

    def damage_test
      [test(:damage, 'a_damaged_region_goes_to_the_safe_state',
            [chart, '', @regions.map { |region| flips_of(region) }]),
       test(:damage, 'a_leaf_that_does_not_exist_goes_to_the_safe_state',
            [chart, inputs_line, '', @regions.map { |region| unknown_of(region) },
             strangers_everywhere])]
    end

    def flips_of(region)
      init = begin_chart.map { |line| "    #{line}" }
      type = @names.region_type(region)
      ['    for (uint32_t bit = 0U; bit < 32U; bit++) {',
       '        const uint32_t flip = (uint32_t)1U << bit;', '', init,
       "        chart.#{field(region)} = (#{type})((uint32_t)chart.#{field(region)} ^ flip);",
       '        expect_frozen_then_safe(&chart);', init, "        chart.#{@names.inverse(region)} ^= flip;",
       '        expect_frozen_then_safe(&chart);', '    }']
    end

    # The initial configuration, but with every timer running, so that the repair has something to stop.
    def begin_chart
      ["    #{@names.chart_function('init')}(&chart);",
       *@document.timers.flat_map do |timer|
         ["    chart.#{@names.time(timer)} = 5U;", "    chart.#{@names.armed(timer)} = 1U;"]
       end]
    end

    # Both copies agree on a value that is no leaf: the region takes no event, and the check repairs.
    def unknown_of(region)
      [begin_chart, make_unknown(region), unheard(region), '    expect_repaired(&chart);']
    end

    # A region that comes and goes may be entered anew by an event of the others.
    def unheard(region)
      return [] unless @regions.all? { |one| @regions.always_active?(one) }

      ["    for (uint32_t event = 0U; event < #{@document.events.length}U; event++) {",
       "        (void)#{dispatch("(#{@names.event_type})event")};",
       "        TEST_ASSERT_EQUAL_UINT32(#{unknown(region)}, chart.#{field(region)});", '    }']
    end

    def unknown(region)
      "#{@names.resting_values(region).length}U"
    end

    def make_unknown(region)
      unknown = unknown(region)
      ["    chart.#{field(region)} = (#{@names.region_type(region)})#{unknown};",
       "    chart.#{@names.inverse(region)} = ~(uint32_t)#{unknown};"]
    end

    # With no region left that could act, there are no actions.
    def strangers_everywhere
      [begin_chart, @regions.map { |region| make_unknown(region) },
       "    for (uint32_t event = 0U; event < #{@document.events.length}U; event++) {",
       "        TEST_ASSERT_EQUAL_HEX32(0U, #{dispatch("(#{@names.event_type})event")});", '    }',
       '    expect_repaired(&chart);']
    end

    def sound_test
      test(:damage, 'a_sound_chart_is_left_alone',
           [chart, '', "    #{@names.chart_function('init')}(&chart);",
            "    TEST_ASSERT_EQUAL_UINT32(0U, #{@names.chart_function('check')}(&chart));",
            expect_leaves(@walk.start.after.leaves), expect_armed(@walk.start.after.armed)])
    end

    # --- timers -----------------------------------------------------------------------------------

    def timer_tests
      @document.timers.filter_map do |timer|
        pair = @walk.reachable_pairs.find { |one| one.stimulus == [:expire, [timer.id]] }
        [boundary_test(timer, pair), idle_test(timer)] if pair
      end
    end

    def boundary_test(timer, pair)
      delay = timer.threshold_us
      test(:behaviour, "timer_#{timer.id}_expires_at_#{delay}_us_and_not_before",
           [chart, inputs_line, '', place(pair),
            expect_no_expiry(timer, delay - 1, pair), expect_expiry('1U', pair),
            place(pair), expect_expiry("#{delay}U", pair),
            place(pair), expect_expiry("#{delay + 1}U", pair),
            '    /* a sum that would wrap saturates instead */',
            place(pair), "    chart.#{@names.time(timer)} = 1U;", expect_expiry('UINT32_MAX', pair)])
    end

    # The leaves where the timer runs, with no other timer running.
    def place(pair)
      cells = pair.before.leaves.map do |id|
        state = @document.state(id)
        ".at_#{field(@regions.of(state))} = #{@names.leaf(state)}"
      end
      ["    place(&chart, &(const pair_t){ #{cells.join(', ')} });",
       timers(pair).map { |timer| ["    chart.#{@names.armed(timer)} = 1U;"] }]
    end

    def expect_no_expiry(timer, microseconds, pair)
      ["    TEST_ASSERT_EQUAL_HEX32(0U, #{advance("#{microseconds}U")});", expect_leaves(pair.before.leaves),
       "    TEST_ASSERT_EQUAL_UINT32(#{microseconds}U, chart.#{@names.time(timer)});",
       '    TEST_ASSERT_EQUAL_UINT32(0U, last_transition(&chart));']
    end

    def expect_expiry(microseconds, pair)
      outcome = pair.outcomes.first
      ["    TEST_ASSERT_EQUAL_HEX32(#{actions_cell(outcome.actions)}, #{advance(microseconds)});",
       expect_leaves(outcome.after.leaves), expect_armed(outcome.started),
       "    TEST_ASSERT_EQUAL_UINT32(#{outcome.taken.last&.number || 0}U, last_transition(&chart));"]
    end

    def idle_test(timer)
      return [] if @walk.start.after.armed.any?

      test(:behaviour, "timer_#{timer.id}_stands_still_while_not_armed",
           [chart, inputs_line, '', "    #{@names.chart_function('init')}(&chart);",
            "    TEST_ASSERT_EQUAL_HEX32(0U, #{advance('UINT32_MAX')});",
            "    TEST_ASSERT_EQUAL_UINT32(0U, chart.#{@names.time(timer)});", expect_leaves(@walk.start.after.leaves)])
    end
  end
end

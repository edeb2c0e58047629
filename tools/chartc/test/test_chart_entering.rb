# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'minitest/autorun'
require_relative 'own_charts'
require_relative '../lib/emit/c/header'
require_relative '../lib/emit/tests/walk_test'

# From where an event of bs:enters enters a state: what the walk has seen, as a function of the header.
class TestChartEntering < Minitest::Test
  include OwnCharts

  ASKED = [/bs:tick="1ms"/, 'bs:tick="1ms" bs:enters="pull stop"'].freeze

  def test_SWR_TOOL_072_the_header_says_from_where_an_event_enters_a_state
    text = changed(ASKED)
    header = Chart::C::Header.new(parse(text), walk_of(text)).emit
    assert_includes header, <<~C
      /* True where stop enters a state, with some inputs: from warming, on. */
      static inline bool lamp_chart_enters_by_stop(const lamp_chart_t *self)
      {
          return ((self->power == LAMP_POWER_WARMING) || (self->power == LAMP_POWER_ON));
      }
    C
    assert_includes header, '/* True where pull enters a state, with some inputs: from closed, warming, on. */'
    refute_includes Chart::C::Header.new(parse(CHART), walk_of(CHART)).emit, 'enters_by'
  end

  def test_SWR_TOOL_072_what_takes_no_target_enters_nothing
    text = changed(ASKED, [/event="stop" target="off" cond="!is_kept"/, 'event="stop" cond="!is_kept"'],
                   [/event="stop" target="warming" cond="is_kept"/, 'event="stop" cond="is_kept"'])
    assert_equal %w[warming], Chart::Entering.new(parse(text), walk_of(text)).leaves('stop').map(&:id)
  end

  # The one leaf from which it starts is not enough: the door decides.
  def test_SWR_TOOL_072_refuses_an_event_of_which_one_leaf_does_not_say_it
    refusal = refusal_of([ASKED.first, 'bs:tick="1ms" bs:enters="start"'])
    assert_equal [42, line_of('<scxml')], [refusal.rule, refusal.line]
    assert_match(/"start" enters a state from closed off depends on several regions/, refusal.message)
  end
end

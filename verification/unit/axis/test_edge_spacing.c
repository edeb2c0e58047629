/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a driven axis whose counts come and go is reported, whatever its motor's speed;
 * one whose states are of unequal width never. A cycle of these makes a quarter of a tick, or more.
 */
#include "axis/edge_spacing.h"
#include "limits/requirement_limits.h"
#include "unity.h"

#define TICK 65536U
#define LONG 100000U

/* Widths of four states, as in an encoder whose widths differ by a tenth (rms), in 1/1000. */
static const uint32_t widths[4] = {1094U, 859U, 1094U, 953U};

static edge_spacing_t pace;

void setUp(void)
{
    edge_spacing_init(&pace);
}

void tearDown(void)
{
}

/* A cycle, the count at its end. */
static bool cycle(uint32_t way_q16, uint32_t ticks)
{
    return edge_spacing_step(
        &pace, &(edge_spacing_view_t){.way_q16 = way_q16, .after_q16 = 0U, .ticks = ticks});
}

/* Counts, each after so much of the model's way. True when one is reported, the last one then. */
static bool run(uint32_t counts, uint32_t way_q16)
{
    bool is_reported = false;
    for (uint32_t i = 0U; (i < counts) && !is_reported; i++) {
        is_reported = cycle(way_q16 / 2U, 0U) || cycle(way_q16 - (way_q16 / 2U), 1U);
    }
    return is_reported;
}

/* So often one count is lost, after so many. @return how many have been lost, 0: more than `most`
 */
static uint32_t lose(uint32_t every, uint32_t most)
{
    uint32_t lost = 0U;
    bool is_reported = run(every, TICK);
    while (!is_reported && (lost < most)) {
        lost++;
        is_reported = run(1U, 2U * TICK) || run(every, TICK);
    }
    return is_reported ? lost : 0U;
}

void test_SWR_AXIS_027_even_counts_are_never_reported(void)
{
    TEST_ASSERT_FALSE(run(LONG, TICK));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
    setUp();
    TEST_ASSERT_FALSE(run(LONG, TICK * 5U / 4U));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
}

void test_SWR_AXIS_027_states_of_unequal_width_are_even(void)
{
    for (uint32_t i = 0U; i < LONG; i++) {
        TEST_ASSERT_FALSE(cycle((TICK / 1000U) * widths[i % 4U], 1U));
        TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
    }
}

void test_SWR_AXIS_027_counts_that_are_lost_now_and_then_are_reported(void)
{
    static const uint32_t every[] = {1U, 2U, 3U, 10U, 50U, 150U, 400U};
    for (uint32_t i = 0U; i < (sizeof every / sizeof every[0]); i++) {
        setUp();
        const uint32_t lost = lose(every[i], 16U);
        TEST_ASSERT_GREATER_THAN_UINT32(0U, lost);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(4U, lost);
    }
}

/* A cycle of a fast axis makes many counts. */
void test_SWR_AXIS_027_ways_of_many_counts_are_compared_as_well(void)
{
    bool is_reported = false;
    for (uint32_t i = 0U; i < 40U; i++) {
        TEST_ASSERT_FALSE(cycle((12U + (i % 3U)) * TICK, 12U + (i % 3U)));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
    for (uint32_t i = 0U; (i < 40U) && !is_reported; i++) {
        is_reported = cycle(12U * TICK, ((i % 10U) == 0U) ? 6U : 12U);
    }
    TEST_ASSERT_TRUE(is_reported);
}

void test_SWR_AXIS_027_each_even_way_takes_back_one(void)
{
    TEST_ASSERT_FALSE(run(3U, TICK));
    TEST_ASSERT_FALSE(run(1U, 2U * TICK));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNEVEN_WEIGHT, pace.uneven);
    TEST_ASSERT_FALSE(run(1U, TICK));
    TEST_ASSERT_EQUAL_UINT32(2U * LIMIT_UNEVEN_WEIGHT, pace.uneven);
    TEST_ASSERT_FALSE(run(30U, TICK));
    TEST_ASSERT_EQUAL_UINT32((2U * LIMIT_UNEVEN_WEIGHT) - 30U, pace.uneven);
    TEST_ASSERT_FALSE(run(LONG, TICK));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
}

void test_SWR_AXIS_027_a_rare_loss_is_borne_for_ever(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, lose((2U * LIMIT_UNEVEN_WEIGHT) + 1U, 1000U));
}

void test_SWR_AXIS_027_at_the_limit_a_change_is_reported(void)
{
    TEST_ASSERT_FALSE(run(3U, TICK));
    pace.uneven = LIMIT_UNEVEN_MOST - LIMIT_UNEVEN_WEIGHT - 1U;
    TEST_ASSERT_FALSE(run(1U, 2U * TICK));
    pace.uneven = LIMIT_UNEVEN_MOST - LIMIT_UNEVEN_WEIGHT;
    TEST_ASSERT_TRUE(run(1U, TICK));
}

void test_SWR_AXIS_027_more_than_the_share_is_a_change_and_the_share_is_none(void)
{
    const uint32_t way_q16 = 100U * 600U;
    const uint32_t most_q16 = LIMIT_PACE_CHANGE_PERCENT * 600U;
    TEST_ASSERT_FALSE(run(2U, way_q16));
    TEST_ASSERT_FALSE(run(1U, most_q16));
    TEST_ASSERT_FALSE(run(1U, way_q16));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
    TEST_ASSERT_FALSE(run(1U, most_q16 + 1U));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNEVEN_WEIGHT, pace.uneven);
}

void test_SWR_AXIS_027_what_was_made_after_a_count_is_of_the_next_way(void)
{
    const edge_spacing_view_t early = {.way_q16 = TICK, .after_q16 = TICK * 3U / 4U, .ticks = 1U};
    TEST_ASSERT_FALSE(run(3U, TICK));
    TEST_ASSERT_FALSE(cycle(TICK * 3U / 4U, 0U));
    TEST_ASSERT_FALSE(edge_spacing_step(&pace, &early));
    TEST_ASSERT_EQUAL_UINT32(TICK, pace.due_q16);
    TEST_ASSERT_FALSE(cycle(TICK / 4U, 1U));
    TEST_ASSERT_EQUAL_UINT32(TICK, pace.due_q16);
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
}

/* The stamp of a count may be older than its cycle. */
void test_SWR_AXIS_027_after_a_count_no_more_was_made_than_in_its_cycle(void)
{
    const edge_spacing_view_t old = {.way_q16 = TICK / 2U, .after_q16 = TICK, .ticks = 1U};
    TEST_ASSERT_FALSE(run(1U, TICK));
    TEST_ASSERT_FALSE(cycle(TICK / 2U, 0U));
    TEST_ASSERT_FALSE(edge_spacing_step(&pace, &old));
    TEST_ASSERT_EQUAL_UINT32(TICK / 2U, pace.due_q16);
    TEST_ASSERT_EQUAL_UINT32(TICK / 2U, pace.since_q16);
}

/* From the last count before it to the first one after it there is no way. */
void test_SWR_AXIS_027_an_axis_that_turned_begins_anew_with_the_pace_that_it_had(void)
{
    TEST_ASSERT_FALSE(run(1U, TICK));
    edge_spacing_begin(&pace);
    TEST_ASSERT_FALSE(run(1U, 3U * TICK));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.ticks);
    TEST_ASSERT_FALSE(run(1U, TICK));
    edge_spacing_begin(&pace);
    TEST_ASSERT_FALSE(run(1U, 50U * TICK));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
    TEST_ASSERT_FALSE(run(1U, 2U * TICK));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNEVEN_WEIGHT, pace.uneven);
}

void test_SWR_AXIS_027_once_the_position_is_sure_nothing_is_uneven(void)
{
    TEST_ASSERT_FALSE(run(3U, TICK));
    TEST_ASSERT_FALSE(run(1U, 2U * TICK));
    edge_spacing_settle(&pace);
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
}

void test_SWR_AXIS_024_a_way_is_shown_in_the_cycle_in_which_it_ends(void)
{
    TEST_ASSERT_FALSE(cycle(TICK, 1U));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.ended_q16);
    TEST_ASSERT_FALSE(cycle(TICK / 2U, 0U));
    TEST_ASSERT_FALSE(cycle(TICK / 4U, 1U));
    TEST_ASSERT_EQUAL_UINT32(TICK * 3U / 4U, pace.ended_q16);
    TEST_ASSERT_FALSE(cycle(TICK, 0U));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.ended_q16);
    TEST_ASSERT_FALSE(cycle(TICK, 1U));
    edge_spacing_begin(&pace);
    TEST_ASSERT_EQUAL_UINT32(0U, pace.ended_q16);
}

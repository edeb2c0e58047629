/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a running axis whose counts come and go is told, whatever its motor's speed; one
 * whose states are of unequal width, or whose speed changes as the model's does, never.
 */
#include "axis/edge_pace.h"
#include "limits/requirement_limits.h"
#include "unity.h"

#include <string.h>

#define SPEED_Q8 (1000U * 256U)
#define EVEN_US 1000U
/* Of four, as wide as in an encoder whose widths differ by a tenth (rms). */
static const uint32_t widths_us[4] = {1094U, 859U, 1094U, 953U};
#define LONG 100000U

static edge_pace_t pace;
static uint32_t edge_us;

void setUp(void)
{
    (void)memset(&pace, 0, sizeof pace);
    edge_us = UINT32_MAX - 20000U;
}

void tearDown(void)
{
}

static bool count(uint32_t ticks, uint32_t time_us, uint32_t speed_q8)
{
    edge_us += time_us;
    return edge_pace_step(&pace, ticks, edge_us, speed_q8);
}

/* True when one of these is told, the last one then. */
static bool run(uint32_t counts, uint32_t time_us)
{
    bool is_told = false;
    for (uint32_t i = 0U; (i < counts) && !is_told; i++) {
        is_told = count(1U, time_us, SPEED_Q8);
    }
    return is_told;
}

/* So often, one count is lost after so many. @return how many have been lost */
static uint32_t lose(uint32_t every, uint32_t most)
{
    uint32_t lost = 0U;
    while (!run(every, EVEN_US)) {
        if (lost == most) {
            return 0U;
        }
        lost++;
        if (run(1U, 2U * EVEN_US)) {
            return lost;
        }
    }
    return lost;
}

void test_SWR_AXIS_027_even_counts_are_never_told(void)
{
    TEST_ASSERT_FALSE(run(LONG, EVEN_US));
    TEST_ASSERT_FALSE(run(LONG, EVEN_US * 3U / 2U));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(LIMIT_UNEVEN_WEIGHT, pace.uneven);
}

void test_SWR_AXIS_027_states_of_unequal_width_are_even(void)
{
    for (uint32_t i = 0U; i < LONG; i++) {
        TEST_ASSERT_FALSE(count(1U, widths_us[i % 4U], SPEED_Q8));
        TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
    }
}

void test_SWR_AXIS_027_counts_that_are_lost_now_and_then_are_told(void)
{
    static const uint32_t every[] = {1U, 2U, 3U, 10U, 50U, 150U};
    for (uint32_t i = 0U; i < (sizeof every / sizeof every[0]); i++) {
        setUp();
        const uint32_t lost = lose(every[i], 16U);
        TEST_ASSERT_GREATER_THAN_UINT32(0U, lost);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(8U, lost);
    }
}

void test_SWR_AXIS_027_each_even_pace_takes_back_one(void)
{
    TEST_ASSERT_FALSE(run(3U, EVEN_US));
    TEST_ASSERT_FALSE(run(1U, 2U * EVEN_US));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNEVEN_WEIGHT, pace.uneven);
    TEST_ASSERT_FALSE(run(1U, EVEN_US));
    TEST_ASSERT_EQUAL_UINT32(2U * LIMIT_UNEVEN_WEIGHT, pace.uneven);
    TEST_ASSERT_FALSE(run(30U, EVEN_US));
    TEST_ASSERT_EQUAL_UINT32((2U * LIMIT_UNEVEN_WEIGHT) - 30U, pace.uneven);
    TEST_ASSERT_FALSE(run(LONG, EVEN_US));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
}

void test_SWR_AXIS_027_a_rare_hiccup_is_borne_for_ever(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, lose((2U * LIMIT_UNEVEN_WEIGHT) + 1U, 1000U));
}

void test_SWR_AXIS_027_at_the_limit_a_change_is_told(void)
{
    TEST_ASSERT_FALSE(run(3U, EVEN_US));
    pace.uneven = LIMIT_UNEVEN_MOST - LIMIT_UNEVEN_WEIGHT - 1U;
    TEST_ASSERT_FALSE(run(1U, 2U * EVEN_US));
    pace.uneven = LIMIT_UNEVEN_MOST - LIMIT_UNEVEN_WEIGHT;
    TEST_ASSERT_TRUE(run(1U, EVEN_US));
}

void test_SWR_AXIS_027_more_than_the_share_is_a_change_and_the_share_is_none(void)
{
    const uint32_t most_us = EVEN_US * LIMIT_PACE_CHANGE_PERCENT / 100U;
    TEST_ASSERT_FALSE(run(2U, EVEN_US));
    TEST_ASSERT_FALSE(run(1U, most_us));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
    TEST_ASSERT_FALSE(run(2U, EVEN_US));
    TEST_ASSERT_FALSE(run(1U, most_us + 1U));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNEVEN_WEIGHT, pace.uneven);
}

void test_SWR_AXIS_027_a_speed_that_changes_as_the_models_does_is_even(void)
{
    TEST_ASSERT_FALSE(count(1U, EVEN_US, SPEED_Q8));
    for (uint32_t i = 0U; i < 40U; i++) {
        const uint32_t speed_q8 = SPEED_Q8 + (i * 4000U);
        TEST_ASSERT_FALSE(count(1U, (uint32_t)(256000000U / speed_q8), speed_q8));
    }
    TEST_ASSERT_FALSE(count(20U, 20000U, SPEED_Q8));
    TEST_ASSERT_FALSE(count(2U, 2000U, SPEED_Q8));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
}

/* From the last count before it to the first one after it there is no way. */
void test_SWR_AXIS_027_a_rest_is_no_way_and_the_pace_before_it_stays(void)
{
    TEST_ASSERT_FALSE(run(1U, EVEN_US));
    edge_pace_rest(&pace);
    TEST_ASSERT_FALSE(run(1U, 3U * EVEN_US));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.ticks);
    TEST_ASSERT_FALSE(run(1U, EVEN_US));
    edge_pace_rest(&pace);
    TEST_ASSERT_FALSE(run(1U, 50U * EVEN_US));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
    TEST_ASSERT_FALSE(run(1U, 2U * EVEN_US));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNEVEN_WEIGHT, pace.uneven);
}

void test_SWR_AXIS_027_a_count_that_is_too_old_begins_anew(void)
{
    TEST_ASSERT_FALSE(run(3U, EVEN_US));
    TEST_ASSERT_FALSE(run(1U, LIMIT_SPEED_TIMEOUT_US));
    TEST_ASSERT_FALSE(run(1U, EVEN_US));
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
}

void test_SWR_AXIS_027_once_the_position_is_sure_nothing_is_uneven(void)
{
    TEST_ASSERT_FALSE(run(3U, EVEN_US));
    TEST_ASSERT_FALSE(run(1U, 2U * EVEN_US));
    edge_pace_settle(&pace);
    TEST_ASSERT_EQUAL_UINT32(0U, pace.uneven);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: every interval above the limit counts as an overrun; three more than the
 * punctual ones stop motion until a reset.
 */
#include "unity.h"

#include "charts/loop_guard_chart.h"
#include "limits/requirement_limits.h"
#include "safety/loop_guard.h"

#define PUNCTUAL_US LIMIT_OVERRUN_US
#define LATE_US (LIMIT_OVERRUN_US + 1U)
#define STAGE 2U

static loop_guard_t guard;

static void late(uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        loop_guard_step(&guard, LATE_US, STAGE);
    }
}

static bool is_stopped(void)
{
    return guard.chart.state == LOOP_GUARD_STATE_STOPPED;
}

void setUp(void)
{
    loop_guard_init(&guard);
}

void tearDown(void)
{
}

void test_SWR_LOOP_001_an_interval_at_the_limit_is_punctual(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, guard.sealed.overruns);
    loop_guard_step(&guard, PUNCTUAL_US, STAGE);
    TEST_ASSERT_EQUAL_UINT32(0U, guard.sealed.overruns);
    TEST_ASSERT_EQUAL_UINT32(LOOP_GUARD_STATE_ON_TIME, guard.chart.state);
}

void test_SWR_LOOP_001_an_interval_above_the_limit_is_counted(void)
{
    loop_guard_step(&guard, LATE_US, STAGE);
    TEST_ASSERT_EQUAL_UINT32(1U, guard.sealed.overruns);
    loop_guard_step(&guard, PUNCTUAL_US, STAGE);
    TEST_ASSERT_EQUAL_UINT32(1U, guard.sealed.overruns);
    loop_guard_step(&guard, UINT32_MAX, STAGE);
    TEST_ASSERT_EQUAL_UINT32(2U, guard.sealed.overruns);
}

void test_SWR_LOOP_001_overruns_are_counted_while_stopped(void)
{
    late(LIMIT_OVERRUNS_IN_A_ROW + 4U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OVERRUNS_IN_A_ROW + 4U, guard.sealed.overruns);
}

void test_SWR_LOOP_001_the_count_saturates(void)
{
    guard.sealed.overruns = UINT32_MAX - 1U;
    late(1U);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, guard.sealed.overruns);
    late(1U);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, guard.sealed.overruns);
}

void test_SWR_LOOP_002_one_overrun_less_than_the_limit_does_not_stop(void)
{
    late(LIMIT_OVERRUNS_IN_A_ROW - 1U);
    TEST_ASSERT_FALSE(is_stopped());
}

void test_SWR_LOOP_002_overruns_in_a_row_stop_in_the_last_of_them(void)
{
    late(LIMIT_OVERRUNS_IN_A_ROW);
    TEST_ASSERT_TRUE(is_stopped());
}

static void punctual(uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        loop_guard_step(&guard, PUNCTUAL_US, STAGE);
    }
}

void test_SWR_LOOP_004_each_punctual_cycle_makes_up_for_a_late_one(void)
{
    for (uint32_t i = 1U; i < LIMIT_OVERRUNS_IN_A_ROW; i++) {
        late(i);
        punctual(i);
        late(LIMIT_OVERRUNS_IN_A_ROW - 1U);
        TEST_ASSERT_FALSE(is_stopped());
        punctual(LIMIT_OVERRUNS_IN_A_ROW);
    }
}

void test_SWR_LOOP_004_two_late_cycles_of_three_stop_the_motion(void)
{
    late(2U);
    punctual(1U);
    late(1U);
    TEST_ASSERT_FALSE(is_stopped());
    late(1U);
    TEST_ASSERT_TRUE(is_stopped());
}

void test_SWR_LOOP_004_one_late_cycle_of_two_is_counted_only(void)
{
    for (uint32_t i = 0U; i < 1000U; i++) {
        late(1U);
        punctual(1U);
        TEST_ASSERT_FALSE(is_stopped());
    }
    TEST_ASSERT_EQUAL_UINT32(1000U, guard.sealed.overruns);
}

void test_SWR_LOOP_002_punctual_cycles_do_not_end_the_stop(void)
{
    late(LIMIT_OVERRUNS_IN_A_ROW);
    for (uint32_t i = 0U; i < 1000U; i++) {
        loop_guard_step(&guard, PUNCTUAL_US, STAGE);
        TEST_ASSERT_TRUE(is_stopped());
    }
}

void test_SWR_LOOP_002_a_reset_ends_the_stop_and_begins_the_row_anew(void)
{
    late(LIMIT_OVERRUNS_IN_A_ROW);
    loop_guard_reset(&guard);
    TEST_ASSERT_FALSE(is_stopped());
    late(LIMIT_OVERRUNS_IN_A_ROW - 1U);
    TEST_ASSERT_FALSE(is_stopped());
    late(1U);
    TEST_ASSERT_TRUE(is_stopped());
}

void test_SWR_LOOP_009_an_interval_in_which_cards_may_switch_off_stops_at_once(void)
{
    loop_guard_step(&guard, LIMIT_LOOP_SILENT_US, STAGE);
    TEST_ASSERT_FALSE(is_stopped());
    loop_guard_step(&guard, PUNCTUAL_US, STAGE);
    loop_guard_step(&guard, LIMIT_LOOP_SILENT_US + 1U, STAGE);
    TEST_ASSERT_TRUE(is_stopped());
    TEST_ASSERT_EQUAL_UINT32(2U, guard.sealed.overruns);
}

static void expect_lateness(uint32_t count, uint32_t span_us, uint32_t longest_us, uint32_t stage)
{
    TEST_ASSERT_EQUAL_UINT32(count, guard.sealed.lateness.count);
    TEST_ASSERT_EQUAL_UINT32(span_us, guard.sealed.lateness.span_us);
    TEST_ASSERT_EQUAL_UINT32(longest_us, guard.sealed.lateness.longest_us);
    TEST_ASSERT_EQUAL_UINT32(stage, guard.sealed.lateness.longest_stage);
}

void test_SWR_LOOP_011_what_was_late_is_kept_until_it_is_late_anew(void)
{
    expect_lateness(0U, 0U, 0U, 0U);
    loop_guard_step(&guard, 2000U, 1U);
    loop_guard_step(&guard, 5000U, 3U);
    loop_guard_step(&guard, 1000U, 1U);
    expect_lateness(2U, 8000U, 5000U, 3U);
    loop_guard_step(&guard, 1000U, 1U);
    loop_guard_step(&guard, 1000U, 1U);
    expect_lateness(2U, 9000U, 5000U, 3U);
    loop_guard_step(&guard, 3000U, 2U);
    expect_lateness(1U, 3000U, 3000U, 2U);
}

void test_SWR_LOOP_011_what_has_stopped_the_loop_stands(void)
{
    late(LIMIT_OVERRUNS_IN_A_ROW);
    loop_guard_step(&guard, UINT32_MAX, 0U);
    expect_lateness(LIMIT_OVERRUNS_IN_A_ROW, LIMIT_OVERRUNS_IN_A_ROW * LATE_US, LATE_US, STAGE);
    loop_guard_reset(&guard);
    loop_guard_step(&guard, PUNCTUAL_US, 0U);
    expect_lateness(LIMIT_OVERRUNS_IN_A_ROW, LIMIT_OVERRUNS_IN_A_ROW * LATE_US, LATE_US, STAGE);
}

void test_SWR_LOOP_011_its_span_saturates(void)
{
    loop_guard_step(&guard, LATE_US, STAGE);
    guard.sealed.lateness.span_us = UINT32_MAX - 1U;
    loop_guard_step(&guard, LATE_US, STAGE);
    expect_lateness(2U, UINT32_MAX, LATE_US, STAGE);
}

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

static loop_guard_t guard;

static void late(uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        loop_guard_step(&guard, LATE_US);
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
    TEST_ASSERT_EQUAL_UINT32(0U, guard.overruns);
    loop_guard_step(&guard, PUNCTUAL_US);
    TEST_ASSERT_EQUAL_UINT32(0U, guard.overruns);
    TEST_ASSERT_EQUAL_UINT32(LOOP_GUARD_STATE_ON_TIME, guard.chart.state);
}

void test_SWR_LOOP_001_an_interval_above_the_limit_is_counted(void)
{
    loop_guard_step(&guard, LATE_US);
    TEST_ASSERT_EQUAL_UINT32(1U, guard.overruns);
    loop_guard_step(&guard, PUNCTUAL_US);
    TEST_ASSERT_EQUAL_UINT32(1U, guard.overruns);
    loop_guard_step(&guard, UINT32_MAX);
    TEST_ASSERT_EQUAL_UINT32(2U, guard.overruns);
}

void test_SWR_LOOP_001_overruns_are_counted_while_stopped(void)
{
    late(LIMIT_OVERRUNS_IN_A_ROW + 4U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OVERRUNS_IN_A_ROW + 4U, guard.overruns);
}

void test_SWR_LOOP_001_the_count_saturates(void)
{
    guard.overruns = UINT32_MAX - 1U;
    late(1U);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, guard.overruns);
    late(1U);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, guard.overruns);
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
        loop_guard_step(&guard, PUNCTUAL_US);
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
    TEST_ASSERT_EQUAL_UINT32(1000U, guard.overruns);
}

void test_SWR_LOOP_002_punctual_cycles_do_not_end_the_stop(void)
{
    late(LIMIT_OVERRUNS_IN_A_ROW);
    for (uint32_t i = 0U; i < 1000U; i++) {
        loop_guard_step(&guard, PUNCTUAL_US);
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

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the cubic begins and ends exactly where and as fast as was requested, its speed
 * is how its position changes, and what is judged of its control points holds all along it.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "motion/cubic.h"

#include <stdlib.h>

#define WAYS 400U

static cubic_t way;

void setUp(void)
{
    srand(1U);
}

void tearDown(void)
{
}

static void go(int32_t from, int32_t from_speed, int32_t to, int32_t to_speed, uint32_t span_ms)
{
    const cubic_end_t begin = {.ticks = from, .speed_ticks_per_s = from_speed};
    const cubic_end_t end = {.ticks = to, .speed_ticks_per_s = to_speed};
    cubic_set(&way, &begin, &end, span_ms);
}

static int32_t at(uint32_t time_us)
{
    return cubic_position_ticks(&way, cubic_share_q20(time_us, way.span_ms));
}

static int32_t speed_at(uint32_t time_us)
{
    return cubic_speed_ticks_per_s_q8(&way, cubic_share_q20(time_us, way.span_ms));
}

static int32_t any(int32_t most)
{
    return (int32_t)(rand() % ((2 * most) + 1)) - most;
}

void test_SWR_TRAJ_009_both_ends_have_their_position_and_speed(void)
{
    for (uint32_t i = 0U; i < WAYS; i++) {
        const int32_t from = any(600000);
        const int32_t to = any(600000);
        const int32_t first = any(20000);
        const int32_t last = any(20000);
        const uint32_t span_ms = 10U + (uint32_t)(rand() % 59990);
        go(from, first, to, last, span_ms);
        TEST_ASSERT_EQUAL_INT32(from, at(0U));
        TEST_ASSERT_EQUAL_INT32(to, at(span_ms * 1000U));
        TEST_ASSERT_INT32_WITHIN(900, first * 256, speed_at(0U));
        TEST_ASSERT_INT32_WITHIN(900, last * 256, speed_at(span_ms * 1000U));
    }
}

void test_SWR_TRAJ_009_halfway_from_rest_to_rest_half_of_the_way_is_done_at_its_peak(void)
{
    go(1000, 0, 3000, 0, 2000U);
    TEST_ASSERT_EQUAL_INT32(2000, at(1000000U));
    TEST_ASSERT_EQUAL_INT32(1500 * 256, speed_at(1000000U));
    TEST_ASSERT_EQUAL_INT32(1313, at(500000U)); /* 1000 + 2000 (3/16 - 2/64) */
}

void test_SWR_TRAJ_009_the_speed_is_how_the_position_changes(void)
{
    go(-5000, 400, 7000, -300, 8000U);
    for (uint32_t time_us = 100000U; time_us < 7900000U; time_us += 100000U) {
        const int32_t change = at(time_us + 100000U) - at(time_us - 100000U);
        TEST_ASSERT_INT32_WITHIN(10 * 256, change * 5 * 256, speed_at(time_us));
    }
}

void test_SWR_TRAJ_003_from_rest_to_rest_the_peak_is_judged_exactly(void)
{
    go(0, 0, 2000, 0, 2000U);
    TEST_ASSERT_TRUE(cubic_keeps_speed(&way, 1500));
    TEST_ASSERT_FALSE(cubic_keeps_speed(&way, 1499));
    go(0, 0, -2000, 0, 2000U);
    TEST_ASSERT_TRUE(cubic_keeps_speed(&way, 1500));
    TEST_ASSERT_FALSE(cubic_keeps_speed(&way, 1499));
}

void test_SWR_TRAJ_003_a_peak_at_either_end_is_judged(void)
{
    go(0, 2000, 500, 0, 1000U);
    TEST_ASSERT_TRUE(cubic_keeps_speed(&way, 2000));
    TEST_ASSERT_FALSE(cubic_keeps_speed(&way, 1999));
    go(0, 0, 500, 2000, 1000U);
    TEST_ASSERT_FALSE(cubic_keeps_speed(&way, 1999));
}

void test_SWR_TRAJ_003_what_keeps_its_speed_is_nowhere_faster(void)
{
    for (uint32_t i = 0U; i < WAYS; i++) {
        const int32_t limit = 2000;
        go(any(3000), any(2000), any(3000), any(2000), 500U + (uint32_t)(rand() % 3000));
        const bool is_kept = cubic_keeps_speed(&way, limit);
        for (uint32_t k = 0U; is_kept && (k <= 64U); k++) {
            const int32_t speed = cubic_speed_ticks_per_s_q8(&way, k * (CUBIC_ONE_Q20 / 64U));
            TEST_ASSERT_INT32_WITHIN((limit * 256) + 2, 0, speed);
        }
    }
}

/* From rest to rest it is 6 S / T^2. */
void test_SWR_TRAJ_003_the_acceleration_is_judged_at_both_ends(void)
{
    go(0, 0, 2000, 0, 2000U);
    TEST_ASSERT_TRUE(cubic_keeps_acceleration(&way, 3000));
    TEST_ASSERT_FALSE(cubic_keeps_acceleration(&way, 2900));
    go(0, 0, 1000, 2000, 1000U); /* 2000 ticks/s^2 all the way, then 6000 at the end. */
    TEST_ASSERT_TRUE(cubic_keeps_acceleration(&way, 2000));
    go(0, 0, 500, 2000, 1000U);
    TEST_ASSERT_FALSE(cubic_keeps_acceleration(&way, 4900));
    TEST_ASSERT_TRUE(cubic_keeps_acceleration(&way, 5000));
}

void test_SWR_TRAJ_025_the_longest_way_at_the_most_acceleration_is_judged_right(void)
{
    const int32_t most = (int32_t)LIMIT_ACCELERATION_MOST_TICKS_PER_S2;
    go(-1000000, 0, 1000000, 0, LIMIT_TRAJECTORY_STEP_MOST_MS);
    TEST_ASSERT_TRUE(cubic_keeps_acceleration(&way, most));
    TEST_ASSERT_TRUE(cubic_keeps_acceleration(&way, 3334));
    TEST_ASSERT_FALSE(cubic_keeps_acceleration(&way, 3333));
    go(-1000000, most, 1000000, -most, LIMIT_TRAJECTORY_STEP_MOST_MS);
    TEST_ASSERT_TRUE(cubic_keeps_acceleration(&way, 337000));
    TEST_ASSERT_FALSE(cubic_keeps_acceleration(&way, 336000));
}

void test_SWR_TRAJ_003_rounding_to_a_tick_is_no_acceleration(void)
{
    go(0, 0, 1, 0, 10U);
    TEST_ASSERT_TRUE(cubic_keeps_acceleration(&way, 1000));
}

void test_SWR_TRAJ_004_the_curve_is_between_its_control_points(void)
{
    for (uint32_t i = 0U; i < WAYS; i++) {
        go(any(3000), any(2000), any(3000), any(2000), 500U + (uint32_t)(rand() % 3000));
        int32_t least = cubic_point_ticks(&way, 0U);
        int32_t most = least;
        for (uint32_t k = 1U; k < CUBIC_POINTS; k++) {
            const int32_t ticks = cubic_point_ticks(&way, k);
            least = (ticks < least) ? ticks : least;
            most = (ticks > most) ? ticks : most;
        }
        for (uint32_t k = 0U; k <= 64U; k++) {
            const int32_t ticks = cubic_position_ticks(&way, k * (CUBIC_ONE_Q20 / 64U));
            TEST_ASSERT_TRUE((ticks >= least) && (ticks <= most));
        }
    }
}

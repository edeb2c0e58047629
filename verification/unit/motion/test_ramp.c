/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a set-point is never faster than what it can ramp down from within its room.
 */
#include "unity.h"

#include "base/fixed.h"
#include "motion/ramp.h"

#define STEP INT64_C(100)
#define MOST INT64_C(1000)

static const ramp_steps_t even = {STEP, STEP};

void setUp(void)
{
}

void tearDown(void)
{
}

/* The way until it rests: all of its cycles from `speed` on, one step slower each. */
static int64_t walked(int64_t speed)
{
    int64_t way = 0;
    for (int64_t now = speed; now > 0; now = ramp_slower(now, STEP)) {
        way += now;
    }
    return way;
}

void test_SWR_VEL_003_the_way_of_a_ramp_down_is_the_sum_of_its_cycles(void)
{
    for (int64_t speed = 0; speed <= MOST; speed += 7) {
        TEST_ASSERT_EQUAL_INT64(walked(speed), ramp_way(speed, STEP));
    }
}

void test_SWR_VEL_003_a_speed_changes_by_a_step_at_most_and_stays_below_the_most(void)
{
    TEST_ASSERT_EQUAL_INT64(STEP, ramp_next(0, MOST, &even, INT64_MAX));
    TEST_ASSERT_EQUAL_INT64(MOST, ramp_next(MOST - 1, MOST, &even, INT64_MAX));
    TEST_ASSERT_EQUAL_INT64(MOST - STEP, ramp_next(MOST, 0, &even, INT64_MAX));
    TEST_ASSERT_EQUAL_INT64(0, ramp_next(STEP - 1, 0, &even, INT64_MAX));
}

/* It may slow down by more than it may gain. */
void test_SWR_COOP_002_a_speed_grows_by_the_one_step_and_falls_by_the_other(void)
{
    const ramp_steps_t uneven = {.up_q8 = STEP, .down_q8 = 5 * STEP};
    TEST_ASSERT_EQUAL_INT64(200 + STEP, ramp_next(200, MOST, &uneven, INT64_MAX));
    TEST_ASSERT_EQUAL_INT64(MOST - (5 * STEP), ramp_next(MOST, 0, &uneven, INT64_MAX));
    TEST_ASSERT_EQUAL_INT64(MOST, ramp_next(MOST, MOST, &uneven, ramp_way(MOST, 5 * STEP)));
    TEST_ASSERT_EQUAL_INT64(MOST - (5 * STEP),
                            ramp_next(MOST, MOST, &uneven, ramp_way(MOST, 5 * STEP) - 1));
}

/* Over many cycles nothing of the way is lost, in both directions. */
void test_SWR_VEL_004_parts_of_a_tick_add_up(void)
{
    for (int64_t way = -3 * RAMP_TICK; way <= (3 * RAMP_TICK); way += 12347) {
        int32_t ticks = 1000;
        int32_t rest = 0;
        for (int64_t i = 1; i <= 100; i++) {
            ticks = ramp_place(ticks, way, &rest);
            TEST_ASSERT_EQUAL_INT64(way * i, (((int64_t)ticks - 1000) * RAMP_TICK) + rest);
            TEST_ASSERT_LESS_OR_EQUAL_INT64(RAMP_TICK, 2 * fixed_magnitude(rest));
        }
    }
}

void test_SWR_VEL_003_of_the_three_next_speeds_it_takes_the_fastest_that_fits(void)
{
    const int64_t faster = walked(600);
    const int64_t same = walked(500);
    TEST_ASSERT_EQUAL_INT64(600, ramp_next(500, MOST, &even, faster));
    TEST_ASSERT_EQUAL_INT64(500, ramp_next(500, MOST, &even, faster - 1));
    TEST_ASSERT_EQUAL_INT64(500, ramp_next(500, MOST, &even, same));
    TEST_ASSERT_EQUAL_INT64(400, ramp_next(500, MOST, &even, same - 1));
    TEST_ASSERT_EQUAL_INT64(400, ramp_next(500, 400, &even, same));
}

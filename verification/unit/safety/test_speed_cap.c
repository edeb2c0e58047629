/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: over any time an axis moves no further than its cap allows, or it is too fast.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "safety/speed_cap.h"

#define CYCLE_US 1000U
#define TICKS_PER_S 16667 /* The needle's speed. */

static speed_cap_t cap;
static int32_t position_ticks;

void setUp(void)
{
    cap = (speed_cap_t){0};
    position_ticks = 0;
}

void tearDown(void)
{
}

/* Cycles too fast of `count` at a speed. */
static uint32_t fast_cycles(uint32_t percent, int32_t ticks_per_cycle, uint32_t count)
{
    uint32_t fast = 0U;
    for (uint32_t i = 0U; i < count; i++) {
        position_ticks += ticks_per_cycle;
        fast += speed_cap_step(&cap, &robot_neuro.axes[NEURO_AXIS_INSERTION], percent,
                               position_ticks, CYCLE_US)
                    ? 1U
                    : 0U;
    }
    return fast;
}

void test_SWR_PERMIT_005_an_axis_within_its_cap_is_never_too_fast(void)
{
    TEST_ASSERT_EQUAL_INT32(TICKS_PER_S, robot_neuro.axes[NEURO_AXIS_INSERTION].speed_ticks_per_s);
    TEST_ASSERT_EQUAL_UINT32(0U, fast_cycles(100U, 18, 2000U));
    TEST_ASSERT_EQUAL_UINT32(0U, fast_cycles(100U, -18, 2000U));
    TEST_ASSERT_EQUAL_UINT32(0U, fast_cycles(25U, 5, 2000U));
}

void test_SWR_PERMIT_005_an_axis_beyond_its_cap_is_too_fast_in_both_directions(void)
{
    TEST_ASSERT_EQUAL_UINT32(100U, fast_cycles(100U, 19, 100U));
    TEST_ASSERT_EQUAL_UINT32(100U, fast_cycles(100U, -19, 100U));
    TEST_ASSERT_EQUAL_UINT32(100U, fast_cycles(25U, 6, 100U));
}

void test_SWR_PERMIT_005_what_is_not_used_is_kept_for_a_short_while_only(void)
{
    (void)fast_cycles(25U, 0, 5000U);
    const int32_t kept_ticks =
        (int32_t)((16667ULL * 35ULL * LIMIT_SPEED_CAP_US) / (100ULL * 1000000ULL));
    position_ticks += kept_ticks;
    TEST_ASSERT_EQUAL_UINT32(0U, fast_cycles(25U, 0, 1U));
    setUp();
    (void)fast_cycles(25U, 0, 5000U);
    position_ticks += kept_ticks + 7;
    TEST_ASSERT_EQUAL_UINT32(1U, fast_cycles(25U, 0, 1U));
    TEST_ASSERT_EQUAL_UINT32(0U, fast_cycles(25U, 0, 1U));
}

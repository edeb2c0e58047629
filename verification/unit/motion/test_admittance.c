/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the speed of the needle is gain times the force beyond the dead zone, within its
 * bounds; and the loop that a hand closes through it does not swing.
 */
#include "unity.h"

#include "motion/admittance.h"
#include "robot/robot_prostate.h"

#include <math.h>
#include <stdint.h>

#define TICKS_PER_MM 1666.67
#define MN_PER_N 1000.0

void setUp(void)
{
}

void tearDown(void)
{
}

/* The law in mm/s and N. */
static double reference_mm_per_s(double force_n)
{
    const hand_law_t *const law = &robot_prostate.hand;
    const double beyond_n = force_n - ((double)law->dead_zone_mn / MN_PER_N);
    const double gain_mm_per_s_n = (double)law->gain_q8 / 256.0 * MN_PER_N / TICKS_PER_MM;
    const double most_mm_per_s = (double)law->speed_ticks_per_s / TICKS_PER_MM;
    return fmax(0.0, fmin(most_mm_per_s, gain_mm_per_s_n * beyond_n));
}

void test_SWR_COOP_001_the_speed_is_that_of_the_law_for_every_force(void)
{
    for (int32_t force_mn = -20000; force_mn <= 20000; force_mn++) {
        const double speed = (double)admittance_speed_q8(&robot_prostate.hand, force_mn) / 256.0;
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, reference_mm_per_s((double)force_mn / MN_PER_N),
                                  speed / TICKS_PER_MM);
    }
}

void test_SWR_COOP_001_any_force_at_all_keeps_within_the_bounds(void)
{
    const hand_law_t *const law = &robot_prostate.hand;
    TEST_ASSERT_EQUAL_INT64(0, admittance_speed_q8(law, INT32_MIN));
    TEST_ASSERT_EQUAL_INT64((int64_t)law->speed_ticks_per_s * 256,
                            admittance_speed_q8(law, INT32_MAX));
    TEST_ASSERT_EQUAL_INT64(0, admittance_speed_q8(law, (int32_t)law->dead_zone_mn));
    TEST_ASSERT_EQUAL_INT64((int64_t)law->gain_q8,
                            admittance_speed_q8(law, (int32_t)law->dead_zone_mn + 1));
}

/* As the robot's file has it. */
void test_SWR_COOP_001_a_hand_of_one_newton_moves_the_needle_of_the_file(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(0.01, 3.5, reference_mm_per_s(1.0));
    TEST_ASSERT_DOUBLE_WITHIN(0.01, 5.0, reference_mm_per_s(1.3));
    TEST_ASSERT_DOUBLE_WITHIN(0.01, 0.0, reference_mm_per_s(0.3));
}

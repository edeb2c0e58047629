/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the rotation of a needle that is steered has the speed of the law
 * 1 - alpha exp(-d^2 / (2 c^2)) at every angle, whichever turn the axis counts.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "motion/curv.h"
#include "robot/robot_prostate.h"

#include <math.h>
#include <stdint.h>

#define ONE 65536.0
#define TURN_BAM 4294967296.0
#define TURN_RAD 6.283185307179586
#define WIDTH_RAD (TURN_RAD / 6.0)
#define WITHIN 20.0
#define STEP_BAM 3000017 /* Some 1400 angles of a turn. */

/* A tick is a bam, and its speed in 8 fraction bits 97 shares. */
static const axis_config_t plain = {.unit_per_tick_q16 = 65536, .speed_ticks_per_s = 25600};
static const axis_config_t *const rotation = &robot_prostate.axes[PROSTATE_AXIS_ROTATION];

void setUp(void)
{
}

void tearDown(void)
{
}

static int64_t share_of(uint32_t alpha_q16, int32_t away)
{
    const steering_t steering = {.method = (uint32_t)STEERING_BIDIRECTIONAL,
                                 .alpha_q16 = alpha_q16};
    return curv_speed_q8(&plain, &steering, away) / (int64_t)LIMIT_STEERING_SPEED_PERCENT;
}

/* `away` from the direction, radians. */
static double law(double alpha, double away)
{
    const double near = remainder(away, TURN_RAD);
    return 1.0 - (alpha * exp(-(near * near) / (2.0 * WIDTH_RAD * WIDTH_RAD)));
}

void test_SWR_STEER_001_the_speed_is_that_of_the_law_at_every_angle(void)
{
    for (uint32_t alpha_q16 = 0U; alpha_q16 <= 65536U; alpha_q16 += 4096U) {
        for (int64_t away = INT32_MIN; away <= INT32_MAX; away += STEP_BAM) {
            const double expected =
                law((double)alpha_q16 / ONE, ((double)away / TURN_BAM) * TURN_RAD) * ONE;
            const double share = (double)share_of(alpha_q16, (int32_t)away);
            TEST_ASSERT_TRUE(fabs(share - expected) <= WITHIN);
        }
    }
}

/* No error of the caller makes it turn the other way. */
void test_SWR_STEER_001_a_strength_beyond_one_is_taken_for_one(void)
{
    TEST_ASSERT_EQUAL_INT64(0, share_of(65536U, 0));
    TEST_ASSERT_EQUAL_INT64(0, share_of(UINT32_MAX, 0));
}

/* At 10 degrees with a direction of 350 the angle is 20, and not 340. */
void test_SWR_STEER_001_it_wraps_on_both_sides_and_over_turns(void)
{
    static const struct {
        double at_deg;
        double direction_deg;
    } rows[] = {{10.0, 350.0}, {350.0, 10.0}, {-170.0, 170.0}, {730.0, 350.0}, {-1440.0, 0.0}};
    for (uint32_t i = 0U; i < (sizeof rows / sizeof rows[0]); i++) {
        const double at_rad = rows[i].at_deg * TURN_RAD / 360.0;
        const double direction_rad = rows[i].direction_deg * TURN_RAD / 360.0;
        const steering_t steering = {.method = (uint32_t)STEERING_BIDIRECTIONAL,
                                     .direction_bam = (int32_t)(uint32_t)(int64_t)lround(
                                         rows[i].direction_deg / 360.0 * TURN_BAM),
                                     .alpha_q16 = 52429U};
        const int32_t ticks = (int32_t)lround(at_rad * 265.27);
        const double true_rad = (double)ticks / 265.27;
        const double expected = law(0.8, true_rad - direction_rad) * 1285.0 * 0.97;
        TEST_ASSERT_TRUE(
            fabs(((double)curv_speed_q8(rotation, &steering, ticks) / 256.0) - expected) < 1.0);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a needle that is steered may go deeper only while its rotation is where its
 * law has it, and its set-point as fast.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/count_balance.h"
#include "axis/drift_audit.h"
#include "axis/edge_spacing.h"
#include "limits/requirement_limits.h"
#include "motion/curv.h"
#include "robot/joints.h"
#include "robot/robot_prostate.h"
#include "safety/steering_guard.h"

#define ROTATION PROSTATE_AXIS_ROTATION
#define NEAR_TICKS 23 /* 4.97 degrees; LIMIT_STEERING_LAG_BAM are 5. */

static const axis_config_t *const config = &robot_prostate.axes[ROTATION];
static axis_t axes[ROBOT_AXIS_MAX];
static steering_t steering;

void setUp(void)
{
    for (uint32_t i = 0U; i < robot_prostate.axis_count; i++) {
        axis_init(&axes[i]);
    }
    (void)steering_set(&steering, &robot_prostate.steering, (uint32_t)STEERING_BIDIRECTIONAL, 1000U,
                       90);
}

void tearDown(void)
{
}

static bool follows(int32_t position_ticks, int32_t lag_ticks, int64_t speed_q8)
{
    axes[ROTATION].sealed.encoder.position_ticks = position_ticks;
    axes[ROTATION].sealed.setpoint_ticks = position_ticks + lag_ticks;
    axes[ROTATION].sealed.setpoint_speed_ticks_per_s_q8 = (int32_t)speed_q8;
    return steering_guard_follows(&steering, &robot_prostate, axes);
}

void test_SWR_STEER_006_a_rotation_as_its_law_has_it_follows(void)
{
    for (int32_t ticks = config->minimum_ticks; ticks < config->maximum_ticks; ticks += 11) {
        const int64_t law_q8 = curv_speed_q8(config, &steering, ticks);
        TEST_ASSERT_TRUE(follows(ticks, 0, law_q8));
        TEST_ASSERT_TRUE(follows(ticks, NEAR_TICKS, -law_q8));
        TEST_ASSERT_TRUE(follows(ticks, -NEAR_TICKS, law_q8));
    }
}

void test_SWR_STEER_006_one_that_stands_lags_or_is_slow_does_not(void)
{
    for (int32_t ticks = config->minimum_ticks; ticks < config->maximum_ticks; ticks += 11) {
        const int64_t law_q8 = curv_speed_q8(config, &steering, ticks);
        const int64_t least_q8 = ((law_q8 * (int64_t)LIMIT_STEERING_PACE_PERCENT) + 99) / 100;
        TEST_ASSERT_FALSE(follows(ticks, 0, 0));
        TEST_ASSERT_FALSE(follows(ticks, NEAR_TICKS + 1, law_q8));
        TEST_ASSERT_FALSE(follows(ticks, -NEAR_TICKS - 1, -law_q8));
        TEST_ASSERT_TRUE(follows(ticks, 0, least_q8));
        TEST_ASSERT_TRUE(follows(ticks, 0, -least_q8));
        TEST_ASSERT_FALSE(follows(ticks, 0, least_q8 - 1));
        TEST_ASSERT_FALSE(follows(ticks, 0, 1 - least_q8));
    }
}

void test_SWR_STEER_006_a_needle_that_is_not_steered_waits_for_nothing(void)
{
    steering = (steering_t){.method = (uint32_t)STEERING_NONE};
    TEST_ASSERT_TRUE(follows(0, 100000, 0));
}

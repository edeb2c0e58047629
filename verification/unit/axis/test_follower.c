/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: who follows an axis that homes keeps the distance from it that they had when
 * that began, and is stuck where it is too far from there or its own limits hold it.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/follower.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

static const card_drive_t off = {CARD_DRIVE_OFF, 0U, 0U, 0U};

static robot_t robot;
static axis_t axes[ROBOT_AXIS_MAX];

/* The feet follow the head in its third stage; pitch follows yaw in its fourth. */
void setUp(void)
{
    robot = robot_neuro;
    robot.axes[NEURO_AXIS_HEAD].home_stage = 3U;
    robot.axes[NEURO_AXIS_YAW].home_stage = 4U;
    robot.axes[NEURO_AXIS_FEET].leaders[2] = 1U + NEURO_AXIS_HEAD;
    robot.axes[NEURO_AXIS_PITCH].leaders[3] = 1U + NEURO_AXIS_YAW;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        axis_init(&axes[i]);
    }
}

void tearDown(void)
{
}

static void put(uint32_t axis, int32_t ticks)
{
    axes[axis].sealed.encoder.position_ticks = ticks;
}

/* The head homes from 100 on, the feet stand at 3000. */
static void tie(void)
{
    put(NEURO_AXIS_HEAD, 100);
    put(NEURO_AXIS_FEET, 3000);
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_APPROACH;
    axes[NEURO_AXIS_HEAD].sealed.homing.start_ticks = 100;
    follower_tie(&robot, axes, NEURO_AXIS_HEAD);
}

static bool is_stuck(uint32_t axis, uint32_t leader, const card_drive_t *request)
{
    return follower_is_stuck(&axes[axis], &robot.axes[axis], &axes[leader], 1U, request);
}

void test_SWR_AXIS_028_an_axis_follows_in_the_stage_in_which_its_leader_homes(void)
{
    TEST_ASSERT_TRUE(follower_is_of(&robot, NEURO_AXIS_FEET, NEURO_AXIS_HEAD));
    TEST_ASSERT_FALSE(follower_is_of(&robot, NEURO_AXIS_HEAD, NEURO_AXIS_FEET));
    TEST_ASSERT_FALSE(follower_is_of(&robot, NEURO_AXIS_HEAD, NEURO_AXIS_HEAD));
    TEST_ASSERT_FALSE(follower_is_of(&robot, NEURO_AXIS_PITCH, NEURO_AXIS_HEAD));
    TEST_ASSERT_TRUE(follower_is_of(&robot, NEURO_AXIS_PITCH, NEURO_AXIS_YAW));
    robot.axes[NEURO_AXIS_HEAD].home_stage = 2U;
    TEST_ASSERT_FALSE(follower_is_of(&robot, NEURO_AXIS_FEET, NEURO_AXIS_HEAD));
}

void test_SWR_AXIS_036_who_follows_or_leads_is_of_a_block(void)
{
    TEST_ASSERT_TRUE(follower_is_in_block(&robot, NEURO_AXIS_FEET));
    TEST_ASSERT_TRUE(follower_is_in_block(&robot, NEURO_AXIS_HEAD));
    TEST_ASSERT_TRUE(follower_is_in_block(&robot, NEURO_AXIS_YAW));
    TEST_ASSERT_FALSE(follower_is_in_block(&robot, NEURO_AXIS_LATERAL));
}

void test_SWR_AXIS_030_it_travels_with_its_leader_while_that_homes_only(void)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(i, follower_leader(&robot, axes, i));
    }
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_BACK_OFF;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        const uint32_t expected = (i == NEURO_AXIS_FEET) ? NEURO_AXIS_HEAD : i;
        TEST_ASSERT_EQUAL_UINT32(expected, follower_leader(&robot, axes, i));
    }
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_VERIFIED;
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_FEET, follower_leader(&robot, axes, NEURO_AXIS_FEET));
}

void test_SWR_AXIS_031_only_those_that_follow_are_tied_where_they_stand(void)
{
    put(NEURO_AXIS_PITCH, 77);
    tie();
    TEST_ASSERT_EQUAL_INT32(3000, axes[NEURO_AXIS_FEET].sealed.homing.start_ticks);
    TEST_ASSERT_EQUAL_INT32(0, axes[NEURO_AXIS_PITCH].sealed.homing.start_ticks);
    TEST_ASSERT_EQUAL_INT32(100, axes[NEURO_AXIS_HEAD].sealed.homing.start_ticks);
}

void test_SWR_AXIS_028_the_set_point_keeps_the_distance_and_has_the_leaders_speed(void)
{
    tie();
    axes[NEURO_AXIS_HEAD].sealed.setpoint_ticks = 60;
    axes[NEURO_AXIS_HEAD].sealed.setpoint_speed_ticks_per_s_q8 = -196 * 256;
    put(NEURO_AXIS_FEET, 2990);
    const card_drive_t request = follower_step(&axes[NEURO_AXIS_FEET], &robot.axes[NEURO_AXIS_FEET],
                                               &axes[NEURO_AXIS_HEAD], 1U, LIMIT_CYCLE_US);
    TEST_ASSERT_EQUAL_INT32(2960, axes[NEURO_AXIS_FEET].sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(-196 * 256, axes[NEURO_AXIS_FEET].sealed.setpoint_speed_ticks_per_s_q8);
    TEST_ASSERT_NOT_EQUAL(CARD_DRIVE_OFF, request.mode);
    TEST_ASSERT_FALSE(motor_model_is_upwards(&robot.axes[NEURO_AXIS_FEET], &request));
}

void test_SWR_AXIS_029_apart_is_what_it_is_above_its_place(void)
{
    tie();
    put(NEURO_AXIS_HEAD, 60);
    put(NEURO_AXIS_FEET, 2970);
    TEST_ASSERT_EQUAL_INT32(
        10, follower_apart_ticks(&axes[NEURO_AXIS_FEET], &axes[NEURO_AXIS_HEAD], 1U));
    put(NEURO_AXIS_FEET, 2950);
    TEST_ASSERT_EQUAL_INT32(
        -10, follower_apart_ticks(&axes[NEURO_AXIS_FEET], &axes[NEURO_AXIS_HEAD], 1U));
}

void test_SWR_AXIS_051_one_that_goes_at_the_double_is_where_twice_the_way_has_it(void)
{
    tie();
    axes[NEURO_AXIS_HEAD].sealed.setpoint_ticks = 60;
    axes[NEURO_AXIS_HEAD].sealed.setpoint_speed_ticks_per_s_q8 = -98 * 256;
    put(NEURO_AXIS_HEAD, 60);
    put(NEURO_AXIS_FEET, 2925);
    (void)follower_step(&axes[NEURO_AXIS_FEET], &robot.axes[NEURO_AXIS_FEET],
                        &axes[NEURO_AXIS_HEAD], 2U, LIMIT_CYCLE_US);
    TEST_ASSERT_EQUAL_INT32(2920, axes[NEURO_AXIS_FEET].sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(-196 * 256, axes[NEURO_AXIS_FEET].sealed.setpoint_speed_ticks_per_s_q8);
    TEST_ASSERT_EQUAL_INT32(
        5, follower_apart_ticks(&axes[NEURO_AXIS_FEET], &axes[NEURO_AXIS_HEAD], 2U));
}

/* 0.15 mm are 11.8 ticks. */
void test_SWR_AXIS_029_a_follower_is_stuck_beyond_its_way_on_both_sides(void)
{
    TEST_ASSERT_EQUAL_UINT32(150000U, LIMIT_FOLLOWER_WAY_NM);
    tie();
    put(NEURO_AXIS_FEET, 3011);
    TEST_ASSERT_FALSE(is_stuck(NEURO_AXIS_FEET, NEURO_AXIS_HEAD, &off));
    put(NEURO_AXIS_FEET, 3012);
    TEST_ASSERT_TRUE(is_stuck(NEURO_AXIS_FEET, NEURO_AXIS_HEAD, &off));
    put(NEURO_AXIS_FEET, 2989);
    TEST_ASSERT_FALSE(is_stuck(NEURO_AXIS_FEET, NEURO_AXIS_HEAD, &off));
    put(NEURO_AXIS_FEET, 2988);
    TEST_ASSERT_TRUE(is_stuck(NEURO_AXIS_FEET, NEURO_AXIS_HEAD, &off));
}

/* 0.75 degrees are 10.4 ticks. */
void test_SWR_AXIS_029_a_turning_follower_has_a_way_of_its_own(void)
{
    put(NEURO_AXIS_PITCH, 10);
    TEST_ASSERT_FALSE(is_stuck(NEURO_AXIS_PITCH, NEURO_AXIS_YAW, &off));
    put(NEURO_AXIS_PITCH, 11);
    TEST_ASSERT_TRUE(is_stuck(NEURO_AXIS_PITCH, NEURO_AXIS_YAW, &off));
}

void test_SWR_AXIS_029_a_follower_is_stuck_at_its_switch_and_at_its_soft_limit(void)
{
    card_drive_t request = {CARD_DRIVE_NON_PWM, 1U, 0U, 0U};
    axes[NEURO_AXIS_PITCH].sealed.limit_switches = CARD_LIMIT_UPPER;
    TEST_ASSERT_TRUE(is_stuck(NEURO_AXIS_PITCH, NEURO_AXIS_YAW, &request));
    request.direction = 0U;
    TEST_ASSERT_FALSE(is_stuck(NEURO_AXIS_PITCH, NEURO_AXIS_YAW, &request));
    robot.axes[NEURO_AXIS_PITCH].minimum_ticks = 0;
    TEST_ASSERT_FALSE(is_stuck(NEURO_AXIS_PITCH, NEURO_AXIS_YAW, &request));
    axes[NEURO_AXIS_PITCH].chart.reference = AXIS_REFERENCE_TAKEN;
    TEST_ASSERT_TRUE(is_stuck(NEURO_AXIS_PITCH, NEURO_AXIS_YAW, &request));
}

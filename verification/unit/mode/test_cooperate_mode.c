/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the needle goes in as fast as the hand pushes and no farther than its depth; it
 * stands when the hand lets go, and ends on a doubt.
 */
#include "unity.h"

#include "axis/axis.h"
#include "limits/requirement_limits.h"
#include "mode/cooperate/cooperate_mode.h"
#include "mode/leg/mode_frame.h"
#include "mode/leg/steer.h"
#include "mode/move/move_mode.h"
#include "motion/admittance.h"
#include "robot/robot_prostate.h"
#include "unit/support/mode_world.h"

#define NEEDLE NEURO_AXIS_INSERTION
#define DEEP_TICKS 20000
#define LONG_CYCLES 20000U
#define HARD_MN 1000000

static const move_mode_t move = {.target_ticks = {-400, 150, -200, DEEP_TICKS, 500, 30, -60}};
/* That of the ProstateRobot. */
static const hand_law_t law = {300U, 2133U, 8333U, 333334U};

/* 70 um of it, at 4 Hz. */
static const vibration_law_t vibration = {116U, 110U, 15U, 3U};

static cooperate_mode_t mode;
static steer_t steer;

void setUp(void)
{
    world_start();
    robot.hand = law;
    mode = (cooperate_mode_t){0};
    steer = (steer_t){0};
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, move.target_ticks[i]);
    }
    world_put(NEEDLE, 1000);
    frame.hand = (hand_t){.force_mn = 0, .is_trusted = true};
}

void tearDown(void)
{
}

static int32_t speed_q8(void)
{
    return axes[NEEDLE].sealed.setpoint_speed_ticks_per_s_q8;
}

/* Where the axes are is looked at only by a step that runs. */
static void step(int32_t force_mn)
{
    frame.hand.force_mn = force_mn;
    mode_clear(&result);
    cooperate_mode_step(&mode, &move, &steer, &frame, &result);
    world_follow();
}

/* Until it has ended, `most` cycles. */
static void steps(int32_t force_mn, uint32_t most)
{
    for (uint32_t i = 0U; (i < most) && (result.progress == MODE_RUNNING); i++) {
        step(force_mn);
    }
}

static bool all_rest(void)
{
    bool is_rest = true;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        is_rest = is_rest && world_rests(i);
    }
    return is_rest;
}

static void expect_given_up(status_t status)
{
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(status, result.status);
    TEST_ASSERT_EQUAL_UINT32(MODE_NO_AXIS, result.axis);
    TEST_ASSERT_TRUE(all_rest());
}

void test_SWR_COOP_001_the_needle_is_as_fast_as_the_hand_pushes(void)
{
    for (int32_t force_mn = 400; force_mn <= 3000; force_mn += 400) {
        setUp();
        steps(force_mn, 500U);
        TEST_ASSERT_EQUAL_INT64(admittance_speed_q8(&law, force_mn), speed_q8());
    }
}

void test_SWR_COOP_001_the_axis_and_the_permit_may_be_slower_than_the_hand(void)
{
    robot.axes[NEEDLE].speed_ticks_per_s = 2000;
    frame.speed_cap_percent[NEEDLE] = 25U;
    steps(HARD_MN, 1000U);
    TEST_ASSERT_EQUAL_INT32(500 * 256, speed_q8());
}

void test_SWR_COOP_002_the_speed_grows_by_the_acceleration_and_falls_by_the_stop_slope(void)
{
    const int32_t up = (robot.axes[NEEDLE].acceleration_ticks_per_s2 * 256) / 1000;
    const int32_t down = ((int32_t)law.stop_ticks_per_s2 * 256) / 1000;
    uint64_t random = 1U;
    int32_t before = 0;
    for (uint32_t i = 0U; i < 4000U; i++) {
        random = (random * 6364136223846793005U) + 1442695040888963407U;
        step((int32_t)((random >> 33U) % 3000U) - 500);
        TEST_ASSERT_LESS_OR_EQUAL_INT32(up, speed_q8() - before);
        TEST_ASSERT_LESS_OR_EQUAL_INT32(down, before - speed_q8());
        before = speed_q8();
    }
}

/* Hard, jerking and all at once, from every start. */
void test_SWR_COOP_003_no_force_takes_the_set_point_past_the_depth(void)
{
    for (int32_t start = 0; start < DEEP_TICKS; start += 997) {
        setUp();
        world_put(NEEDLE, start);
        for (uint32_t i = 0U; (i < LONG_CYCLES) && (result.progress == MODE_RUNNING); i++) {
            step(((i % 97U) < 60U) ? HARD_MN : 0);
            TEST_ASSERT_LESS_OR_EQUAL_INT32(DEEP_TICKS, axes[NEEDLE].sealed.setpoint_ticks);
        }
        TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
        TEST_ASSERT_INT32_WITHIN(robot.axes[NEEDLE].deadband_ticks, DEEP_TICKS,
                                 axes[NEEDLE].sealed.encoder.position_ticks);
        TEST_ASSERT_TRUE(all_rest());
    }
}

void test_SWR_COOP_003_beyond_the_depth_nothing_is_asked_for(void)
{
    world_put(NEEDLE, DEEP_TICKS + 500);
    step(HARD_MN);
    TEST_ASSERT_TRUE(all_rest());
}

void test_SWR_COOP_004_neither_a_pull_draws_the_needle_out_nor_any_push_moves_another_axis(void)
{
    for (uint32_t i = 0U; i < 3000U; i++) {
        const int32_t before = axes[NEEDLE].sealed.encoder.position_ticks;
        step(((i % 200U) < 100U) ? 2000 : -HARD_MN);
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(0, speed_q8());
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(before, axes[NEEDLE].sealed.encoder.position_ticks);
        for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
            TEST_ASSERT_TRUE((axis == (uint32_t)NEEDLE) || world_rests(axis));
        }
    }
}

/* From the highest speed, and however far the motor is behind its set-point. */
void test_SWR_COOP_005_it_stands_soon_after_the_hand_has_let_go(void)
{
    steps(HARD_MN, 400U);
    TEST_ASSERT_EQUAL_INT32((int32_t)law.speed_ticks_per_s * 256, speed_q8());
    uint32_t cycles = 0U;
    while (!world_rests(NEEDLE)) {
        step((int32_t)law.dead_zone_mn);
        cycles++;
        world_put(NEEDLE, axes[NEEDLE].sealed.setpoint_ticks - ((speed_q8() != 0) ? 30 : 0));
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(LIMIT_HAND_OFF_US / LIMIT_CYCLE_US, cycles);
    }
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    step(2000);
    TEST_ASSERT_FALSE(world_rests(NEEDLE));
}

void test_SWR_COOP_007_a_base_that_leaves_the_line_ends_it(void)
{
    for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
        if (axis != (uint32_t)NEEDLE) {
            setUp();
            steps(2000, 400U);
            world_put(axis, move.target_ticks[axis] + robot.axes[axis].deadband_ticks + 3);
            step(2000);
            expect_given_up(STATUS_NOT_ALIGNED);
        }
    }
}

void test_SWR_COOP_007_a_needle_that_goes_on_while_its_drive_ends_is_at_its_depth(void)
{
    const int32_t beyond = robot.axes[NEEDLE].deadband_ticks * (int32_t)LIMIT_HAND_BEYOND_DEADBANDS;
    world_put(NEEDLE, DEEP_TICKS + beyond);
    step(2000);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_TRUE(all_rest());
    world_put(NEEDLE, DEEP_TICKS + beyond + 1);
    step(2000);
    expect_given_up(STATUS_TOO_DEEP);
}

void test_SWR_COOP_009_it_is_armed_on_the_line_and_short_of_the_depth_of_a_robot_with_a_hand(void)
{
    const int32_t beyond = robot.axes[NEEDLE].deadband_ticks * (int32_t)LIMIT_HAND_BEYOND_DEADBANDS;
    TEST_ASSERT_EQUAL(STATUS_OK, cooperate_mode_judge(&move, &robot, axes).status);
    world_put(NEEDLE, DEEP_TICKS + beyond);
    TEST_ASSERT_EQUAL(STATUS_OK, cooperate_mode_judge(&move, &robot, axes).status);
    world_put(NEEDLE, DEEP_TICKS + beyond + 1);
    TEST_ASSERT_EQUAL(STATUS_TOO_DEEP, cooperate_mode_judge(&move, &robot, axes).status);
    world_put(NEURO_AXIS_YAW, move.target_ticks[NEURO_AXIS_YAW] + 30);
    TEST_ASSERT_EQUAL(STATUS_NOT_ALIGNED, cooperate_mode_judge(&move, &robot, axes).status);
    robot.hand = (hand_law_t){0};
    TEST_ASSERT_EQUAL(STATUS_NO_HAND, cooperate_mode_judge(&move, &robot, axes).status);
}

/* The needle of a robot that answers a puncture, pushed to a speed, has just met one. */
static void puncture(int32_t force_mn)
{
    robot.vibration = vibration;
    steps(force_mn, 300U);
    frame.is_puncture = true;
    step(force_mn);
    frame.is_puncture = false;
}

/* Until it stands. */
static void brake(int32_t force_mn)
{
    for (uint32_t i = 0U; (i < 100U) && (speed_q8() != 0); i++) {
        step(force_mn);
    }
    TEST_ASSERT_EQUAL_INT32(0, speed_q8());
    TEST_ASSERT_TRUE(cooperate_mode_is_vibrating(&mode));
}

void test_SWR_VIB_700_a_puncture_stops_the_needle_by_the_stop_slope(void)
{
    const int32_t down = ((int32_t)law.stop_ticks_per_s2 * 256) / 1000;
    puncture(1000);
    int32_t before = speed_q8();
    while (speed_q8() != 0) {
        step(HARD_MN);
        TEST_ASSERT_TRUE((speed_q8() == 0) || (speed_q8() == (before - down)));
        before = speed_q8();
    }
}

void test_SWR_VIB_700_it_vibrates_once(void)
{
    puncture(1000);
    brake(1000);
    const int32_t there = axes[NEEDLE].sealed.encoder.position_ticks;
    int32_t farthest = 0;
    uint32_t turns = 0U;
    bool was_back = false;
    uint32_t cycles = 0U;
    while (!cooperate_mode_wants_hand_off(&mode)) {
        step(1000);
        const int32_t behind = there - axes[NEEDLE].sealed.setpoint_ticks;
        farthest = (behind > farthest) ? behind : farthest;
        turns += ((speed_q8() < 0) && !was_back) ? 1U : 0U;
        was_back = (speed_q8() < 0) || (was_back && (speed_q8() == 0));
        cycles++;
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
    }
    TEST_ASSERT_EQUAL_INT32(vibration.amplitude_ticks, farthest);
    TEST_ASSERT_EQUAL_UINT32(vibration.periods, turns);
}

void test_SWR_VIB_703_a_hand_that_pushes_on_is_followed_only_after_it_has_let_go(void)
{
    puncture(1000);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && !cooperate_mode_wants_hand_off(&mode); i++) {
        step(1000);
    }
    for (uint32_t i = 0U; i < 1000U; i++) {
        step(1000);
        TEST_ASSERT_TRUE(cooperate_mode_wants_hand_off(&mode));
        TEST_ASSERT_TRUE(world_rests(NEEDLE));
    }
    step(0);
    TEST_ASSERT_FALSE(cooperate_mode_is_vibrating(&mode));
    steps(1000, 300U);
    TEST_ASSERT_EQUAL_INT64(admittance_speed_q8(&law, 1000), speed_q8());
}

void test_SWR_VIB_700_a_puncture_while_it_brakes_or_vibrates_begins_nothing_anew(void)
{
    static const uint32_t ends[] = {0U, 1U};
    uint32_t cycles[2] = {0U, 0U};
    for (uint32_t i = 0U; i < 2U; i++) {
        setUp();
        puncture(1000);
        frame.is_puncture = ends[i] != 0U;
        brake(1000);
        while (cooperate_mode_is_vibrating(&mode) && (cycles[i] < LONG_CYCLES)) {
            step(1000);
            cycles[i]++;
        }
        frame.is_puncture = false;
    }
    TEST_ASSERT_EQUAL_UINT32(cycles[0], cycles[1]);
}

void test_SWR_VIB_700_a_robot_without_a_vibration_goes_on(void)
{
    puncture(1000);
    setUp();
    steps(1000, 300U);
    frame.is_puncture = true;
    step(1000);
    TEST_ASSERT_EQUAL_INT64(admittance_speed_q8(&law, 1000), speed_q8());
    TEST_ASSERT_FALSE(cooperate_mode_is_vibrating(&mode));
}

void test_SWR_VIB_702_no_vibration_where_the_axis_has_no_room_behind_it(void)
{
    robot.vibration = vibration;
    robot.axes[NEEDLE].minimum_ticks = 1000 - (int32_t)vibration.amplitude_ticks;
    frame.is_puncture = true;
    step(1000);
    TEST_ASSERT_FALSE(cooperate_mode_is_vibrating(&mode));
    robot.axes[NEEDLE].minimum_ticks--;
    step(1000);
    TEST_ASSERT_TRUE(cooperate_mode_is_vibrating(&mode));
}

/* Hard and soft by chance, but never off. */
void test_SWR_VIB_703_no_push_moves_the_needle_while_it_vibrates(void)
{
    uint64_t random = 1U;
    puncture(1000);
    brake(1000);
    const int32_t there = axes[NEEDLE].sealed.encoder.position_ticks;
    step(1000);
    for (uint32_t i = 0U; cooperate_mode_is_vibrating(&mode) && (i < LONG_CYCLES); i++) {
        TEST_ASSERT_INT32_WITHIN(vibration.amplitude_ticks,
                                 there - (int32_t)vibration.amplitude_ticks,
                                 axes[NEEDLE].sealed.setpoint_ticks);
        TEST_ASSERT_LESS_OR_EQUAL_INT32(there, axes[NEEDLE].sealed.setpoint_ticks);
        random = (random * 6364136223846793005U) + 1442695040888963407U;
        step(HARD_MN - (int32_t)((random >> 33U) % (HARD_MN - 400U)));
    }
}

/* In every part of it: while it brakes, and in each stroke and rest. */
void test_SWR_VIB_704_a_hand_that_lets_go_or_pulls_ends_it_in_the_same_cycle(void)
{
    for (uint32_t after = 0U; after < 200U; after += 7U) {
        setUp();
        puncture(1000);
        steps(1000, after);
        TEST_ASSERT_TRUE(cooperate_mode_is_vibrating(&mode));
        const int32_t there = axes[NEEDLE].sealed.encoder.position_ticks;
        step((after % 2U) == 0U ? (int32_t)law.dead_zone_mn : -HARD_MN);
        TEST_ASSERT_FALSE(cooperate_mode_is_vibrating(&mode));
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(there, axes[NEEDLE].sealed.setpoint_ticks);
        TEST_ASSERT_TRUE((speed_q8() > 0) || world_rests(NEEDLE));
        steps((int32_t)law.dead_zone_mn, 100U);
        TEST_ASSERT_TRUE(world_rests(NEEDLE));
    }
}

void test_SWR_VIB_704_it_is_not_resumed_after_a_pause(void)
{
    puncture(1000);
    steps(1000, 150U);
    cooperate_mode_pause(&mode);
    (void)axis_rest(&axes[NEEDLE], LIMIT_CYCLE_US);
    for (uint32_t i = 0U; i < 300U; i++) {
        step(1000);
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(0, speed_q8());
    }
}

/* The rotation never follows: a push that has waited too long is given up. */
void test_SWR_STEER_007_a_push_that_waits_too_long_for_the_rotation_is_given_up(void)
{
    move_mode_t steered = move;
    robot.steering = robot_prostate.steering;
    robot.steering.axis = NEURO_AXIS_ROTATION;
    (void)steering_set(&steered.steering, &robot.steering, (uint32_t)STEERING_BIDIRECTIONAL, 700U,
                       0);
    frame.hand.force_mn = 2000;
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (result.progress == MODE_RUNNING); i++) {
        mode_clear(&result);
        cooperate_mode_step(&mode, &steered, &steer, &frame, &result);
        world_follow_but(NEURO_AXIS_ROTATION);
        world_put(NEURO_AXIS_ROTATION, 7000);
    }
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_ROTATION, result.axis);
    TEST_ASSERT_EQUAL_INT32(1000, axes[NEEDLE].sealed.encoder.position_ticks);
    TEST_ASSERT_TRUE(all_rest());
}

/* The rotation turns while the hand pushes, and rests while it does not. */
void test_SWR_STEER_008_the_rotation_rests_while_no_hand_pushes(void)
{
    move_mode_t steered = move;
    robot.steering = robot_prostate.steering;
    robot.steering.axis = NEURO_AXIS_ROTATION;
    (void)steering_set(&steered.steering, &robot.steering, (uint32_t)STEERING_BIDIRECTIONAL, 700U,
                       0);
    for (uint32_t i = 0U; i < 400U; i++) {
        frame.hand.force_mn = (i < 200U) ? 2000 : 0;
        mode_clear(&result);
        cooperate_mode_step(&mode, &steered, &steer, &frame, &result);
        world_follow();
        TEST_ASSERT_EQUAL(i >= 200U, world_rests(NEURO_AXIS_ROTATION));
    }
}

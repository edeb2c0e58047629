/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: homing goes by the stages of the robot's table, takes the needle out before the
 * base homes, takes axes without a switch where they stand, and fails when a coupled limit bars it
 * or one that follows cannot. A robot with the pose home ends there.
 */
#include "unity.h"

#include "axis/axis.h"
#include "mode/leg/escort.h"
#include "mode/homing/homing_mode.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

static leg_t leg;
static escort_t escort;

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
    escort_end(&escort);
}

void tearDown(void)
{
}

/* As after the power-on. */
static void start_fresh(void)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_grade(i, AXIS_REFERENCE_FRESH);
    }
    frame.is_every_axis_homed = false;
}

static void step(void)
{
    mode_clear(&result);
    homing_mode_step(&leg, &escort, &frame, &result);
}

void test_SWR_JOG_016_the_needle_homes_before_all_else(void)
{
    start_fresh();
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL(i == (uint32_t)NEURO_AXIS_INSERTION, axis_is_homing(&axes[i]));
        TEST_ASSERT_EQUAL(i != (uint32_t)NEURO_AXIS_INSERTION, world_rests(i));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

void test_SWR_REF_002_axes_without_a_switch_are_taken_in_the_second_stage(void)
{
    start_fresh();
    world_grade(NEURO_AXIS_INSERTION, AXIS_REFERENCE_VERIFIED);
    world_put(NEURO_AXIS_FEET, 12);
    step();
    TEST_ASSERT_EQUAL_UINT32(2U, result.note_count);
    TEST_ASSERT_EQUAL(EVENT_AXIS_TAKEN, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_FEET, result.notes[0].axis);
    TEST_ASSERT_EQUAL_INT32(-12, result.notes[0].value);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_ROTATION, result.notes[1].axis);
    TEST_ASSERT_TRUE(axis_is_homing(&axes[NEURO_AXIS_HEAD]));
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    step();
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

/* A homed axis stays where it is. */
void test_SWR_AXIS_006_a_homed_axis_rests_while_another_homes(void)
{
    world_lose(NEURO_AXIS_LATERAL);
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL(i == (uint32_t)NEURO_AXIS_LATERAL, axis_is_homing(&axes[i]));
        TEST_ASSERT_EQUAL(i != (uint32_t)NEURO_AXIS_LATERAL, world_rests(i));
    }
}

void test_SWR_JOG_016_a_needle_that_is_in_leaves_alone_before_the_base_homes(void)
{
    const int32_t out_ticks = needle_retracted_ticks(&robot);
    uint32_t cycles = 0U;
    world_lose(NEURO_AXIS_LATERAL);
    world_put(NEURO_AXIS_INSERTION, 20000);
    while (needle_must_leave(&robot, axes)) {
        step();
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
        TEST_ASSERT_TRUE(axes[NEURO_AXIS_INSERTION].sealed.setpoint_ticks <= 20000);
        TEST_ASSERT_FALSE(axis_is_homing(&axes[NEURO_AXIS_LATERAL]));
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_LATERAL));
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_PITCH));
        TEST_ASSERT_LESS_THAN_UINT32(20000U, cycles);
        cycles++;
        world_follow();
        world_put(NEURO_AXIS_PITCH, 5);
    }
    TEST_ASSERT_EQUAL_INT32(out_ticks, leg.profile.end_ticks[NEURO_AXIS_INSERTION]);
    step();
    TEST_ASSERT_EQUAL_UINT32(0U, leg.is_running);
    TEST_ASSERT_TRUE(axis_is_homing(&axes[NEURO_AXIS_LATERAL]));
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_INSERTION));
}

void test_SWR_COUPLE_003_an_axis_that_is_barred_fails_it_and_no_other_begins(void)
{
    world_lose(NEURO_AXIS_HEAD);
    world_lose(NEURO_AXIS_LATERAL);
    world_put(NEURO_AXIS_FEET, -5000);
    step();
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_FAULT_PRESENT, result.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, result.axis);
    TEST_ASSERT_EQUAL_UINT32(1U, result.note_count);
    TEST_ASSERT_EQUAL(EVENT_HOMING_BARRED, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, result.notes[0].axis);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_FALSE(axis_is_homing(&axes[i]));
        TEST_ASSERT_TRUE(world_rests(i));
    }
}

/* The feet follow the head, which homes last. No limit that they share says where they may be. */
static void start_with_followers(void)
{
    static const int32_t home[] = {-500, 100, -200, 1000, 0, 30, -60};
    robot.axes[NEURO_AXIS_HEAD].home_stage = ROBOT_HOME_STAGES;
    robot.axes[NEURO_AXIS_FEET].leaders[ROBOT_HOME_STAGES - 1U] = 1U + NEURO_AXIS_HEAD;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        robot.poses[POSE_HOME].ticks[i] = home[i];
    }
    robot.coupled_limit_count = 0U;
    world_lose(NEURO_AXIS_HEAD);
    world_put(NEURO_AXIS_HEAD, -40);
    world_put(NEURO_AXIS_FEET, 3000);
}

void test_SWR_AXIS_028_a_follower_goes_the_way_of_its_leader_and_the_others_rest(void)
{
    start_with_followers();
    for (uint32_t i = 0U; i < 1000U; i++) {
        step();
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
        TEST_ASSERT_EQUAL_INT32(3040, axes[NEURO_AXIS_FEET].sealed.setpoint_ticks -
                                          axes[NEURO_AXIS_HEAD].sealed.setpoint_ticks);
        TEST_ASSERT_EQUAL_INT32(axes[NEURO_AXIS_HEAD].sealed.setpoint_speed_ticks_per_s_q8,
                                axes[NEURO_AXIS_FEET].sealed.setpoint_speed_ticks_per_s_q8);
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_LATERAL));
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_YAW));
        world_follow();
    }
    TEST_ASSERT_TRUE(axes[NEURO_AXIS_FEET].sealed.setpoint_ticks > 3100);
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

void test_SWR_AXIS_030_a_follower_rests_once_its_leader_does_not_home_any_more(void)
{
    start_with_followers();
    step();
    TEST_ASSERT_FALSE(world_rests(NEURO_AXIS_FEET));
    world_grade(NEURO_AXIS_HEAD, AXIS_REFERENCE_VERIFIED);
    step();
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_FEET));
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_HEAD));
}

void test_SWR_AXIS_031_the_distance_outlasts_a_pause_but_not_a_new_homing(void)
{
    start_with_followers();
    step();
    mode_rest(&frame, &result);
    world_put(NEURO_AXIS_HEAD, -38);
    step();
    TEST_ASSERT_EQUAL_INT32(3002, axes[NEURO_AXIS_FEET].sealed.setpoint_ticks);
    axis_stop_homing(&axes[NEURO_AXIS_HEAD]);
    mode_rest(&frame, &result);
    step();
    TEST_ASSERT_EQUAL_INT32(3000, axes[NEURO_AXIS_FEET].sealed.setpoint_ticks);
}

void test_SWR_AXIS_029_a_follower_that_cannot_follow_fails_it_by_name(void)
{
    start_with_followers();
    step();
    world_put(NEURO_AXIS_FEET, 2900);
    step();
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_FAULT_PRESENT, result.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_FEET, result.axis);
    TEST_ASSERT_EQUAL_UINT32(1U, result.note_count);
    TEST_ASSERT_EQUAL(EVENT_FOLLOWER_STUCK, result.notes[0].id);
    TEST_ASSERT_EQUAL_INT32(-100, result.notes[0].value);
}

void test_SWR_AXIS_029_the_first_that_cannot_follow_is_named_alone(void)
{
    start_with_followers();
    robot.axes[NEURO_AXIS_LATERAL].leaders[ROBOT_HOME_STAGES - 1U] = 1U + NEURO_AXIS_HEAD;
    step();
    world_put(NEURO_AXIS_FEET, 2900);
    world_put(NEURO_AXIS_LATERAL, -500);
    step();
    TEST_ASSERT_EQUAL_UINT32(1U, result.note_count);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_FEET, result.axis);
}

/* The feet are so far out that the head cannot be at its switch: they come along. */
static void start_with_escort(void)
{
    start_with_followers();
    robot.coupled_limit_count = 1U;
    world_put(NEURO_AXIS_FEET, -5000);
}

void test_SWR_AXIS_051_the_last_of_a_block_homes_with_its_escort(void)
{
    uint32_t rests = 0U;
    start_with_escort();
    step();
    while (world_rests(NEURO_AXIS_HEAD)) {
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_FEET));
        TEST_ASSERT_TRUE(axis_is_homing(&axes[NEURO_AXIS_HEAD]));
        TEST_ASSERT_LESS_THAN_UINT32(30U, rests);
        rests++;
        step();
    }
    for (uint32_t i = 0U; i < 1000U; i++) {
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
        TEST_ASSERT_EQUAL_INT32(-4960, axes[NEURO_AXIS_FEET].sealed.setpoint_ticks -
                                           axes[NEURO_AXIS_HEAD].sealed.setpoint_ticks);
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_YAW));
        world_follow();
        step();
    }
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD + 1U, escort.leader);
    world_grade(NEURO_AXIS_HEAD, AXIS_REFERENCE_VERIFIED);
    world_put(NEURO_AXIS_HEAD, 0);
    world_put(NEURO_AXIS_FEET, 0);
    step();
    TEST_ASSERT_EQUAL_UINT32(0U, escort.leader);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_FEET));
}

void test_SWR_AXIS_051_an_axis_that_does_not_begin_has_no_escort(void)
{
    start_with_escort();
    axis_disable(&axes[NEURO_AXIS_HEAD]);
    step();
    TEST_ASSERT_EQUAL_UINT32(0U, escort.leader);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_HEAD));
}

void test_SWR_AXIS_051_an_escort_at_the_double_makes_its_leader_half_as_fast(void)
{
    int32_t full = 0;
    start_with_escort();
    while ((result.progress == MODE_RUNNING) && (full == 0)) {
        step();
        full = axes[NEURO_AXIS_HEAD].sealed.setpoint_speed_ticks_per_s_q8;
        world_follow();
    }
    escort.paces *= 2U;
    homing_rest(&axes[NEURO_AXIS_HEAD].sealed.homing);
    step();
    TEST_ASSERT_EQUAL_INT32(full / 2, axes[NEURO_AXIS_HEAD].sealed.setpoint_speed_ticks_per_s_q8);
    TEST_ASSERT_INT32_WITHIN(1, full, axes[NEURO_AXIS_FEET].sealed.setpoint_speed_ticks_per_s_q8);
}

void test_SWR_AXIS_052_without_any_escort_it_fails_with_the_way_by_hand(void)
{
    uint32_t cycles = 0U;
    start_with_escort();
    robot.axes[NEURO_AXIS_FEET].maximum_ticks = -4999;
    robot.axes[NEURO_AXIS_FEET].minimum_ticks = -5001;
    while (result.progress == MODE_RUNNING) {
        step();
        TEST_ASSERT_LESS_THAN_UINT32(100U, cycles);
        cycles++;
    }
    TEST_ASSERT_EQUAL(STATUS_FAULT_PRESENT, result.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, result.axis);
    TEST_ASSERT_EQUAL_UINT32(1U, result.note_count);
    TEST_ASSERT_EQUAL(EVENT_HOMING_NO_WAY, result.notes[0].id);
    TEST_ASSERT_EQUAL_INT32(escort_way_by_hand_ticks(&escort, &robot, axes), result.notes[0].value);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_TRUE(world_rests(i));
    }
}

/* Head and lateral are of one linkage, and nothing that they count is believed any more. */
static void start_with_two_unplaced(void)
{
    start_with_followers();
    robot.axes[NEURO_AXIS_LATERAL].leaders[ROBOT_HOME_STAGES - 1U] = 1U + NEURO_AXIS_HEAD;
    world_lose(NEURO_AXIS_LATERAL);
    axes[NEURO_AXIS_HEAD].sealed.place = AXIS_PLACE_COUNTED | AXIS_PLACE_BROKEN;
    axes[NEURO_AXIS_LATERAL].sealed.place = AXIS_PLACE_BROKEN;
}

void test_SWR_AXIS_055_a_linkage_with_two_that_nobody_can_place_is_not_driven(void)
{
    start_with_two_unplaced();
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, homing_mode_unplaced(&robot, axes));
    robot.axes[NEURO_AXIS_LATERAL].home_stage = ROBOT_HOME_STAGES;
    step();
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, result.axis);
    TEST_ASSERT_EQUAL(EVENT_HOMING_UNPLACED, result.notes[0].id);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_FALSE(axis_is_homing(&axes[i]));
        TEST_ASSERT_TRUE(world_rests(i));
    }
}

void test_SWR_AXIS_055_one_that_stands_as_it_was_parked_has_the_block_driven(void)
{
    start_with_two_unplaced();
    axes[NEURO_AXIS_LATERAL].sealed.place = 0U;
    TEST_ASSERT_EQUAL_UINT32(robot.axis_count, homing_mode_unplaced(&robot, axes));
    axes[NEURO_AXIS_LATERAL].sealed.place = AXIS_PLACE_COUNTED;
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, homing_mode_unplaced(&robot, axes));
    axes[NEURO_AXIS_HEAD].sealed.place = AXIS_PLACE_COUNTED;
    TEST_ASSERT_EQUAL_UINT32(robot.axis_count, homing_mode_unplaced(&robot, axes));
}

/* The feet have no room: the block does not stand where it is parked. */
void test_SWR_AXIS_055_a_block_that_meets_an_end_was_not_parked_there(void)
{
    uint32_t cycles = 0U;
    start_with_followers();
    robot.axes[NEURO_AXIS_FEET].minimum_ticks = 3000;
    robot.axes[NEURO_AXIS_FEET].maximum_ticks = 3000;
    TEST_ASSERT_TRUE(axis_is_as_parked(&axes[NEURO_AXIS_HEAD]));
    do {
        step();
        TEST_ASSERT_LESS_THAN_UINT32(1000U, cycles);
        cycles++;
    } while (result.progress == MODE_RUNNING);
    TEST_ASSERT_EQUAL(EVENT_FOLLOWER_STUCK, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, homing_mode_unplaced(&robot, axes));
}

static bool is_done(void)
{
    return homing_mode_is_done(&leg, &frame);
}

void test_SWR_ROBOT_024_without_a_pose_homing_is_done_when_every_axis_is_homed(void)
{
    TEST_ASSERT_TRUE(is_done());
    world_lose(NEURO_AXIS_HEAD);
    TEST_ASSERT_FALSE(is_done());
    robot.pose_mask = (uint32_t)1U << POSE_HOME;
    TEST_ASSERT_FALSE(is_done());
}

void test_SWR_ROBOT_024_with_a_pose_it_is_done_when_every_axis_rests_there(void)
{
    start_with_followers();
    world_grade(NEURO_AXIS_HEAD, AXIS_REFERENCE_VERIFIED);
    frame.is_every_axis_homed = true;
    robot.pose_mask = (uint32_t)1U << POSE_HOME;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_FALSE(is_done());
        world_put(i, robot.poses[POSE_HOME].ticks[i]);
    }
    TEST_ASSERT_TRUE(is_done());
    leg.is_running = 1U;
    TEST_ASSERT_FALSE(is_done());
}

void test_SWR_ROBOT_024_all_axes_go_to_the_pose_with_the_needle_out(void)
{
    uint32_t cycles = 0U;
    start_with_followers();
    world_grade(NEURO_AXIS_HEAD, AXIS_REFERENCE_VERIFIED);
    frame.is_every_axis_homed = true;
    robot.pose_mask = (uint32_t)1U << POSE_HOME;
    world_put(NEURO_AXIS_INSERTION, 20000);
    do {
        const bool is_out =
            axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks <= needle_out_ticks(&robot);
        step();
        TEST_ASSERT_TRUE(is_out || world_rests(NEURO_AXIS_FEET));
        TEST_ASSERT_LESS_THAN_UINT32(20000U, cycles);
        cycles++;
        world_follow();
    } while (result.progress == MODE_RUNNING);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_TRUE(is_done());
}

/* The pose itself is outside; that of a robot never is. */
void test_SWR_ROBOT_026_a_way_home_that_leaves_a_coupled_limit_is_refused_by_its_name(void)
{
    start_with_followers();
    world_grade(NEURO_AXIS_HEAD, AXIS_REFERENCE_VERIFIED);
    world_put(NEURO_AXIS_FEET, 100);
    frame.is_every_axis_homed = true;
    robot.pose_mask = (uint32_t)1U << POSE_HOME;
    robot.coupled_limit_count = 1U;
    robot.coupled_limits[0].is_curved = 1U;
    robot.coupled_limits[0].minimum = 140000000;
    step();
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(robot.coupled_limits[0].refusal, result.status);
    TEST_ASSERT_EQUAL_UINT32(MODE_NO_AXIS, result.axis);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_TRUE(world_rests(i));
    }
}

void test_SWR_ROBOT_024_without_a_pose_homed_axes_stay_where_they_are(void)
{
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_TRUE(world_rests(i));
    }
}

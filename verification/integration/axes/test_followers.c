/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: axes that carry one linkage home as a block, stage after stage, and end at the
 * pose home. The robot is the ProstateRobot: two stages of two carriages each, a needle and its
 * rotation. Each pair of carriages carries a linkage, whose length must not change by more than 0.2
 * mm. In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "integration/support/followers_world.inc"

#define HOME_SPEED 2500 /* A quarter of 4 mm/s. */

void setUp(void)
{
    set_robot();
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* START_UP is discarded because `axis` cannot follow; no axis is driven any more. */
static void expect_stuck(uint32_t axis)
{
    const answer_t answer = rig_finish(&rig, MOST_CYCLES);

    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(axis, answer_axis(&answer));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_FOLLOWER_STUCK));
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if (rig.events[i].id == (uint32_t)EVENT_FOLLOWER_STUCK) {
            TEST_ASSERT_EQUAL_UINT32(axis, rig.events[i].subject);
        }
    }
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_cycles(&rig, 20U);
    expect_pairs_keep();
}

void test_SWR_AXIS_028_the_pairs_keep_their_length_and_the_stages_come_in_order(void)
{
    start();
    while (!is_homed(FRONT_RIGHT) || !is_homed(REAR_RIGHT)) {
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, rig.controller.sealed.cycle);
        TEST_ASSERT_TRUE(is_homed(NEEDLE) || !is_homing(FRONT_LEFT));
        TEST_ASSERT_TRUE(is_homed(REAR_LEFT) || !is_homing(FRONT_LEFT));
        TEST_ASSERT_TRUE(is_homed(FRONT_LEFT) || !is_homing(FRONT_RIGHT));
        TEST_ASSERT_TRUE(is_homed(FRONT_LEFT) || !is_homing(REAR_RIGHT));
        expect_pairs_keep();
        if (is_homing(FRONT_LEFT)) {
            TEST_ASSERT_DOUBLE_WITHIN(APART_TICKS, 0.0, stretch_ticks(FRONT_LEFT, REAR_LEFT));
        }
    }
    TEST_ASSERT_DOUBLE_WITHIN(30.0, -325000.0, true_ticks(FRONT_RIGHT));
    TEST_ASSERT_DOUBLE_WITHIN(30.0, -390000.0, true_ticks(REAR_RIGHT));
    TEST_ASSERT_DOUBLE_WITHIN(APART_TICKS,
                              -325000.0 + (start_ticks[FRONT_LEFT] - start_ticks[FRONT_RIGHT]),
                              true_ticks(FRONT_LEFT));
    TEST_ASSERT_EQUAL_UINT32(4U, rig_count(&rig, EVENT_AXIS_HOMED));
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_AXIS_TAKEN));
}

void test_SWR_AXIS_030_the_pedal_stops_every_stage_and_takes_it_on(void)
{
    start_at_home();
    expect_at_home();
}

void test_SWR_ROBOT_024_start_up_ends_at_the_pose_home_and_at_once_when_all_stand_there(void)
{
    start_at_home();
    expect_at_home();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.outputs.answers[1].kind);
}

/* A homed robot that stands elsewhere goes there, at the speed of homed axes. */
void test_SWR_ROBOT_024_a_homed_robot_that_stands_elsewhere_is_taken_home(void)
{
    const command_t jog = {.kind = COMMAND_JOG, .as.jog = {.axis = FRONT_LEFT, .to_ticks = 350000}};
    int32_t fastest = 0;
    start_at_home();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOST_CYCLES).kind);
    rig_release(&rig);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.answer_count);
    rig_press(&rig);
    while (rig_count(&rig, EVENT_ORDER_DONE) == 0U) {
        const int32_t speed_q8 =
            rig.controller.axes[FRONT_LEFT].sealed.setpoint_speed_ticks_per_s_q8;
        fastest = (speed_q8 > fastest) ? speed_q8 : fastest;
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, rig.controller.sealed.cycle);
    }
    TEST_ASSERT_GREATER_THAN_INT32(3 * HOME_SPEED * 256, fastest);
    expect_at_home();
}

/* Its own supervision finds it. */
void test_SWR_AXIS_029_a_stuck_follower_stops_its_leader(void)
{
    static const char *const orders[] = {"motor front_right stuck", "motor rear_left stuck",
                                         "motor rear_right stuck"};
    for (uint32_t i = 0U; i < 3U; i++) {
        start();
        run_until_homing(FRONT_LEFT, 2000U);
        rig_box(&rig, orders[i]);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 1000U).kind);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_NO_COUNTS));
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        rig_cycles(&rig, 20U);
        expect_pairs_keep();
    }
}

void test_SWR_AXIS_029_a_leader_that_is_stuck_stops_its_followers(void)
{
    start();
    run_until_homing(FRONT_LEFT, 2000U);
    rig_box(&rig, "motor front_left stuck");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 1000U).kind);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_cycles(&rig, 20U);
    expect_pairs_keep();
}

/* Its permit is missing, so that its own supervision has nothing to say. */
void test_SWR_AXIS_029_a_follower_that_stays_behind_is_named_and_stops_all(void)
{
    robot.coupled_limits[1].axes = (uint32_t)1U << REAR_LEFT;
    robot.coupled_limits[1].maximum = 152000000;
    start();
    expect_stuck(REAR_LEFT);
    TEST_ASSERT_TRUE(true_ticks(REAR_LEFT) < 380000.0);
    TEST_ASSERT_TRUE(stretch_ticks(REAR_RIGHT, REAR_LEFT) > 300.0);
}

void test_SWR_AXIS_029_a_homed_follower_keeps_its_soft_limit_and_all_stop_there(void)
{
    robot.axes[REAR_LEFT].maximum_ticks = 380000;
    start();
    expect_stuck(REAR_LEFT);
    TEST_ASSERT_DOUBLE_WITHIN(30.0, 380000.0, true_ticks(REAR_LEFT));
}

void test_SWR_AXIS_029_a_follower_that_meets_its_switch_stops_all(void)
{
    robot.axes[REAR_RIGHT].limit_switch = LIMIT_SWITCH_UPPER;
    robot.axes[REAR_RIGHT].home_ticks = -370000;
    start();
    expect_stuck(REAR_RIGHT);
    TEST_ASSERT_DOUBLE_WITHIN(100.0, -370000.0, true_ticks(REAR_RIGHT));
}

void test_SWR_AXIS_036_a_linkage_does_not_home_carriage_by_carriage(void)
{
    start();
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    for (uint32_t i = FRONT_LEFT; i <= REAR_RIGHT; i++) {
        const command_t home = {.kind = COMMAND_HOME_AXIS, .as.axis = {.axis = i}};
        TEST_ASSERT_EQUAL_UINT32(STATUS_HOMES_WITH_OTHERS, rig_command(&rig, home).status);
    }
    const command_t needle = {.kind = COMMAND_HOME_AXIS, .as.axis = {.axis = NEEDLE}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, needle).status);
}

/* The block was another one when it stopped. */
void test_SWR_AXIS_031_a_homing_that_was_interrupted_begins_anew_from_where_the_axes_are(void)
{
    command_t jog = {.kind = COMMAND_JOG, .as.jog = {.axis = FRONT_RIGHT}};
    start();
    run_until_homing(FRONT_LEFT, 2000U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    rig_release(&rig);
    TEST_ASSERT_FALSE(is_homing(FRONT_LEFT));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    jog.as.jog.to_ticks = rig_position(&rig, FRONT_RIGHT) - (TICKS_PER_MM / 2);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOST_CYCLES).kind);
    rig_release(&rig);
    box_true_positions(&rig.box, start_ticks);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    while (!is_homed(FRONT_LEFT)) {
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, rig.controller.sealed.cycle);
        expect_pairs_keep();
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_FOLLOWER_STUCK));
}

/* On until the leg of homing of `axis` is `leg`. */
static void run_until_leg(uint32_t axis, axis_reference_t leg)
{
    while (rig.controller.axes[axis].chart.reference != (uint32_t)leg) {
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, rig.controller.sealed.cycle);
        rig_cycle(&rig);
    }
}

/* rear_right meets its switch, twice at the same place, 14 mm before it is there: the gap to
 * rear_left says that it cannot be. */
void test_SWR_AXIS_033_a_switch_that_lies_ends_start_up_before_the_other_pair_goes_on(void)
{
    start();
    run_until_homing(FRONT_RIGHT, 2000U);
    rig_box(&rig, "switch rear_right stuck");
    run_until_leg(REAR_RIGHT, AXIS_REFERENCE_BACK_OFF);
    const int32_t edge = rig.controller.axes[REAR_RIGHT].sealed.homing.edge_ticks;
    rig_box(&rig, "switch rear_right normal");
    run_until_leg(REAR_RIGHT, AXIS_REFERENCE_LATCH);
    while (rig_position(&rig, REAR_RIGHT) > edge) {
        rig_cycle(&rig);
    }
    rig_box(&rig, "switch rear_right stuck");
    const double front = true_ticks(FRONT_RIGHT);
    const answer_t answer = rig_finish(&rig, 1000U);

    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(REAR_RIGHT, answer_axis(&answer));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_HOMED) - 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_HOMED_BEYOND_LIMIT));
    TEST_ASSERT_FALSE(is_homed(REAR_RIGHT));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_DOUBLE_WITHIN(0.2 * TICKS_PER_MM, front, true_ticks(FRONT_RIGHT));
}

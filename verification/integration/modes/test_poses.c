/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: in MANUAL a robot goes to the poses of its file by their names, with the needle
 * out and left where it is; otherwise it is refused by name. On the simulated box, whose true
 * positions are looked at.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "charts/arming_chart.h"
#include "robot/robot_neuro.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static command_t to(uint32_t pose)
{
    return (command_t){.kind = (uint32_t)COMMAND_POSE, .as.pose_name = {.pose = pose}};
}

static uint32_t status_of(command_t command)
{
    return rig_command(&rig, command).status;
}

static void start_manual(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    rig_forget(&rig);
}

static void run(command_t command)
{
    const answer_t answer = rig_command(&rig, command);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, answer.is_final);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    rig_cycles(&rig, 100U);
}

static void expect_there(uint32_t pose, double needle_ticks)
{
    double ticks[ROBOT_AXIS_MAX];
    box_true_positions(&rig.box, ticks);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const bool is_needle = i == (uint32_t)NEURO_AXIS_INSERTION;
        TEST_ASSERT_DOUBLE_WITHIN(
            3.0, is_needle ? needle_ticks : (double)robot_neuro.poses[pose].ticks[i], ticks[i]);
    }
}

void test_SWR_POSE_001_the_robot_goes_from_pose_to_pose_and_the_needle_stays_out(void)
{
    double before[ROBOT_AXIS_MAX];
    start_manual();
    box_true_positions(&rig.box, before);
    for (uint32_t pose = POSE_NAME_COUNT - 1U; pose >= (uint32_t)POSE_PARK; pose--) {
        run(to(pose));
        expect_there(pose, before[NEURO_AXIS_INSERTION]);
        TEST_ASSERT_EQUAL_UINT32(WORKPHASE_MANUAL, rig.outputs.snapshot.workphase);
    }
}

void test_SWR_POSE_001_it_pauses_without_the_pedal_and_goes_on(void)
{
    double before[ROBOT_AXIS_MAX];
    start_manual();
    box_true_positions(&rig.box, before);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(to(POSE_DRAPING)));
    rig_press(&rig);
    rig_cycles(&rig, 1500U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_release(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_cycles(&rig, 500U);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    rig_cycles(&rig, 100U);
    expect_there(POSE_DRAPING, before[NEURO_AXIS_INSERTION]);
}

void test_SWR_POSE_002_with_the_needle_in_it_is_refused_until_that_was_retracted(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NEEDLE_IN, status_of(to(POSE_EGRESS)));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    run((command_t){.kind = (uint32_t)COMMAND_RETRACT});
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(to(POSE_EGRESS)));
}

void test_SWR_POSE_003_what_the_file_does_not_name_is_refused(void)
{
    start_manual();
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_POSE, status_of(to(POSE_HOME)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_POSE, status_of(to(POSE_NAME_COUNT)));
    rig.robot.poses[POSE_EGRESS].ticks[NEURO_AXIS_HEAD] ^= 64;
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, status_of(to(POSE_EGRESS)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(to(POSE_PARK)));
}

void test_SWR_POSE_001_in_manual_only(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, status_of(to(POSE_PARK)));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a treatment program needs nothing of a robot but an axis along the needle and
 * one about it: the ProstateRobot, whose needle is turned by waves, runs one as well.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "robot/robot_prostate.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static command_t entry(const rigid_t *pose)
{
    command_t command = {.kind = (uint32_t)COMMAND_ENTRY, .as.pose = {.pose = *pose}};
    command.as.pose.pose.translation.z_nm -= 30000000;
    return command;
}

static void run(command_t command)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 120000U).kind);
    rig_release(&rig);
    rig_cycles(&rig, 100U);
}

/* One step, 2 mm short of the target and a quarter of a turn. */
void test_SWR_PROG_011_another_robot_that_turns_its_needle_runs_a_program(void)
{
    rigid_t pose;
    rigid_set_identity(&pose);
    pose.translation = (point_t){5000000, -10000000, 52000000};
    rig_start_robot_targeted(&rig, rig_short_prostate(), &pose);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry(&pose)).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    run((command_t){.kind = (uint32_t)COMMAND_ALIGN});
    const int64_t tick_q16 = robot_prostate.axes[PROSTATE_AXIS_INSERTION].unit_per_tick_q16;
    const int32_t depth = rig.controller.plan.target_ticks[PROSTATE_AXIS_INSERTION] -
                          (int32_t)((INT64_C(2000000) * 65536) / tick_q16);
    command_t command = {.kind = (uint32_t)COMMAND_PROGRAM_STEP, .as.step = {.dwell_ms = 300}};
    command.as.step.ticks[PROSTATE_AXIS_INSERTION] = depth;
    command.as.step.ticks[PROSTATE_AXIS_ROTATION] = 417;
    const command_t begin = {.kind = (uint32_t)COMMAND_PROGRAM_BEGIN,
                             .as.list_begin = {.count = 1U}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, begin).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    const uint32_t sum = rig.outputs.snapshot.program_crc;
    const command_t end = {.kind = (uint32_t)COMMAND_PROGRAM_END, .as.list = {.checksum = sum}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, end).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    run((command_t){.kind = (uint32_t)COMMAND_RUN_PROGRAM, .as.list = {.checksum = sum}});
    TEST_ASSERT_INT32_WITHIN(10, depth, rig_position(&rig, PROSTATE_AXIS_INSERTION));
    TEST_ASSERT_INT32_WITHIN(5, 417, rig_position(&rig, PROSTATE_AXIS_ROTATION));
}

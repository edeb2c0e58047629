/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a robot has the axes of its table and no other. Room for more is no axis: it
 * waits for no card, homes before nothing and writes no frame.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "base/seal.h"
#include "controller/controller.h"
#include "robot/robot_neuro.h"

#include <stddef.h>
#include <string.h>

#define NEEDLE 0U
#define SIDE 1U
#define SLOTS 0x11U /* 0 and 4. */

static rig_t rig;
static robot_t robot; /* The needle in slot 0, and one more axis. */

void setUp(void)
{
    robot = robot_neuro;
    (void)memset(robot.axes, 0, sizeof robot.axes);
    robot.axes[NEEDLE] = robot_neuro.axes[NEURO_AXIS_INSERTION];
    robot.axes[NEEDLE].slot = 0U;
    robot.axes[SIDE] = robot_neuro.axes[NEURO_AXIS_LATERAL];
    robot.start_ticks[NEEDLE] = robot_neuro.start_ticks[NEURO_AXIS_INSERTION];
    robot.start_ticks[SIDE] = robot_neuro.start_ticks[NEURO_AXIS_LATERAL];
    robot.axis_count = 2U;
    robot.kind = 0U; /* No robot's kinematics. */
    robot.needle_axis = NEEDLE;
    robot.coupled_limit_count = 0U;
    robot.seal = seal_of(SEAL_START, (const uint8_t *)&robot, offsetof(robot_t, seal));
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        axis_config_t *const row = &robot.axes[i];
        row->seal = seal_of(SEAL_START, (const uint8_t *)row, offsetof(axis_config_t, seal));
    }
    rig_start_robot(&rig, &robot);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static answer_t jog(uint32_t axis, int32_t ticks)
{
    const command_t command = {.kind = (uint32_t)COMMAND_JOG,
                               .as.jog = {.axis = axis, .to_ticks = ticks}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    return rig_command(&rig, command);
}

/* And to at most one empty slot, which is asked whether a card has come. */
static void expect_frames_to_axes(void)
{
    const uint32_t others = rig.outputs.frames_to_send & ~SLOTS;
    TEST_ASSERT_EQUAL_HEX32(SLOTS, rig.outputs.frames_to_send & SLOTS);
    TEST_ASSERT_EQUAL_HEX32(0U, others & (others - 1U));
}

void test_SWR_ROBOT_013_two_axes_are_homed_and_jogged(void)
{
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.snapshot.axis_count);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, jog(SIDE, -500).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 20000U).kind);
    TEST_ASSERT_INT32_WITHIN(2, -500, rig_position(&rig, SIDE));
}

void test_SWR_ROBOT_013_frames_go_to_the_cards_of_the_table_and_each_names_its_own_axis(void)
{
    rig_home(&rig);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(i, rig_sent(&rig, i).axis_id);
        TEST_ASSERT_EQUAL_UINT32(robot.axes[i].full_speed_ticks_per_s * 2,
                                 rig_sent(&rig, i).overspeed_ticks_per_s);
    }
    expect_frames_to_axes();
}

void test_SWR_ROBOT_013_what_the_table_does_not_hold_is_not_jogged(void)
{
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND, jog(robot.axis_count, 0).status);
}

void test_SWR_ROBOT_013_a_number_of_axes_that_was_damaged_is_not_believed(void)
{
    rig_home(&rig);
    rig.controller.sealed.axis_count = UINT32_MAX;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.controller.sealed.axis_count);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    rig.robot.axis_count = UINT32_MAX;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ROBOT_TABLE_DAMAGED));
    expect_frames_to_axes();
    rig.controller.sealed.axis_count = UINT32_MAX;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_MAX, rig.controller.sealed.axis_count);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: without a sound table of the robot nothing moves, and only what needs no table
 * is obeyed.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_damage.h"
#include "robot/robot_neuro.h"

#include <stddef.h>
#include <string.h>

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void begin_move(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_forget(&rig);
}

static void expect_blind(uint32_t part)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    TEST_ASSERT_EQUAL_UINT32(EVENT_ROBOT_TABLE_DAMAGED, rig.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(part, rig.events[0].subject);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ROBOT_TABLE_DAMAGED));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_MEMORY, shown->next_step);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, shown->pose_status);
    TEST_ASSERT_EQUAL_UINT32(0U, shown->is_homed | shown->has_target);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_MEMORY, shown->axes[i].permit_reasons);
    }
}

void test_SWR_MEMORY_004_a_damaged_table_stops_all_motion_until_the_programs_are_restarted(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_move();
        rig.robot.axes[i].unit_per_tick_q16 = 0;
        rig_cycle(&rig);
        expect_blind(i);
        TEST_ASSERT_EQUAL_UINT32(1U, rig.answer_count);
        TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, rig.answers[0].status);
        rig.robot = robot_neuro;
        rig_cycles(&rig, 100U);
        expect_blind(i);
        TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED,
                                 rig_workphase(&rig, WORKPHASE_START_UP).status);
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_CARD_LOST));
    }
}

void test_SWR_MEMORY_004_a_damaged_geometry_is_a_damaged_table(void)
{
    begin_move();
    rig.robot.geometry_nm[NEURO_SIDE_LINK] ^= 0x100;
    rig_cycle(&rig);
    expect_blind(ROBOT_PART_GEOMETRY);
}

void test_SWR_MEMORY_004_without_a_table_stop_is_obeyed_and_nothing_that_needs_it(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_YAW, .to_ticks = -200}};
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    begin_move();
    rig.robot.axes[NEURO_AXIS_YAW].slot = 255U;
    rig_cycle(&rig);
    expect_blind(NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, rig_command(&rig, jog).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, rig_target(&rig, &pose).status);
    TEST_ASSERT_TRUE(rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status != STATUS_OK);
}

void test_SWR_MEMORY_004_without_a_table_nothing_is_confirmed_and_no_drift_is_reported(void)
{
    begin_move();
    rig.robot.coupled_limits[0].axes = UINT32_MAX;
    rig_cycle(&rig);
    expect_blind(ROBOT_PART_GEOMETRY);
    rig_release(&rig);
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 5U);
    rig_box(&rig, "scanner off");
    rig_box(&rig, "button press");
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_SCANNER));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SCAN_DRIFT));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_CONFIRMED));
}

void test_SWR_MEMORY_004_a_table_that_is_damaged_at_the_start_moves_nothing(void)
{
    (void)memset(&rig, 0, sizeof rig);
    rig.elapsed_us = 1000U;
    rig.robot = robot_neuro;
    rig.robot.axes[NEURO_AXIS_PITCH].maximum_ticks ^= 0x20;
    box_init(&rig.box, &robot_neuro, 1U);
    controller_init(&rig.controller, &rig.robot);
    rig_cycles(&rig, 20U);
    expect_blind(NEURO_AXIS_PITCH);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, rig_workphase(&rig, WORKPHASE_START_UP).status);
}

void test_SWR_MEMORY_380_a_number_of_axes_without_room_stays_within_the_room(void)
{
    const uint32_t counts[] = {ROBOT_AXIS_MAX + 1U, 4096U};
    for (size_t i = 0U; i < (sizeof counts / sizeof counts[0]); i++) {
        (void)memset(&rig, 0, sizeof rig);
        rig.elapsed_us = 1000U;
        rig.robot = robot_neuro;
        rig.robot.axis_count = counts[i];
        box_init(&rig.box, &robot_neuro, 1U);
        controller_init(&rig.controller, &rig.robot);
        TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_MAX, rig.controller.sealed.axis_count);
        rig_cycles(&rig, 20U);
        expect_blind(ROBOT_PART_GEOMETRY);
        TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED,
                                 rig_workphase(&rig, WORKPHASE_START_UP).status);
    }
}

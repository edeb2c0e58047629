/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is said of each mode and workphase before it is commanded is what the controller then
 * says. */
#include "unity.h"

#include "http/view/mode_availability.h"
#include "interface/app/names.h"
#include "unit/support/commands.h"
#include "integration/support/rig.h"
#include "robot/robot_neuro.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
}

static void in_undefined(void)
{
    rig_start(&rig);
}

static void in_planning(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
}

static void in_manual(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
}

static void on_the_way(void)
{
    rig_start_moving(&rig);
    rig_cycles(&rig, 100U);
}

static void with_a_lost_card(void)
{
    in_manual();
    rig_box(&rig, "card pitch silent");
    rig_cycles(&rig, 100U);
}

static void with_a_stall_of_the_needle(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "motor insertion runs");
    rig_cycles(&rig, 2000U);
}

static void after_the_estop(void)
{
    in_manual();
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 20U);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U);
}

static void without_a_place(void)
{
    in_manual();
    const command_t clear = {.kind = (uint32_t)COMMAND_CLEAR_AXIS,
                             .as.axis = {.axis = NEURO_AXIS_FEET}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    rig_cycles(&rig, 20U);
}

/* A list of one row, where the axes stand. */
static void with_a_trajectory(void)
{
    in_manual();
    command_t command = {.kind = (uint32_t)COMMAND_LIST_BEGIN, .as.list_begin = {.count = 1U}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    command = (command_t){.kind = (uint32_t)COMMAND_LIST_ROW};
    for (uint32_t i = 0U; i < rig.robot.axis_count; i++) {
        command.as.row.ticks[i] = rig_position(&rig, i);
    }
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    command = (command_t){.kind = (uint32_t)COMMAND_LIST_END,
                          .as.list = {.checksum = rig.outputs.snapshot.trajectory_crc}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
}

static void on_an_unfit_computer(void)
{
    in_manual();
    rig.unfit = 1U;
    rig_cycle(&rig);
}

static void (*const scenes[])(void) = {in_undefined,      in_planning,
                                       in_manual,         on_the_way,
                                       with_a_lost_card,  with_a_stall_of_the_needle,
                                       after_the_estop,   without_a_place,
                                       with_a_trajectory, on_an_unfit_computer};

/* One that its mode has nothing against. */
static command_t command_for(mode_kind_t kind)
{
    command_t command = commands_of_number((command_kind_t)mode_rows[kind].command, NEURO_AXIS_YAW);
    if (kind == MODE_HOMING) {
        command.as.workphase.workphase = (uint32_t)WORKPHASE_START_UP;
    } else if (kind == MODE_MOVE) {
        command.as.workphase.workphase = (uint32_t)WORKPHASE_MOVE_TO_TARGET;
    } else if (kind == MODE_TRAJECTORY) {
        command.as.list.checksum = rig.outputs.snapshot.trajectory_crc;
    } else if (kind == MODE_POSE) {
        command.as.pose_name.pose = (uint32_t)POSE_PARK;
    } else if (kind == MODE_JOG) {
        command.as.jog.to_ticks =
            (rig.outputs.snapshot.is_homed != 0U) ? -200 : rig_position(&rig, NEURO_AXIS_YAW);
    }
    return command;
}

static status_t outlook(const robot_t *robot, mode_kind_t kind)
{
    return mode_availability(robot, &rig.outputs.snapshot, rig.controller.rows[0].ticks, kind);
}

void test_SWR_MODE_004_what_is_said_of_each_mode_is_what_becomes_of_its_command(void)
{
    static const mode_kind_t kinds[] = {MODE_HOMING,    MODE_MOVE,       MODE_JOG,   MODE_RETRACT,
                                        MODE_HOME_AXIS, MODE_TRAJECTORY, MODE_ALIGN, MODE_INSERT,
                                        MODE_POSE,      MODE_PROGRAM,    MODE_SWEEP};
    uint32_t allowed = 0U;
    uint32_t refused = 0U;
    for (uint32_t i = 0U; i < (sizeof scenes / sizeof scenes[0]); i++) {
        for (uint32_t j = 0U; j < (sizeof kinds / sizeof kinds[0]); j++) {
            scenes[i]();
            const status_t said = outlook(&robot_neuro, kinds[j]);
            const status_t became = (status_t)rig_command(&rig, command_for(kinds[j])).status;
            const bool is_of_command =
                (mode_rows[kinds[j]].axes == (uint32_t)MODE_AXES_COMMANDED) &&
                ((became == STATUS_NEEDLE_IN) || (became == STATUS_SWITCH_ZONE));
            if (is_of_command) {
                continue; /* The refusal of a command for this axis comes first. */
            }
            TEST_ASSERT_EQUAL_UINT32_MESSAGE(became, said, mode_kind_name((int32_t)kinds[j]));
            allowed += (said == STATUS_OK) ? 1U : 0U;
            refused += (said == STATUS_OK) ? 0U : 1U;
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(5U, allowed);
    TEST_ASSERT_GREATER_THAN_UINT32(5U, refused);
}

void test_SWR_MODE_004_a_target_without_an_entry_point_and_a_robot_without_poses_are_named(void)
{
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_entry);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_ENTRY_POINT, outlook(&robot_neuro, MODE_ALIGN));
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_ENTRY_POINT,
                             rig_command(&rig, command_for(MODE_ALIGN)).status);
    in_manual();
    robot_t bare = robot_neuro;
    bare.pose_mask = 0U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, outlook(&robot_neuro, MODE_POSE));
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_POSE, outlook(&bare, MODE_POSE));
}

static void expect(mode_kind_t kind, status_t status)
{
    TEST_ASSERT_EQUAL_UINT32(status, outlook(&robot_neuro, kind));
    TEST_ASSERT_EQUAL_UINT32(status, rig_command(&rig, command_for(kind)).status);
}

static void finish(command_t command)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    rig_forget(&rig);
}

void test_SWR_MODE_004_a_base_that_is_not_aligned_is_named(void)
{
    const rigid_t target = rig_pose(5000000, 190000000, 60000000);
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY, .as.pose = {.pose = target}};
    rig_start_targeted(&rig);
    entry.as.pose.pose.translation.y_nm += 56000000;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &target).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    expect(MODE_INSERT, STATUS_NOT_ALIGNED);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    rig_forget(&rig);
    finish(command_for(MODE_ALIGN));
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_forget(&rig);
    expect(MODE_INSERT, STATUS_OK);
}

void test_SWR_MODE_004_a_trajectory_that_begins_elsewhere_is_named(void)
{
    const command_t away = {.kind = (uint32_t)COMMAND_JOG_BY,
                            .as.jog_by = {.axis = NEURO_AXIS_YAW, .by_ticks = -600}};
    with_a_trajectory();
    expect(MODE_TRAJECTORY, STATUS_OK);
    with_a_trajectory();
    rig_forget(&rig);
    finish(away);
    expect(MODE_TRAJECTORY, STATUS_TRAJECTORY_FAR);
}

void test_SWR_MODE_010_what_is_said_of_each_workphase_is_what_becomes_of_its_command(void)
{
    uint32_t allowed = 0U;
    uint32_t refused = 0U;
    for (uint32_t i = 0U; i < (sizeof scenes / sizeof scenes[0]); i++) {
        for (uint32_t j = (uint32_t)WORKPHASE_UNDEFINED + 1U; j < WORKPHASE_COUNT; j++) {
            scenes[i]();
            const status_t said =
                workphase_availability(&robot_neuro, &rig.outputs.snapshot, (workphase_t)j);
            TEST_ASSERT_EQUAL_UINT32_MESSAGE(rig_workphase(&rig, (workphase_t)j).status, said,
                                             workphase_name((int32_t)j));
            allowed += (said == STATUS_OK) ? 1U : 0U;
            refused += (said == STATUS_OK) ? 0U : 1U;
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(20U, allowed);
    TEST_ASSERT_GREATER_THAN_UINT32(10U, refused);
}

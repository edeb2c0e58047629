/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is said of an act before it is commanded is what the controller then says, wherever
 * chance has led the robot. */
#include "unity.h"

#include "http/view/command_availability.h"
#include "interface/app/names.h"
#include "unit/support/commands.h"
#include "integration/support/rig.h"
#include "robot/robot_neuro.h"
#include "supervise/scenario/prng.h"
#include "unit/support/scenes.h"

#include <string.h>

#define ROBOTS SCENES(40U) /* Each begins homed. */
#define STEPS 60U

static rig_t rig;
static uint32_t random_state = 20261127U;
static uint64_t allowed; /* Kinds that were. */
static uint64_t barred;  /* Kinds that were not. */

static const command_kind_t kinds[] = {COMMAND_REGISTRATION,
                                       COMMAND_TARGET,
                                       COMMAND_ENTRY,
                                       COMMAND_PROBE,
                                       COMMAND_RESTORE,
                                       COMMAND_CLEAR_AXIS,
                                       COMMAND_CONFIRM_AXIS,
                                       COMMAND_SET_HOME,
                                       COMMAND_ENABLE_AXIS,
                                       COMMAND_DISABLE_AXIS,
                                       COMMAND_LIST_BEGIN,
                                       COMMAND_PROGRAM_BEGIN,
                                       COMMAND_ACCEPT_NO_BLACK_BOX};

#define KINDS (sizeof kinds / sizeof kinds[0])

void setUp(void)
{
}

void tearDown(void)
{
}

static uint32_t below(uint32_t bound)
{
    return prng_below(&random_state, bound);
}

/* One whose numbers are as they should be. */
static command_t command_of(command_kind_t kind)
{
    command_t command = commands_of_number(kind, NEURO_AXIS_FEET);
    if (kind == COMMAND_REGISTRATION) {
        rigid_set_identity(&command.as.registration.pose);
    } else if ((kind == COMMAND_TARGET) || (kind == COMMAND_ENTRY)) {
        command.as.pose.pose = rig_pose(5000000, 190000000, 60000000);
    } else if (kind == COMMAND_PROBE) {
        command.as.probe.count = rig.robot.probe_length_count;
        (void)memcpy(command.as.probe.lengths_nm, rig.outputs.snapshot.probe_nm,
                     sizeof rig.outputs.snapshot.probe_nm);
    } else if (kind == COMMAND_RESTORE) {
        command.as.positions.axes = 1U << NEURO_AXIS_FEET;
        command.as.positions.ticks[NEURO_AXIS_FEET] = rig_position(&rig, NEURO_AXIS_FEET);
    } else if (kind == COMMAND_PROGRAM_BEGIN) {
        command.as.list_begin.count = 1U;
    } else {
        /* Its axis says it, or nothing. */
    }
    return command;
}

/* Refusals that depend on the axis, on the numbers or on a movement that is not shown. */
static bool is_of_command(command_kind_t kind, status_t status)
{
    bool is_its = (status == STATUS_HARDWARE_NOT_READY) && (kind != COMMAND_CLEAR_AXIS);
    if ((kind == COMMAND_TARGET) || (kind == COMMAND_ENTRY)) {
        is_its = (status != STATUS_WRONG_WORKPHASE) && (status != STATUS_MOTION_ARMED);
    } else if (kind == COMMAND_CONFIRM_AXIS) {
        is_its = status == STATUS_NOTHING_TO_CONFIRM;
    } else if ((kind == COMMAND_SET_HOME) || (kind == COMMAND_RESTORE)) {
        is_its = is_its || (status == STATUS_NOT_AT_REST);
    } else {
        /* Nothing else. */
    }
    return is_its;
}

static void compare(command_kind_t kind)
{
    const snapshot_t before = rig.outputs.snapshot;
    const status_t said = command_availability(&rig.robot, &before, kind);
    const status_t became = (status_t)rig_command(&rig, command_of(kind)).status;
    if ((said != STATUS_OK) || !is_of_command(kind, became)) {
        TEST_ASSERT_EQUAL_STRING_MESSAGE(status_name((int32_t)became), status_name((int32_t)said),
                                         command_kind_name((int32_t)kind));
    }
    allowed |= (became == STATUS_OK) ? (UINT64_C(1) << (uint32_t)kind) : 0U;
    barred |= (said == STATUS_OK) ? 0U : (UINT64_C(1) << (uint32_t)kind);
}

/* As far as control lets it. */
static void plan(void)
{
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    (void)rig_command(&rig, command_of(COMMAND_REGISTRATION));
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    (void)rig_command(&rig, command_of(COMMAND_TARGET));
}

/* Acts of people and programs meanwhile. */
static void go_on(void)
{
    static const workphase_t ways[] = {
        WORKPHASE_START_UP,       WORKPHASE_PLANNING, WORKPHASE_TARGETING, WORKPHASE_CALIBRATION,
        WORKPHASE_MOVE_TO_TARGET, WORKPHASE_MANUAL,   WORKPHASE_STOP};
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_INSERTION, .to_ticks = 9000}};
    rig.lacks_black_box = 0U;
    switch (below(12U)) {
    case 0:
        plan();
        break;
    case 1:
        (void)rig_command(&rig, jog);
        break;
    case 2:
        rig_press(&rig);
        break;
    case 3:
    case 4:
        rig_release(&rig);
        break;
    case 5:
        rig_box(&rig, "estop pull");
        break;
    case 6:
        rig_box(&rig, "estop reset");
        break;
    case 7:
        rig.lacks_black_box = 1U;
        rig.controller.sealed.is_box_settled = 0U; /* As in a run that begins. */
        controller_seal(&rig.controller);
        break;
    default:
        (void)rig_workphase(&rig, ways[below(sizeof ways / sizeof ways[0])]);
        break;
    }
    rig_cycles(&rig, 20U + below(300U));
    rig_forget(&rig);
}

void test_SWR_HTTP_055_what_is_said_of_an_act_is_what_becomes_of_it(void)
{
    for (uint32_t i = 0U; i < ROBOTS; i++) {
        rig_start_homed(&rig);
        for (uint32_t j = 0U; j < STEPS; j++) {
            go_on();
            compare(kinds[below(KINDS)]);
        }
    }
    for (uint32_t i = 0U; ARE_SCENES_WHOLE && (i < KINDS); i++) {
        const char *const name = command_kind_name((int32_t)kinds[i]);
        TEST_ASSERT_TRUE_MESSAGE(((allowed >> (uint32_t)kinds[i]) & 1U) != 0U, name);
        TEST_ASSERT_TRUE_MESSAGE(((barred >> (uint32_t)kinds[i]) & 1U) != 0U, name);
    }
}

void test_SWR_HTTP_055_zeroing_is_said_to_be_refused_as_it_is(void)
{
    const robot_t *const robots[] = {&robot_neuro, rig_short_prostate()};
    for (uint32_t i = 0U; i < 2U; i++) {
        rig_start_robot_homed(&rig, robots[i]);
        rig_cycles(&rig, 500U);
        rig_press(&rig);
        compare(COMMAND_ZERO_FORCE);
        rig_release(&rig);
        compare(COMMAND_ZERO_FORCE);
    }
}

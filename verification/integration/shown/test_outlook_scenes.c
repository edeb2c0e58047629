/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: what is said of each workphase, mode, axis and act is what becomes of its
 * command, in every state to which chance leads the robot: faults, lost cards that answer again,
 * pedal, e-stop, a loop that was stopped, an unfit computer, cards of another dialect, authority
 * that is given up, a damaged table.
 */
#include "unity.h"

#include "card/card_dialect.h"
#include "http/view/axis_availability.h"
#include "http/view/command_availability.h"
#include "http/view/mode_availability.h"
#include "unit/support/commands.h"
#include "integration/support/rig.h"
#include "interface/app/names.h"
#include "robot/app/robots.h"
#include "robot/kinematics.h"
#include "supervise/scenario/prng.h"
#include "unit/support/scenes.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define ROBOTS SCENES(16U)
#define STEPS 50U
#define BLIND_STEPS 3U /* The last ones, of every eighth scene. */
#define PICKS 4U       /* So many axes in each step. */
#define STATUSES 128U
#define PARTS_OF_AWAY 19 /* Parts of 2^30: the entry point is 56 mm before its target. */

static rig_t rig;
static rig_t next;
static rig_t trial;
static uint32_t random_state;
static bool was_said[STATUSES];

void setUp(void)
{
    random_state = 2463534242U;
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static uint32_t below(uint32_t bound)
{
    return prng_below(&random_state, bound);
}

/* Without the rows of a trajectory, which no trial changes. */
static void copy(rig_t *to, const rig_t *from)
{
    const size_t begin = offsetof(rig_t, controller.rows);
    const size_t end = begin + sizeof from->controller.rows;
    (void)memcpy(to, from, begin);
    (void)memcpy((char *)to + end, (const char *)from + end, sizeof *from - end);
}

/* Outcome of `command` in the next cycle. The page comes back for it. */
static status_t becomes(command_t command)
{
    copy(&trial, &rig);
    trial.is_page_away = false;
    return (status_t)rig_command(&trial, command).status;
}

static void expect(status_t before, status_t after, command_t command, const char *name)
{
    const status_t became = becomes(command);
    char words[128];
    (void)snprintf(words, sizeof words, "%s of %u in %s, cycle %u of %s", name,
                   (unsigned)command.as.axis.axis,
                   workphase_name((int32_t)rig.outputs.snapshot.workphase),
                   (unsigned)rig.controller.sealed.cycle, rig.robot.name);
    if ((before == after) && (became != STATUS_NO_AUTHORITY)) {
        TEST_ASSERT_EQUAL_STRING_MESSAGE(status_name((int32_t)became), status_name((int32_t)before),
                                         words);
        was_said[before] = true;
    }
}

static void compare_workphases(void)
{
    for (uint32_t i = (uint32_t)WORKPHASE_UNDEFINED + 1U; i < WORKPHASE_COUNT; i++) {
        const command_t command = {.kind = (uint32_t)COMMAND_WORKPHASE,
                                   .as.workphase = {.workphase = i}};
        expect(workphase_availability(&rig.robot, &rig.outputs.snapshot, (workphase_t)i),
               workphase_availability(&rig.robot, &next.outputs.snapshot, (workphase_t)i), command,
               workphase_name((int32_t)i));
    }
}

static status_t said_of(const rig_t *shown, mode_kind_t kind)
{
    return mode_availability(&shown->robot, &shown->outputs.snapshot, rig.controller.rows[0].ticks,
                             kind);
}

static void compare_modes(void)
{
    static const mode_kind_t kinds[] = {MODE_RETRACT, MODE_ALIGN, MODE_INSERT, MODE_TRAJECTORY,
                                        MODE_PROGRAM};
    const snapshot_t *const shown = &rig.outputs.snapshot;
    for (uint32_t i = 0U; i < (sizeof kinds / sizeof kinds[0]); i++) {
        const bool is_program = kinds[i] == MODE_PROGRAM;
        const command_t command =
            commands_of_number((command_kind_t)mode_rows[kinds[i]].command,
                               is_program ? shown->program_crc : shown->trajectory_crc);
        expect(said_of(&rig, kinds[i]), said_of(&next, kinds[i]), command,
               mode_kind_name((int32_t)kinds[i]));
    }
}

static void compare_axis(void)
{
    static const mode_kind_t kinds[] = {MODE_JOG, MODE_HOME_AXIS, MODE_VELOCITY, MODE_SWEEP};
    const mode_kind_t kind = kinds[below(4U)];
    const uint32_t axis = below(rig.robot.axis_count);
    const bool is_upwards = below(2U) == 0U;
    if (rig_position(&rig, axis) != rig_position(&next, axis)) {
        return; /* The command is for where it was. */
    }
    expect(axis_availability(&rig.robot, &rig.outputs.snapshot, kind, axis, is_upwards),
           axis_availability(&rig.robot, &next.outputs.snapshot, kind, axis, is_upwards),
           axis_availability_command(&rig.robot, &rig.outputs.snapshot, kind, axis, is_upwards),
           mode_kind_name((int32_t)kind));
}

/* Those that hang neither on their axis nor on their numbers. */
static void compare_acts(void)
{
    static const command_kind_t kinds[] = {COMMAND_CLEAR_AXIS, COMMAND_DISABLE_AXIS,
                                           COMMAND_LIST_BEGIN, COMMAND_PROGRAM_BEGIN,
                                           COMMAND_PROBE};
    for (uint32_t i = 0U; i < (sizeof kinds / sizeof kinds[0]); i++) {
        const command_kind_t kind = kinds[i];
        command_t command = {.kind = (uint32_t)kind};
        if (kind == COMMAND_PROBE) {
            command.as.probe.count = rig.robot.probe_length_count;
            (void)memcpy(command.as.probe.lengths_nm, rig.robot.probe.length_nm,
                         sizeof rig.robot.probe.length_nm);
        }
        expect(command_availability(&rig.robot, &rig.outputs.snapshot, kind),
               command_availability(&rig.robot, &next.outputs.snapshot, kind), command,
               command_kind_name((int32_t)kind));
    }
}

/* The shown facts make use of this. */
static void expect_live_cards_to_be_healthy(void)
{
    for (uint32_t i = 0U; i < rig.robot.axis_count; i++) {
        const link_t *const link = rig_link(&rig, i);
        TEST_ASSERT_TRUE((link->chart.state != CARD_LINK_STATE_LIVE) || link_is_healthy_now(link));
    }
}

static void compare(void)
{
    expect_live_cards_to_be_healthy();
    copy(&next, &rig);
    rig_cycle(&next);
    compare_workphases();
    compare_modes();
    compare_acts();
    for (uint32_t i = 0U; i < PICKS; i++) {
        compare_axis();
    }
}

/* About the middle of all ways. */
static rigid_t some_target(void)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    rigid_t pose;
    for (uint32_t i = 0U; i < rig.robot.axis_count; i++) {
        const axis_config_t *const axis = &rig.robot.axes[i];
        const int32_t span = axis->target_maximum_ticks - axis->target_minimum_ticks;
        ticks[i] = axis->target_minimum_ticks + (span / 2) + (int32_t)below((uint32_t)span / 8U);
    }
    joints_from_ticks(&rig.robot, ticks, &joints);
    kinematics_forward(&rig.robot, &rig.robot.probe, &joints, &pose);
    return pose;
}

/* Before the target, on the needle's line. */
static void send_entry(const rigid_t *target)
{
    command_t command = {.kind = (uint32_t)COMMAND_ENTRY, .as.pose = {.pose = *target}};
    command.as.pose.pose.translation.x_nm -= target->rotation_q30[0][2] / PARTS_OF_AWAY;
    command.as.pose.pose.translation.y_nm -= target->rotation_q30[1][2] / PARTS_OF_AWAY;
    command.as.pose.pose.translation.z_nm -= target->rotation_q30[2][2] / PARTS_OF_AWAY;
    (void)rig_command(&rig, command);
}

/* A program of one step, at the target. */
static void send_program(void)
{
    command_t command = {.kind = (uint32_t)COMMAND_PROGRAM_BEGIN, .as.list_begin = {.count = 1U}};
    (void)rig_command(&rig, command);
    command = (command_t){.kind = (uint32_t)COMMAND_PROGRAM_STEP, .as.step = {.dwell_ms = 100}};
    (void)memcpy(command.as.step.ticks, rig.outputs.snapshot.target_ticks,
                 sizeof command.as.step.ticks);
    (void)rig_command(&rig, command);
    command = (command_t){.kind = (uint32_t)COMMAND_PROGRAM_END,
                          .as.list = {.checksum = rig.outputs.snapshot.program_crc}};
    (void)rig_command(&rig, command);
}

/* As far as control lets it. */
static void plan(void)
{
    command_t registration = {.kind = (uint32_t)COMMAND_REGISTRATION};
    const rigid_t target = some_target();
    rigid_set_identity(&registration.as.registration.pose);
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    (void)rig_command(&rig, registration);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    if (below(2U) == 0U) {
        send_entry(&target);
    }
    (void)rig_target(&rig, &target);
    if (below(3U) == 0U) {
        send_entry(&target);
    }
    if (below(2U) == 0U) {
        send_program();
    }
    if (below(2U) == 0U) {
        (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    }
}

/* A list of one row, where the axes stand. */
static void trajectory(void)
{
    command_t command = {.kind = (uint32_t)COMMAND_LIST_BEGIN, .as.list_begin = {.count = 1U}};
    (void)rig_command(&rig, command);
    command = (command_t){.kind = (uint32_t)COMMAND_LIST_ROW};
    for (uint32_t i = 0U; i < rig.robot.axis_count; i++) {
        command.as.row.ticks[i] = rig_position(&rig, i);
    }
    (void)rig_command(&rig, command);
    command = (command_t){.kind = (uint32_t)COMMAND_LIST_END,
                          .as.list = {.checksum = rig.outputs.snapshot.trajectory_crc}};
    (void)rig_command(&rig, command);
    (void)memcpy(next.controller.rows, rig.controller.rows, sizeof rig.controller.rows);
    (void)memcpy(trial.controller.rows, rig.controller.rows, sizeof rig.controller.rows);
}

/* Something of the box, or of an axis of it. */
static void hand(void)
{
    static const char *const orders[] = {
        "pedal press",       "pedal press",      "pedal press",    "pedal release",
        "pedal release",     "pedal a close",    "pedal b open",   "estop pull",
        "estop reset",       "estop reset",      "button press",   "button release",
        "scanner on",        "scanner off",      "scanner off",    "gate stop",
        "gate off",          "card %s silent",   "card %s normal", "card %s normal",
        "card %s normal",    "card %s corrupt",  "card %s deaf",   "card %s foreign",
        "encoder %s normal", "encoder %s stuck", "motor %s runs",  "motor %s normal",
        "motor %s stuck",    "switch %s stuck",  "switch %s open", "switch %s normal"};
    char order[64];
    (void)snprintf(order, sizeof order, orders[below(sizeof orders / sizeof orders[0])],
                   rig.robot.axes[below(rig.robot.axis_count)].name);
    rig_box(&rig, order);
}

static void act(void)
{
    static const command_kind_t kinds[] = {COMMAND_CLEAR_AXIS, COMMAND_ENABLE_AXIS,
                                           COMMAND_DISABLE_AXIS, COMMAND_SET_HOME,
                                           COMMAND_HOME_AXIS};
    const uint32_t axis = below(rig.robot.axis_count);
    command_t command = commands_of_number(kinds[below(5U)], axis);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    if (below(3U) == 0U) {
        command =
            (command_t){.kind = (uint32_t)COMMAND_RESTORE, .as.positions = {.axes = 1U << axis}};
        command.as.positions.ticks[axis] = rig_position(&rig, axis);
    }
    (void)rig_command(&rig, command);
}

/* The loop comes late until it is stopped, now and then. */
static void be_late(void)
{
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, 1U + below(2U * LIMIT_OVERRUNS_IN_A_ROW));
    rig.elapsed_us = 1000U;
}

static void go_on(void)
{
    const uint32_t choice = below(24U);
    if (choice < 8U) {
        (void)rig_workphase(&rig, (workphase_t)(1U + below(WORKPHASE_COUNT - 1U)));
    } else if (choice < 11U) {
        plan();
    } else if (choice == 11U) {
        trajectory();
    } else if (choice == 12U) {
        rig.unfit = (rig.unfit == 0U) ? below(2U) : 0U;
        rig.lacks_black_box = below(2U);
    } else if (choice == 13U) {
        be_late();
    } else if (choice == 14U) {
        rig.is_page_away = !rig.is_page_away;
    } else if (choice < 17U) {
        act();
    } else {
        hand();
    }
    rig_cycles(&rig, 1U + below((below(6U) == 0U) ? 2000U : 100U));
    rig_forget(&rig);
}

/* A row of the table, or its geometry. */
static void damage_table(void)
{
    rig.robot.axes[below(rig.robot.axis_count)].deadband_ticks ^= 1;
    rig_cycle(&rig);
}

static void play(const robot_t *robot, uint32_t scene)
{
    if (below(3U) == 0U) {
        rig_start_robot(&rig, robot);
    } else {
        rig_start_robot_homed(&rig, robot);
    }
    next = rig;
    trial = rig;
    for (uint32_t i = 0U; i < STEPS; i++) {
        const bool is_to_be_blind = ((scene % 8U) == 7U) && (i == (STEPS - BLIND_STEPS));
        go_on();
        if (is_to_be_blind) {
            damage_table();
        }
        compare();
    }
}

static void play_all(const char *name)
{
    (void)memset(was_said, 0, sizeof was_said);
    for (uint32_t i = 0U; i < ROBOTS; i++) {
        play(robots_find(name), i);
    }
}

static void expect_said(const status_t *statuses, uint32_t count)
{
    for (uint32_t i = 0U; ARE_SCENES_WHOLE && (i < count); i++) {
        TEST_ASSERT_TRUE_MESSAGE(was_said[statuses[i]], status_name((int32_t)statuses[i]));
    }
}

void test_SWR_MODE_004_what_is_said_is_what_becomes_of_it_wherever_chance_leads_the_neuro(void)
{
    static const status_t statuses[] = {STATUS_OK,
                                        STATUS_WRONG_WORKPHASE,
                                        STATUS_HARDWARE_NOT_READY,
                                        STATUS_NOT_HOMED,
                                        STATUS_CONFIRM_POSITIONS,
                                        STATUS_FAULT_PRESENT,
                                        STATUS_NO_TARGET,
                                        STATUS_NOT_REGISTERED,
                                        STATUS_NO_ENTRY_POINT,
                                        STATUS_NOT_AT_REST,
                                        STATUS_MOTION_ARMED,
                                        STATUS_COMPUTER_UNFIT,
                                        STATUS_NO_BLACK_BOX,
                                        STATUS_NOT_ALIGNED,
                                        STATUS_PROGRAM_OTHER,
                                        STATUS_TRAJECTORY_EMPTY,
                                        STATUS_MEMORY_DAMAGED};
    play_all("neuro");
    expect_said(statuses, sizeof statuses / sizeof statuses[0]);
}

void test_SWR_MODE_010_what_is_said_is_what_becomes_of_it_wherever_chance_leads_the_prostate(void)
{
    static const status_t statuses[] = {STATUS_OK, STATUS_HARDWARE_NOT_READY, STATUS_FAULT_PRESENT,
                                        STATUS_COMPUTER_UNFIT, STATUS_MEMORY_DAMAGED};
    play_all("prostate");
    expect_said(statuses, sizeof statuses / sizeof statuses[0]);
}

void test_SWR_MODE_010_a_card_that_was_lost_and_answers_again_may_be_started_up(void)
{
    const robot_t *const robot = robots_find("neuro");
    rig_start_robot_homed(&rig, robot);
    rig_box(&rig, "card pitch silent");
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(
        STATUS_HARDWARE_NOT_READY,
        workphase_availability(robot, &rig.outputs.snapshot, WORKPHASE_START_UP));
    rig_box(&rig, "card pitch normal");
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(
        STATUS_OK, workphase_availability(robot, &rig.outputs.snapshot, WORKPHASE_START_UP));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
}

/* The way of an entry point to a straight needle, with a program for it or not. */
static void aim(int32_t y_nm, bool has_program)
{
    const rigid_t target = rig_pose(5000000, y_nm, 60000000);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    send_entry(&target);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &target).status);
    if (has_program) {
        send_program();
        TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.program_steps);
    }
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
}

void test_SWR_MODE_004_a_program_for_another_target_is_named(void)
{
    rig_start_targeted(&rig);
    aim(190000000, true);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_ALIGNED, said_of(&rig, MODE_PROGRAM));
    aim(185000000, false);
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROGRAM_OTHER, said_of(&rig, MODE_PROGRAM));
    const command_t command = {.kind = (uint32_t)COMMAND_RUN_PROGRAM,
                               .as.list = {.checksum = rig.outputs.snapshot.program_crc}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROGRAM_OTHER, rig_command(&rig, command).status);
}

void test_SWR_MODE_010_cards_of_another_dialect_change_nothing_of_what_is_said(void)
{
    rig_start_robot_homed(&rig, robots_find("neuro"));
    next = rig;
    trial = rig;
    for (uint32_t i = 0U; i < STEPS; i++) {
        rig.dialect = ((i % 8U) < 4U) ? (uint32_t)CARD_DIALECT_AIM32 : (uint32_t)CARD_DIALECT_OWN;
        rig.is_dialect_accepted = i % 2U;
        go_on();
        compare();
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * bench-samples: plays one scene with the real controller on the simulated control box, in
 * simulated time, and keeps single cycles of it. The same bytes on every run.
 *
 *     bench-samples SAMPLES ROBOT [hand|sensorless]
 *
 * The NeuroRobot is seen from its start on. Any other robot has been homed before: it goes to a
 * target, retracts, and, where an axis has waves, is swept. With `hand` it rests, and a hand and
 * then the robot alone insert its needle; with `sensorless` it rests in the same way, and its file
 * names no force sensor.
 *
 * Kept is every SAMPLES_DISTANCE-th cycle and every one with a command, an answer or an event.
 * Standard output has one line for each, tabulated: "even" or "extra", cycle, the mode that the
 * robot moves in, what happened.
 */
#include "base/contract.h"
#include "bench/sample.h"
#include "integration/support/rig.h"
#include "interface/app/names.h"
#include "robot/app/robot_names.h"
#include "robot/app/robots.h"
#include "robot/joints.h"
#include "robot/kinematics.h"

#include "unity.h"
#include "unit/support/commands.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SAMPLES_DISTANCE 101U /* No multiple of the slots, which have their turns. */
#define LONGEST_WAIT_CYCLES 150000U
#define ENTRY_Z_NM 90000000
#define HAND_WAY_NM 20000000
#define HAND_OFF_CYCLES 200U
#define HAND_PUSH_CYCLES 4000U
#define REST_CYCLES 4000U

static FILE *file;
static const robot_t *robot;
static rig_t rig;
static sample_t sample;
static samples_header_t samples = {.magic = SAMPLES_MAGIC,
                                   .sample_size = sizeof(sample_t),
                                   .controller_size = CONTROLLER_CHECKPOINT_BYTES,
                                   .inputs_size = sizeof(controller_inputs_t),
                                   .outputs_size = sizeof(controller_outputs_t)};

void setUp(void)
{
}

void tearDown(void)
{
}

static void fail(const char *sentence)
{
    (void)fprintf(stderr, "Cycle %" PRIu32 ": %s.\n", rig.controller.sealed.cycle, sentence);
    _Exit(EXIT_FAILURE);
}

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "Contract %s/%" PRIu32 " is broken.\n", module, id);
    fail("a contract is broken");
}

/* Names what happened in the cycle, commands first. */
static void print_label(void)
{
    for (uint32_t i = 0U; i < sample.inputs.command_count; i++) {
        const command_t *const command = &sample.inputs.commands[i];
        const bool names_workphase = command->kind == (uint32_t)COMMAND_WORKPHASE;
        (void)printf("%s%s%s", (i > 0U) ? ", " : "", command_kind_name((int32_t)command->kind),
                     names_workphase ? " " : "");
        (void)printf(
            "%s", names_workphase ? workphase_name((int32_t)command->as.workphase.workphase) : "");
    }
    if (sample.inputs.command_count == 0U) {
        for (uint32_t i = 0U; i < sample.outputs.event_count; i++) {
            (void)printf("%s%s", (i > 0U) ? ", " : "",
                         event_id_name((int32_t)sample.outputs.events[i].id));
        }
    }
    (void)putchar('\n');
}

static const char *moving_mode(void)
{
    const snapshot_t *const shown = &sample.outputs.snapshot;
    return (shown->order == (uint32_t)ARMING_STATE_MOVING) ? mode_kind_name((int32_t)shown->mode)
                                                           : "NONE";
}

static void keep(void)
{
    const bool is_even = (sample.cycle % SAMPLES_DISTANCE) == 0U;
    const bool is_extra = (sample.inputs.command_count + sample.outputs.answer_count +
                           sample.outputs.event_count) > 0U;
    if (!is_even && !is_extra) {
        return;
    }
    samples.count++;
    (void)printf("%s\t%" PRIu32 "\t%s\t", is_even ? "even" : "extra", sample.cycle, moving_mode());
    print_label();
    if (fwrite(&sample, sizeof(sample), 1U, file) != 1U) {
        fail("the sample cannot be written");
    }
}

static void cycles(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        sample.cycle = rig.controller.sealed.cycle;
        (void)memcpy(sample.before, &rig.controller, sizeof sample.before);
        rig_cycle(&rig);
        sample.inputs = rig.inputs;
        sample.outputs = rig.outputs;
        keep();
    }
}

static void order(const char *line)
{
    rig_box(&rig, line);
    cycles(20U);
}

static void say(command_t command)
{
    rig.commands[rig.command_count] = command;
    rig.command_count++;
}

static void say_phase(workphase_t workphase)
{
    say((command_t){.kind = (uint32_t)COMMAND_WORKPHASE,
                    .as.workphase = {.workphase = (uint32_t)workphase}});
    cycles(1U);
}

static void say_pose(command_kind_t kind, const rigid_t *pose)
{
    say(commands_of_pose(kind, *pose));
    cycles(1U);
}

static void say_point(command_kind_t kind, point_t point)
{
    say_pose(kind, &(rigid_t){.translation = point});
}

static void finish(void)
{
    const uint32_t before = rig.answer_count;
    for (uint32_t i = 0U; rig.answer_count == before; i++) {
        if (i == LONGEST_WAIT_CYCLES) {
            fail("the order does not end");
        }
        cycles(1U);
    }
}

static void start_up(void)
{
    say_phase(WORKPHASE_START_UP);
    order("pedal press");
    finish();
    order("pedal release");
}

/* A needle that is turned about all axes. */
static rigid_t oblique(void)
{
    return (rigid_t){
        .rotation_q30 = {{-772375762, -637529041, -387184994},
                         {-80356690, 625246086, -869214385},
                         {741547560, -596277310, -497470048}},
        .translation = {.x_nm = 11173943, .y_nm = 225277747, .z_nm = 66443691},
    };
}

static void plan(void)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    say_phase(WORKPHASE_PLANNING);
    say_point(COMMAND_PROPOSE_ENTRY, (point_t){11000000, 250000000, 90000000});
    say_point(COMMAND_PROPOSE_TARGET, (point_t){11000000, 190000000, 66000000});
    say_pose(COMMAND_PROPOSE_REGISTRATION, &identity);
    say_phase(WORKPHASE_CALIBRATION);
    say_pose(COMMAND_REGISTRATION, &identity);
    say_phase(WORKPHASE_TARGETING);
}

/* Beyond reach, at its border and within, then with an entry point, then four words in a cycle. */
static void target(void)
{
    rigid_t pose = oblique();
    pose.translation.y_nm = 300000000;
    say_pose(COMMAND_TARGET, &pose);
    pose.translation.y_nm = 245277747;
    say_pose(COMMAND_TARGET, &pose);
    for (int32_t i = 0; i < 8; i++) {
        pose = rig_pose((i - 4) * 4000000, 178000000 + (i * 3000000), 45000000 + (i * 4000000));
        say_pose(COMMAND_TARGET, &pose);
    }
    pose = oblique();
    say_pose(COMMAND_TARGET, &pose);
    pose = rig_pose(5000000, 190000000, 60000000);
    say_point(COMMAND_ENTRY, (point_t){5000000, 255000000, 60000000});
    for (uint32_t i = 1U; i < CONTROLLER_COMMANDS; i++) {
        say((command_t){.kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = i}});
    }
    say_pose(COMMAND_TARGET, &pose);
    if (rig.controller.plan.has_target == 0U) {
        fail("the last target is refused");
    }
}

/* A move that is interrupted by the pedal and by the scanner. */
static void move(void)
{
    say_phase(WORKPHASE_MOVE_TO_TARGET);
    order("pedal press");
    cycles(1500U);
    order("pedal release");
    order("pedal press");
    cycles(500U);
    order("scanner on");
    cycles(100U);
    order("scanner off");
    order("pedal release");
    order("pedal press");
    finish();
    order("pedal release");
}

/* All that goes wrong at once. */
static void lose(void)
{
    say_phase(WORKPHASE_TARGETING);
    say_phase(WORKPHASE_MOVE_TO_TARGET);
    order("pedal press");
    cycles(200U);
    order("estop pull");
    order("estop reset");
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        char line[64];
        (void)snprintf(line, sizeof line, "card %s silent", robot->axes[i].name);
        rig_box(&rig, line);
    }
    cycles(200U);
}

/* Where a share of the ways of all axes leads. */
static rigid_t pose_at(int32_t part, int32_t parts)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    rigid_t pose;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const axis = &robot->axes[i];
        const int32_t span = axis->target_maximum_ticks - axis->target_minimum_ticks;
        ticks[i] = axis->target_minimum_ticks + (span / parts * part);
    }
    joints_from_ticks(robot, ticks, &joints);
    kinematics_forward(robot, &robot->probe, &joints, &pose);
    return pose;
}

static void aim(void)
{
    say_phase(WORKPHASE_TARGETING);
    for (int32_t i = 1; i <= 8; i++) {
        const rigid_t pose = pose_at(i, 9);
        say_pose(COMMAND_TARGET, &pose);
    }
    const rigid_t middle = pose_at(1, 2);
    say_pose(COMMAND_TARGET, &middle);
    if (rig.controller.plan.has_target == 0U) {
        fail("the last target is refused");
    }
}

static void retract(void)
{
    say((command_t){.kind = (uint32_t)COMMAND_RETRACT});
    cycles(1U);
    order("pedal press");
    finish();
    order("pedal release");
}

/* A position in doubt after a sweep is right. */
static void confirm(void)
{
    say_phase(WORKPHASE_STOP);
    order("button press");
    cycles((LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 2U);
    order("button release");
    cycles(2U);
}

/* Into the second run of the search. */
static void sweep(void)
{
    say_phase(WORKPHASE_MANUAL);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (robot->axes[i].card_type == (uint8_t)CARD_TYPE_HIGH_FREQUENCY) {
            say((command_t){.kind = (uint32_t)COMMAND_SWEEP,
                            .as.sweep = {.axis = i, .is_free = 1}});
            cycles(1U);
            order("pedal press");
            cycles(8000U);
            order("pedal release");
        }
    }
}

static void play_neuro(void)
{
    box_init(&rig.box, robot, 1U);
    rig.robot = *robot;
    controller_init(&rig.controller, &rig.robot);
    rig.elapsed_us = LIMIT_CYCLE_US;
    cycles(50U);
    start_up();
    plan();
    target();
    move();
    lose();
}

static void play_homed(void)
{
    const rigid_t middle = pose_at(1, 2);
    rig_start_robot_targeted(&rig, robot, &middle);
    cycles(50U);
    aim();
    move();
    retract();
    sweep();
    confirm();
    aim();
    lose();
}

/* The base stands at the target, the needle out. */
static void align_by_hand(void)
{
    rigid_t pose;
    rigid_set_identity(&pose);
    pose.translation = (point_t){5000000, -10000000, ENTRY_Z_NM};
    rigid_t target_pose = pose;
    target_pose.translation.z_nm = ENTRY_Z_NM + HAND_WAY_NM;
    rig_start_robot_targeted(&rig, robot, &target_pose);
    say_pose(COMMAND_ENTRY, &pose);
    say_pose(COMMAND_TARGET, &target_pose);
    say((command_t){.kind = (uint32_t)COMMAND_ALIGN});
    cycles(1U);
    order("pedal press");
    finish();
    order("pedal release");
}

/* Pushed for a part of its way by a hand, the needle goes the rest by the robot alone. */
static void insert(void)
{
    say_phase(WORKPHASE_MOVE_TO_TARGET);
    cycles(HAND_OFF_CYCLES);
    say((command_t){.kind = (uint32_t)COMMAND_COOPERATE});
    cycles(1U);
    order("pedal press");
    order("grip 1000");
    order("hand press");
    cycles(HAND_PUSH_CYCLES);
    order("hand release");
    cycles(HAND_OFF_CYCLES);
    order("pedal release");
    say_phase(WORKPHASE_MOVE_TO_TARGET);
    order("pedal press");
    finish();
    order("pedal release");
}

static void play_by_hand(bool is_with_hand)
{
    align_by_hand();
    cycles(REST_CYCLES);
    if (is_with_hand) {
        say((command_t){.kind = (uint32_t)COMMAND_ZERO_FORCE,
                        .source = (uint32_t)COMMAND_SOURCE_HTTP,
                        .peer = RIG_PAGE});
        cycles(LIMIT_FORCE_ZERO_CYCLES + 1U);
        insert();
    }
}

int main(int count, char **arguments)
{
    const char *const play = (count == 4) ? arguments[3] : "";
    robot = ((count == 3) || (count == 4)) ? robots_find(arguments[2]) : NULL;
    file = (robot != NULL) ? fopen(arguments[1], "wb") : NULL;
    if (file == NULL) {
        (void)fprintf(stderr, "usage: bench-samples SAMPLES ROBOT [hand|sensorless]\nrobots: %s\n",
                      robot_names_list());
        return EXIT_FAILURE;
    }
    UnityBegin("samples.c");
    samples.robot_crc = robot->crc;
    samples.is_sensorless = (strcmp(play, "sensorless") == 0) ? 1U : 0U;
    robot = sample_robot(robot, samples.is_sensorless != 0U);
    (void)snprintf(samples.robot, sizeof samples.robot, "%s", robot->name);
    if (fwrite(&samples, sizeof(samples), 1U, file) != 1U) {
        fail("the header cannot be written");
    }
    if (*play != '\0') {
        play_by_hand(strcmp(play, "hand") == 0);
    } else if (strcmp(robot->name, "neuro") == 0) {
        play_neuro();
    } else {
        play_homed();
    }
    const bool is_written =
        (fseek(file, 0L, SEEK_SET) == 0) && (fwrite(&samples, sizeof(samples), 1U, file) == 1U);
    return ((fclose(file) == 0) && is_written) ? EXIT_SUCCESS : EXIT_FAILURE;
}

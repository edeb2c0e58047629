/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/stage.h"

#include "charts/arming_chart.h"
#include "limits/requirement_limits.h"
#include "robot/kinematics.h"
#include "supervise/acts.h"
#include "supervise/chance.h"
#include "supervise/targets.h"

#include <math.h>

#include <stdio.h>
#include <string.h>

#define ORDER_SIZE 64U
#define ORDERS_MOST 32U
#define SHARE_STEPS 1000000U
#define RISE_SPREAD 0.1
#define BEFORE_NM 20000000     /* Of the target, on the needle's line. */
#define DEAD_ZONE_SPREAD 0.005 /* Of all words. */
#define OTHER_PARTS 6U         /* One of so many orders is not of the theme of the play. */
#define BREAK_PARTS 40000U     /* In one of so many cycles of motion something breaks... */
#define BREAK_LATE_PARTS 3000U /* The same where time is the enemy... */
#define REPAIR_CYCLES 6000U    /* ...and is repaired after these at the latest. */
#define GATE_CYCLES 900U
#define NEEDLE_PARTS 12    /* Of its way, the needle goes in before a sweep. */
#define SWEEP_PATIENCE 32U /* A sweep is given so much longer than any other order. */

static uint32_t random_below(stage_t *self, uint32_t bound)
{
    return chance_below(&self->random, bound);
}

static void start_targeted(const stage_t *self, rig_t *rig)
{
    const rigid_t pose = targets_first(self->robot);
    rig_start_robot_targeted(rig, self->robot, &pose);
}

static void set_random_scene(stage_t *self, rig_t *rig)
{
    const uint32_t start = random_below(self, 4U);
    if (start == 0U) {
        rig_start_robot(rig, self->robot);
    } else if (start == 1U) {
        rig_start_robot_homed(rig, self->robot);
    } else {
        start_targeted(self, rig);
    }
    if (self->play == PLAY_JOGS) {
        self->is_chaotic = 1U;
        return;
    }
    self->is_chaotic = (random_below(self, 3U) == 0U) ? 1U : 0U;
    if (self->play == PLAY_RIVALS) {
        return;
    }
    self->fault_cycle = (random_below(self, 5U) == 0U) ? UINT32_MAX : random_below(self, 12000U);
}

/* Anywhere within `part` of one. */
static double near_one(stage_t *self, double part)
{
    const double share = (double)random_below(self, SHARE_STEPS + 1U) / SHARE_STEPS;
    return 1.0 - part + (2.0 * part * share);
}

/* Other motors: full speed, time of gaining it, and the smallest word that turns them. */
static void spread_motors(stage_t *self, rig_t *rig)
{
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        sim_motor_t *const motor = &rig->box.axes[i].motor;
        const double span = motor->maximum_duty - motor->minimum_duty;
        motor->full_speed_ticks_per_s *= near_one(self, LIMIT_MOTOR_SPREAD_PERCENT / 100.0);
        motor->rise_share *= near_one(self, RISE_SPREAD);
        motor->minimum_duty += span * (near_one(self, DEAD_ZONE_SPREAD) - 1.0);
    }
}

static void begin_late(stage_t *self, rig_t *rig, uint32_t seed)
{
    if ((seed % 3U) == 0U) {
        rig_start_robot(rig, self->robot);
    } else {
        start_targeted(self, rig);
    }
    lateness_begin(&self->lateness, rig, seed);
}

void stage_begin(stage_t *self, rig_t *rig, const robot_t *robot, play_t play, uint32_t seed)
{
    *self = (stage_t){.play = play,
                      .random = (seed * 2654435761U) | 1U,
                      .whim = (seed * 3266489917U) | 1U,
                      .fault_cycle = UINT32_MAX,
                      .robot = robot};
    const bool is_of_faults = (play_theme(play) != COMMAND_NONE) || (play == PLAY_LATE);
    self->is_brittle = (is_of_faults && ((seed % 2U) == 0U)) ? 1U : 0U;
    self->wish = (play == PLAY_SWEEPS) ? (uint32_t)WORKPHASE_MANUAL : 0U;
    watcher_begin(&self->watcher, seed);
    for (uint32_t i = 0U; i < 8U; i++) {
        (void)random_below(self, 2U);
    }
    if ((play == PLAY_RANDOM) || (play == PLAY_JOGS)) {
        set_random_scene(self, rig);
    } else if (play == PLAY_RIVALS) {
        set_random_scene(self, rig);
        rivals_begin(&self->rivals, rig, seed);
    } else if (play == PLAY_SPREAD) {
        rig_start_robot(rig, robot);
        spread_motors(self, rig);
    } else if (play == PLAY_MAGNITUDE) {
        rig_set_magnitude_robot(&self->magnitude_robot, robot);
        rig_start_robot(rig, &self->magnitude_robot);
        spread_motors(self, rig);
    } else if (play == PLAY_TAPS) {
        foe_begin(&self->foe, rig, robot, seed);
    } else if (play == PLAY_LATE) {
        begin_late(self, rig, seed);
    } else {
        start_targeted(self, rig);
    }
}

bool stage_is_disturbed(const stage_t *self)
{
    return (self->has_fault != 0U) || (self->play == PLAY_LATE);
}

bool stage_is_sound(const stage_t *self)
{
    return self->has_fault == 0U;
}

/* One of the words between bars: "silent|corrupt|normal". */
static void pick_word(stage_t *self, const char *words, size_t length, char *picked)
{
    uint32_t count = 1U;
    for (size_t i = 0U; i < length; i++) {
        count += (words[i] == '|') ? 1U : 0U;
    }
    uint32_t left = random_below(self, count);
    size_t begin = 0U;
    for (; left > 0U; begin++) {
        left -= (words[begin] == '|') ? 1U : 0U;
    }
    size_t end = begin;
    while ((end < length) && (words[end] != '|')) {
        end++;
    }
    (void)snprintf(picked, ORDER_SIZE, "%.*s", (int)(end - begin), &words[begin]);
}

static bool begins_with(const char *line, const char *word)
{
    return strncmp(line, word, strlen(word)) == 0;
}

static bool ends_with(const char *line, const char *word)
{
    const size_t length = strcspn(line, "\n");
    return (length >= strlen(word)) && begins_with(&line[length - strlen(word)], word);
}

/* To be drawn by lot: what disturbs. By where the axes are the witness would take a hand for a
 * drive. Who holds from afar is waited for in the world's time, of which a scene has none. */
static bool is_disturbance(const char *line)
{
    return !begins_with(line, "show") && !begins_with(line, "probe ") &&
           !begins_with(line, "push ") && !ends_with(line, " WHO");
}

/* Any such order that the box knows, whatever its list says today. */
static void disturb(stage_t *self, rig_t *rig)
{
    const char *lines[ORDERS_MOST];
    uint32_t count = 0U;
    for (const char *line = box_orders(); (*line != '\0') && (count < ORDERS_MOST);
         line = strchr(line, '\n') + 1) {
        if (is_disturbance(line)) {
            lines[count] = line;
            count++;
        }
    }
    const char *const line = lines[random_below(self, count)];
    char order[ORDER_SIZE * 3U] = "";
    for (const char *word = line; *word != '\n';) {
        const size_t length = strcspn(word, " \n");
        char picked[ORDER_SIZE];
        pick_word(self, word, length, picked);
        if (strcmp(picked, "SLOT") == 0) {
            (void)snprintf(picked, sizeof picked, "%s",
                           self->robot->axes[random_below(self, self->robot->axis_count)].name);
        }
        (void)snprintf(order + strlen(order), sizeof order - strlen(order), "%s%s",
                       (word == line) ? "" : " ", picked);
        word += length;
        word += (*word == ' ') ? 1U : 0U;
    }
    rig_box(rig, order);
}

/* A motor that runs by itself and an encoder that counts nothing hide each other from whoever sees
 * no more than the frames: two faults, which no supervision can tell from rest. */
static void part_hidden_pairs(rig_t *rig)
{
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        box_axis_t *const axis = &rig->box.axes[i];
        if ((axis->encoder.fault == SIM_ENCODER_STUCK) && (axis->motor.fault == SIM_MOTOR_RUNS)) {
            axis->motor.fault = SIM_MOTOR_NORMAL;
        }
    }
}

static void send(stage_t *self, rig_t *rig, command_t command)
{
    command.id = 1000U + self->cycle;
    if (self->play == PLAY_RIVALS) {
        rivals_sign(&self->rivals, rig, &command);
    }
    rig->commands[rig->command_count] = command;
    rig->command_count++;
}

static void send_phase(stage_t *self, rig_t *rig, workphase_t phase)
{
    send(self, rig, (command_t){.kind = (uint32_t)COMMAND_WORKPHASE, .argument = (uint32_t)phase});
}

static rigid_t some_target(stage_t *self)
{
    const bool is_near = (self->play == PLAY_TAPS) && (self->foe.wish == FOE_ASKS_NEAR);
    return is_near ? targets_near(self->robot, &self->random)
                   : targets_any(self->robot, &self->random);
}

/* An end of the way, or anywhere on it. */
static int32_t some_end(stage_t *self, const axis_config_t *axis)
{
    const int32_t span = axis->target_maximum_ticks - axis->target_minimum_ticks;
    int32_t ticks = axis->target_minimum_ticks;
    switch (random_below(self, 4U)) {
    case 0:
        break;
    case 1:
        ticks = axis->target_maximum_ticks;
        break;
    case 2:
        ticks = axis->home_ticks + (int32_t)random_below(self, 21U) - 10;
        break;
    default:
        ticks += (int32_t)random_below(self, (uint32_t)span);
        break;
    }
    return ticks;
}

/* A target with some axes at an end of their way, and the entry point that decides its depth. */
static void send_corner(stage_t *self, rig_t *rig)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    command_t target = {.kind = (uint32_t)COMMAND_TARGET};
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY};
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        ticks[i] = some_end(self, &self->robot->axes[i]);
    }
    joints_from_ticks(self->robot, ticks, &joints);
    kinematics_forward(self->robot, &self->robot->probe, &joints, &target.pose);
    rigid_set_identity(&entry.pose);
    if (targets_entry(self->robot, &joints, &target.pose, &entry.pose.translation)) {
        send(self, rig, entry);
    } else if (play_is_of_orders(self->play)) {
        const point_t before = {0, 0, -BEFORE_NM};
        entry.pose.translation = rigid_apply(&target.pose, &before);
        send(self, rig, entry);
    } else {
        /* It is asked for none. */
    }
    send(self, rig, target);
}

static void send_target(stage_t *self, rig_t *rig)
{
    if ((self->play == PLAY_CORNERS) || play_is_of_orders(self->play)) {
        send_corner(self, rig);
    } else {
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_TARGET, .pose = some_target(self)});
    }
}

/* Anywhere, or near where the axis stands, as one that is not homed is jogged. */
static void send_jog(stage_t *self, rig_t *rig)
{
    command_t command = {.kind = (uint32_t)COMMAND_JOG,
                         .argument = random_below(self, self->robot->axis_count)};
    const axis_config_t *const axis = &self->robot->axes[command.argument];
    const int32_t span = axis->maximum_ticks - axis->minimum_ticks;
    if (random_below(self, 2U) == 0U) {
        command.value = axis->minimum_ticks + (int32_t)random_below(self, (uint32_t)span);
    } else {
        command.value = rig->outputs.snapshot.axes[command.argument].position_ticks - (span / 20) +
                        (int32_t)random_below(self, (uint32_t)span / 10U);
    }
    send(self, rig, command);
}

/* In one of so many cases. */
static bool has_whim(stage_t *self, uint32_t bound)
{
    return chance_below(&self->whim, bound) == 0U;
}

/* One of the acts for a single axis; who has asked for a press gives it, if what is shown is true.
 */
static void send_act(stage_t *self, rig_t *rig)
{
    const command_t command = acts_choose(rig, &self->whim);
    send(self, rig, command);
    if ((command.kind == (uint32_t)COMMAND_CONFIRM_AXIS) && acts_is_shown_true(rig)) {
        rig_box(rig, "button press");
        self->wait_cycles = 2U * (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US);
    }
}

/* Another probe, or lengths that none has: each up to a tenth of its range from the file's. */
static void send_probe(stage_t *self, rig_t *rig)
{
    const robot_t *const robot = self->robot;
    command_t command = {.kind = (uint32_t)COMMAND_PROBE, .argument = robot->probe_length_count};
    for (uint32_t i = 0U; i < robot->probe_length_count; i++) {
        const int32_t range_nm =
            robot->probe_maximum.length_nm[i] - robot->probe_minimum.length_nm[i];
        command.ticks[i] = robot->probe.length_nm[i] - (range_nm / 10) +
                           (int32_t)chance_below(&self->whim, (uint32_t)(range_nm / 5) + 1U);
    }
    send(self, rig, command);
}

/* Of any mode, mostly that of the play; WORKPHASE_COUNT: wherever it is. */
static void send_order(stage_t *self, rig_t *rig, workphase_t phase)
{
    const command_kind_t theme = play_theme(self->play);
    const bool is_of_theme = (theme != COMMAND_NONE) && !has_whim(self, OTHER_PARTS);
    const orders_wish_t wish = {phase, is_of_theme ? theme : COMMAND_NONE};
    command_t command;
    if (orders_choose(&self->orders, rig, wish, &self->whim, &command)) {
        send(self, rig, command);
    }
}

/* At the target, on the way there, or while it is drawn out already. */
static bool wants_out(stage_t *self, const snapshot_t *shown)
{
    const bool is_there = shown->next_step == (uint32_t)NEXT_STEP_NOTHING;
    return (shown->workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET) &&
           has_whim(self, is_there ? 3U : 40U);
}

/* Positions that somebody has saved: where the axes are, or anywhere. */
static void send_saved(stage_t *self, rig_t *rig)
{
    const bool is_true = !has_whim(self, 8U);
    const uint32_t axes = ((uint32_t)1U << self->robot->axis_count) - 1U;
    command_t command = {.kind = (uint32_t)COMMAND_RESTORE,
                         .argument = 1U + chance_below(&self->whim, axes)};
    double truth[ROBOT_AXIS_MAX];
    box_true_positions(&rig->box, truth);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const axis_config_t *const axis = &self->robot->axes[i];
        const uint32_t span = (uint32_t)(axis->maximum_ticks - axis->minimum_ticks);
        command.ticks[i] = is_true
                               ? (int32_t)lround(truth[i])
                               : (axis->minimum_ticks + (int32_t)chance_below(&self->whim, span));
    }
    self->has_fault = is_true ? self->has_fault : 1U;
    send(self, rig, command);
}

static void do_anything(stage_t *self, rig_t *rig)
{
    switch (random_below(self, 6U)) {
    case 0:
        send_phase(self, rig, (workphase_t)(1U + random_below(self, 8U)));
        break;
    case 1:
        send_jog(self, rig);
        break;
    case 2:
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_TARGET, .pose = some_target(self)});
        break;
    case 3:
        rig_box(rig, "pedal press");
        break;
    case 4:
        rig_box(rig, (random_below(self, 2U) == 0U) ? "pedal release" : "estop reset");
        break;
    default:
        send_phase(self, rig, WORKPHASE_MOVE_TO_TARGET);
        break;
    }
    if (has_whim(self, 8U)) {
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
    } else if (has_whim(self, 8U)) {
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_ACCEPT_ENTRY});
    } else if (has_whim(self, 8U)) {
        send_saved(self, rig);
    } else if (has_whim(self, 8U)) {
        send_act(self, rig);
    } else if (has_whim(self, 16U)) {
        send_probe(self, rig);
    } else if (has_whim(self, 4U)) {
        send_order(self, rig, WORKPHASE_COUNT);
    } else {
        /* None of these. */
    }
}

static void send_jog_or_act(stage_t *self, rig_t *rig)
{
    if (has_whim(self, 6U)) {
        send_act(self, rig);
    } else if (has_whim(self, 6U)) {
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
    } else if (has_whim(self, 4U)) {
        send_order(self, rig, WORKPHASE_MANUAL);
    } else {
        send_jog(self, rig);
    }
}

/* One jog after the other, each under a pedal that is pressed anew and sometimes released. */
static void do_jog(stage_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    if ((shown->workphase == (uint32_t)WORKPHASE_UNDEFINED) ||
        (shown->workphase == (uint32_t)WORKPHASE_EMERGENCY)) {
        send_phase(self, rig, WORKPHASE_START_UP);
    } else if (shown->workphase != (uint32_t)WORKPHASE_MANUAL) {
        send_phase(self, rig, WORKPHASE_MANUAL);
    } else if (shown->order == (uint32_t)ARMING_STATE_NONE) {
        rig_box(rig, "pedal release");
        send_jog_or_act(self, rig);
    } else if (shown->order == (uint32_t)ARMING_STATE_WAITING) {
        rig_box(rig, "pedal press");
    } else if (random_below(self, 4U) == 0U) {
        rig_box(rig, "pedal release");
    } else {
        /* It goes on. */
    }
}

static void send_target_or_phase(stage_t *self, rig_t *rig)
{
    if (rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_TARGETING) {
        self->wants_target = 0U;
        send_target(self, rig);
    } else {
        send_phase(self, rig, WORKPHASE_TARGETING);
    }
}

/* An operator who sees another place than is shown lets go, and homes again if that is allowed. */
static void confirm(stage_t *self, rig_t *rig)
{
    if (acts_is_shown_true(rig)) {
        rig_box(rig, "button press");
        self->wait_cycles += (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US);
    } else {
        send_phase(self, rig, WORKPHASE_START_UP);
    }
}

/* What the console asks for. */
static void do_next_step(stage_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    if (wants_out(self, shown)) {
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
        return;
    }
    switch (shown->next_step) {
    case NEXT_STEP_RELEASE_ESTOP:
        rig_box(rig, "estop reset");
        break;
    case NEXT_STEP_RELEASE_PEDAL:
        rig_box(rig, "pedal release");
        break;
    case NEXT_STEP_PRESS_PEDAL:
        rig_box(rig, "pedal press");
        break;
    case NEXT_STEP_SCANNER:
        rig_box(rig, "scanner off");
        break;
    case NEXT_STEP_PLANNING:
        send_phase(self, rig, WORKPHASE_PLANNING);
        break;
    case NEXT_STEP_CALIBRATION:
    case NEXT_STEP_REGISTER:
        send_phase(self, rig, WORKPHASE_CALIBRATION);
        if (shown->workphase == (uint32_t)WORKPHASE_CALIBRATION) {
            command_t command = {.kind = (uint32_t)COMMAND_REGISTRATION};
            rigid_set_identity(&command.pose);
            send(self, rig, command);
        }
        break;
    case NEXT_STEP_NOTHING:
    case NEXT_STEP_PROGRAM_DONE:
        self->wants_target = 1U;
        send_phase(self, rig, WORKPHASE_TARGETING);
        break;
    case NEXT_STEP_TARGETING:
        send_phase(self, rig, WORKPHASE_TARGETING);
        break;
    case NEXT_STEP_MANUAL:
        send_phase(self, rig, WORKPHASE_MANUAL);
        break;
    case NEXT_STEP_RETRACT:
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
        break;
    case NEXT_STEP_DRAPING:
        send(self, rig,
             (command_t){.kind = (uint32_t)COMMAND_POSE, .argument = (uint32_t)POSE_DRAPING});
        break;
    case NEXT_STEP_PROBE:
        if (has_whim(self, 3U)) {
            send_phase(self, rig, WORKPHASE_START_UP);
        } else {
            send_probe(self, rig);
        }
        break;
    case NEXT_STEP_TARGET:
        if (has_whim(self, 12U)) {
            send_probe(self, rig);
        } else {
            send_target_or_phase(self, rig);
        }
        break;
    case NEXT_STEP_MOVE:
        if (self->wants_target != 0U) {
            send_target_or_phase(self, rig);
        } else {
            send_phase(self, rig, WORKPHASE_MOVE_TO_TARGET);
        }
        break;
    case NEXT_STEP_CONFIRM:
    case NEXT_STEP_PLACE:
    case NEXT_STEP_COMPARE:
        confirm(self, rig);
        break;
    case NEXT_STEP_STOP:
        send_phase(self, rig, WORKPHASE_STOP);
        break;
    case NEXT_STEP_WAIT:
        break;
    case NEXT_STEP_AUTHORITY:
    case NEXT_STEP_GRANT:
        rig_box(rig, "pedal release");
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_TAKE});
        break;
    case NEXT_STEP_HOLD_PEDAL:
        if (random_below(self, (self->play == PLAY_INTERRUPTED) ? 2U : 8U) == 0U) {
            rig_box(rig, "pedal release");
        }
        break;
    default:
        send_phase(self, rig, WORKPHASE_START_UP);
        break;
    }
}

/* Every axis is homed, nothing is armed, and nothing is in the way of a jog. */
static bool is_free(const snapshot_t *shown)
{
    return (shown->is_homed != 0U) && (shown->order == (uint32_t)ARMING_STATE_NONE) &&
           ((shown->next_step == (uint32_t)NEXT_STEP_TARGETING) ||
            (shown->next_step == (uint32_t)NEXT_STEP_CALIBRATION) ||
            (shown->next_step == (uint32_t)NEXT_STEP_PLANNING) ||
            ((shown->next_step >= (uint32_t)NEXT_STEP_REGISTER) &&
             (shown->next_step <= (uint32_t)NEXT_STEP_NOTHING)));
}

/* What the console asks for, or jogs where it asks for none. */
static void do_wish(stage_t *self, rig_t *rig)
{
    self->wait_cycles = 20U + random_below(self, 120U);
    if ((self->foe.wish < FOE_ASKS_JOGS) || !is_free(&rig->outputs.snapshot)) {
        do_next_step(self, rig);
    } else if (rig->outputs.snapshot.workphase != (uint32_t)WORKPHASE_MANUAL) {
        send_phase(self, rig, WORKPHASE_MANUAL);
    } else {
        rig_box(rig, "pedal release");
        send(self, rig, foe_jog(&self->foe, rig));
    }
}

/* In some cases the needle goes in before a sweep, which must then be refused, and out again. */
static bool moves_needle(stage_t *self, rig_t *rig)
{
    const uint32_t needle = self->robot->needle_axis;
    const axis_config_t *const axis = &self->robot->axes[needle];
    const int32_t far_ticks = (axis->maximum_ticks - axis->minimum_ticks) / NEEDLE_PARTS;
    const bool is_in = rig->outputs.snapshot.axes[needle].position_ticks > (far_ticks / 2);
    const bool is_due = (self->play == PLAY_SWEEPS) && has_whim(self, is_in ? 2U : OTHER_PARTS);
    if (is_due && is_in) {
        send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
    } else if (is_due) {
        send(self, rig,
             (command_t){.kind = (uint32_t)COMMAND_JOG_BY, .argument = needle, .value = far_ticks});
    } else {
        /* It stays. */
    }
    return is_due;
}

/* The next order of a play without a theme: mostly in `phase`, or where targets are. */
static void wish_for(stage_t *self, workphase_t phase, uint32_t parts)
{
    if (play_theme(self->play) == COMMAND_NONE) {
        self->wish = has_whim(self, parts) ? 0U : (uint32_t)phase;
    }
}

/* In TARGETING, or once a move has ended: an order there, or another target and its entry point. */
static void do_aiming_order(stage_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const bool is_targeting = shown->workphase == (uint32_t)WORKPHASE_TARGETING;
    if (is_targeting && ((shown->has_entry == 0U) || has_whim(self, 4U))) {
        send_target(self, rig);
    } else if (is_targeting && has_whim(self, 4U)) {
        send_phase(self, rig, WORKPHASE_MOVE_TO_TARGET);
    } else if ((self->play == PLAY_PROGRAMS) && has_whim(self, OTHER_PARTS)) {
        send_phase(self, rig, WORKPHASE_TARGETING);
    } else {
        send_order(self, rig, (workphase_t)shown->workphase);
        wish_for(self, WORKPHASE_MANUAL, 3U);
    }
}

/* Towards the workphase of the next order, and that. */
static void do_order(stage_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const bool is_manual = self->wish == (uint32_t)WORKPHASE_MANUAL;
    const bool is_aiming = (shown->workphase == (uint32_t)WORKPHASE_TARGETING) ||
                           (shown->workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    rig_box(rig, "pedal release");
    if (is_manual && (shown->workphase == (uint32_t)WORKPHASE_MANUAL)) {
        if (!moves_needle(self, rig)) {
            send_order(self, rig, WORKPHASE_MANUAL);
        }
        wish_for(self, WORKPHASE_MANUAL, 6U);
    } else if (is_manual && (shown->is_homed != 0U)) {
        send_phase(self, rig, WORKPHASE_MANUAL);
    } else if (!is_manual && is_aiming && (shown->is_homed != 0U)) {
        do_aiming_order(self, rig);
    } else {
        do_next_step(self, rig);
    }
}

/* One order of any mode after the other; some give way to another one, and some to a stop. */
static void do_mode(stage_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const uint32_t patience = (self->play == PLAY_SWEEPS) ? SWEEP_PATIENCE : 1U;
    if (self->orders.rows != 0U) {
        return;
    }
    if (shown->order == (uint32_t)ARMING_STATE_NONE) {
        do_order(self, rig);
    } else if ((shown->workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET) && has_whim(self, 40U)) {
        send_order(self, rig, WORKPHASE_MOVE_TO_TARGET);
    } else if (shown->order == (uint32_t)ARMING_STATE_WAITING) {
        rig_box(rig, has_whim(self, 8U) ? "pedal release" : "pedal press");
    } else if (has_whim(self, 24U * patience)) {
        rig_box(rig, "pedal release");
    } else if (has_whim(self, 80U * patience)) {
        send_order(self, rig, WORKPHASE_COUNT);
    } else if (has_whim(self, 160U * patience)) {
        send_phase(self, rig, WORKPHASE_STOP);
    } else {
        /* It goes on. */
    }
}

/* The rest of a list that was begun, a command in each cycle. */
static void let_list_go_on(stage_t *self, rig_t *rig)
{
    command_t command;
    if (orders_go_on(&self->orders, rig, &self->whim, &command)) {
        send(self, rig, command);
    }
}

/* At any time. */
static void let_watch(stage_t *self, rig_t *rig)
{
    command_t command;
    if (watcher_play(&self->watcher, rig, &command)) {
        send(self, rig, command);
    }
}

static void let_rivals_play(stage_t *self, rig_t *rig)
{
    command_t command;
    if ((self->play == PLAY_RIVALS) && rivals_play(&self->rivals, rig, &command)) {
        command.id = 1000U + self->cycle;
        rig->commands[rig->command_count] = command;
        rig->command_count++;
    }
}

static void let_foe_play(stage_t *self, rig_t *rig)
{
    if ((self->play == PLAY_TAPS) && foe_play(&self->foe, rig)) {
        self->has_fault = 1U;
    }
}

/* Mostly it waits for a dose or has it; now and then it stops the treatment. */
static void let_gate_change(stage_t *self, rig_t *rig)
{
    static const char *const words[] = {"gate off",  "gate dose", "gate off", "gate dose",
                                        "gate dose", "gate off",  "gate off", "gate stop"};
    if (self->play != PLAY_PROGRAMS) {
        return;
    }
    if (self->gate_cycles == 0U) {
        self->gate_cycles = 1U + chance_below(&self->whim, GATE_CYCLES);
        rig_box(rig, words[chance_below(&self->whim, (uint32_t)(sizeof words / sizeof words[0]))]);
    }
    self->gate_cycles--;
}

/* Whatever was broken of an axis. */
static void repair(rig_t *rig)
{
    static const char *const parts[] = {"card", "encoder", "motor", "switch"};
    char order[ORDER_SIZE];
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        for (uint32_t part = 0U; part < (sizeof parts / sizeof parts[0]); part++) {
            (void)snprintf(order, sizeof order, "%s %s normal", parts[part],
                           rig->box.robot->axes[i].name);
            rig_box(rig, order);
        }
    }
    rig_box(rig, "scanner off");
}

/* An encoder or a motor of any axis, and nothing else any more: two faults may hide each other. */
static void break_axis(stage_t *self, rig_t *rig)
{
    static const char *const faults[] = {"encoder %s stuck", "encoder %s reversed",
                                         "encoder %s half",  "motor %s stuck",
                                         "motor %s half",    "motor %s twice"};
    const char *const fault = faults[random_below(self, sizeof faults / sizeof faults[0])];
    const uint32_t axis = random_below(self, self->robot->axis_count);
    char order[ORDER_SIZE];
    (void)snprintf(order, sizeof order, fault, self->robot->axes[axis].name);
    repair(rig);
    rig_box(rig, order);
}

/* In the middle of an order, in a play with a theme or of time. */
static void break_and_repair(stage_t *self, rig_t *rig)
{
    const bool is_late = self->play == PLAY_LATE;
    if ((rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING) &&
        has_whim(self, is_late ? BREAK_LATE_PARTS : BREAK_PARTS)) {
        if (is_late) {
            break_axis(self, rig);
        } else {
            disturb(self, rig);
        }
        part_hidden_pairs(rig);
        self->has_fault = 1U;
        self->fault_cycle = self->cycle + 1U + chance_below(&self->whim, REPAIR_CYCLES);
    } else if (self->cycle == self->fault_cycle) {
        repair(rig);
    } else {
        /* As it is. */
    }
}

static void let_things_break(stage_t *self, rig_t *rig)
{
    if ((play_theme(self->play) == COMMAND_NONE) && (self->play != PLAY_LATE)) {
        if (self->cycle == self->fault_cycle) {
            disturb(self, rig);
            part_hidden_pairs(rig);
            self->has_fault = 1U;
            self->fault_cycle += 200U + random_below(self, 6000U);
        }
    } else if (self->is_brittle != 0U) {
        break_and_repair(self, rig);
    } else {
        /* Nothing does. */
    }
}

/* Now and then what the console asks for; in a play with a theme once nothing is armed. */
static bool does_next_step(stage_t *self, const snapshot_t *shown)
{
    return ((play_theme(self->play) == COMMAND_NONE) ||
            (shown->order == (uint32_t)ARMING_STATE_NONE)) &&
           (random_below(self, 12U) == 0U);
}

/* Before the next cycle, and before the enemy. */
static void play_operator(stage_t *self, rig_t *rig)
{
    const bool is_own_press = self->rivals.press_cycles == 0U;
    if (rig->box.button_pressed &&
        ((is_own_press && (self->wait_cycles == 0U)) || !acts_is_shown_true(rig))) {
        rig_box(rig, "button release");
    }
    if (self->wait_cycles > 0U) {
        self->wait_cycles--;
        return;
    }
    self->wait_cycles = 30U + random_below(self, play_is_of_orders(self->play) ? 200U : 600U);
    if (self->play == PLAY_TAPS) {
        do_wish(self, rig);
    } else if ((self->play == PLAY_JOGS) && (random_below(self, 5U) != 0U)) {
        do_jog(self, rig);
    } else if (play_is_of_orders(self->play) && !does_next_step(self, &rig->outputs.snapshot)) {
        do_mode(self, rig);
    } else if (self->is_chaotic != 0U) {
        do_anything(self, rig);
    } else {
        do_next_step(self, rig);
    }
}

void stage_play(stage_t *self, rig_t *rig)
{
    self->cycle++;
    let_things_break(self, rig);
    let_gate_change(self, rig);
    let_list_go_on(self, rig);
    play_operator(self, rig);
    let_watch(self, rig);
    let_rivals_play(self, rig);
    let_foe_play(self, rig);
    if (self->play == PLAY_LATE) {
        lateness_play(&self->lateness, rig);
    }
}

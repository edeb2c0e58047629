/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/scenario.h"

#include "charts/arming_chart.h"
#include "limits/requirement_limits.h"
#include "supervise/scenario/acts.h"
#include "supervise/scenario/hand_deeds.h"
#include "supervise/scenario/prng.h"
#include "supervise/scenario/scenario_deeds.h"
#include "supervise/scenario/scenario_sends.h"
#include "supervise/scenario/targets.h"

#include <stdio.h>
#include <string.h>

#define ORDER_SIZE 64U
#define ORDERS_MOST 32U
#define SHARE_STEPS 1000000U
#define RISE_SPREAD 0.1
#define DEAD_ZONE_SPREAD 0.005 /* Share of all words. */
#define BREAK_PARTS 40000U     /* In one of so many cycles of motion something breaks... */
#define BREAK_LATE_PARTS 3000U /* The same where time is the enemy... */
#define REPAIR_CYCLES 6000U    /* ...and is repaired after these at the latest. */
#define GATE_CYCLES 900U

static void start_targeted(const scenario_t *self, rig_t *rig)
{
    const rigid_t pose = targets_first(self->robot);
    rig_start_robot_targeted(rig, self->robot, &pose);
}

static void set_random_scene(scenario_t *self, rig_t *rig)
{
    const uint32_t start = scenario_random_below(self, 4U);
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
    self->is_chaotic = (scenario_random_below(self, 3U) == 0U) ? 1U : 0U;
    if (self->play == PLAY_RIVALS) {
        return;
    }
    self->fault_cycle =
        (scenario_random_below(self, 5U) == 0U) ? UINT32_MAX : scenario_random_below(self, 12000U);
}

/* Anywhere within `part` of one. */
static double near_one(scenario_t *self, double part)
{
    const double share = (double)scenario_random_below(self, SHARE_STEPS + 1U) / SHARE_STEPS;
    return 1.0 - part + (2.0 * part * share);
}

/* Other motors: full speed, time of gaining it, and the smallest word that turns them. */
static void spread_motors(scenario_t *self, rig_t *rig)
{
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        sim_motor_t *const motor = &rig->box.axes[i].motor;
        const double span = motor->maximum_duty - motor->minimum_duty;
        motor->full_speed_ticks_per_s *= near_one(self, LIMIT_MOTOR_SPREAD_PERCENT / 100.0);
        motor->rise_share *= near_one(self, RISE_SPREAD);
        motor->minimum_duty += span * (near_one(self, DEAD_ZONE_SPREAD) - 1.0);
    }
}

static void begin_late(scenario_t *self, rig_t *rig, uint32_t seed)
{
    if ((seed % 3U) == 0U) {
        rig_start_robot(rig, self->robot);
    } else {
        start_targeted(self, rig);
    }
    lateness_begin(&self->lateness, rig, seed);
}

void scenario_begin(scenario_t *self, rig_t *rig, const robot_t *robot, play_t play, uint32_t seed)
{
    *self = (scenario_t){.play = play,
                         .random = (seed * 2654435761U) | 1U,
                         .whim = (seed * 3266489917U) | 1U,
                         .fault_cycle = UINT32_MAX,
                         .robot = robot};
    const bool is_of_faults = (play_theme(play) != COMMAND_NONE) || (play == PLAY_LATE);
    self->is_brittle = (is_of_faults && ((seed % 2U) == 0U)) ? 1U : 0U;
    self->wish = (play == PLAY_SWEEPS) ? (uint32_t)WORKPHASE_MANUAL : 0U;
    watcher_begin(&self->watcher, seed);
    for (uint32_t i = 0U; i < 8U; i++) {
        (void)scenario_random_below(self, 2U);
    }
    if ((play == PLAY_RANDOM) || (play == PLAY_JOGS)) {
        set_random_scene(self, rig);
    } else if (play == PLAY_RIVALS) {
        set_random_scene(self, rig);
        competing_peers_begin(&self->rivals, rig, seed);
    } else if (play == PLAY_SPREAD) {
        rig_start_robot(rig, robot);
        spread_motors(self, rig);
    } else if (play == PLAY_MAGNITUDE) {
        rig_set_magnitude_robot(&self->magnitude_robot, robot);
        rig_start_robot(rig, &self->magnitude_robot);
        spread_motors(self, rig);
    } else if (play == PLAY_TAPS) {
        adversary_begin(&self->adversary, rig, robot, seed);
    } else if (play == PLAY_LATE) {
        begin_late(self, rig, seed);
    } else if (play == PLAY_HANDS) {
        hands_begin(&self->hands, seed);
        hands_start(&self->hands, rig, robot, seed);
    } else {
        start_targeted(self, rig);
    }
}

bool scenario_is_disturbed(const scenario_t *self)
{
    return (self->has_fault != 0U) || (self->play == PLAY_LATE);
}

bool scenario_is_sound(const scenario_t *self)
{
    return self->has_fault == 0U;
}

/* One of the words between bars: "silent|corrupt|normal". */
static void pick_word(scenario_t *self, const char *words, size_t length, char *picked)
{
    uint32_t count = 1U;
    for (size_t i = 0U; i < length; i++) {
        count += (words[i] == '|') ? 1U : 0U;
    }
    uint32_t left = scenario_random_below(self, count);
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

/* A fault of hand, tissue or load cells: for PLAY_HANDS, as no other play has a motion that follows
 * a force. */
static bool is_force(const char *line)
{
    return begins_with(line, "hand ") || begins_with(line, "grip ") ||
           begins_with(line, "tissue ") || begins_with(line, "force hand|needle stuck");
}

/* To be drawn by lot: orders that disturb. By where the axes are the oracle would take a hand for a
 * drive. A client that holds from afar is timed in the world's time, of which a scene has none. */
static bool is_disturbance(const char *line)
{
    return !begins_with(line, "show") && !begins_with(line, "probe ") &&
           !begins_with(line, "push ") && !is_force(line) && !ends_with(line, " WHO");
}

/* Any such order that the box knows, whatever its list says today. */
static void disturb(scenario_t *self, rig_t *rig)
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
    const char *const line = lines[scenario_random_below(self, count)];
    char order[ORDER_SIZE * 3U] = "";
    for (const char *word = line; *word != '\n';) {
        const size_t length = strcspn(word, " \n");
        char picked[ORDER_SIZE];
        pick_word(self, word, length, picked);
        if (strcmp(picked, "SLOT") == 0) {
            (void)snprintf(
                picked, sizeof picked, "%s",
                self->robot->axes[scenario_random_below(self, self->robot->axis_count)].name);
        }
        (void)snprintf(order + strlen(order), sizeof order - strlen(order), "%s%s",
                       (word == line) ? "" : " ", picked);
        word += length;
        word += (*word == ' ') ? 1U : 0U;
    }
    rig_box(rig, order);
}

/* A motor that runs by itself and an encoder that counts nothing hide each other from a reader
 * of the frames alone: two faults, which no supervision can distinguish from rest. */
static void part_hidden_pairs(rig_t *rig)
{
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        box_axis_t *const axis = &rig->box.axes[i];
        if ((axis->encoder.fault == SIM_ENCODER_STUCK) && (axis->motor.fault == SIM_MOTOR_RUNS)) {
            axis->motor.fault = SIM_MOTOR_NORMAL;
        }
    }
}

/* The rest of a list that was begun, a command in each cycle. */
static void let_list_go_on(scenario_t *self, rig_t *rig)
{
    command_t command;
    if (orders_go_on(&self->orders, rig, &self->whim, &command)) {
        scenario_send(self, rig, command);
    }
}

/* At any time. */
static void let_watch(scenario_t *self, rig_t *rig)
{
    command_t command;
    if (watcher_play(&self->watcher, rig, &command)) {
        scenario_send(self, rig, command);
    }
}

static void let_rivals_play(scenario_t *self, rig_t *rig)
{
    command_t command;
    if ((self->play == PLAY_RIVALS) && competing_peers_play(&self->rivals, rig, &command)) {
        command.id = 1000U + self->cycle;
        rig->commands[rig->command_count] = command;
        rig->command_count++;
    }
}

static void let_adversary_play(scenario_t *self, rig_t *rig)
{
    if ((self->play == PLAY_TAPS) && adversary_play(&self->adversary, rig)) {
        self->has_fault = 1U;
    }
}

/* Mostly it waits for a dose or has it; now and then it stops the treatment. */
static void let_gate_change(scenario_t *self, rig_t *rig)
{
    static const char *const words[] = {"gate off",  "gate dose", "gate off", "gate dose",
                                        "gate dose", "gate off",  "gate off", "gate stop"};
    if (self->play != PLAY_PROGRAMS) {
        return;
    }
    if (self->gate_cycles == 0U) {
        self->gate_cycles = 1U + prng_below(&self->whim, GATE_CYCLES);
        rig_box(rig, words[prng_below(&self->whim, (uint32_t)(sizeof words / sizeof words[0]))]);
    }
    self->gate_cycles--;
}

/* Repairs all broken parts of an axis. */
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
static void break_axis(scenario_t *self, rig_t *rig)
{
    static const char *const faults[] = {"encoder %s stuck", "encoder %s reversed",
                                         "encoder %s half",  "motor %s stuck",
                                         "motor %s half",    "motor %s twice"};
    const char *const fault = faults[scenario_random_below(self, sizeof faults / sizeof faults[0])];
    const uint32_t axis = scenario_random_below(self, self->robot->axis_count);
    char order[ORDER_SIZE];
    (void)snprintf(order, sizeof order, fault, self->robot->axes[axis].name);
    repair(rig);
    rig_box(rig, order);
}

/* In the middle of an order, in a play with a theme or of time. */
static void break_and_repair(scenario_t *self, rig_t *rig)
{
    const bool is_late = self->play == PLAY_LATE;
    if ((rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING) &&
        scenario_has_whim(self, is_late ? BREAK_LATE_PARTS : BREAK_PARTS)) {
        if (is_late) {
            break_axis(self, rig);
        } else {
            disturb(self, rig);
        }
        part_hidden_pairs(rig);
        self->has_fault = 1U;
        self->fault_cycle = self->cycle + 1U + prng_below(&self->whim, REPAIR_CYCLES);
    } else if (self->cycle == self->fault_cycle) {
        repair(rig);
    } else {
        /* As it is. */
    }
}

static void let_things_break(scenario_t *self, rig_t *rig)
{
    if ((play_theme(self->play) == COMMAND_NONE) && (self->play != PLAY_LATE)) {
        if (self->cycle == self->fault_cycle) {
            disturb(self, rig);
            part_hidden_pairs(rig);
            self->has_fault = 1U;
            self->fault_cycle += 200U + scenario_random_below(self, 6000U);
        }
    } else if (self->is_brittle != 0U) {
        break_and_repair(self, rig);
    } else {
        /* Nothing does. */
    }
}

/* Before the next cycle, and before the enemy. */
static void play_operator(scenario_t *self, rig_t *rig)
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
    self->wait_cycles =
        30U + scenario_random_below(self, play_is_of_orders(self->play) ? 200U : 600U);
    if (self->play == PLAY_TAPS) {
        scenario_do_wish(self, rig);
    } else if (self->play == PLAY_HANDS) {
        hand_deeds_do_order(self, rig);
    } else if ((self->play == PLAY_JOGS) && (scenario_random_below(self, 5U) != 0U)) {
        scenario_do_jog(self, rig);
    } else if (play_is_of_orders(self->play) &&
               !scenario_does_next_step(self, &rig->outputs.snapshot)) {
        scenario_do_mode(self, rig);
    } else if (self->is_chaotic != 0U) {
        scenario_do_anything(self, rig);
    } else {
        scenario_do_next_step(self, rig);
    }
}

void scenario_play(scenario_t *self, rig_t *rig)
{
    self->cycle++;
    let_things_break(self, rig);
    let_gate_change(self, rig);
    let_list_go_on(self, rig);
    play_operator(self, rig);
    let_watch(self, rig);
    let_rivals_play(self, rig);
    let_adversary_play(self, rig);
    if (self->play == PLAY_LATE) {
        lateness_play(&self->lateness, rig);
    }
    if (self->play == PLAY_HANDS) {
        hands_play(&self->hands, rig);
    }
}

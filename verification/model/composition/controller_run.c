/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The controller itself on the simulated control box, with an operator and a world that do anything
 * at any time: which configurations of the charts it comes into, and what it permits there.
 *
 *     controller_run EPISODES
 *
 * Standard output has a line for each change, of every axis with its card and with the next axis:
 * the numbers of loop, pedal, estop, card, axes, stalls, workphase, arming, authority, need, plan
 * and scanner, and for each axis the reasons that it shows against motion, with ANOTHER_CARD_LOST
 * if one is. The same lines on every run.
 */
#include "numbers.h"
#include "robot/robot_neuro.h"

#include "integration/support/rig.h"
#include "safety/permit.h"
#include "unity.h"
#include "unit/support/commands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CYCLES 2500U
#define AXES 2U
#define COLUMNS 16U

typedef struct {
    uint32_t numbers[COLUMNS];
    uint32_t count;
} row_t;

static rig_t rig;
static uint32_t random_state = 1U;

void setUp(void)
{
}

void tearDown(void)
{
}

void contract_broken(const char *module, uint32_t id)
{
    printf("contract %s %u is broken\n", module, (unsigned)id);
    exit(2);
}

/* xorshift32. */
static uint32_t random_below(uint32_t bound)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 17;
    random_state ^= random_state << 5;
    return random_state % bound;
}

static uint32_t plan_of(const plan_t *plan)
{
    plan_chart_t chart;
    plan_chart_init(&chart);
    if (plan->is_registered != 0U) {
        (void)plan_chart_dispatch(&chart, PLAN_EVENT_REGISTER);
    }
    if (plan->has_target != 0U) {
        (void)plan_chart_dispatch(&chart, PLAN_EVENT_TARGET);
    }
    return plan_number(&chart);
}

static uint32_t scanner_of(const controller_inputs_t *inputs)
{
    scanner_chart_t chart;
    scanner_chart_init(&chart);
    if (inputs->scanner_active != 0U) {
        (void)scanner_chart_dispatch(&chart, SCANNER_EVENT_ON);
    }
    return scanner_number(&chart);
}

/* By the row of the mode that was armed. */
static uint32_t need_of(const controller_t *self)
{
    need_chart_t chart;
    need_chart_init(&chart);
    if (procedure_is_armed(&self->procedure) &&
        !mode_may_be_unhomed((mode_kind_t)self->mode.sealed.kind)) {
        (void)need_chart_dispatch(&chart, NEED_EVENT_ASK_MOTION);
        (void)need_chart_dispatch(&chart, NEED_EVENT_ARMED);
    }
    return need_number(&chart);
}

/* Where the axes stand is no part of the composition, and only such reasons are held. */
static uint32_t reasons_of(uint32_t axis, uint32_t card)
{
    const uint32_t left_out = (1U << PERMIT_REASON_LIMIT_SWITCH) |
                              (1U << PERMIT_REASON_SOFT_LIMIT) |
                              (1U << PERMIT_REASON_COUPLED_LIMIT) | (1U << PERMIT_REASON_NEEDLE_IN);
    const uint32_t shown = rig.controller.records[axis].sealed.reason_hold.shown & ~left_out;
    bool is_another_lost = false;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        is_another_lost = is_another_lost || ((i != card) && !link_is_usable(rig_link(&rig, i)));
    }
    return shown | (is_another_lost ? ANOTHER_CARD_LOST : 0U);
}

static void add(row_t *row, uint32_t number)
{
    row->numbers[row->count] = number;
    row->count++;
}

static row_t row_of(uint32_t axis)
{
    const controller_t *const self = &rig.controller;
    row_t row = {{0U}, 0U};
    add(&row, loop_guard_number(&self->loop.chart));
    add(&row, pedal_gate_number(&self->pedal.chart));
    add(&row, estop_latch_number(&self->estop));
    add(&row, card_link_number(&rig_link(&rig, axis)->chart));
    for (uint32_t i = 0U; i < AXES; i++) {
        add(&row, axis_number(&self->axes[(axis + i) % robot_neuro.axis_count].chart));
    }
    for (uint32_t i = 0U; i < AXES; i++) {
        add(&row, stall_watchdog_number(
                      &self->axes[(axis + i) % robot_neuro.axis_count].supervision.stall));
    }
    add(&row, workphase_number(&self->procedure.workphase));
    add(&row, arming_number(&self->procedure.arming));
    add(&row, authority_number(&self->authority.chart));
    add(&row, need_of(self));
    add(&row, plan_of(&self->plan));
    add(&row, scanner_of(&rig.inputs));
    for (uint32_t i = 0U; i < AXES; i++) {
        add(&row, reasons_of((axis + i) % robot_neuro.axis_count, axis));
    }
    return row;
}

static void note(uint32_t axis)
{
    static row_t last[ROBOT_AXIS_MAX];
    const row_t row = row_of(axis);
    if (memcmp(&row, &last[axis], sizeof row) != 0) {
        last[axis] = row;
        for (uint32_t i = 0U; i < row.count; i++) {
            printf("%u%c", (unsigned)row.numbers[i], ((i + 1U) < row.count) ? ' ' : '\n');
        }
    }
}

/* Faults of the box are rarer than what heals them, so that motion comes about. */
static void disturb(void)
{
    static const char *const orders[] = {
        "pedal press",     "pedal press",      "pedal release",      "pedal a open",
        "pedal b close",   "estop pull",       "estop reset",        "estop reset",
        "scanner on",      "scanner off",      "card 1 silent",      "card 1 normal",
        "card 3 corrupt",  "card 3 normal",    "motor 2 stuck",      "motor 2 normal",
        "encoder 4 stuck", "encoder 4 normal", "encoder 5 reversed", "encoder 5 normal",
        "pedal press",     "card 1 normal",    "card 3 normal",      "estop reset",
        "button press",    "button press",     "button release"};
    rig_box(&rig, orders[random_below(sizeof orders / sizeof orders[0])]);
}

static void command(void)
{
    static const command_kind_t of_axis[] = {COMMAND_HOME_AXIS,    COMMAND_CLEAR_AXIS,
                                             COMMAND_CONFIRM_AXIS, COMMAND_SET_HOME,
                                             COMMAND_ENABLE_AXIS,  COMMAND_DISABLE_AXIS};
    static const command_kind_t motions[] = {COMMAND_ALIGN, COMMAND_INSERT, COMMAND_POSE,
                                             COMMAND_RELEASE, COMMAND_TAKE};
    command_t one = {.kind = (uint32_t)COMMAND_WORKPHASE,
                     .as.workphase = {.workphase = 1U + random_below(8U)}};
    switch (random_below(9U)) {
    case 0:
        one.as.workphase.workphase = (uint32_t)WORKPHASE_START_UP;
        break;
    case 1:
        one = (command_t){.kind = (uint32_t)COMMAND_JOG,
                          .as.jog = {.axis = random_below(robot_neuro.axis_count),
                                     .to_ticks = (int32_t)random_below(2000U)}};
        break;
    case 2:
        one = (command_t){.kind = (uint32_t)COMMAND_REGISTRATION};
        rigid_set_identity(&one.as.registration.pose);
        break;
    case 3:
        one = (command_t){.kind = (uint32_t)COMMAND_TARGET};
        one.as.pose.pose =
            rig_pose(5000000, (random_below(3U) == 0U) ? 900000000 : 190000000, 60000000);
        break;
    case 4:
        one = (command_t){.kind = (uint32_t)COMMAND_RETRACT};
        break;
    case 5:
        one = (command_t){.kind = (uint32_t)COMMAND_RESTORE,
                          .as.positions = {.axes = 1U << random_below(robot_neuro.axis_count)}};
        break;
    case 6:
        one = (command_t){.kind =
                              (uint32_t)of_axis[random_below(sizeof of_axis / sizeof of_axis[0])]};
        one.as.axis.axis = random_below(robot_neuro.axis_count);
        break;
    case 7:
        one = commands_of_number(motions[random_below(sizeof motions / sizeof motions[0])],
                                 random_below(POSE_NAME_COUNT));
        break;
    default:
        break;
    }
    one.id = random_state;
    rig.commands[0] = one;
    rig.command_count = 1U;
}

static void run_episode(uint32_t cycles_between)
{
    for (uint32_t i = 0U; i < CYCLES; i++) {
        if (random_below(cycles_between) == 0U) {
            disturb();
        }
        if (random_below(cycles_between) == 0U) {
            command();
        }
        rig.elapsed_us = (random_below(cycles_between * 2U) < 3U) ? 2000U : 1000U;
        rig_cycle(&rig);
        for (uint32_t axis = 0U; axis < robot_neuro.axis_count; axis++) {
            note(axis);
        }
    }
}

int main(int count, char **arguments)
{
    const uint32_t episodes = (count == 2) ? (uint32_t)strtoul(arguments[1], NULL, 10) : 0U;
    UnityBegin("controller_run.c");
    for (uint32_t episode = 0U; episode < episodes; episode++) {
        if ((episode % 4U) == 0U) {
            rig_start(&rig);
        } else if ((episode % 4U) == 1U) {
            rig_start_robot_homed(&rig, &robot_neuro);
        } else {
            const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
            rig_start_robot_targeted(&rig, &robot_neuro, &pose);
        }
        run_episode(((episode % 3U) == 0U) ? 20U : 150U);
    }
    return 0;
}

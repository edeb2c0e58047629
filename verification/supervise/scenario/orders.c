/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/orders.h"

#include "interface/pose_name.h"
#include "mode/lists/program_step.h"
#include "mode/lists/trajectory_list.h"
#include "supervise/scenario/prng.h"

#include <math.h>
#include <stdlib.h>

#define ROWS_MOST 6U
#define WAY_PARTS 16 /* Part of an axis' whole way: a row is no farther from the one before. */
#define SPEED_SHARE 0.5
#define SLOWEST_MS 50.0
#define SPEEDS 2 /* No faster than one of so many parts. */
#define STEPS_MOST 4U
#define DWELL_LEAST_MS 20
#define DWELL_SPREAD_MS 1200U
#define AMISS_PARTS 32U /* One of so many steps, or sweeps, is not as it must be. */

static const axis_config_t *config_of(const rig_t *rig, uint32_t axis)
{
    return &rig->box.robot->axes[axis];
}

static uint32_t some_axis(const rig_t *rig, uint32_t *chance)
{
    return prng_below(chance, rig->box.robot->axis_count);
}

/* Up to `most` to either side. */
static int32_t either_way(int32_t most, uint32_t *chance)
{
    return (int32_t)prng_below(chance, (2U * (uint32_t)most) + 1U) - most;
}

static int32_t span_of(const axis_config_t *config)
{
    return config->maximum_ticks - config->minimum_ticks;
}

static void of_itself(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    (void)self;
    (void)rig;
    (void)chance;
    (void)command;
}

static void of_axis(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    (void)self;
    command->as.axis.axis = some_axis(rig, chance);
}

static void of_way(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    const uint32_t axis = some_axis(rig, chance);
    (void)self;
    command->as.jog_by.axis = axis;
    command->as.jog_by.by_ticks = either_way(span_of(config_of(rig, axis)) / WAY_PARTS, chance);
}

static void of_pose(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    (void)self;
    (void)rig;
    command->as.pose_name.pose = prng_below(chance, POSE_NAME_COUNT);
}

/* Each axis or not, and in one of four cases by way. */
static void of_speeds(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    const bool is_way = prng_below(chance, 4U) == 0U;
    const uint32_t every = ((uint32_t)1U << rig->box.robot->axis_count) - 1U;
    command_velocity_t *const velocity = &command->as.velocity;
    (void)self;
    velocity->axes =
        is_way ? ((uint32_t)1U << some_axis(rig, chance)) : (1U + prng_below(chance, every));
    const uint32_t bound = 1U + prng_below(chance, 2000U);
    velocity->time_ms = is_way ? 0U : bound;
    velocity->way_ticks = is_way ? bound : 0U;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        velocity->speeds_ticks_per_s[i] =
            either_way(config_of(rig, i)->speed_ticks_per_s / SPEEDS, chance);
    }
}

/* It begins where the axes stand. */
static void of_list(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    *self = (orders_t){.rows = 2U + prng_below(chance, ROWS_MOST - 1U)};
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        self->row.ticks[i] = rig->outputs.snapshot.axes[i].position_ticks;
    }
    command->as.list_begin.count = self->rows;
}

static void of_program(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    (void)rig;
    *self = (orders_t){.rows = 1U + prng_below(chance, STEPS_MOST), .is_program = true};
    command->as.list_begin.count = self->rows;
}

static bool is_amiss(uint32_t *chance)
{
    return prng_below(chance, AMISS_PARTS) == 0U;
}

/* Mostly an axis with waves, where there is one, that the operator has found free. */
static void of_sweep(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    command_sweep_t *const sweep = &command->as.sweep;
    (void)self;
    sweep->axis = some_axis(rig, chance);
    for (uint32_t i = 0U; (i < rig->box.robot->axis_count) && !is_amiss(chance); i++) {
        if (config_of(rig, i)->card_type == (uint8_t)CARD_TYPE_HIGH_FREQUENCY) {
            sweep->axis = i;
        }
    }
    sweep->is_free = is_amiss(chance) ? 0U : 1U;
}

typedef void (*make_t)(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command);

/* The possible orders, and the workphases in which they have a chance. */
static const struct {
    command_kind_t kind;
    workphase_t phase;
    make_t make;
} orders[] = {{COMMAND_ALIGN, WORKPHASE_TARGETING, of_itself},
              {COMMAND_INSERT, WORKPHASE_MOVE_TO_TARGET, of_itself},
              {COMMAND_RETRACT, WORKPHASE_MOVE_TO_TARGET, of_itself},
              {COMMAND_RETRACT, WORKPHASE_MANUAL, of_itself},
              {COMMAND_POSE, WORKPHASE_MANUAL, of_pose},
              {COMMAND_VELOCITY, WORKPHASE_MANUAL, of_speeds},
              {COMMAND_JOG_BY, WORKPHASE_MANUAL, of_way},
              {COMMAND_ENABLE_AXIS, WORKPHASE_MANUAL, of_axis},
              {COMMAND_DISABLE_AXIS, WORKPHASE_MANUAL, of_axis},
              {COMMAND_LIST_BEGIN, WORKPHASE_MANUAL, of_list},
              {COMMAND_PROGRAM_BEGIN, WORKPHASE_TARGETING, of_program},
              {COMMAND_PROGRAM_BEGIN, WORKPHASE_MOVE_TO_TARGET, of_program},
              {COMMAND_SWEEP, WORKPHASE_MANUAL, of_sweep}};
#define ORDERS (sizeof orders / sizeof orders[0])

static bool is_for(uint32_t row, orders_wish_t wish)
{
    return ((wish.phase == WORKPHASE_COUNT) || (orders[row].phase == wish.phase)) &&
           ((wish.theme == COMMAND_NONE) || (orders[row].kind == wish.theme));
}

static uint32_t count_rows(orders_wish_t wish)
{
    uint32_t rows = 0U;
    for (uint32_t i = 0U; i < ORDERS; i++) {
        rows += is_for(i, wish) ? 1U : 0U;
    }
    return rows;
}

bool orders_choose(orders_t *self, const rig_t *rig, orders_wish_t wish, uint32_t *chance,
                   command_t *command)
{
    const command_kind_t theme = (count_rows(wish) > 0U) ? wish.theme : COMMAND_NONE;
    const orders_wish_t due = {wish.phase, theme};
    const uint32_t rows = count_rows(due);
    if (rows == 0U) {
        return false;
    }
    uint32_t left = prng_below(chance, rows);
    for (uint32_t i = 0U; i < ORDERS; i++) {
        if (is_for(i, due)) {
            if (left == 0U) {
                *command = (command_t){.kind = (uint32_t)orders[i].kind};
                orders[i].make(self, rig, chance, command);
                return true;
            }
            left--;
        }
    }
    return false;
}

/* The axes go on from where the row before has left them, at rest in each row, all but the needle,
 * and as fast as each may. */
static void lengthen(orders_t *self, const rig_t *rig, uint32_t *chance)
{
    double longest_ms = SLOWEST_MS;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const axis_config_t *const config = config_of(rig, i);
        if (i != rig->box.robot->needle_axis) {
            const int32_t way = either_way(span_of(config) / WAY_PARTS, chance);
            const double by_speed =
                1.5 * fabs((double)way) / (SPEED_SHARE * config->speed_ticks_per_s);
            const double by_ramp =
                sqrt(6.0 * fabs((double)way) / (SPEED_SHARE * config->acceleration_ticks_per_s2));
            self->row.ticks[i] += way;
            longest_ms = fmax(longest_ms, 1000.0 * fmax(by_speed, by_ramp));
        }
    }
    self->row.time_ms += (uint32_t)ceil(longest_ms);
}

static void send_row(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    if (self->next > 0U) {
        lengthen(self, rig, chance);
    }
    command->kind = (uint32_t)COMMAND_LIST_ROW;
    command->as.row = (command_row_t){.index = self->next, .time_ms = self->row.time_ms};
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        command->as.row.ticks[i] = self->row.ticks[i];
    }
    self->sum = trajectory_list_crc(self->sum, &self->row);
}

/* Within what a target may ask of the axis. */
static int32_t clamped(const axis_config_t *config, int32_t ticks)
{
    const int32_t least = config->target_minimum_ticks;
    const int32_t most = config->target_maximum_ticks;
    return (ticks < least) ? least : (ticks > most) ? most : ticks;
}

/* Before the target, somehow turned, with a gate or without; now and then deeper than it. */
static void send_step(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    const robot_t *const robot = rig->box.robot;
    const int32_t *const target_ticks = rig->controller.plan.target_ticks;
    const uint32_t turning = program_step_turning_axis(robot);
    const axis_config_t *const along = config_of(rig, robot->needle_axis);
    const int32_t dwell_ms = DWELL_LEAST_MS + (int32_t)prng_below(chance, DWELL_SPREAD_MS);
    const int32_t way = either_way(span_of(along) / WAY_PARTS, chance);
    command_step_t *const sent = &command->as.step;
    program_step_t step;
    const bool is_deeper = is_amiss(chance);
    command->kind = (uint32_t)COMMAND_PROGRAM_STEP;
    *sent = (command_step_t){.index = self->next,
                             .dwell_ms = (uint32_t)dwell_ms,
                             .is_gated = (prng_below(chance, 2U) == 0U) ? 0U : 1U};
    sent->ticks[robot->needle_axis] =
        clamped(along, target_ticks[robot->needle_axis] - (is_deeper ? way : abs(way)));
    if (turning < robot->axis_count) {
        const axis_config_t *const about = config_of(rig, turning);
        sent->ticks[turning] =
            clamped(about, target_ticks[turning] + either_way(span_of(about) / WAY_PARTS, chance));
    }
    program_step_place(robot, sent->ticks, &step);
    step.dwell_ms = (uint32_t)dwell_ms;
    step.is_gated = sent->is_gated;
    self->sum = program_list_crc(self->sum, &step);
}

/* From TARGETING by way of a move that is armed, and not run. */
static void send_run(orders_t *self, const rig_t *rig, command_t *command)
{
    const bool is_targeting = rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_TARGETING;
    if (self->is_program && is_targeting && (self->next == (self->rows + 1U))) {
        command->kind = (uint32_t)COMMAND_WORKPHASE;
        command->as.workphase.workphase = (uint32_t)WORKPHASE_MOVE_TO_TARGET;
    } else {
        command->kind = (uint32_t)(self->is_program ? COMMAND_RUN_PROGRAM : COMMAND_RUN_TRAJECTORY);
        command->as.list.checksum = self->sum;
        self->rows = 0U;
    }
}

bool orders_go_on(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command)
{
    if (self->rows == 0U) {
        return false;
    }
    *command = (command_t){.kind = (uint32_t)COMMAND_NONE};
    if ((self->next < self->rows) && self->is_program) {
        send_step(self, rig, chance, command);
    } else if (self->next < self->rows) {
        send_row(self, rig, chance, command);
    } else if (self->next == self->rows) {
        command->kind = (uint32_t)(self->is_program ? COMMAND_PROGRAM_END : COMMAND_LIST_END);
        command->as.list.checksum = self->sum;
    } else {
        send_run(self, rig, command);
    }
    self->next++;
    return true;
}

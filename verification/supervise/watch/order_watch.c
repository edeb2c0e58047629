/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/order_watch.h"

#include "procedure/command_kinds.h"

#include "charts/arming_chart.h"
#include "supervise/watch/truth.h"

#include <math.h>
#include <string.h>

#define STILL_MM 0.1 /* Way that the servo may correct. */
#define STILL_DEG 1.0

static uint32_t rule(order_rule_t which, bool is_broken)
{
    return is_broken ? ((uint32_t)1U << (uint32_t)which) : 0U;
}

static bool is_sent(const rig_t *rig, uint32_t axis)
{
    return rig_sent(rig, axis).drive.mode != (uint32_t)CARD_DRIVE_OFF;
}

static bool is_farther(const rig_t *rig, uint32_t axis, double ticks)
{
    const axis_config_t *const config = &rig->box.robot->axes[axis];
    const bool is_mm = config->unit == (uint8_t)AXIS_UNIT_MM;
    return fabs(truth_measure(config, ticks)) > (is_mm ? STILL_MM : STILL_DEG);
}

bool order_watch_is_steering(const rig_t *rig, uint32_t axis)
{
    return (rig->outputs.snapshot.steering_method != (uint32_t)STEERING_NONE) &&
           (axis == rig->box.robot->steering.axis);
}

static void begin_list(order_watch_t *self)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        self->lowest[i] = INT32_MAX;
        self->highest[i] = INT32_MIN;
    }
}

static void add_row(order_watch_t *self, const command_t *command)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        self->lowest[i] = fmin(self->lowest[i], command->as.row.ticks[i]);
        self->highest[i] = fmax(self->highest[i], command->as.row.ticks[i]);
    }
}

/* Along the needle and about it. */
static uint32_t needle_axes(const rig_t *rig)
{
    uint32_t axes = (uint32_t)1U << rig->box.robot->needle_axis;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const bool is_about = rig->box.robot->axes[i].needle_motion == (uint32_t)NEEDLE_ABOUT;
        axes |= is_about ? ((uint32_t)1U << i) : 0U;
    }
    return axes;
}

/* The axes that an order names; of one that names none every axis. */
static uint32_t named_by(const rig_t *rig, const command_t *command)
{
    switch (command->kind) {
    case COMMAND_RUN_PROGRAM:
        return needle_axes(rig);
    case COMMAND_JOG:
        return (uint32_t)1U << command->as.jog.axis;
    case COMMAND_JOG_BY:
        return (uint32_t)1U << command->as.jog_by.axis;
    case COMMAND_HOME_AXIS:
        return (uint32_t)1U << command->as.axis.axis;
    case COMMAND_SWEEP:
        return (uint32_t)1U << command->as.sweep.axis;
    case COMMAND_VELOCITY:
        return command->as.velocity.axes;
    default:
        return UINT32_MAX;
    }
}

static void note_accepted(order_watch_t *self, const rig_t *rig, const command_t *command,
                          bool is_order, const double truth[ROBOT_AXIS_MAX])
{
    if (is_order) {
        self->armed[command->kind]++;
        self->kind = command->kind;
        self->swept_axis = (command->kind == (uint32_t)COMMAND_SWEEP) ? command->as.sweep.axis : 0U;
        self->axes = named_by(rig, command);
        self->inwards = 0.0;
        (void)memcpy(self->from, truth, sizeof self->from);
    }
    switch (command->kind) {
    case COMMAND_WORKPHASE:
        self->disabled =
            (command_kinds_workphase(command) == WORKPHASE_START_UP) ? 0U : self->disabled;
        break;
    case COMMAND_DISABLE_AXIS:
        self->disabled |= (uint32_t)1U << command->as.axis.axis;
        break;
    case COMMAND_ENABLE_AXIS:
        self->disabled &= ~((uint32_t)1U << command->as.axis.axis);
        break;
    case COMMAND_LIST_BEGIN:
        begin_list(self);
        break;
    case COMMAND_LIST_ROW:
        add_row(self, command);
        break;
    default:
        break;
    }
}

/* START_UP that has homed in vain is refused, and clears and enables all the same. */
static bool is_clearing(const rig_t *rig, const answer_t *answer, uint32_t number)
{
    const command_t *const command = &rig->inputs.commands[number];
    return (answer->status == (uint32_t)STATUS_MOVED_IN_VAIN) &&
           (command_kinds_workphase(command) == WORKPHASE_START_UP);
}

/* The first answers come in the order of the commands, and ends of orders among them. */
static void read_answers(order_watch_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX])
{
    uint32_t number = 0U;
    for (uint32_t i = 0U; i < rig->outputs.answer_count; i++) {
        const answer_t *const answer = &rig->outputs.answers[i];
        const bool is_accepted = answer->kind == (uint32_t)ANSWER_ACCEPTED;
        if (is_accepted && (number < rig->inputs.command_count)) {
            note_accepted(self, rig, &rig->inputs.commands[number], answer->is_final == 0U, truth);
        }
        const bool is_refused = answer->kind == (uint32_t)ANSWER_REFUSED;
        if (is_refused && (number < rig->inputs.command_count) &&
            is_clearing(rig, answer, number)) {
            self->disabled = 0U;
        }
        if (is_accepted || is_refused) {
            number++;
        } else {
            self->done[self->kind] += (answer->kind == (uint32_t)ANSWER_DONE) ? 1U : 0U;
            self->kind = (uint32_t)COMMAND_NONE;
        }
    }
}

static void follow_needle(order_watch_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX])
{
    const uint32_t along = rig->box.robot->needle_axis;
    const card_drive_t drive = rig_sent(rig, along).drive;
    const bool is_inwards = (drive.mode != (uint32_t)CARD_DRIVE_OFF) &&
                            motor_model_is_upwards(&rig->box.robot->axes[along], &drive);
    self->inwards += is_inwards ? fmax(0.0, truth[along] - self->before[along]) : 0.0;
}

/* Rules of an order that moves the needle alone, one that drives it at all, and a list. */
static uint32_t judge_axis(const order_watch_t *self, const rig_t *rig, uint32_t axis, double truth)
{
    const bool is_needle = axis == rig->box.robot->needle_axis;
    const bool is_astray =
        (truth < self->lowest[axis])
            ? is_farther(rig, axis, self->lowest[axis] - truth)
            : ((truth > self->highest[axis]) && is_farther(rig, axis, truth - self->highest[axis]));
    return rule(ORDER_INSERT, (self->kind == (uint32_t)COMMAND_INSERT) && !is_needle &&
                                  !order_watch_is_steering(rig, axis) &&
                                  is_farther(rig, axis, truth - self->from[axis])) |
           rule(ORDER_LISTED, (self->kind == (uint32_t)COMMAND_RUN_TRAJECTORY) && is_astray);
}

static uint32_t judge_drive(const order_watch_t *self, const rig_t *rig, uint32_t axis)
{
    const bool is_needle = axis == rig->box.robot->needle_axis;
    const uint32_t bit = (uint32_t)1U << axis;
    return !is_sent(rig, axis)
               ? 0U
               : (rule(ORDER_POSE, (self->kind == (uint32_t)COMMAND_POSE) && is_needle) |
                  rule(ORDER_COMMANDED,
                       (self->kind != (uint32_t)COMMAND_NONE) && ((self->axes & bit) == 0U)) |
                  rule(ORDER_DISABLED, (self->disabled & bit) != 0U));
}

uint32_t order_watch_look(order_watch_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                          bool is_disturbed)
{
    uint32_t broken = 0U;
    read_answers(self, rig, truth);
    follow_needle(self, rig, truth);
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        broken |= judge_drive(self, rig, i);
        broken |= is_disturbed ? 0U : judge_axis(self, rig, i, truth[i]);
    }
    (void)memcpy(self->before, truth, sizeof self->before);
    return broken |
           rule(ORDER_TOLD, (self->kind != (uint32_t)COMMAND_NONE) &&
                                (rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE)) |
           rule(ORDER_ALIGN, (self->kind == (uint32_t)COMMAND_ALIGN) && !is_disturbed &&
                                 is_farther(rig, rig->box.robot->needle_axis, self->inwards));
}

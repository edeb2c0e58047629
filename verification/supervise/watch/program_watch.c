/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/program_watch.h"

#include "charts/arming_chart.h"
#include "supervise/watch/truth.h"
#include "oracle/replies.h"

#include <math.h>
#include <stdlib.h>

#define PLACE_MM 0.1
#define PLACE_DEG 1.0
#define LONGER_US 300000U /* Until the axes have settled. */
#define US_PER_MS 1000U

static uint32_t rule(program_rule_t which, bool is_broken)
{
    return is_broken ? ((uint32_t)1U << (uint32_t)which) : 0U;
}

/* The axis along the needle and the one about it. */
static bool is_placed(const rig_t *rig, uint32_t axis)
{
    return (axis == rig->box.robot->needle_axis) ||
           (rig->box.robot->axes[axis].needle_motion == (uint32_t)NEEDLE_ABOUT);
}

static bool stands_at(const rig_t *rig, const program_watch_step_t *step,
                      const double truth[ROBOT_AXIS_MAX])
{
    bool is_there = true;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const axis_config_t *const config = &rig->box.robot->axes[i];
        const double most = (config->unit == (uint8_t)AXIS_UNIT_MM) ? PLACE_MM : PLACE_DEG;
        is_there =
            is_there && (!is_placed(rig, i) ||
                         (fabs(truth_measure(config, truth[i] - (double)step->ticks[i])) <= most));
    }
    return is_there;
}

static void read_commands(program_watch_t *self, const rig_t *rig)
{
    for (uint32_t i = 0U; i < rig->inputs.command_count; i++) {
        const command_t *const command = &rig->inputs.commands[i];
        if (!replies_accept(&rig->outputs, i)) {
            continue;
        }
        if (command->kind == (uint32_t)COMMAND_PROGRAM_BEGIN) {
            self->count = 0U;
        } else if (command->kind == (uint32_t)COMMAND_PROGRAM_STEP) {
            program_watch_step_t *const step = &self->steps[self->count % LIMIT_PROGRAM_STEPS];
            for (uint32_t axis = 0U; axis < ROBOT_AXIS_MAX; axis++) {
                step->ticks[axis] = command->as.step.ticks[axis];
            }
            step->dwell_ms = command->as.step.dwell_ms;
            step->is_gated = command->as.step.is_gated != 0U;
            self->count++;
        } else if (command->kind == (uint32_t)COMMAND_RUN_PROGRAM) {
            self->done = 0U;
            self->rested_us = 0U;
        } else {
            /* Nothing of a program. */
        }
    }
}

/* A longer rest is no matter of a broken part. */
static bool is_dwell_wrong(const program_watch_t *self, const rig_t *rig, bool is_by_dose,
                           const double truth[ROBOT_AXIS_MAX], bool is_disturbed)
{
    const program_watch_step_t *const step = &self->steps[self->done % LIMIT_PROGRAM_STEPS];
    const uint32_t dwell_us = step->dwell_ms * US_PER_MS;
    const bool is_dosed = step->is_gated && (rig->inputs.dose_reached != 0U) && self->was_undosed;
    return (is_by_dose ? !is_dosed : (self->rested_us < dwell_us)) ||
           (!is_disturbed &&
            ((self->rested_us > (dwell_us + LONGER_US)) || !stands_at(rig, step, truth)));
}

static uint32_t judge_steps(program_watch_t *self, const rig_t *rig,
                            const double truth[ROBOT_AXIS_MAX], bool is_disturbed)
{
    uint32_t broken = 0U;
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        const event_t *const event = &rig->outputs.events[i];
        if (event->id == (uint32_t)EVENT_PROGRAM_STEP) {
            broken |= rule(PROGRAM_DWELL,
                           is_dwell_wrong(self, rig, event->value == 1, truth, is_disturbed));
            self->done++;
            self->rested_us = 0U;
            self->was_undosed = false;
            broken |= rule(PROGRAM_END, event->subject != self->done);
        }
    }
    return broken;
}

static bool is_done_early(const program_watch_t *self, const rig_t *rig)
{
    bool is_early = false;
    for (uint32_t i = 0U; i < rig->outputs.answer_count; i++) {
        const answer_t *const answer = &rig->outputs.answers[i];
        is_early = is_early || ((answer->kind == (uint32_t)ANSWER_DONE) &&
                                (answer->command == (uint32_t)COMMAND_RUN_PROGRAM) &&
                                (self->done != self->count));
    }
    return is_early;
}

static void follow_rest(program_watch_t *self, const rig_t *rig)
{
    const bool is_moving = rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING;
    if (is_moving && !rig_is_driving(rig)) {
        self->rested_us += rig->inputs.elapsed_us;
        self->was_undosed = self->was_undosed || (rig->inputs.dose_reached == 0U);
    }
}

uint32_t program_watch_look(program_watch_t *self, const order_watch_t *order, const rig_t *rig,
                            const double truth[ROBOT_AXIS_MAX], bool is_disturbed)
{
    uint32_t broken = 0U;
    if (order->kind == (uint32_t)COMMAND_RUN_PROGRAM) {
        follow_rest(self, rig);
        broken = judge_steps(self, rig, truth, is_disturbed);
        broken |= rule(PROGRAM_END, is_done_early(self, rig));
        broken |= rule(PROGRAM_GATE, (rig->inputs.treatment_stopped != 0U) && rig_is_driving(rig));
    }
    read_commands(self, rig);
    return broken;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/cycle/controller_move.h"

#include "controller/controller_facts.h"
#include "controller/controller_force.h"
#include "controller/controller_membranes.h"
#include "controller/controller_order.h"
#include "robot/robot_damage.h"
#include "safety/permit.h"

static void follow_pedal(controller_t *self, const cycle_t *cycle)
{
    const bool is_open = pedal_gate_is_open(&self->pedal);
    if (is_open && !procedure_is_moving(&self->procedure)) {
        controller_notify_order(self, cycle, ARMING_EVENT_PEDAL_DOWN, STATUS_OK);
    } else if (!is_open && procedure_is_moving(&self->procedure)) {
        controller_notify_order(self, cycle, ARMING_EVENT_PEDAL_UP, STATUS_OK);
    } else {
        /* Nothing has changed. */
    }
}

/* The hand as far as it was seen off the handle before, and the membranes. */
static void feel(controller_t *self, const cycle_t *cycle, mode_frame_t *frame)
{
    hand_t *const hand = &frame->hand;
    *hand = controller_hand(self, cycle);
    frame->is_puncture = false;
    if (cycle->robot->force.is_there != 0U) {
        const bool goes_on =
            procedure_is_moving(&self->procedure) &&
            !force_channel_is_still(&self->force.sealed.channels[FORCE_CHANNEL_HAND]) &&
            !mode_wants_hand_off(&self->mode, mode_in(&self->mode, frame->workphase));
        hand->force_mn = hand_guard_step(&self->sealed.hand_guard, &cycle->robot->hand, hand,
                                         goes_on, cycle->inputs->elapsed_us);
        frame->is_puncture = controller_feel_membranes(self, cycle);
    }
}

/* The cap is the permit's, known before the mode plans anything. */
static void fill_frame(controller_t *self, const cycle_t *cycle, bool is_every_axis_homed,
                       mode_frame_t *frame)
{
    const uint32_t percent = permit_cap_percent(is_every_axis_homed);
    frame->robot = cycle->robot;
    frame->axes = self->axes;
    frame->axis_count = self->sealed.axis_count;
    frame->is_every_axis_homed = is_every_axis_homed;
    frame->workphase = procedure_workphase(&self->procedure);
    frame->is_moving = procedure_is_moving(&self->procedure);
    frame->elapsed_us = cycle->inputs->elapsed_us;
    frame->rows = self->rows;
    frame->program = &self->program;
    frame->is_dose_reached = cycle->inputs->dose_reached != 0U;
    frame->is_treatment_stopped = cycle->inputs->treatment_stopped != 0U;
    frame->links = self->links;
    feel(self, cycle, frame);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        frame->speed_cap_percent[i] = percent;
    }
}

/* The result of the mode becomes events, and the end of the order. */
static void notify(controller_t *self, const cycle_t *cycle, const mode_result_t *result)
{
    for (uint32_t i = 0U; i < result->note_count; i++) {
        const mode_note_t *const note = &result->notes[i];
        controller_note(self, cycle, note->id, note->axis, note->value);
    }
    if (result->progress == MODE_DONE) {
        controller_notify_order(self, cycle, ARMING_EVENT_DONE, STATUS_OK);
    } else if (result->progress == MODE_FAILED) {
        const bool is_of_axis = result->axis != MODE_NO_AXIS;
        const cycle_t because =
            controller_with_cause(cycle, is_of_axis ? EVENT_CAUSE_AXIS : EVENT_CAUSE_NONE,
                                  is_of_axis ? result->axis : 0U);
        controller_notify_order(self, &because, ARMING_EVENT_FAULT, result->status);
    } else {
        /* It goes on. */
    }
}

/* A hand that cannot be trusted moves nothing, and what it was to move ends, pedal or not. */
static bool is_hand_doubtful(const controller_t *self, const mode_frame_t *frame)
{
    return procedure_is_armed(&self->procedure) &&
           mode_is_by_hand(mode_in(&self->mode, frame->workphase)) &&
           (!frame->hand.is_trusted || robot_is_force_damaged(frame->robot));
}

/* A steering is forgotten with its target, whatever has taken that. */
static void note_unsteered(controller_t *self, const cycle_t *cycle)
{
    const uint32_t was_steered = self->sealed.is_steered;
    self->sealed.is_steered = 0U;
    if (steering_is_on(&self->plan.steering)) {
        self->sealed.is_steered = 1U;
    } else if (was_steered != 0U) {
        controller_note(self, cycle, EVENT_STEERING_FORGOTTEN, 0U, 0);
    } else {
        /* It goes straight, as before. */
    }
}

void controller_move(controller_t *self, const cycle_t *cycle, mode_result_t *result)
{
    note_unsteered(self, cycle);
    follow_pedal(self, cycle);
    mode_frame_t frame;
    fill_frame(self, cycle, controller_is_homed(self), &frame);
    if (is_hand_doubtful(self, &frame)) {
        mode_clear(result);
        mode_give_up(&frame, result, STATUS_FORCE_DOUBTFUL);
    } else {
        mode_step(&self->mode, &frame, result);
    }
    notify(self, cycle, result);
}

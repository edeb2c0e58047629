/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller.h"

#include "base/contract.h"
#include "controller/controller_parts.h"

#include <stddef.h>
#include <string.h>

static const char contract_module[] = "controller";

void controller_note(controller_t *self, const cycle_t *cycle, event_id_t id, uint32_t subject,
                     int32_t value)
{
    controller_outputs_t *const outputs = cycle->outputs;
    if (outputs->event_count >= CONTROLLER_EVENTS) {
        self->events_lost++;
        return;
    }
    event_t *const event = &outputs->events[outputs->event_count];
    event->number = self->events;
    event->cycle = self->cycle;
    event->id = (uint32_t)id;
    event->severity = (uint32_t)event_severity(id);
    event->subject = subject;
    event->value = value;
    event->cause = self->cause;
    event->peer = self->peer;
    outputs->event_count++;
    self->events++;
}

void controller_because(controller_t *self, event_cause_t cause, uint32_t peer)
{
    self->cause = (uint32_t)cause;
    self->peer = peer;
}

void controller_init(controller_t *self, const robot_t *robot)
{
    (void)memset(self, 0, sizeof *self);
    pedal_gate_init(&self->pedal);
    loop_guard_init(&self->loop);
    estop_latch_chart_init(&self->estop);
    workphases_chart_init(&self->workphases);
    plan_init(&self->plan);
    self->axis_count = robot->axis_count;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        axis_init(&self->axes[i]);
        link_init(&self->links[i], (uint32_t)robot->axes[i].slot,
                  (uint32_t)robot->axes[i].card_type, robot->card_firmware);
    }
    controller_seal(self);
}

void controller_step(controller_t *self, const robot_t *robot, const controller_inputs_t *inputs,
                     controller_outputs_t *outputs)
{
    REQUIRE(100U, inputs->command_count <= CONTROLLER_COMMANDS);
    const cycle_t cycle = {.robot = robot, .inputs = inputs, .outputs = outputs};
    card_drive_t requests[ROBOT_AXIS_MAX];
    /* The frames are written, or cleared, by controller_drive(). */
    (void)memset(outputs, 0, offsetof(controller_outputs_t, frames));
    controller_check_memory(self, &cycle);
    if (self->has_started == 0U) {
        self->has_started = 1U;
        controller_note(self, &cycle, EVENT_STARTED, 0U, (int32_t)self->kept.verdict);
    }
    self->time_us += inputs->elapsed_us;
    controller_observe(self, &cycle);
    controller_obey(self, &cycle);
    controller_move(self, &cycle, requests);
    controller_drive(self, &cycle, requests);
    controller_show(self, &cycle);
    self->cycle++;
    controller_seal(self);
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Contract of controller_note() for Eva: it writes any events of this cycle and their
 * numbers, and nothing else. Under a name of its own: `parts.c` follows the real one. */
#ifndef BORESIGHT_EVA_CONTROLLER_EVENTS_H
#define BORESIGHT_EVA_CONTROLLER_EVENTS_H

#include "../../../../core/controller/controller_events.h"

#define controller_note any_controller_note

/*@ requires valid: \valid(self) && \valid_read(cycle) && \valid(cycle->outputs);
    requires room: cycle->outputs->event_count <= CONTROLLER_EVENTS;
    assigns self->last_event, self->sealed.events, self->sealed.events_lost
             \from id, self->sealed.events, self->sealed.events_lost, *cycle->outputs;
    assigns cycle->outputs->event_count, cycle->outputs->events[0 .. CONTROLLER_EVENTS - 1]
             \from *cycle->outputs, self->sealed, cycle->cause, cycle->peer, id, subject, value;
    ensures room: cycle->outputs->event_count <= CONTROLLER_EVENTS; */
void any_controller_note(controller_t *self, const cycle_t *cycle, event_id_t id, uint32_t subject,
                         int32_t value);

#endif

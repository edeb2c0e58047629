/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_events.h"

#include "interface/note_kind.h"

void controller_note(controller_t *self, const cycle_t *cycle, event_id_t id, uint32_t subject,
                     int32_t value)
{
    controller_outputs_t *const outputs = cycle->outputs;
    self->last_event = (uint32_t)id;
    if (outputs->event_count >= CONTROLLER_EVENTS) {
        self->sealed.events_lost++;
        return;
    }
    event_t *const event = &outputs->events[outputs->event_count];
    event->number = self->sealed.events;
    event->cycle = self->sealed.cycle;
    event->id = (uint32_t)id;
    event->severity = (uint32_t)event_severity(id);
    event->subject = subject;
    event->value = value;
    event->cause = (uint32_t)cycle->cause;
    event->peer = cycle->peer;
    outputs->event_count++;
    self->sealed.events++;
}

cycle_t controller_with_cause(const cycle_t *cycle, event_cause_t cause, uint32_t peer)
{
    cycle_t because = *cycle;
    because.cause = cause;
    because.peer = peer;
    return because;
}

status_t controller_obey_note(controller_t *self, const cycle_t *cycle, const command_t *command,
                              answer_t *answer)
{
    (void)answer;
    const command_note_t *const sent = command_as_note(command);
    if (sent->note >= NOTE_KIND_COUNT) {
        return STATUS_UNKNOWN_COMMAND;
    }
    const bool is_refusal = sent->note == (uint32_t)NOTE_LOGIN_REFUSED;
    controller_note(self, cycle, is_refusal ? EVENT_LOGIN_REFUSED : EVENT_NOTE, sent->note,
                    sent->number);
    return STATUS_OK;
}

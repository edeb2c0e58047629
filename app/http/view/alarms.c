/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/alarms.h"

#include "charts/axis_chart.h"
#include "interface/app/event_words.h"

/* The axis that an event is about; ROBOT_AXIS_MAX: none. */
static uint32_t axis_of(const event_t *event)
{
    uint32_t axis = ROBOT_AXIS_MAX;

    if (event_subject_word(event->id) == EVENT_WORD_AXIS) {
        axis = event->subject;
    } else if (event_subject_owner(event->id, event->subject) == EVENT_WORD_AXIS) {
        axis = (uint32_t)event->value;
    } else {
        /* It is about something else. */
    }
    return (axis < ROBOT_AXIS_MAX) ? axis : ROBOT_AXIS_MAX;
}

static void note(alarm_word_t *word, const exchange_event_t *event)
{
    word->is_known = true;
    word->said = *event;
}

static void take_part(alarms_t *self, const exchange_event_t *event)
{
    static const struct {
        uint32_t id;
        alarm_part_t part;
    } parts[] = {{EVENT_ROBOT_TABLE_DAMAGED, ALARM_PART_TABLE},
                 {EVENT_INPUTS_UNREAD, ALARM_PART_INPUTS},
                 {EVENT_ESTOP_PULLED, ALARM_PART_ESTOP},
                 {EVENT_LOOP_STOPPED, ALARM_PART_LOOP},
                 {EVENT_PEDAL_FAULT, ALARM_PART_PEDAL},
                 {EVENT_RECORDING_STOPPED, ALARM_PART_RECORDER}};

    for (uint32_t i = 0U; i < (sizeof parts / sizeof parts[0]); i++) {
        if (parts[i].id == event->event.id) {
            note(&self->parts[parts[i].part], event);
        }
    }
    if (event->event.id == (uint32_t)EVENT_ESTOP_CLEARED) {
        self->parts[ALARM_PART_ESTOP].is_known = false;
    }
    if (event->event.id == (uint32_t)EVENT_INPUTS_READ) {
        self->parts[ALARM_PART_INPUTS].is_known = false;
    }
}

static void take_card(alarms_t *self, const exchange_event_t *event)
{
    const uint32_t slot = event->event.subject;

    if (slot >= CARD_SLOT_COUNT) {
        return;
    }
    switch (event->event.id) {
    case (uint32_t)EVENT_CARD_LOST:
        note(&self->cards[slot], event);
        break;
    case (uint32_t)EVENT_CARD_LIVE:
        self->cards[slot].is_known = false;
        break;
    case (uint32_t)EVENT_CARD_UNWELL:
        note(&self->unwell[slot], event);
        break;
    default:
        break;
    }
}

static void place(alarm_place_t *self, bool is_now, int32_t ticks, uint32_t cycle)
{
    *self = (alarm_place_t){.is_now = is_now, .is_known = true, .ticks = ticks, .cycle = cycle};
}

/* Counts before the first homing mean no place, so what is lost then was none. */
static void lose_place(alarm_place_t *self, const event_t *event)
{
    if (self->is_now) {
        place(self, false, event->value, event->cycle);
    }
}

static void take_place(alarms_t *self, const exchange_event_t *event, uint32_t axis)
{
    switch (event->event.id) {
    case (uint32_t)EVENT_AXIS_HOMED:
    case (uint32_t)EVENT_AXIS_TAKEN:
    case (uint32_t)EVENT_AXIS_CONFIRMED:
        self->doubts[axis].is_known = false;
        self->places[axis].is_now = true;
        break;
    case (uint32_t)EVENT_AXIS_RESTORED:
    case (uint32_t)EVENT_AXIS_PLACED:
        note(&self->doubts[axis], event);
        place(&self->places[axis], false, event->event.value, event->event.cycle);
        break;
    case (uint32_t)EVENT_AXIS_REFERENCE_LOST:
    case (uint32_t)EVENT_AXIS_UNVERIFIED:
        note(&self->doubts[axis], event);
        lose_place(&self->places[axis], &event->event);
        break;
    case (uint32_t)EVENT_AXIS_CONTRADICTED:
        note(&self->doubts[axis], event);
        break;
    default:
        break;
    }
}

void alarms_take(alarms_t *self, const exchange_event_t *event)
{
    const uint32_t axis = axis_of(&event->event);

    take_part(self, event);
    if (event_subject_word(event->event.id) == EVENT_WORD_CARD) {
        take_card(self, event);
    }
    if (axis < ROBOT_AXIS_MAX) {
        if (event->event.severity == (uint32_t)EVENT_SEVERITY_CRITICAL) {
            note(&self->faults[axis], event);
        }
        take_place(self, event, axis);
    }
}

void alarms_see(alarms_t *self, const snapshot_t *snapshot)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        const snapshot_axis_t *const axis = &snapshot->axes[i];
        const bool is_homed = ((uint32_t)axis->reference == (uint32_t)AXIS_REFERENCE_VERIFIED) ||
                              ((uint32_t)axis->reference == (uint32_t)AXIS_REFERENCE_TAKEN);
        if (is_homed) {
            place(&self->places[i], true, axis->position_ticks, snapshot->cycle);
        } else {
            self->places[i].is_now = false;
        }
    }
}

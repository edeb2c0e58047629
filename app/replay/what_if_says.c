/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/what_if_says.h"

#include "common/event_text.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "replay/frame_fields.h"
#include "robot/robot_cards.h"

#include <stdio.h>
#include <string.h>

#define CYCLES_PER_S (1e6 / LIMIT_CYCLE_US)
#define VALUE_SIZE (SERIES_WORD_SIZE + 1U)

static void keep(void *to, const series_t *series)
{
    what_if_list_t *const list = to;

    if (list->count < WHAT_IF_SERIES) {
        list->series[list->count] = *series;
        list->count++;
    }
}

static void write_value(const series_t *series, char text[VALUE_SIZE])
{
    if (series->kind == SERIES_NUMBER) {
        (void)snprintf(text, VALUE_SIZE, "%.*f", series->decimals, series->number);
    } else if (series->kind == SERIES_FLAG) {
        (void)snprintf(text, VALUE_SIZE, "%s", (series->number != 0.0) ? "true" : "false");
    } else {
        (void)snprintf(text, VALUE_SIZE, "%s", (series->word[0] != '\0') ? series->word : "none");
    }
}

/* Begins a line. */
static void say_cycle(const what_if_t *self)
{
    (void)printf("Cycle %lu (%.3f s): ", (unsigned long)self->cycle,
                 (double)self->cycle / CYCLES_PER_S);
}

static void say_series(const what_if_t *self, const char *where, const series_t *was,
                       const series_t *now)
{
    char recorded[VALUE_SIZE];
    char changed[VALUE_SIZE];

    write_value(was, recorded);
    write_value(now, changed);
    say_cycle(self);
    (void)printf("%s %s is %s, was %s.\n", where, now->name, changed, recorded);
}

static bool differs(const series_t *was, const series_t *now)
{
    return (was->number != now->number) || (strcmp(was->word, now->word) != 0);
}

/* Of a source those series that are numbers, or those that are not. Returns how many are told. */
static uint32_t say_source(what_if_t *self, uint32_t place, const snapshot_t *recorded,
                           bool are_numbers)
{
    const source_t *const source = &self->sources[place];
    uint32_t told = 0U;

    self->was.count = 0U;
    self->now.count = 0U;
    source_tell(source, recorded, keep, &self->was);
    source_tell(source, &self->outputs.snapshot, keep, &self->now);
    for (uint32_t i = 0U; i < self->now.count; i++) {
        const series_t *const now = &self->now.series[i];
        if (((now->kind == SERIES_NUMBER) == are_numbers) && !self->is_told[place][i] &&
            differs(&self->was.series[i], now)) {
            self->is_told[place][i] = true;
            say_series(self, &source->topic[1], &self->was.series[i], now);
            told++;
        }
    }
    return told;
}

static uint32_t say_sources(what_if_t *self, const snapshot_t *recorded, bool are_numbers)
{
    uint32_t told = 0U;

    for (uint32_t i = 0U; i < self->source_count; i++) {
        told += say_source(self, i, recorded, are_numbers);
    }
    return told;
}

/* States only when those of either side are others than in the cycle before. */
static uint32_t say_states(what_if_t *self, const snapshot_t *recorded)
{
    const uint32_t was = series_states(fields_snapshot, recorded);
    const uint32_t now = series_states(fields_snapshot, &self->outputs.snapshot);
    const bool is_same = (was == self->states[0]) && (now == self->states[1]);

    self->states[0] = was;
    self->states[1] = now;
    return ((was == now) || is_same) ? 0U : say_sources(self, recorded, false);
}

static bool is_same_event(const event_t *one, const event_t *other)
{
    return (one->id == other->id) && (one->subject == other->subject) &&
           (one->value == other->value) && (one->cause == other->cause) &&
           (one->peer == other->peer);
}

static bool has_event(const controller_outputs_t *outputs, const event_t *event)
{
    for (uint32_t i = 0U; (i < outputs->event_count) && (i < CONTROLLER_EVENTS); i++) {
        if (is_same_event(&outputs->events[i], event)) {
            return true;
        }
    }
    return false;
}

/* Those of one side that the other has not in this cycle. */
static uint32_t say_events(what_if_t *self, const controller_outputs_t *side,
                           const controller_outputs_t *other)
{
    bool *const is_told = self->is_event_told[(side == &self->outputs) ? 1U : 0U];
    const char *const says = (side == &self->outputs) ? "event" : "no event";
    char sentence[EVENT_TEXT_SIZE];
    uint32_t told = 0U;

    for (uint32_t i = 0U; (i < side->event_count) && (i < CONTROLLER_EVENTS); i++) {
        const event_t *const event = &side->events[i];
        if (!has_event(other, event) && (event->id < EVENT_ID_COUNT) && !is_told[event->id]) {
            is_told[event->id] = true;
            event_text_sentence(self->robot, event, NULL, sentence, sizeof sentence);
            say_cycle(self);
            (void)printf("%s %s: %s\n", says, event_id_name((int32_t)event->id), sentence);
            told++;
        }
    }
    return told;
}

/* What leaves to a card; a slot without a frame gets no drive. */
static void find_drive(const controller_outputs_t *outputs, uint32_t slot, card_command_t *command)
{
    (void)memset(command, 0, sizeof *command);
    if ((outputs->frames_to_send & (1U << slot)) != 0U) {
        (void)card_frame_decode_command(outputs->frames[slot], slot, command);
    }
}

static void print_drive(const char *before, const card_drive_t *drive)
{
    (void)printf("%s%s (word %lu, direction %lu)", before, frame_drive_word((int32_t)drive->mode),
                 (unsigned long)drive->duty, (unsigned long)drive->direction);
}

static uint32_t say_drive(what_if_t *self, uint32_t slot, const controller_outputs_t *recorded)
{
    card_command_t was;
    card_command_t now;

    find_drive(recorded, slot, &was);
    find_drive(&self->outputs, slot, &now);
    if (self->is_drive_told[slot] || (memcmp(&was.drive, &now.drive, sizeof was.drive) == 0)) {
        return 0U;
    }
    self->is_drive_told[slot] = true;
    const uint32_t axis = robot_cards_axis(self->robot, slot);
    say_cycle(self);
    (void)printf("to card %lu (%s) leaves drive ", (unsigned long)slot,
                 (axis < self->robot->axis_count) ? self->robot->axes[axis].name : "no axis");
    print_drive("", &now.drive);
    print_drive(", was ", &was.drive);
    (void)printf(".\n");
    return 1U;
}

void what_if_says(what_if_t *self, const controller_outputs_t *recorded)
{
    uint32_t told = say_states(self, &recorded->snapshot);

    told += say_events(self, &self->outputs, recorded);
    told += say_events(self, recorded, &self->outputs);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        told += say_drive(self, slot, recorded);
    }
    if ((self->different == 1U) && (told == 0U)) {
        (void)say_sources(self, &recorded->snapshot, true);
    }
}

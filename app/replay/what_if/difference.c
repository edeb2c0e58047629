/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/what_if/difference.h"

#include "common/event_text.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "replay/data/frame_fields.h"
#include "robot/robot_cards.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define CYCLES_PER_S (1e6 / LIMIT_CYCLE_US)
#define VALUE_SIZE (SERIES_WORD_SIZE + 1U)

void difference_init(difference_t *self, const robot_t *robot, difference_sink_t *sink, void *to)
{
    (void)memset(self, 0, sizeof *self);
    self->robot = robot;
    self->sink = sink;
    self->to = to;
    self->source_count = source_find(robot, self->sources);
}

static void keep(void *to, const series_t *series)
{
    difference_list_t *const list = to;

    if (list->count < DIFFERENCE_SERIES) {
        list->series[list->count] = *series;
        list->count++;
    }
}

__attribute__((format(printf, 2, 3))) static void say(const difference_t *self, const char *format,
                                                      ...)
{
    char line[DIFFERENCE_LINE_SIZE];
    va_list words;

    const int used = snprintf(line, sizeof line, "Cycle %lu (%.3f s): ", (unsigned long)self->cycle,
                              (double)self->cycle / CYCLES_PER_S);
    va_start(words, format);
    (void)vsnprintf(&line[used], sizeof line - (size_t)used, format, words);
    va_end(words);
    self->sink(self->to, line);
}

static void say_series(const difference_t *self, const char *where, const series_t *was,
                       const series_t *now)
{
    char before[VALUE_SIZE];
    char after[VALUE_SIZE];

    series_write(was, before, sizeof before);
    series_write(now, after, sizeof after);
    say(self, "%s %s is %s, was %s.", where, now->name, after, before);
}

static bool differs(const series_t *was, const series_t *now)
{
    return (was->number != now->number) || (strcmp(was->word, now->word) != 0);
}

/* Series of a source that are numbers, or those that are not. Returns the number that is reported.
 */
static uint32_t say_source(difference_t *self, uint32_t place, const snapshot_t *const both[2],
                           bool are_numbers)
{
    const source_t *const source = &self->sources[place];
    uint32_t reported = 0U;

    self->was.count = 0U;
    self->now.count = 0U;
    source_report(source, both[0], keep, &self->was);
    source_report(source, both[1], keep, &self->now);
    for (uint32_t i = 0U; i < self->now.count; i++) {
        const series_t *const now = &self->now.series[i];
        if (((now->kind == SERIES_NUMBER) == are_numbers) && !self->is_reported[place][i] &&
            differs(&self->was.series[i], now)) {
            self->is_reported[place][i] = true;
            say_series(self, &source->topic[1], &self->was.series[i], now);
            reported++;
        }
    }
    return reported;
}

static uint32_t say_sources(difference_t *self, const snapshot_t *const both[2], bool are_numbers)
{
    uint32_t reported = 0U;

    for (uint32_t i = 0U; i < self->source_count; i++) {
        reported += say_source(self, i, both, are_numbers);
    }
    return reported;
}

/* States only when those of either side are others than in the cycle before. */
static uint32_t say_states(difference_t *self, const snapshot_t *const both[2])
{
    const uint32_t was = series_states(fields_snapshot, both[0]);
    const uint32_t now = series_states(fields_snapshot, both[1]);
    const bool is_same = (was == self->states[0]) && (now == self->states[1]);

    self->states[0] = was;
    self->states[1] = now;
    return ((was == now) || is_same) ? 0U : say_sources(self, both, false);
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

/* Those of the one (0) or of the other (1) side that are not of both in this cycle. */
static uint32_t say_events(difference_t *self, const controller_outputs_t *const both[2],
                           uint32_t which)
{
    const controller_outputs_t *const side = both[which];
    bool *const is_reported = self->is_event_reported[which];
    char sentence[EVENT_TEXT_SIZE];
    uint32_t reported = 0U;

    for (uint32_t i = 0U; (i < side->event_count) && (i < CONTROLLER_EVENTS); i++) {
        const event_t *const event = &side->events[i];
        if (!has_event(both[1U - which], event) && (event->id < EVENT_ID_COUNT) &&
            !is_reported[event->id]) {
            is_reported[event->id] = true;
            event_text_sentence(self->robot, event, NULL, sentence, sizeof sentence);
            say(self, "%s %s: %s", (which == 1U) ? "event" : "no event",
                event_id_name((int32_t)event->id), sentence);
            reported++;
        }
    }
    return reported;
}

/* The command that leaves to a card; a slot without a frame gets no drive. */
static void find_drive(const controller_outputs_t *outputs, uint32_t slot, card_command_t *command)
{
    (void)memset(command, 0, sizeof *command);
    if ((outputs->frames_to_send & (1U << slot)) != 0U) {
        (void)card_frame_decode_command(outputs->frames[slot], slot, command);
    }
}

static uint32_t say_drive(difference_t *self, uint32_t slot,
                          const controller_outputs_t *const both[2])
{
    card_command_t was;
    card_command_t now;

    find_drive(both[0], slot, &was);
    find_drive(both[1], slot, &now);
    if (self->is_drive_reported[slot] || (memcmp(&was.drive, &now.drive, sizeof was.drive) == 0)) {
        return 0U;
    }
    self->is_drive_reported[slot] = true;
    const uint32_t axis = robot_cards_axis(self->robot, slot);
    say(self,
        "to card %lu (%s) leaves drive %s (word %lu, direction %lu), was %s (word %lu, direction "
        "%lu).",
        (unsigned long)slot,
        (axis < self->robot->axis_count) ? self->robot->axes[axis].name : "no axis",
        frame_drive_word((int32_t)now.drive.mode), (unsigned long)now.drive.duty,
        (unsigned long)now.drive.direction, frame_drive_word((int32_t)was.drive.mode),
        (unsigned long)was.drive.duty, (unsigned long)was.drive.direction);
    return 1U;
}

void difference_report(difference_t *self, uint32_t cycle, const controller_outputs_t *was,
                       const controller_outputs_t *now)
{
    if (memcmp(was, now, sizeof *was) == 0) {
        return;
    }
    const controller_outputs_t *const both[2] = {was, now};
    const snapshot_t *const snapshots[2] = {&was->snapshot, &now->snapshot};
    const bool is_first = !self->has_begun;

    self->has_begun = true;
    self->cycle = cycle;
    uint32_t reported = say_states(self, snapshots);
    reported += say_events(self, both, 1U);
    reported += say_events(self, both, 0U);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        reported += say_drive(self, slot, both);
    }
    if (is_first && (reported == 0U)) {
        (void)say_sources(self, snapshots, true);
    }
}

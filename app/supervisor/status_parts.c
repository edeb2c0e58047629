/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/status_parts.h"

#include "charts/loop_guard_chart.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define REPEAT_US UINT64_C(5000000)
#define BETWEEN " | "
#define LEFT_OUT " ..."
#define MOST_COLUMNS 100000U
#define MINUTES_PER_HOUR 60U

static const char *const colours[] = {[STATUS_PLAIN] = "",
                                      [STATUS_GOOD] = "\033[32m",
                                      [STATUS_NOTE] = "\033[33m",
                                      [STATUS_BAD] = "\033[1;31m"};
static const char plain_again[] = "\033[0m";

void status_parts_add(status_parts_t *self, status_tone_t tone, const char *format, ...)
{
    va_list arguments;

    if (self->count < STATUS_PARTS) {
        status_part_t *const part = &self->parts[self->count];
        va_start(arguments, format);
        (void)vsnprintf(part->text, sizeof part->text, format, arguments);
        va_end(arguments);
        part->tone = tone;
        self->count++;
    }
}

bool status_repeat_is_due(status_repeat_t *self, const status_parts_t *parts, uint64_t now_us)
{
    const uint32_t bad_before = self->bad;

    self->bad = 0U;
    for (uint32_t i = 0U; i < parts->count; i++) {
        self->bad += (parts->parts[i].tone == STATUS_BAD) ? 1U : 0U;
    }
    const bool is_due = (self->bad > bad_before) || (self->shown_us == 0U) ||
                        ((now_us - self->shown_us) >= REPEAT_US);
    self->shown_us = is_due ? now_us : self->shown_us;
    return is_due;
}

void status_parts_add_room(status_parts_t *self, uint32_t minutes)
{
    const status_tone_t tone = (minutes < LIMIT_RECORDING_LEFT_MIN) ? STATUS_NOTE : STATUS_PLAIN;

    if (minutes >= MINUTES_PER_HOUR) {
        status_parts_add(self, tone, "disk full in %u h %u min at this rate",
                         (unsigned)(minutes / MINUTES_PER_HOUR),
                         (unsigned)(minutes % MINUTES_PER_HOUR));
    } else if (minutes > 0U) {
        status_parts_add(self, tone, "disk full in %u min at this rate", (unsigned)minutes);
    } else {
        /* Nothing to say. */
    }
}

void status_parts_add_lateness(status_parts_t *self, const snapshot_t *shown)
{
    if (shown->loop == (uint32_t)LOOP_GUARD_STATE_STOPPED) {
        status_parts_add(self, STATUS_BAD, "loop STOPPED: %s late by %.1f ms, %u in %.1f ms",
                         loop_stage_name((int32_t)shown->late_stage),
                         (double)shown->late_us / 1000.0, (unsigned)shown->late_count,
                         (double)shown->late_span_us / 1000.0);
    }
}

/* Columns that the part takes behind others. */
static size_t width_of(const status_part_t *part)
{
    return strlen(BETWEEN) + strlen(part->text);
}

/* Takes those of one tone that fit into `*left` columns. */
static void pick_tone(const status_parts_t *self, status_tone_t tone, bool is_shown[STATUS_PARTS],
                      size_t *left)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        const status_part_t *const part = &self->parts[i];
        if (!is_shown[i] && (part->tone == tone) && (width_of(part) <= *left)) {
            is_shown[i] = true;
            *left -= width_of(part);
        }
    }
}

/* The first one in any case, then trouble. @return whether all are shown */
static bool pick(const status_parts_t *self, size_t columns, bool is_shown[STATUS_PARTS])
{
    static const status_tone_t tones[] = {STATUS_BAD, STATUS_NOTE, STATUS_GOOD, STATUS_PLAIN};
    const size_t first = (self->count > 0U) ? strlen(self->parts[0].text) : 0U;
    size_t left = (columns > first) ? (columns - first) : 0U;
    bool are_all = true;

    (void)memset(is_shown, 0, STATUS_PARTS * sizeof is_shown[0]);
    is_shown[0] = true;
    for (size_t i = 0U; i < (sizeof tones / sizeof tones[0]); i++) {
        pick_tone(self, tones[i], is_shown, &left);
    }
    for (uint32_t i = 0U; i < self->count; i++) {
        are_all = are_all && is_shown[i];
    }
    return are_all;
}

/* Appends a part, or nothing when there is no room for it. */
static void append(char *text, size_t size, const status_part_t *part, bool is_coloured)
{
    const size_t used = strlen(text);
    const bool has_colour = is_coloured && (part->tone != STATUS_PLAIN);
    const int length =
        snprintf(&text[used], size - used, "%s%s%s%s", (used > 0U) ? BETWEEN : "",
                 has_colour ? colours[part->tone] : "", part->text, has_colour ? plain_again : "");

    if ((size_t)length >= (size - used)) {
        text[used] = '\0';
    }
}

void status_parts_write(const status_parts_t *self, uint32_t columns, bool is_coloured, char *text,
                        size_t size)
{
    const size_t most = (columns > 0U) ? columns : MOST_COLUMNS;
    bool is_shown[STATUS_PARTS];
    const bool are_all = pick(self, most, is_shown);

    if (!are_all) {
        (void)pick(self, (most > strlen(LEFT_OUT)) ? (most - strlen(LEFT_OUT)) : 0U, is_shown);
    }
    text[0] = '\0';
    for (uint32_t i = 0U; i < self->count; i++) {
        if (is_shown[i]) {
            append(text, size, &self->parts[i], is_coloured);
        }
    }
    if (!are_all && ((strlen(text) + strlen(LEFT_OUT)) < size)) {
        (void)strcat(text, LEFT_OUT);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/membranes/force_csv.h"

#include "limits/requirement_limits.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TIME = 0, DEPTH, FORCE, COLUMNS };

#define NO_PLACE UINT32_MAX
#define MOST_TIME_MS 4e9
#define ROWS_AT_FIRST 4096U

typedef struct {
    force_csv_t *csv;
    uint32_t places[COLUMNS]; /* Of each column in a line. */
    uint32_t count;           /* Of all values of a line. */
    uint32_t room;            /* For rows. */
} reader_t;

static const char *const names[COLUMNS] = {
    [TIME] = "time_ms", [DEPTH] = "depth_mm", [FORCE] = "force_n"};

/* Nothing follows a line that is refused. */
static const char *refuse(force_csv_t *csv, const char *reason)
{
    (void)snprintf(csv->refused, sizeof csv->refused, "%s", reason);
    return NULL;
}

static size_t word_size(const char *at)
{
    return strcspn(at, ",\r\n");
}

/* Behind the end of this line. */
static const char *skip_end(force_csv_t *csv, const char *at, const char *reason)
{
    const char *const end = &at[(*at == '\r') ? 1 : 0];

    if (*end == '\n') {
        return &end[1];
    }
    return (*end == '\0') ? end : refuse(csv, reason);
}

/* The column of this name, COLUMNS: another one. */
static uint32_t find_name(const char *word)
{
    uint32_t column = 0U;

    while ((column < (uint32_t)COLUMNS) && ((strlen(names[column]) != word_size(word)) ||
                                            (strncmp(word, names[column], word_size(word)) != 0))) {
        column++;
    }
    return column;
}

static const char *read_head(reader_t *self, const char *text)
{
    static const char reason[] = "it must name time_ms, depth_mm and force_n, each once";
    const char *at = text;
    uint32_t found = 0U;

    for (bool more = true; more; self->count++) {
        const uint32_t column = find_name(at);
        if (column < (uint32_t)COLUMNS) {
            if (self->places[column] != NO_PLACE) {
                return refuse(self->csv, reason);
            }
            self->places[column] = self->count;
            found++;
        }
        at = &at[word_size(at)];
        more = *at == ',';
        at = &at[more ? 1 : 0];
    }
    return (found == (uint32_t)COLUMNS) ? skip_end(self->csv, at, reason)
                                        : refuse(self->csv, reason);
}

/* A decimal number that is all of its word. */
static bool read_number(const char *word, double *value)
{
    char *end = NULL;

    *value = strtod(word, &end);
    return (word_size(word) > 0U) && (strspn(word, "+-.0123456789eE") == word_size(word)) &&
           (end == &word[word_size(word)]);
}

/* The value at `place` of a line, if it is one of ours. */
static bool read_value(const reader_t *self, uint32_t place, const char *word,
                       double values[COLUMNS])
{
    bool is_number = true;

    for (uint32_t i = 0U; i < (uint32_t)COLUMNS; i++) {
        if (self->places[i] == place) {
            is_number = read_number(word, &values[i]);
        }
    }
    return is_number;
}

static const char *read_values(const reader_t *self, const char *line, double values[COLUMNS])
{
    static const char reason[] = "it has not as many values as the head has columns";
    const char *at = line;

    for (uint32_t place = 0U; place < self->count; place++) {
        if (place > 0U) {
            if (*at != ',') {
                return refuse(self->csv, reason);
            }
            at++;
        }
        if (!read_value(self, place, at, values)) {
            return refuse(self->csv, "a value is no decimal number");
        }
        at = &at[word_size(at)];
    }
    return skip_end(self->csv, at, reason);
}

static bool is_within(force_csv_t *csv, const char *name, double value, double most)
{
    if ((value >= -most) && (value <= most)) {
        return true;
    }
    (void)snprintf(csv->refused, sizeof csv->refused, "%s is not from %.0f to %.0f", name, -most,
                   most);
    return false;
}

static bool is_in_time(force_csv_t *csv, double time_ms)
{
    const double gap_ms = (double)LIMIT_MEMBRANE_CSV_GAP_MS;

    if (csv->count == 0U) {
        return true;
    }
    const double step_ms = time_ms - csv->rows[csv->count - 1U].time_ms;
    if ((step_ms > 0.0) && (step_ms <= gap_ms)) {
        return true;
    }
    (void)snprintf(csv->refused, sizeof csv->refused,
                   "time_ms is not after the row before, or more than %.0f after it", gap_ms);
    return false;
}

static bool make_room(reader_t *self)
{
    if (self->csv->count < self->room) {
        return true;
    }
    const uint32_t room = (self->room == 0U) ? ROWS_AT_FIRST : (2U * self->room);
    force_row_t *const rows = realloc(self->csv->rows, room * sizeof rows[0]);
    if (rows == NULL) {
        (void)refuse(self->csv, "there is no memory for more rows");
        return false;
    }
    self->csv->rows = rows;
    self->room = room;
    return true;
}

/* Behind the row. */
static const char *read_row(reader_t *self, const char *line)
{
    force_csv_t *const csv = self->csv;
    double values[COLUMNS] = {0.0, 0.0, 0.0};
    const char *const next = read_values(self, line, values);

    if ((next == NULL) || !is_within(csv, names[TIME], values[TIME], MOST_TIME_MS) ||
        !is_within(csv, names[DEPTH], values[DEPTH], (double)LIMIT_MEMBRANE_CSV_MOST_MM) ||
        !is_within(csv, names[FORCE], values[FORCE], (double)LIMIT_MEMBRANE_MOST_MN / 1000.0) ||
        !is_in_time(csv, values[TIME]) || !make_room(self)) {
        return NULL;
    }
    csv->rows[csv->count] = (force_row_t){values[TIME], values[DEPTH], values[FORCE]};
    csv->count++;
    return next;
}

uint32_t force_csv_read(force_csv_t *self, const char *text)
{
    reader_t reader = {.csv = self, .places = {NO_PLACE, NO_PLACE, NO_PLACE}};
    uint32_t line = 1U;

    *self = (force_csv_t){.rows = NULL};
    const char *at = read_head(&reader, text);
    while ((at != NULL) && (at[strspn(at, "\r\n")] != '\0')) {
        line++;
        at = read_row(&reader, at);
    }
    if ((at != NULL) && (self->count < 2U)) {
        at = refuse(self, "there are fewer than two rows");
    }
    if (at == NULL) {
        force_csv_free(self);
    }
    return (at == NULL) ? line : 0U;
}

void force_csv_free(force_csv_t *self)
{
    free(self->rows);
    self->rows = NULL;
    self->count = 0U;
}

static double between(double from, double to, double share)
{
    return from + ((to - from) * share);
}

bool force_samples_next(force_samples_t *self, force_row_t *sample)
{
    const force_row_t *const rows = self->csv->rows;
    const double time_ms = rows[0].time_ms + (double)self->at_ms;

    while ((self->row < (self->csv->count - 2U)) && (rows[self->row + 1U].time_ms < time_ms)) {
        self->row++;
    }
    const force_row_t *const from = &rows[self->row];
    const force_row_t *const to = &rows[self->row + 1U];
    if (time_ms > to->time_ms) {
        return false;
    }
    const double share = (time_ms - from->time_ms) / (to->time_ms - from->time_ms);
    *sample = (force_row_t){time_ms, between(from->depth_mm, to->depth_mm, share),
                            between(from->force_n, to->force_n, share)};
    self->at_ms++;
    return true;
}

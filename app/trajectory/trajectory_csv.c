/* SPDX-License-Identifier: Apache-2.0 */
#include "trajectory/trajectory_csv.h"

#include "common/axis_terms.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COLUMNS ((2U * ROBOT_AXIS_MAX) + 1U)
#define NAME_SIZE 32U

typedef enum { COLUMN_TIME, COLUMN_POSITION, COLUMN_SPEED } column_kind_t;

typedef struct {
    column_kind_t kind;
    uint32_t axis;
    double scale; /* To ms, ticks or ticks/s. */
} column_t;

typedef struct {
    column_t columns[COLUMNS];
    uint32_t count;
    uint32_t times;
    bool has_position[ROBOT_AXIS_MAX];
    bool has_speed[ROBOT_AXIS_MAX];
} head_t;

static bool read_time_unit(const char *unit, column_t *column)
{
    column->kind = COLUMN_TIME;
    column->scale = (strcmp(unit, "s") == 0) ? 1000.0 : 1.0;
    return (strcmp(unit, "s") == 0) || (strcmp(unit, "ms") == 0);
}

static bool read_axis_unit(const robot_t *robot, char *unit, column_t *column)
{
    const axis_config_t *axis = &robot->axes[column->axis];
    const char *own = (axis->unit == (uint8_t)AXIS_UNIT_MM) ? "mm" : "deg";
    char *slash = strchr(unit, '/');
    column->kind = (slash != NULL) ? COLUMN_SPEED : COLUMN_POSITION;
    if (slash != NULL) {
        if (strcmp(slash, "/s") != 0) {
            return false;
        }
        *slash = '\0';
    }
    column->scale = (strcmp(unit, own) == 0) ? (1.0 / axis_terms_unit(axis)) : 1.0;
    return (strcmp(unit, own) == 0) || (strcmp(unit, "ticks") == 0);
}

static bool take_column(head_t *self, const column_t *column)
{
    bool *has_it = (column->kind == COLUMN_SPEED) ? &self->has_speed[column->axis]
                                                  : &self->has_position[column->axis];
    if (self->count >= COLUMNS) {
        return false;
    }
    if (column->kind == COLUMN_TIME) {
        self->times++;
    } else if (*has_it) {
        return false;
    } else {
        *has_it = true;
    }
    self->columns[self->count] = *column;
    self->count++;
    return true;
}

/* "NAME UNIT". */
static bool read_column(head_t *self, const robot_t *robot, const char *text, size_t size)
{
    char name[NAME_SIZE];
    column_t column = {.kind = COLUMN_TIME};
    if (size >= sizeof name) {
        return false;
    }
    (void)memcpy(name, text, size);
    name[size] = '\0';
    char *space = strchr(name, ' ');
    if (space == NULL) {
        return false;
    }
    *space = '\0';
    const bool is_time = strcmp(name, "time") == 0;
    column.axis = is_time ? 0U : axis_terms_find(robot, name);
    if (column.axis == robot->axis_count) {
        return false;
    }
    return (is_time ? read_time_unit(&space[1], &column)
                    : read_axis_unit(robot, &space[1], &column)) &&
           take_column(self, &column);
}

/* Up to the end of its line; a value ends at a comma. NULL: the line is wrong. */
static const char *skip_end(const char *at)
{
    at += (at[0] == '\r') ? 1 : 0;
    if (*at == '\n') {
        return &at[1];
    }
    return (*at == '\0') ? at : NULL;
}

static const char *read_head(head_t *self, const robot_t *robot, const char *text,
                             bool is_all_needed)
{
    const char *at = text;
    (void)memset(self, 0, sizeof *self);
    for (;;) {
        const size_t size = strcspn(at, ",\r\n");
        if (!read_column(self, robot, at, size)) {
            return NULL;
        }
        at += size;
        if (*at != ',') {
            break;
        }
        at++;
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if ((self->has_speed[i] || is_all_needed) && !self->has_position[i]) {
            return NULL;
        }
    }
    return (self->times == 1U) ? skip_end(at) : NULL;
}

/* Decimal, up to `*end`. */
static bool read_number(const char *at, double *value, const char **end)
{
    char *stopped = NULL;
    *end = &at[strspn(at, "+-.0123456789eE")];
    *value = strtod(at, &stopped);
    return (*end != at) && (stopped == *end);
}

static bool put(const column_t *column, double value, trajectory_row_t *row)
{
    const double scaled = round(value * column->scale);
    if (!(fabs(scaled) <= (double)INT32_MAX) || ((column->kind == COLUMN_TIME) && (scaled < 0.0))) {
        return false;
    }
    if (column->kind == COLUMN_TIME) {
        row->time_ms = (uint32_t)scaled;
    } else if (column->kind == COLUMN_POSITION) {
        row->ticks[column->axis] = (int32_t)scaled;
    } else {
        row->speeds_ticks_per_s[column->axis] = (int32_t)scaled;
    }
    return true;
}

static const char *read_row(const head_t *head, const char *line, trajectory_row_t *row)
{
    const char *at = line;
    for (uint32_t i = 0U; i < head->count; i++) {
        const char *end = NULL;
        double value = 0.0;
        if (!read_number(at, &value, &end) || !put(&head->columns[i], value, row)) {
            return NULL;
        }
        at = end;
        if ((i + 1U) < head->count) {
            if (*at != ',') {
                return NULL;
            }
            at++;
        }
    }
    return skip_end(at);
}

static double slope(const trajectory_row_t *from, const trajectory_row_t *to, uint32_t axis)
{
    const double span_s = ((double)to->time_ms - (double)from->time_ms) / 1000.0;
    const double way = (double)to->ticks[axis] - (double)from->ticks[axis];
    return (span_s > 0.0) ? (way / span_s) : 0.0;
}

static void find_speeds(trajectory_csv_t *self, uint32_t axis)
{
    for (uint32_t i = 1U; (i + 1U) < self->count; i++) {
        const double before = slope(&self->rows[i - 1U], &self->rows[i], axis);
        const double behind = slope(&self->rows[i], &self->rows[i + 1U], axis);
        const double mean =
            (before * behind > 0.0) ? (2.0 * before * behind / (before + behind)) : 0.0;
        self->rows[i].speeds_ticks_per_s[axis] =
            (fabs(mean) < (double)INT32_MAX) ? (int32_t)mean : 0;
    }
}

static bool is_blank(const char *at)
{
    return at[strspn(at, "\r\n")] == '\0';
}

uint32_t trajectory_csv_read(trajectory_csv_t *self, const char *text, const robot_t *robot,
                             const int32_t stands[ROBOT_AXIS_MAX])
{
    head_t head;
    const char *at = read_head(&head, robot, text, stands == NULL);
    self->count = 0U;
    if (at == NULL) {
        return 1U;
    }
    while (!is_blank(at)) {
        trajectory_row_t *row = &self->rows[self->count];
        if (self->count >= LIMIT_TRAJECTORY_ROWS) {
            return trajectory_csv_line(self->count);
        }
        (void)memset(row, 0, sizeof *row);
        if (stands != NULL) {
            (void)memcpy(row->ticks, stands, robot->axis_count * sizeof row->ticks[0]);
        }
        at = read_row(&head, at, row);
        if (at == NULL) {
            return trajectory_csv_line(self->count);
        }
        self->count++;
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (!head.has_speed[i]) {
            find_speeds(self, i);
        }
    }
    return (self->count > 0U) ? 0U : trajectory_csv_line(0U);
}

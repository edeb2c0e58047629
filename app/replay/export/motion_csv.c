/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/export/motion_csv.h"

#include <string.h>

/* A name of a column, and the value in it. */
typedef struct {
    bytes_t *row;
    const char *prefix;
} cell_t;

static void put_name(void *to, const series_t *series)
{
    const cell_t *const cell = to;

    bytes_print(cell->row, ",%s%s", cell->prefix, series->name);
}

static void put_value(void *to, const series_t *series)
{
    const cell_t *const cell = to;

    if (series->kind == SERIES_WORD) {
        bytes_print(cell->row, ",%s", series->word);
    } else {
        bytes_print(cell->row, ",%.*f", series->decimals, series->number);
    }
}

static void write_row(motion_csv_t *self, const snapshot_t *snapshot, series_sink_t *sink)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        cell_t cell = {&self->row, self->sources[i].prefix};
        source_report(&self->sources[i], snapshot, sink, &cell);
    }
    bytes_put8(&self->row, (uint8_t)'\n');
    (void)fwrite(self->row.at, 1U, self->row.used, self->file);
    bytes_clear(&self->row);
}

void motion_csv_begin(motion_csv_t *self, FILE *file, const robot_t *robot)
{
    static const snapshot_t nothing;

    (void)memset(self, 0, sizeof *self);
    self->file = file;
    self->count = source_find(robot, self->sources);
    bytes_print(&self->row, "utc_s");
    write_row(self, &nothing, put_name);
}

void motion_csv_take(motion_csv_t *self, const recording_header_t *header,
                     const cycle_record_t *record, const snapshot_t *shown)
{
    pace_take(&self->pace, header, record);
    if ((shown == NULL) || !pace_is_turn(&self->pace, shown)) {
        return;
    }
    bytes_print(&self->row, "%llu.%06u", (unsigned long long)(self->pace.utc_us / 1000000U),
                (unsigned)(self->pace.utc_us % 1000000U));
    write_row(self, shown, put_value);
}

void motion_csv_end(motion_csv_t *self)
{
    bytes_free(&self->row);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "recorder/position_keeper.h"

#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "limits/requirement_limits.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define US_PER_S UINT64_C(1000000)

static kept_grade_t grade_of(uint32_t reference)
{
    switch (reference) {
    case AXIS_REFERENCE_FRESH:
        return KEPT_FRESH;
    case AXIS_REFERENCE_UNVERIFIED:
    case AXIS_REFERENCE_TAKEN:
    case AXIS_REFERENCE_VERIFIED:
        return KEPT_KNOWN;
    default:
        return KEPT_LOST;
    }
}

static kept_axis_t keep_axis(const snapshot_axis_t *shown)
{
    kept_axis_t axis = {.grade = (uint32_t)grade_of(shown->reference)};

    if (axis.grade == (uint32_t)KEPT_KNOWN) {
        axis.position_ticks = shown->position_ticks;
    }
    if (axis.grade != (uint32_t)KEPT_LOST) {
        axis.reading_ticks = shown->reading_ticks;
    }
    return axis;
}

/* The speed of an axis that is lost may be one from before. */
static bool is_moving(const snapshot_t *snapshot)
{
    bool is_one_moving = false;

    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        const snapshot_axis_t *axis = &snapshot->axes[i];
        is_one_moving =
            is_one_moving || (axis->drive_mode != (uint32_t)CARD_DRIVE_OFF) ||
            ((grade_of(axis->reference) == KEPT_KNOWN) && (axis->speed_ticks_per_s_q8 != 0));
    }
    return is_one_moving;
}

static position_record_t record_of(const position_keeper_t *self, const snapshot_t *snapshot,
                                   uint64_t utc_us)
{
    position_record_t record = {.number = self->kept.number + 1U,
                                .utc_us = utc_us,
                                .power_on = snapshot->power_on,
                                .robot_crc = snapshot->robot_crc};

    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        record.axes[i] = keep_axis(&snapshot->axes[i]);
    }
    return record;
}

/* A record that is still true must not grow old, nor be from the future because the clock was set
 * back: then its age, which wraps, is very large. */
static bool is_news(const position_record_t *kept, const position_record_t *record)
{
    return (record->power_on != kept->power_on) || (record->robot_crc != kept->robot_crc) ||
           (memcmp(record->axes, kept->axes, sizeof record->axes) != 0) ||
           ((record->utc_us - kept->utc_us) >= (LIMIT_STORE_REFRESH_S * US_PER_S));
}

static void keep(position_keeper_t *self, const position_record_t *record)
{
    if (position_store_write(self->path, record)) {
        self->kept = *record;
        if (self->is_failing) {
            (void)fprintf(stderr, "recorder: positions are kept again.\n");
        }
        self->is_failing = false;
    } else {
        if (!self->is_failing) {
            (void)fprintf(stderr,
                          "recorder: positions cannot be kept in %s (%s); free some space there.\n",
                          self->path, strerror(errno));
        }
        self->is_failing = true;
    }
}

void position_keeper_open(position_keeper_t *self, const char *path)
{
    (void)memset(self, 0, sizeof *self);
    self->path = path;
    (void)position_store_read(path, &self->kept);
}

static bool look(position_keeper_t *self, const snapshot_t *snapshot, uint64_t utc_us)
{
    const position_record_t record = record_of(self, snapshot, utc_us);
    const bool is_due = (snapshot->positions_awaited == 0U) && !is_moving(snapshot) &&
                        is_news(&self->kept, &record);

    if (is_due) {
        keep(self, &record);
    }
    return is_due;
}

void position_keeper_look(position_keeper_t *self, const snapshot_t *snapshot, uint64_t now_us,
                          uint64_t utc_us)
{
    const bool is_first = self->tried_us == 0U;

    if ((is_first || ((now_us - self->tried_us) >= LIMIT_STORE_INTERVAL_US)) &&
        look(self, snapshot, utc_us)) {
        self->tried_us = now_us;
    }
}

void position_keeper_close(position_keeper_t *self, const snapshot_t *snapshot, uint64_t utc_us)
{
    (void)look(self, snapshot, utc_us);
}

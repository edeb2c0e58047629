/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/position_keeper.h"

#include "limits/requirement_limits.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define US_PER_S UINT64_C(1000000)

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
    position_record_t record;
    const bool is_due =
        position_record_take(&record, snapshot, utc_us) && is_news(&self->kept, &record);

    record.number = self->kept.number + 1U;
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

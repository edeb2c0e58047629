/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/recording_room.h"

#include "common/file_series.h"
#include "limits/requirement_limits.h"

#include <sys/statvfs.h>

#define US_PER_S UINT64_C(1000000)
#define S_PER_MIN UINT64_C(60)
#define FILE_S UINT64_C(600) /* A file lasts, and only a new one has older ones removed. */
#define WEIGHT 4U            /* Weight of the known rate, to one of the new one. */
#define MOST_MIN UINT64_C(999999)

/* UINT64_MAX: it is not known, which is no reason to warn. */
static uint64_t free_bytes(const char *directory)
{
    struct statvfs found;

    return (statvfs(directory, &found) == 0) ? ((uint64_t)found.f_bavail * found.f_frsize)
                                             : UINT64_MAX;
}

static void measure_rate(recording_room_t *self, uint64_t size, uint64_t span_us)
{
    const uint64_t rate = ((size - self->size) * US_PER_S) / span_us;

    self->bytes_per_s =
        (self->bytes_per_s == 0U) ? rate : (((self->bytes_per_s * (WEIGHT - 1U)) + rate) / WEIGHT);
}

/* No end is foreseen where the oldest are removed before. */
static uint32_t forecast(const recording_room_t *self, uint64_t free_now, uint64_t used)
{
    const uint64_t most = file_series_recordings.bytes + (self->bytes_per_s * FILE_S);
    const uint64_t growth = (most > used) ? (most - used) : 0U;

    if ((self->bytes_per_s == 0U) || (free_now >= growth)) {
        return 0U;
    }
    const uint64_t minutes = free_now / self->bytes_per_s / S_PER_MIN;
    const uint64_t least = (minutes > 0U) ? minutes : 1U;
    return (uint32_t)((least < MOST_MIN) ? least : MOST_MIN);
}

void recording_room_look(recording_room_t *self, const char *directory, uint64_t earlier_bytes,
                         uint64_t size, uint64_t now_us)
{
    const uint64_t span_us = now_us - self->looked_us;

    if (span_us < LIMIT_RECORDING_LOOK_US) {
        return;
    }
    if ((self->looked_us != 0U) && (size >= self->size)) {
        measure_rate(self, size, span_us);
        self->left_min = forecast(self, free_bytes(directory), earlier_bytes + size);
    }
    self->looked_us = now_us;
    self->size = size;
}

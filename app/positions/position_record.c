/* SPDX-License-Identifier: Apache-2.0 */
#include "positions/position_record.h"

#include "base/crc.h"
#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "common/little_endian.h"

#include <string.h>

#define AT_NUMBER 8U
#define AT_UTC 16U
#define AT_POWER_ON 24U
#define AT_ROBOT 28U
#define AT_AXES 32U
#define AXIS_SIZE 12U
#define AT_CRC (POSITION_RECORD_SIZE - 4U)

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

bool position_record_take(position_record_t *self, const snapshot_t *snapshot, uint64_t utc_us)
{
    *self = (position_record_t){
        .utc_us = utc_us, .power_on = snapshot->power_on, .robot_crc = snapshot->robot_crc};
    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        self->axes[i] = keep_axis(&snapshot->axes[i]);
    }
    return (snapshot->positions_awaited == 0U) && !is_moving(snapshot);
}

static const uint8_t magic[8] = {'B', 'S', 'P', 'O', 'S', '0', '0', '1'};

void position_record_encode(const position_record_t *self, uint8_t *bytes)
{
    (void)memcpy(bytes, magic, sizeof magic);
    put64(&bytes[AT_NUMBER], self->number);
    put64(&bytes[AT_UTC], self->utc_us);
    put32(&bytes[AT_POWER_ON], self->power_on);
    put32(&bytes[AT_ROBOT], self->robot_crc);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        uint8_t *axis = &bytes[AT_AXES + (i * AXIS_SIZE)];
        put32(&axis[0], self->axes[i].grade);
        put32(&axis[4], (uint32_t)self->axes[i].position_ticks);
        put32(&axis[8], (uint32_t)self->axes[i].reading_ticks);
    }
    put32(&bytes[AT_CRC], crc32c(bytes, AT_CRC));
}

bool position_record_decode(const uint8_t *bytes, position_record_t *self)
{
    if ((memcmp(bytes, magic, sizeof magic) != 0) ||
        (get32(&bytes[AT_CRC]) != crc32c(bytes, AT_CRC))) {
        return false;
    }
    self->number = get64(&bytes[AT_NUMBER]);
    self->utc_us = get64(&bytes[AT_UTC]);
    self->power_on = get32(&bytes[AT_POWER_ON]);
    self->robot_crc = get32(&bytes[AT_ROBOT]);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        const uint8_t *axis = &bytes[AT_AXES + (i * AXIS_SIZE)];
        self->axes[i] = (kept_axis_t){.grade = get32(&axis[0]),
                                      .position_ticks = (int32_t)get32(&axis[4]),
                                      .reading_ticks = (int32_t)get32(&axis[8])};
    }
    return true;
}

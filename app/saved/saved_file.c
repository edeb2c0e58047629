/* SPDX-License-Identifier: Apache-2.0 */
#include "saved/saved_file.h"

#include "common/axis_terms.h"
#include "limits/requirement_limits.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#define US_PER_S UINT64_C(1000000)
#define UTC_FORMAT "%Y-%m-%dT%H:%M:%SZ"
#define NO_AXIS ROBOT_AXIS_MAX

void saved_write_utc(uint64_t utc_us, char text[SAVED_UTC_SIZE])
{
    const time_t seconds = (time_t)(utc_us / US_PER_S);
    struct tm utc;
    const bool is_written = (gmtime_r(&seconds, &utc) != NULL) &&
                            (strftime(text, SAVED_UTC_SIZE, UTC_FORMAT, &utc) > 0U);
    if (!is_written) {
        text[0] = '\0';
    }
}

void saved_write_sum(uint32_t crc, char text[SAVED_SUM_SIZE])
{
    (void)snprintf(text, SAVED_SUM_SIZE, "%08x", (unsigned)crc);
}

void saved_write_hmac(const uint8_t *seal, char text[SAVED_HMAC_SIZE])
{
    for (uint32_t i = 0U; i < SAVED_SEAL_SIZE; i++) {
        (void)snprintf(&text[(size_t)2U * i], 3U, "%02x", (unsigned)seal[i]);
    }
}

/* A file in another form was made by hand. */
static bool read_utc(const char *text, uint64_t *utc_us)
{
    char again[SAVED_UTC_SIZE];
    struct tm utc;
    (void)memset(&utc, 0, sizeof utc);
    const char *end = strptime(text, UTC_FORMAT, &utc);
    const time_t seconds = ((end != NULL) && (*end == '\0')) ? timegm(&utc) : -1;
    if (seconds < 0) {
        return false;
    }
    *utc_us = (uint64_t)seconds * US_PER_S;
    saved_write_utc(*utc_us, again);
    return strcmp(again, text) == 0;
}

/* Value of a lower-case hexadecimal digit, 16 for any other byte. */
static uint32_t digit_of(char byte)
{
    static const char digits[] = "0123456789abcdef";
    const char *place = (byte != '\0') ? strchr(digits, byte) : NULL;
    return (place != NULL) ? (uint32_t)(place - digits) : 16U;
}

static bool read_bytes(const char *text, uint8_t *bytes, size_t size)
{
    bool is_good = strlen(text) == (2U * size);
    for (size_t i = 0U; is_good && (i < size); i++) {
        const uint32_t high = digit_of(text[2U * i]);
        const uint32_t low = digit_of(text[(2U * i) + 1U]);
        is_good = (high < 16U) && (low < 16U);
        bytes[i] = (uint8_t)((high << 4) | (low & 15U));
    }
    return is_good;
}

static bool read_head(saved_t *self, const request_saved_positions_t *file, uint32_t *crc)
{
    uint8_t sum[4];
    const bool is_good = read_bytes(file->checksum, sum, sizeof sum) &&
                         read_utc(file->saved_utc, &self->record.utc_us) &&
                         (!file->has_hmac || read_bytes(file->hmac, self->seal, sizeof self->seal));
    *crc = ((uint32_t)sum[0] << 24) | ((uint32_t)sum[1] << 16) | ((uint32_t)sum[2] << 8) | sum[3];
    self->record.power_on = file->power_on;
    self->origin = file->has_hmac ? SAVED_SEALED : SAVED_UNSEALED;
    return is_good;
}

static bool read_axes(saved_t *self, const request_saved_positions_t *file, const robot_t *robot)
{
    uint32_t seen = 0U;
    for (uint32_t i = 0U; i < file->axes_count; i++) {
        const request_saved_axis_t *axis = &file->axes[i];
        const uint32_t index = axis_terms_find(robot, axis->name);
        if ((index == robot->axis_count) || (((seen >> index) & 1U) != 0U)) {
            return false;
        }
        seen |= 1U << index;
        self->record.axes[index] = (kept_axis_t){.grade = axis->grade,
                                                 .position_ticks = axis->position_ticks,
                                                 .reading_ticks = axis->reading_ticks};
    }
    return file->axes_count == robot->axis_count;
}

saved_verdict_t saved_read_file(saved_t *self, const request_saved_positions_t *file,
                                const robot_t *robot)
{
    (void)memset(self, 0, sizeof *self);
    if (strcmp(file->format, SAVED_FORMAT) != 0) {
        return SAVED_OTHER_FORMAT;
    }
    if (strcmp(file->robot, robot->name) != 0) {
        return SAVED_OTHER_ROBOT;
    }
    if (!read_head(self, file, &self->record.robot_crc)) {
        return SAVED_BAD_VALUE;
    }
    if (self->record.robot_crc != robot->crc) {
        return SAVED_OTHER_TABLE;
    }
    return read_axes(self, file, robot) ? SAVED_GOOD : SAVED_BAD_AXES;
}

static uint32_t axis_of_slot(const robot_t *robot, uint32_t slot)
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (robot->axes[i].slot == slot) {
            return i;
        }
    }
    return NO_AXIS;
}

saved_verdict_t saved_read_motors(saved_t *self, const request_old_motor_t *motors, uint32_t count,
                                  const robot_t *robot)
{
    uint32_t seen = 0U;
    (void)memset(self, 0, sizeof *self);
    self->origin = SAVED_OLD_LIST;
    for (uint32_t i = 0U; i < count; i++) {
        const uint32_t index = axis_of_slot(robot, motors[i].slot);
        if ((index == NO_AXIS) || (((seen >> index) & 1U) != 0U)) {
            return SAVED_BAD_SLOTS;
        }
        seen |= 1U << index;
        self->record.axes[index].grade = (uint32_t)(motors[i].homed ? KEPT_KNOWN : KEPT_LOST);
        self->record.axes[index].position_ticks = motors[i].current_ticks;
    }
    return (count == robot->axis_count) ? SAVED_GOOD : SAVED_BAD_SLOTS;
}

saved_verdict_t saved_judge(const saved_t *self, const saved_key_t *key, uint64_t utc_us)
{
    const uint64_t saved_us = self->record.utc_us;
    saved_verdict_t verdict = SAVED_GOOD;
    if (self->origin == SAVED_OLD_LIST) {
        verdict = SAVED_GOOD;
    } else if ((self->origin == SAVED_SEALED) && !saved_seal_fits(key, &self->record, self->seal)) {
        verdict = SAVED_ALTERED;
    } else if (saved_us > utc_us) {
        verdict = SAVED_FROM_FUTURE;
    } else if ((utc_us - saved_us) > (LIMIT_SAVED_AGE_S * US_PER_S)) {
        verdict = SAVED_TOO_OLD;
    } else {
        /* It can be used. */
    }
    return verdict;
}

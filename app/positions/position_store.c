/* SPDX-License-Identifier: Apache-2.0 */
#include "positions/position_store.h"

#include "limits/requirement_limits.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

#define FILE_MODE 0640
#define SLOTS 2U
#define US_PER_S UINT64_C(1000000)

static bool read_slot(int file, uint32_t slot, position_record_t *record)
{
    uint8_t bytes[POSITION_RECORD_SIZE];
    const ssize_t size = pread(file, bytes, sizeof bytes, (off_t)(slot * POSITION_SLOT_SIZE));

    return (size == (ssize_t)sizeof bytes) && position_record_decode(bytes, record);
}

position_file_t position_store_read(const char *path, position_record_t *record)
{
    /* A file of another kind may not hold up control. */
    const int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    position_file_t result = POSITION_FILE_DAMAGED;

    (void)memset(record, 0, sizeof *record);
    if (file < 0) {
        return (errno == ENOENT) ? POSITION_FILE_NONE : POSITION_FILE_DAMAGED;
    }
    for (uint32_t slot = 0U; slot < SLOTS; slot++) {
        position_record_t found;
        if (read_slot(file, slot, &found) &&
            ((result != POSITION_FILE_GOOD) || (found.number > record->number))) {
            *record = found;
            result = POSITION_FILE_GOOD;
        }
    }
    (void)close(file);
    return result;
}

bool position_store_write(const char *path, const position_record_t *record)
{
    uint8_t bytes[POSITION_RECORD_SIZE];
    const off_t place = (off_t)((record->number % SLOTS) * POSITION_SLOT_SIZE);
    const int file = open(path, O_WRONLY | O_CREAT | O_CLOEXEC, FILE_MODE);

    if (file < 0) {
        return false;
    }
    position_record_encode(record, bytes);
    errno = ENOSPC; /* Error of a write that is only too short. */
    const bool is_written = (pwrite(file, bytes, sizeof bytes, place) == (ssize_t)sizeof bytes) &&
                            (fdatasync(file) == 0);
    const int reason = errno;
    (void)close(file);
    errno = reason;
    return is_written;
}

static kept_verdict_t judge(const position_record_t *record, const position_asker_t *asker)
{
    kept_verdict_t verdict = KEPT_GOOD;

    if (record->robot_crc != asker->robot_crc) {
        verdict = KEPT_OTHER_ROBOT;
    } else if (record->utc_us > asker->utc_us) {
        verdict = KEPT_FROM_FUTURE;
    } else if ((asker->utc_us - record->utc_us) > (LIMIT_STORE_AGE_S * US_PER_S)) {
        verdict = KEPT_TOO_OLD;
    } else {
        /* It can be used. */
    }
    return verdict;
}

void position_store_ask(const char *path, const position_asker_t *asker, kept_positions_t *kept)
{
    position_record_t record;
    const position_file_t found = position_store_read(path, &record);
    kept_verdict_t verdict = KEPT_NOTHING;

    if (found == POSITION_FILE_DAMAGED) {
        verdict = KEPT_DAMAGED;
    } else if ((found == POSITION_FILE_GOOD) && (record.power_on == asker->power_on)) {
        verdict = judge(&record, asker);
    } else if (asker->was_used) {
        verdict = KEPT_MISSING;
    } else {
        /* The first one in this power-on. */
    }
    (void)memset(kept, 0, sizeof *kept);
    kept->power_on = asker->power_on;
    kept->verdict = (uint32_t)verdict;
    if (verdict == KEPT_GOOD) {
        (void)memcpy(kept->axes, record.axes, sizeof kept->axes);
    }
}

const char *position_store_why(uint32_t verdict)
{
    switch (verdict) {
    case KEPT_MISSING:
        return "are missing, although the box was used since its power-on";
    case KEPT_OTHER_ROBOT:
        return "are another robot's";
    case KEPT_TOO_OLD:
        return "are too old";
    case KEPT_FROM_FUTURE:
        return "are from the future, so a clock was set";
    default:
        return "are damaged or cannot be read";
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange_files.h"

#include "exchange/exchange_lock.h"
#include "exchange/exchange_segment.h"

void exchange_note_file(exchange_t *self, exchange_file_t file, uint32_t number)
{
    exchange_store_number(&self->segment->others.files[file], number);
}

uint32_t exchange_file(const exchange_t *self, exchange_file_t file)
{
    return exchange_load_number(&self->segment->others.files[file]);
}

void exchange_set_log_level(exchange_t *self, const exchange_log_level_t *level)
{
    segment_others_t *others = &self->segment->others;

    exchange_write_sealed(&others->log_level_seal, &others->log_level, level, sizeof *level);
}

/* http may have died in the middle of anything, and what it writes stands in a log. */
static void make_plain(exchange_log_level_t *level)
{
    level->by[EXCHANGE_SETTER_SIZE - 1U] = '\0';
    for (char *letter = level->by; *letter != '\0'; letter++) {
        *letter = ((*letter > ' ') && (*letter <= '~')) ? *letter : '?';
    }
    if (level->severity > (uint32_t)EVENT_SEVERITY_CRITICAL) {
        level->severity = (uint32_t)EVENT_SEVERITY_CRITICAL;
    }
}

bool exchange_read_log_level(const exchange_t *self, exchange_log_level_t *level)
{
    const segment_others_t *others = &self->segment->others;

    for (uint32_t tries = 0U; tries < EXCHANGE_READ_TRIES; tries++) {
        if (exchange_read_sealed(&others->log_level_seal, level, &others->log_level,
                                 sizeof *level)) {
            make_plain(level);
            return true;
        }
    }
    return false;
}

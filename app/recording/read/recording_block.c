/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/read/recording_block.h"

#include "common/little_endian.h"

#include <string.h>

void recording_block_begin(recording_reader_t *reader, uint32_t raw_size, uint32_t cycle)
{
    reader->raw_size = raw_size;
    reader->raw_next = 0U;
    reader->cycle = cycle;
    cycle_code_begin(&reader->code);
}

/* Their bytes, NULL when they are not there. */
static const uint8_t *find_rows(const recording_reader_t *reader, uint32_t *count)
{
    const uint32_t size = reader->header.controller_size;
    const size_t left = reader->raw_size - reader->raw_next - 1U;
    const uint8_t *bytes = &reader->raw[reader->raw_next + 1U];

    if ((size > CONTROLLER_CHECKPOINT_BYTES) || (left < (size + sizeof *count))) {
        return NULL;
    }
    *count = get32(&bytes[size]);
    const bool are_there = (*count <= LIMIT_TRAJECTORY_ROWS) &&
                           ((left - size - sizeof *count) >= (*count * sizeof(trajectory_row_t)));
    return are_there ? &bytes[size + sizeof *count] : NULL;
}

static bool take_checkpoint(recording_reader_t *reader, cycle_record_t *record,
                            cycle_known_t *known)
{
    const uint32_t size = reader->header.controller_size;
    uint32_t count = 0U;
    const uint8_t *rows = find_rows(reader, &count);

    if (rows == NULL) {
        return false;
    }
    record->kind = (uint32_t)CYCLE_RECORD_CHECKPOINT;
    record->rows = count;
    (void)memcpy(record->body.checkpoint, &reader->raw[reader->raw_next + 1U], size);
    known->rows = rows;
    reader->raw_next = (uint32_t)(&rows[count * sizeof(trajectory_row_t)] - reader->raw);
    return true;
}

static bool take_cycle(recording_reader_t *reader, cycle_record_t *record, cycle_known_t *known)
{
    const size_t size =
        cycle_code_decode(&reader->code, &reader->raw[reader->raw_next],
                          reader->raw_size - reader->raw_next, &record->body.cycle, known);

    record->kind = (uint32_t)CYCLE_RECORD_CYCLE;
    reader->raw_next += (uint32_t)size;
    reader->cycle++;
    return size != 0U;
}

bool recording_block_take(recording_reader_t *reader, cycle_record_t *record, cycle_known_t *known)
{
    if (reader->raw_next == reader->raw_size) {
        return false;
    }
    record->cycle = reader->cycle;
    return (reader->raw[reader->raw_next] == RECORDING_CHECKPOINT)
               ? take_checkpoint(reader, record, known)
               : take_cycle(reader, record, known);
}

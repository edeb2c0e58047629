/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The position store: a small file in which the recorder keeps where the axes stand, for a control
 * that is started again. Two slots, POSITION_SLOT_SIZE apart, are written in turn, so that a write
 * cut short leaves the record before it. The slot of a record is the lowest bit of its number,
 * which grows by one per record.
 */
#ifndef BORESIGHT_POSITION_STORE_H
#define BORESIGHT_POSITION_STORE_H

#include "positions/position_record.h"

#include <stdbool.h>
#include <stdint.h>

#define POSITION_SLOT_SIZE 4096U

typedef enum {
    POSITION_FILE_NONE = 0,
    POSITION_FILE_GOOD = 1,
    POSITION_FILE_DAMAGED = 2 /**< No slot holds a whole record, or it cannot be read. */
} position_file_t;

/** When and where kept positions are asked for. */
typedef struct {
    uint64_t utc_us;
    uint32_t robot_crc;
    uint32_t power_on;
    bool was_used; /**< Frames were exchanged in this power-on before. */
} position_asker_t;

/** Reads the newest whole record of the file `path`; `record` is zeros without one. */
position_file_t position_store_read(const char *path, position_record_t *record);

/**
 * Writes `record` into the slot of its number and waits until the disk has it.
 *
 * @return false with errno set when it could not; the other slot is as it was
 *
 * @satisfies SWR-STORE-002
 */
bool position_store_write(const char *path, const position_record_t *record);

/**
 * Content of the file `path` for `asker`: a verdict in any case, axes with KEPT_GOOD only.
 *
 * @satisfies SWR-STORE-003
 * @satisfies SWR-STORE-004
 */
void position_store_ask(const char *path, const position_asker_t *asker, kept_positions_t *kept);

/** A verdict from KEPT_MISSING on, as the end of a sentence about the kept positions. */
const char *position_store_why(uint32_t verdict);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Reads a recording. Opening it verifies every byte before any of it is used.
 */
#ifndef BORESIGHT_RECORDING_READER_H
#define BORESIGHT_RECORDING_READER_H

#include "recording/recording.h"

#include <stdbool.h>

typedef enum {
    RECORDING_WHOLE = 0,        /**< Every byte is as it was written. */
    RECORDING_CUT_SHORT = 1,    /**< The end is missing; what is there is as it was written. */
    RECORDING_DAMAGED = 2,      /**< A byte was changed, added or removed; nothing is read. */
    RECORDING_UNREADABLE = 3,   /**< There is no such file, or it cannot be read. */
    RECORDING_OTHER_VERSION = 4 /**< It is of another format. */
} recording_verdict_t;

typedef struct {
    recording_verdict_t verdict;
    uint64_t first_byte; /**< Damaged or cut short: offsets of the file between which it is,
                            inclusive. */
    uint64_t last_byte;
    uint32_t block;     /**< Number of the block there. */
    char sentence[512]; /**< What was found, for people. */
} recording_finding_t;

typedef struct {
    recording_header_t header;
    const uint8_t *bytes; /**< The whole file, mapped. */
    uint64_t size;
    uint64_t end;  /**< End of the verified blocks. */
    uint64_t next; /**< Offset of the next block. */
    uint32_t blocks;
    uint64_t records;
    uint32_t cycles_lost;
    bool is_run_end; /**< The run ends with it. */
    uint8_t *raw;    /**< The present block. */
    uint32_t raw_size;
    uint32_t raw_next;
    uint32_t cycle; /**< Of the next record. */
    cycle_code_t code;
} recording_reader_t;

/**
 * Maps and verifies the recording `path`.
 *
 * @return the verdict of `finding`; with RECORDING_WHOLE and RECORDING_CUT_SHORT the reader is open
 *
 * @satisfies SWR-ARM-004
 * @satisfies SWR-REPLAY-002
 * @satisfies SWR-REPLAY-005
 * @satisfies SWR-REPLAY-007
 */
recording_verdict_t recording_reader_open(recording_reader_t *self, const char *path,
                                          recording_finding_t *finding);

/**
 * Says whether the recording's layout and sizes are those of this build; otherwise its records
 * cannot be read.
 *
 * @satisfies SWR-ARM-006
 * @satisfies SWR-REPLAY-006
 */
bool recording_reader_fits(const recording_reader_t *self, uint64_t layout,
                           uint32_t controller_size);

/**
 * The next record, and what is known of it. What was not kept of a cycle's outputs is zero. The
 * rows of a checkpoint live until the next call.
 *
 * @return false at the end, or when a block does not hold what its fields say
 */
bool recording_reader_next(recording_reader_t *self, cycle_record_t *record, cycle_known_t *known);

void recording_reader_close(recording_reader_t *self);

#endif

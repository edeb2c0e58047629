/* SPDX-License-Identifier: Apache-2.0 */
/** @file The state of a reader of recordings, and what it has found; recording_reader.h owns both.
 */
#ifndef BORESIGHT_RECORDING_STATE_H
#define BORESIGHT_RECORDING_STATE_H

#include "recording/format/recording.h"

#include <stdbool.h>
#include <stdint.h>

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
    char sentence[512]; /**< The finding, for people. */
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
    uint32_t cycle; /**< Cycle of the next record. */
    cycle_code_t code;
} recording_reader_t;

#endif

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
    RECORDING_WHOLE = 0,     /**< Every byte is as it was written. */
    RECORDING_CUT_SHORT = 1, /**< The end is missing; what is there is as it was written. */
    RECORDING_DAMAGED = 2,   /**< A byte was changed, added or removed; nothing is read. */
    RECORDING_UNREADABLE = 3 /**< There is no such file, or it cannot be read. */
} recording_verdict_t;

typedef struct {
    recording_verdict_t verdict;
    uint64_t first_byte; /**< Damaged or cut short: offsets of the file between which it is,
                            inclusive. */
    uint64_t last_byte;
    uint32_t block;     /**< Number of the block there. */
    char sentence[256]; /**< What was found, for people. */
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
    uint8_t *raw; /**< The present block. */
    uint32_t raw_size;
    uint32_t raw_next;
    uint8_t before[sizeof(((cycle_record_t *)0)->body)];
} recording_reader_t;

/**
 * Maps and verifies the recording `path`.
 *
 * @return the verdict of `finding`; with RECORDING_WHOLE and RECORDING_CUT_SHORT the reader is open
 *
 * @satisfies SWR-REPLAY-002
 */
recording_verdict_t recording_reader_open(recording_reader_t *self, const char *path,
                                          recording_finding_t *finding);

/** Says whether the sizes of the recording are those of this build; otherwise its records cannot be
 * read. */
bool recording_reader_fits(const recording_reader_t *self, uint32_t controller_size);

/** The next record. False at the end, or when a block does not hold what its fields say. */
bool recording_reader_next(recording_reader_t *self, cycle_record_t *record);

void recording_reader_close(recording_reader_t *self);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Writes one recording. Owned by the recorder; one writer per file. A write that fails leaves the
 * file with whole blocks only, and the writer closed.
 */
#ifndef BORESIGHT_RECORDING_WRITER_H
#define BORESIGHT_RECORDING_WRITER_H

#include "recording/format/recording.h"

#include <stdbool.h>

typedef struct {
    int file; /**< -1: closed. */
    recording_header_t header;
    uint8_t hash[RECORDING_HASH_SIZE]; /**< Hash of the block before. */
    recording_fields_t block;          /**< The block being filled. */
    uint32_t cycle;                    /**< Cycle of the last record. */
    uint32_t next_cycle;               /**< The one that may follow in this block. */
    bool has_whole;                    /**< The block has its first cycle. */
    bool has_checkpoint;               /**< No cycle is missing since one. */
    uint32_t blocks;                   /**< Written. */
    uint64_t records;                  /**< Appended. */
    uint64_t size;                     /**< Bytes written. */
    uint32_t cycles_lost;
    uint32_t lost_before; /**< Those before the next block. */
    bool is_run_end;      /**< The run ends with it. */
    void *compressor;
    cycle_code_t code;
    prover_t prover;
    uint8_t raw[RECORDING_RAW_MAX];
    uint8_t *output; /**< Prefix, checksums and payload of one block. */
    size_t output_size;
} recording_writer_t;

/**
 * Creates the file `path` and writes its header; checkpoints are of its controller_size, at most
 * CONTROLLER_CHECKPOINT_BYTES.
 *
 * @return false with errno set when it cannot; the writer is closed
 */
bool recording_writer_open(recording_writer_t *self, const char *path,
                           const recording_header_t *header);

/** Notes that `cycles` cycles before the next record are missing. */
void recording_writer_note_loss(recording_writer_t *self, uint32_t cycles);

/** Notes that the run ends with the last record; the trailer says so. */
void recording_writer_note_run_end(recording_writer_t *self);

/**
 * Adds a record, a checkpoint without rows; a full block is written. A checkpoint, and a cycle that
 * does not follow the one before, begin a block. Cycles that cannot be computed again, for want of
 * a checkpoint, are kept whole.
 *
 * @return false with errno set when the block could not be written; its records are gone and the
 * writer is closed
 *
 * @satisfies SWR-REC-001
 * @satisfies SWR-REC-002
 * @satisfies SWR-REC-004
 * @satisfies SWR-REC-005
 */
bool recording_writer_append(recording_writer_t *self, const cycle_record_t *record);

/**
 * Adds a checkpoint with the rows of its trajectory, as many as it says. Same result.
 *
 * @satisfies SWR-TRAJ-017
 */
bool recording_writer_append_checkpoint(recording_writer_t *self, const cycle_record_t *record,
                                        const trajectory_row_t *rows);

/** Writes the records that wait for a full block. Same result. */
bool recording_writer_flush(recording_writer_t *self);

/** Writes what waits and the trailer, and closes. False with errno set when it could not write. */
bool recording_writer_close(recording_writer_t *self);

#endif

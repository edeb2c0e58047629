/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The recordings of a run that one recorder writes, one after the other: the present one, and what
 * the earlier ones hold. They are a series in one directory, from which the oldest are removed so
 * that at most LIMIT_RECORDINGS and about LIMIT_RECORDINGS_MB stay. The black box owns them.
 */
#ifndef BORESIGHT_RUN_FILES_H
#define BORESIGHT_RUN_FILES_H

#include "common/file_series.h"
#include "limits/requirement_limits.h"
#include "recording/write/kept_files.h"
#include "recording/write/recording_writer.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    const char *directory; /**< Lives as long as these. */
    recording_header_t header;
    recording_writer_t writer;
    char path[FILE_SERIES_PATH_SIZE]; /**< Path of the newest file tried. */
    uint32_t number;     /**< Number of the newest name; 0: the directory was not looked at. */
    uint64_t opened_us;  /**< When the present file was begun. */
    uint64_t flushed_us; /**< When its last block was written. */
    uint32_t next_cycle;
    uint32_t kept_until; /**< The cycle after the last one that an earlier file has. */
    bool has_cycle;      /**< The two are known. */
    kept_file_t present;
    kept_files_t earlier;  /**< Written before the present one. */
    uint64_t others_bytes; /**< Size of the other recordings when the present one was begun. */
} run_files_t;

/** No file yet. */
void run_files_init(run_files_t *self, const char *directory, const recording_header_t *header);

/** A file was begun and not ended. */
static inline bool run_files_is_open(const run_files_t *self)
{
    return self->writer.file >= 0;
}

/** Takes `cycle` for the first one, if none came before: earlier ones are another recorder's. */
void run_files_expect(run_files_t *self, uint32_t cycle);

/**
 * Begins a file whose first cycle is `cycle`, and makes its directory where it is missing. Old
 * recordings make room only for a file that exists: a failed attempt costs none of them. A
 * recording that makes room is not counted as gone.
 *
 * @return false with errno set when no file could be made
 */
bool run_files_begin(run_files_t *self, uint32_t cycle, uint64_t now_us);

/**
 * Adds a record to the open file, a checkpoint with its `rows`.
 *
 * @return false with errno set when it could not be written; the file is ended
 */
bool run_files_store(run_files_t *self, const cycle_record_t *record, const trajectory_row_t *rows,
                     uint64_t now_us);

/** Writes what waits for a full block. Same result. */
bool run_files_flush(run_files_t *self, uint64_t now_us);

/** Ends the open file, if there is one. False with errno set when its end could not be written. */
bool run_files_end(run_files_t *self);

/** The cycles that are in no file come next again. */
void run_files_go_back(run_files_t *self);

/** The open file was removed, moved or shortened by another. */
bool run_files_is_present_gone(run_files_t *self);

/**
 * Leaves the open file, which is gone, as it was found. Cycles that were written into it are lost,
 * those not written yet come next.
 *
 * @return the cycles that were written into it
 */
uint32_t run_files_give_up(run_files_t *self);

/** Forgets the earlier files that are gone. @return the cycles of those files */
uint32_t run_files_forget_gone(run_files_t *self);

#endif

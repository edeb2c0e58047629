/* SPDX-License-Identifier: Apache-2.0 */
/** @file Which cycles were there, as they are gone through, and which were not. */
#ifndef BORESIGHT_COVERAGE_H
#define BORESIGHT_COVERAGE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct {
    bool has_begun;
    uint32_t first;       /**< The first cycle that is expected. */
    uint32_t next;        /**< The one after the last that was there. */
    uint64_t done;        /**< Cycles that were replayed, each once. */
    uint64_t missing;     /**< Between `first` and `next`. */
    uint64_t undone;      /**< They were there, but follow no checkpoint. */
    bool is_undone;       /**< The last one did. */
    uint32_t undone_from; /**< Since this cycle. */
    const char *path;     /**< Path of the present recording. */
    bool is_again;        /**< The last one was there before. */
    bool is_compared;     /**< And it was replayed. */
    uint32_t again_from;  /**< Since this cycle, */
    uint32_t again_next;  /**< and up to before this one. */
    uint64_t uncompared;  /**< They were there before, and follow no checkpoint. */
} coverage_t;

/** Begins. `is_of_run`: cycle 0 is expected first; otherwise whichever comes. */
void coverage_begin(coverage_t *self, bool is_of_run);

/** The recording `path`, which lives until the next one, begins. */
void coverage_open(coverage_t *self, const char *path, FILE *notes);

/**
 * Takes a cycle that is there; `is_done`: it was replayed, or needs not be. Each gap that ends with
 * it is named in `notes` by its first and last cycle, and so is what was there before.
 *
 * @return false: an earlier recording had it already
 *
 * @satisfies SWR-REPLAY-033
 * @satisfies SWR-REPLAY-038
 */
bool coverage_take(coverage_t *self, uint32_t cycle, bool is_done, FILE *notes);

/** After the last one; the same. */
void coverage_end(coverage_t *self, FILE *notes);

/** Whether every cycle from `first` to the last was there, and was replayed, also where
 * it was there again. */
bool coverage_is_whole(const coverage_t *self);

#endif

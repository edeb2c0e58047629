/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The recordings of one run in a folder. A recording is known by the end of its name, its run and
 * its place in the run by its header, whatever the rest of its name is.
 */
#ifndef BORESIGHT_RUN_H
#define BORESIGHT_RUN_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/** A recording. */
typedef struct {
    char *path;
    uint64_t run;    /**< As exchange_run() says. */
    uint32_t first;  /**< Its first cycle. */
    uint64_t number; /**< In its name, by which the newest run is found; 0: it has none. */
} run_file_t;

/** All zero is empty. */
typedef struct {
    run_file_t *files; /**< In the order of their cycles. */
    uint32_t count;
    run_file_t *left_out; /**< Without a cycle or not readable; its run is 0 where not known. */
    uint32_t left_out_count;
} run_t;

/**
 * Finds the newest run in `folder` whose name begins with `name`; NULL: the newest of all. Names in
 * `notes` the other runs, and what is in the folder and of none.
 *
 * @return false, after a sentence on the standard error: none exists, or without `name` a file
 * that is left out may be of a newer one
 *
 * @satisfies SWR-REPLAY-030
 * @satisfies SWR-REPLAY-034
 * @satisfies SWR-REPLAY-036
 */
bool run_find(run_t *self, const char *folder, const char *name, FILE *notes);

void run_free(run_t *self);

#endif

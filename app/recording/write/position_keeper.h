/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Keeps where the axes stand in the position store, while nothing moves: of a program that ends in
 * a motion the record from before it is left, which the counts contradict afterwards. Owned by the
 * recorder.
 */
#ifndef BORESIGHT_POSITION_KEEPER_H
#define BORESIGHT_POSITION_KEEPER_H

#include "interface/snapshot.h"
#include "positions/position_store.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    const char *path;       /**< Lives as long as the keeper. */
    position_record_t kept; /**< The newest one in the file; zeros without one. */
    uint64_t tried_us;      /**< When it was last written, or could not be. */
    bool is_failing;        /**< The last attempt failed, and it was said. */
} position_keeper_t;

/** Continues with the file `path`, whether or not it holds a record. */
void position_keeper_open(position_keeper_t *self, const char *path);

/**
 * Keeps what `snapshot` says, if nothing moves, it differs from what is kept or that is old, and
 * the last attempt was long enough ago. `now_us` is monotonic, `utc_us` the time of day.
 *
 * @satisfies SWR-STORE-007
 */
void position_keeper_look(position_keeper_t *self, const snapshot_t *snapshot, uint64_t now_us,
                          uint64_t utc_us);

/** The same at the end, whenever the last attempt was. */
void position_keeper_close(position_keeper_t *self, const snapshot_t *snapshot, uint64_t utc_us);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Times of the cycles of a recording, and the choice of the cycles that are shown. */
#ifndef BORESIGHT_PACE_H
#define BORESIGHT_PACE_H

#include "exchange/exchange.h"
#include "recording/format/recording.h"

#include <stdbool.h>

typedef struct {
    uint64_t utc_us; /**< When the last cycle was, since 1970. */
    uint32_t cycle;
    bool has_begun;
    uint32_t states; /**< Value of series_states() for the cycle that was shown last. */
} pace_t;

/** Takes a cycle, each in its turn: its time is that of the one before and how long it took after
 * it; of the first one, when the file was begun. */
void pace_take(pace_t *self, const recording_header_t *header, const cycle_record_t *record);

/** Whether the cycle that was taken is shown: each tenth, and each with another state, word or flag
 * than the one shown before it. */
bool pace_is_turn(pace_t *self, const snapshot_t *snapshot);

#endif

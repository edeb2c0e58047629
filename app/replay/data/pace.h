/* SPDX-License-Identifier: Apache-2.0 */
/** @file When the cycles of a recording were, and which of them are told. */
#ifndef BORESIGHT_PACE_H
#define BORESIGHT_PACE_H

#include "exchange/exchange.h"
#include "recording/format/recording.h"

#include <stdbool.h>

typedef struct {
    uint64_t utc_us; /**< When the last cycle was, since 1970. */
    uint32_t cycle;
    bool has_begun;
    uint32_t states; /**< What series_states() said of what was told last. */
} pace_t;

/** Takes a cycle, each in its turn: its time is that of the one before and how long it took after
 * it; of the first one, when the file was begun. */
void pace_take(pace_t *self, const recording_header_t *header, const cycle_record_t *record);

/** Whether the cycle that was taken is told: each tenth, and each with another state, word or flag
 * than the one told before it. */
bool pace_is_turn(pace_t *self, const snapshot_t *snapshot);

#endif

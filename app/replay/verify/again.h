/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Cycles that are in the recordings again. From a checkpoint of their own they are computed beside
 * the first ones, and the state before each of them is compared with the one that was computed
 * first. Before such a checkpoint they are kept whole, and their records are compared.
 */
#ifndef BORESIGHT_AGAIN_H
#define BORESIGHT_AGAIN_H

#include "replay/verify/replay.h"

/** A state that was computed. */
typedef struct {
    uint32_t cycle;  /**< The next cycle. */
    uint32_t digest; /**< Digest of its seals. */
    uint32_t record; /**< Digest of the whole record of that cycle; 0: it was not replayed. */
} again_state_t;

/** All zero is empty. */
typedef struct {
    replay_t replay;
    bool is_other;    /**< The last record is another, or comes from or leads to another state. */
    bool is_compared; /**< The last record was. */
    again_state_t *states; /**< Those computed first, in the order of their cycles. */
    uint32_t count;
    uint32_t room;
} again_t;

/** Keeps the state that `first` has computed of `record`, which is equal. */
void again_keep(again_t *self, const replay_t *first, const cycle_record_t *record);

/** Frees what was kept: it is empty again. */
void again_end(again_t *self);

/** A recording begins: a checkpoint of the one before it no longer counts. */
void again_begin(again_t *self);

/**
 * Takes a record of a cycle that has been computed before.
 *
 * @return false: its record, its outputs or its state differ
 *
 * @satisfies SWR-REPLAY-038
 */
bool again_take(again_t *self, const robot_t *robot, const cycle_record_t *record,
                const cycle_known_t *known);

/** As replay_difference(), after again_take() has returned false. */
bool again_difference(const again_t *self, const cycle_record_t *record, const cycle_known_t *known,
                      char *text, size_t size);

#endif

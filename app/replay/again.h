/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Cycles that are in the recordings again. They are computed beside the first ones, from a
 * checkpoint of their own, and the state before each of them is compared with the one that was
 * computed first.
 */
#ifndef BORESIGHT_AGAIN_H
#define BORESIGHT_AGAIN_H

#include "replay/replay.h"

/** A state that was computed. */
typedef struct {
    uint32_t cycle;  /**< That is next. */
    uint32_t digest; /**< Of its seals. */
} again_state_t;

/** All zero is empty. */
typedef struct {
    replay_t replay;
    bool is_other;         /**< The last record comes from, or leads to, another state. */
    again_state_t *states; /**< Those computed first, in the order of their cycles. */
    uint32_t count;
    uint32_t room;
} again_t;

/** Keeps the state that `first` has computed. */
void again_keep(again_t *self, const replay_t *first);

/** A recording begins: a checkpoint of the one before it no longer counts. */
void again_begin(again_t *self);

/**
 * Takes a record of a cycle that has been computed before.
 *
 * @return false: its outputs or its state differ
 *
 * @satisfies SWR-REPLAY-038
 */
bool again_take(again_t *self, const robot_t *robot, const cycle_record_t *record,
                const cycle_known_t *known);

/** As replay_difference(), after again_take() has returned false. */
bool again_difference(const again_t *self, const cycle_record_t *record, const cycle_known_t *known,
                      char *text, size_t size);

#endif

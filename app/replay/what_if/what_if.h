/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The behaviour of the controller if some of its inputs had been others. A second controller
 * continues from the state before the first changed cycle, on the recorded inputs but for these,
 * and its outputs are compared with the recorded ones. The reports of the cards are the recorded
 * ones: no card answers to the second controller.
 */
#ifndef BORESIGHT_WHAT_IF_H
#define BORESIGHT_WHAT_IF_H

#include "replay/what_if/difference.h"
#include "replay/verify/replay.h"

#define WHAT_IF_CHANGES 16U /**< Most inputs that are changed. */
#define WHAT_IF_SERIES 256U /**< Most series of one source. */

typedef struct {
    size_t offset; /**< Offset in the inputs. */
    uint32_t value;
} what_if_change_t;

typedef struct {
    uint32_t first; /**< In which cycles they are changed, inclusive. */
    uint32_t last;
    what_if_change_t changes[WHAT_IF_CHANGES];
    uint32_t count;
    const robot_t *robot;
    controller_t controller; /**< The second one. */
    controller_inputs_t inputs;
    controller_outputs_t outputs;
    bool has_begun;
    bool has_ended; /**< Cycles are missing; no more is compared. */
    difference_t difference;
    uint32_t cycle;     /**< That is compared. */
    uint64_t compared;  /**< Cycles. */
    uint64_t different; /**< Those of them that differ. */
} what_if_t;

/** Reads "CYCLE", from which on it is, or "CYCLE-CYCLE", in which it is. False: it is neither. */
bool what_if_read_cycles(what_if_t *self, const char *text);

/**
 * Adds "INPUT=VALUE". False, after a sentence in `error`: there is no such input, it cannot have
 * this value, or there are too many.
 *
 * @satisfies SWR-REPLAY-014
 */
bool what_if_add(what_if_t *self, const char *text, char *error, size_t size);

/** Sets what is compared; after what was read and before the first record. */
void what_if_begin(what_if_t *self, const robot_t *robot);

/** Takes a record before `replay` does: the second controller begins where the first one is. */
void what_if_prepare(what_if_t *self, const replay_t *replay, const cycle_record_t *record);

/**
 * Takes it after `replay`: the second controller does the cycle, and what differs for the first
 * time is printed.
 *
 * @satisfies SWR-REPLAY-013
 */
void what_if_take(what_if_t *self, const replay_t *replay, const cycle_record_t *record);

/** Prints how much differs. False: the changed cycles are not in the recording, or nothing before
 * them gives the state. */
bool what_if_end(const what_if_t *self);

#endif

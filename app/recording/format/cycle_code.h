/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A cycle as bytes: a kind, and what is not as expected (trend.h). Inputs, commands, answers,
 * events and what the board said come back as they were; of snapshot and outgoing frames there is a
 * proof, or, in a cycle that is kept whole, they themselves.
 *
 *     kind     a byte, cycle_kind_t
 *     changes  of the words of cycle_words_of_kept(), not in a quiet cycle
 *     proof    its surprises, then a hash of four bytes for each; only in a cycle of changes
 *     changes  of the words of cycle_words_of_checked(), all from zero; only in a whole cycle
 *
 * A change is how many words further it is than the one before (the first of all words is 1) and by
 * how much the word differs from what is expected of it, lowest bit the sign. 0 ends the changes.
 * Numbers are of 7 bits a byte, the lowest first; all bytes but the last have their highest bit.
 */
#ifndef BORESIGHT_CYCLE_CODE_H
#define BORESIGHT_CYCLE_CODE_H

#include "recording/format/cycle_words.h"
#include "recording/format/proof.h"
#include "recording/format/trend.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum {
    CYCLE_QUIET = 0,   /**< All is as expected: this byte is the cycle. */
    CYCLE_CHANGES = 1, /**< Something is not. */
    CYCLE_WHOLE = 2    /**< Snapshot and frames are kept, too. The first of a block is whole. */
} cycle_kind_t;

/** Most bytes of a cycle: each word two for its place and five for its change. */
#define CYCLE_CODE_MAX ((7U * (CYCLE_WORDS_KEPT + CYCLE_WORDS_CHECKED)) + (4U * PROOF_PARTS) + 16U)

typedef struct {
    trend_t trends[CYCLE_WORDS_KEPT];
} cycle_code_t;

/** Knowledge of a recorded cycle beside the words that come back as they were, or of a checkpoint
 * beside the state. */
typedef struct {
    bool is_whole; /**< Snapshot and frames were kept; otherwise there is a proof. */
    proof_t proof;
    const uint8_t *rows; /**< In a checkpoint: its rows of the trajectory, as many as it states. */
} cycle_known_t;

/** Forgets all cycles before: the next one is whole. */
void cycle_code_begin(cycle_code_t *self);

/**
 * Writes a cycle to `bytes`, at most CYCLE_CODE_MAX. For outputs that are not whole `prover` makes
 * the proof; it forgets all before a whole cycle.
 *
 * @return bytes written
 *
 * @satisfies SWR-REC-006
 * @satisfies SWR-REC-009
 */
size_t cycle_code_encode(cycle_code_t *self, prover_t *prover, bool is_whole,
                         const recorded_cycle_t *cycle, uint8_t *bytes);

/**
 * Reads the cycle at the beginning of any `bytes`; the outputs that were not kept are zero.
 *
 * @return bytes read; 0 when these are not the bytes of a cycle
 */
size_t cycle_code_decode(cycle_code_t *self, const uint8_t *bytes, size_t size,
                         recorded_cycle_t *cycle, cycle_known_t *known);

#endif

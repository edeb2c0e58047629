/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The proof that a recording keeps in place of snapshot and outgoing frames: for each part whether
 * it continues as expected (trend.h), and a hash of each that does not. Recorder and replay
 * make the proof of a cycle alike; equal outputs have equal proofs. A part that differs where it
 * was as expected shows it surely; where it was hashed, by a hash of 32 bits that goes on from the
 * hash before, so that a difference stays in all later ones.
 */
#ifndef BORESIGHT_PROOF_H
#define BORESIGHT_PROOF_H

#include "recording/format/cycle_words.h"
#include "recording/format/trend.h"

#include <stdbool.h>
#include <stdint.h>

#define PROOF_SNAPSHOT 0U /**< The first part is the snapshot, */
#define PROOF_FRAMES 1U   /**< then come the frames in the order of the slots. */
#define PROOF_PARTS (PROOF_FRAMES + CARD_SLOT_COUNT)

typedef struct {
    uint32_t surprises;           /**< Bit n: part n is not as expected. */
    uint32_t hashes[PROOF_PARTS]; /**< Hashes of these parts; 0 for the others. */
} proof_t;

/** The first word of a part that is not as expected. */
typedef struct {
    uint32_t word;
    uint32_t expected;
} proof_surprise_t;

typedef struct {
    trend_t trends[CYCLE_WORDS_CHECKED];
    uint32_t hashes[PROOF_PARTS];            /**< The last of each part. */
    proof_surprise_t surprises[PROOF_PARTS]; /**< Surprises of the last cycle. */
} prover_t;

/** Forgets all cycles before. */
void prover_begin(prover_t *self);

/**
 * Makes the proof of the next cycle, to which `words` belong (cycle_words_of_checked()).
 *
 * @satisfies SWR-REC-006
 */
void prover_take(prover_t *self, uint32_t elapsed_us, const uint32_t words[CYCLE_WORDS_CHECKED],
                 proof_t *proof);

/** The first part in which two proofs differ; PROOF_PARTS when they are equal. */
uint32_t proof_difference(const proof_t *self, const proof_t *other);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Executes the controller again on recorded inputs and compares what it says with what was
 * recorded: counts, answers and events with themselves, snapshot and frames with their proof, or
 * with themselves in a cycle that was kept whole.
 */
#ifndef BORESIGHT_REPLAY_H
#define BORESIGHT_REPLAY_H

#include "controller/controller.h"
#include "exchange/exchange.h"
#include "recording/format/cycle_code.h"
#include "recording/format/proof.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    controller_t controller;
    controller_outputs_t outputs;
    prover_t prover;
    proof_t proof;   /**< Proof of the last cycle, as replayed. */
    bool is_running; /**< A checkpoint was restored and no cycle is missing since. */
    uint32_t next_cycle;
    uint64_t replayed;   /**< Cycles whose outputs were equal. */
    uint64_t unreplayed; /**< Cycles without a checkpoint before them. */
    uint32_t gaps;       /**< Places where cycles are missing. */
    uint32_t checkpoints;
} replay_t;

void replay_init(replay_t *self);

/**
 * Takes the next record: executes a cycle; compares a checkpoint with the state that was computed,
 * or restores it where none leads to it.
 *
 * @return false when the outputs or the state differ; replay_difference() says where
 *
 * @satisfies SWR-REPLAY-001
 * @satisfies SWR-REPLAY-037
 * @satisfies SWR-TRAJ-017
 */
bool replay_take(replay_t *self, const robot_t *robot, const cycle_record_t *record,
                 const cycle_known_t *known);

/**
 * Writes in which part, and as far as it was kept in which field, the outputs of the last cycle
 * differ first from those of `record`, or in which words the state from a checkpoint, as a
 * sentence.
 *
 * @return the field is in it; otherwise the next cycle that is kept whole shows more
 *
 * @satisfies SWR-REPLAY-004
 */
bool replay_difference(const replay_t *self, const cycle_record_t *record,
                       const cycle_known_t *known, char *text, size_t size);

#endif

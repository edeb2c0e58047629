/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The lane of cycles from control to the recorder. Its capacity is chosen by the creator of the
 * segment. Indices run from 0 to below twice the capacity, so that they wrap for any capacity and
 * most damage is no index. Each side keeps its own index in its own memory: the one in the segment
 * only shows it to the other side, and is set right when a neighbour has changed it.
 */
#ifndef BORESIGHT_EXCHANGE_CYCLES_H
#define BORESIGHT_EXCHANGE_CYCLES_H

#include "exchange/exchange.h"

#include <stdbool.h>
#include <stdint.h>

/** Entries that a checkpoint takes: it is longer than a cycle. */
#define EXCHANGE_CHECKPOINT_ENTRIES                                                                \
    ((CONTROLLER_CHECKPOINT_BYTES + sizeof(recorded_cycle_t) - 1U) / sizeof(recorded_cycle_t))

/** Most entries of one cycle: its own and those of a checkpoint before it. */
#define EXCHANGE_CYCLE_ENTRIES ((uint32_t)(EXCHANGE_CHECKPOINT_ENTRIES + 1U))

/**
 * Entries that `mb` megabytes hold.
 *
 * @satisfies SWR-REC-020
 */
uint32_t exchange_cycles_in(uint32_t mb);

/** Entries of the lane. */
uint32_t exchange_cycle_capacity(const exchange_t *self);

/** For control: entries that are free. It writes its own index into the segment again. */
uint32_t exchange_cycle_room(exchange_t *self);

/**
 * For control: the entry to fill next, NULL when the lane is full. exchange_commit_cycle() hands it
 * over.
 *
 * @satisfies SWR-EXCH-003
 */
cycle_entry_t *exchange_reserve_cycle(exchange_t *self);
void exchange_commit_cycle(exchange_t *self);

/** For control: the state before its next cycle, with the rows of the trajectory that belong to it.
 * False when the lane has no room for it. */
bool exchange_push_checkpoint(exchange_t *self, const controller_t *controller);

/**
 * For the recorder: copies the oldest record that was not taken yet, whole. False when there is
 * none.
 */
bool exchange_take_cycle(exchange_t *self, cycle_record_t *record);

/** For the recorder: up to where it has taken records, for exchange_release_cycles(). */
uint32_t exchange_cycles_taken(const exchange_t *self);

/** For the recorder: what was taken up to `taken` is kept elsewhere; control may overwrite it. */
void exchange_release_cycles(exchange_t *self, uint32_t taken);

/** For the recorder: what was taken and is not released is taken again. */
void exchange_retake_cycles(exchange_t *self);

/**
 * State of the recorder: whether it cannot write, so that control hands it no cycles meanwhile, and
 * the number of cycles that it had written and that no recording holds any more (since the start;
 * wraps).
 *
 * @satisfies SWR-REC-032
 */
void exchange_note_recorder(exchange_t *self, bool is_failing, uint32_t removed);
bool exchange_is_recorder_failing(const exchange_t *self);
uint32_t exchange_cycles_removed(const exchange_t *self);

/** Minutes until the disk of the recordings is full, by the recorder; 0: no end is foreseen. */
void exchange_note_recording_left(exchange_t *self, uint32_t left_min);
uint32_t exchange_recording_left_min(const exchange_t *self);

/**
 * For the recorder, before it takes records: sets right what a neighbour has damaged of the lane,
 * and adds the entries that are lost by it to `*dropped`.
 *
 * @return whether there was damage
 *
 * @satisfies SWR-EXCH-025
 */
bool exchange_repair_cycles(exchange_t *self, uint32_t *dropped);

#endif

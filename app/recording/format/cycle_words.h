/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A cycle as words. A frame that says no more than its fields is the words of those: the codec of
 * the cards adds checksums and all that is constant again. Any other frame is the words that it
 * has.
 */
#ifndef BORESIGHT_CYCLE_WORDS_H
#define BORESIGHT_CYCLE_WORDS_H

#include "card/card.h"
#include "card/card_frame.h"
#include "exchange/exchange.h"

#include <stddef.h>
#include <stdint.h>

/** Words of a frame: its kind, then its own words. */
#define CYCLE_WORDS_FRAME (1U + CARD_FRAME_WORDS)
#define CYCLE_WORDS_FRAMES (CARD_SLOT_COUNT * CYCLE_WORDS_FRAME)
#define CYCLE_WORDS_LEVELS (offsetof(controller_inputs_t, frames) / sizeof(uint32_t))
#define CYCLE_WORDS_SAID (offsetof(controller_outputs_t, snapshot) / sizeof(uint32_t))
#define CYCLE_WORDS_SNAPSHOT (sizeof(snapshot_t) / sizeof(uint32_t))

#define CYCLE_WORDS_BOARD (sizeof(cycle_board_t) / sizeof(uint32_t))

/** Words of the inputs, then of the outputs before the snapshot (counts, answers and events), then
 * of the board's report. */
#define CYCLE_WORDS_KEPT                                                                           \
    (CYCLE_WORDS_LEVELS + CYCLE_WORDS_FRAMES + CYCLE_WORDS_SAID + CYCLE_WORDS_BOARD)
/** Words of the rest of the outputs: snapshot, then frames in the order of the slots. */
#define CYCLE_WORDS_CHECKED (CYCLE_WORDS_SNAPSHOT + CYCLE_WORDS_FRAMES)
/** Which of the kept words is the time that has passed. */
#define CYCLE_WORDS_ELAPSED (offsetof(controller_inputs_t, elapsed_us) / sizeof(uint32_t))

void cycle_words_of_kept(const recorded_cycle_t *cycle, uint32_t words[CYCLE_WORDS_KEPT]);
void cycle_words_of_checked(const controller_outputs_t *outputs,
                            uint32_t words[CYCLE_WORDS_CHECKED]);

/** The reverse, of any words. Writes all but the outputs that stand behind the events. */
void cycle_words_to_kept(const uint32_t words[CYCLE_WORDS_KEPT], recorded_cycle_t *cycle);
/** Writes snapshot and frames. */
void cycle_words_to_checked(const uint32_t words[CYCLE_WORDS_CHECKED],
                            controller_outputs_t *outputs);

/**
 * A number that differs when the codec of the cards makes other bytes of the same fields.
 *
 * @satisfies SWR-REC-008
 */
uint32_t cycle_words_frame_layout(void);

#endif

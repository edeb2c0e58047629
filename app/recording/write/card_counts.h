/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The counts of a card in the log: its frames that control discarded or missed, and what the card
 * counts of its commands. Both are sums, so that a line that was not written costs nothing.
 */
#ifndef BORESIGHT_CARD_COUNTS_H
#define BORESIGHT_CARD_COUNTS_H

#include "interface/snapshot.h"

#include <stdbool.h>
#include <stdint.h>

#define CARD_COUNTS_SIZE 256U
#define CARD_COUNTS_END UINT64_MAX /**< The time at the end of the run: no pause counts. */

/** As the log has them; all zero at first. */
typedef struct {
    uint64_t reported_us;     /**< 0: never. */
    uint32_t first_heartbeat; /**< First of the card in this run; 0: it has not answered yet. */
    bool is_settled;          /**< The card's counts from before the run are known. */
    uint32_t numbers[6];      /**< Frames damaged, out of order, missed; commands damaged, out of
                                 order; trips. */
} card_counts_t;

/**
 * Makes the line of the card in `slot` when its counts have changed, and the last line is no less
 * than LIMIT_CARD_COUNTS_PAUSE_MS before `now_us`, which is monotonic. A card counts the first
 * command of a run as out of order, and it may have counted in earlier runs: its own counts up to
 * LIMIT_CARD_COUNTS_SETTLE_FRAMES frames after its first answer change nothing.
 *
 * @return false: there is nothing to report now, and `text` is as it was
 *
 * @satisfies SWR-REC-053
 * @satisfies SWR-REC-054
 */
bool card_counts_look(card_counts_t *self, uint32_t slot, const snapshot_card_t *card,
                      uint64_t now_us, char text[CARD_COUNTS_SIZE]);

#endif

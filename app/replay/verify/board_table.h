/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The reports of the board, as comma-separated values: a row for each cycle. Times are in us of the
 * board's time, which wrap. Inputs are words; `high` are those that were high all the time since
 * the sample before. `results` has a letter for each slot: - not sent, o back, n no answer, l late,
 * i still under way, b bus error.
 */
#ifndef BORESIGHT_BOARD_TABLE_H
#define BORESIGHT_BOARD_TABLE_H

#include "exchange/exchange.h"

/** Prints the names of the columns. */
void board_table_print_names(void);

/**
 * Prints the row of a cycle: `shown` is the snapshot of it, and says how many axes its frames
 * drive; the frames that were received in it say how many cards drive.
 *
 * @satisfies SWR-REPLAY-009
 */
void board_table_print_row(const cycle_record_t *record, const snapshot_t *shown);

#endif

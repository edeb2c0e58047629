/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Recorded motion as a table of comma-separated values: a row each TABLE_CYCLES cycles; the time in
 * s, then the columns that core/interface/snapshot.yml names. Or the interval of each cycle, or the
 * events as lines.
 */
#ifndef BORESIGHT_TABLE_H
#define BORESIGHT_TABLE_H

#include "exchange/exchange.h"

#define TABLE_CYCLES 10U

/** Prints the names of the columns. */
void table_print_names(const robot_t *robot);

/**
 * Prints the row of `cycle` when it is its turn.
 *
 * @satisfies SWR-REPLAY-003
 */
void table_print_row(const robot_t *robot, uint32_t cycle, const snapshot_t *snapshot);

/** Prints the names of the columns of table_print_interval(). */
void table_print_interval_names(void);

/**
 * Prints a row of `record`, a cycle: the time in s, how long after the one before it came in us,
 * and which stage of the one before took longest.
 *
 * @satisfies SWR-CHECK-005
 */
void table_print_interval(const cycle_record_t *record);

/**
 * Prints a line for each event of `record`: time in s, number, severity, name, sentence.
 *
 * @satisfies SWR-EVENT-007
 */
void table_print_events(const robot_t *robot, const cycle_record_t *record);

#endif

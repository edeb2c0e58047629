/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rows of the trajectory that the controller holds, for checkpoints. They are too many to be copied
 * with one: each lies in the exchange once it has come, and a checkpoint says which belong to it.
 */
#ifndef BORESIGHT_EXCHANGE_ROWS_H
#define BORESIGHT_EXCHANGE_ROWS_H

#include "exchange/exchange.h"

#include <stdbool.h>

/**
 * For control, after each cycle: publishes rows of the trajectory that have come in it. `outputs`
 * show whether a list was begun.
 *
 * @satisfies SWR-TRAJ-016
 */
void exchange_publish_rows(exchange_t *self, const controller_t *controller,
                           const controller_outputs_t *outputs);

/**
 * Copies the rows of a checkpoint.
 *
 * @return false when another trajectory was begun since: nothing in `rows` is of use
 *
 * @satisfies SWR-TRAJ-017
 */
bool exchange_read_rows(const exchange_t *self, const cycle_record_t *checkpoint,
                        trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS]);

/**
 * Copies the row where the trajectory begins of which control has rows.
 *
 * @return false without any, or when another one was begun meanwhile: nothing in `row` is of use
 */
bool exchange_read_start(const exchange_t *self, trajectory_row_t *row);

#endif

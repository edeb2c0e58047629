/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What an operator may order besides moves and jogs to a position, by chance: one row of a table
 * for each command.
 */
#ifndef BORESIGHT_ORDERS_H
#define BORESIGHT_ORDERS_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** A trajectory that is being sent. */
typedef struct {
    uint32_t rows; /**< It has so many; 0: none is sent. */
    uint32_t next; /**< The row that is sent next; beyond them the end, and the order to run it. */
    uint32_t sum;
    trajectory_row_t row;
} orders_t;

/** One of the orders for `phase`, or WORKPHASE_COUNT: for any. @return false: it has none */
bool orders_choose(orders_t *self, const rig_t *rig, workphase_t phase, uint32_t *chance,
                   command_t *command);

/** What comes next of a list that was begun. @return false: nothing */
bool orders_go_on(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command);

#endif

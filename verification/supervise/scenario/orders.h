/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Orders of an operator besides moves and jogs to a position, by chance: one row of a table for
 * each command.
 */
#ifndef BORESIGHT_ORDERS_H
#define BORESIGHT_ORDERS_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** A trajectory or a treatment program that is being sent. */
typedef struct {
    uint32_t rows; /**< It has so many; 0: none is sent. */
    uint32_t next; /**< The row that is sent next; beyond them the end, and the order to run it. */
    uint32_t sum;
    bool is_program;
    trajectory_row_t row; /**< Last row of a trajectory. */
} orders_t;

/** Orders that are wished for a robot. */
typedef struct {
    workphase_t phase;    /**< Orders of this workphase alone; WORKPHASE_COUNT: of any. */
    command_kind_t theme; /**< This kind alone, where the workphase has it; COMMAND_NONE: any. */
} orders_wish_t;

/** Some order by `wish`. @return false: there is none */
bool orders_choose(orders_t *self, const rig_t *rig, orders_wish_t wish, uint32_t *chance,
                   command_t *command);

/** Next part of a list that was begun. @return false: nothing */
bool orders_go_on(orders_t *self, const rig_t *rig, uint32_t *chance, command_t *command);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file What restoring saved positions would do to each axis, to be shown before it is done. */
#ifndef BORESIGHT_SAVED_PLAN_H
#define BORESIGHT_SAVED_PLAN_H

#include "interface/snapshot.h"
#include "saved/saved_file.h"

#include <stdbool.h>
#include <stdint.h>

/** Why an axis gets what it gets. The first five: it is restored, unverified. */
typedef enum {
    SAVED_WHY_COUNTS_AGREE = 0,   /**< In this power-on its counter has not moved since. */
    SAVED_WHY_OTHER_POWER_ON = 1, /**< It may have been moved by hand; the counts cannot show it. */
    SAVED_WHY_UNSEALED = 2,       /**< Its writer is unknown. */
    SAVED_WHY_OLD_LIST = 3,       /**< Neither robot nor time is known. */
    SAVED_WHY_MISCOUNTED = 4,     /**< It has not moved, says the operator: its counts are wrong. */
    SAVED_WHY_MOVED = 5,          /**< It stays: its counter has moved since. */
    SAVED_WHY_NOT_KNOWN = 6,      /**< It stays: its position was not known. */
    SAVED_WHY_STANDS_THERE = 7    /**< It stays: it is homed, and there. */
} saved_why_t;

typedef struct {
    saved_why_t why;
    int32_t now_ticks;
    int32_t saved_ticks; /**< In the file. */
    int32_t next_ticks;  /**< After a restoration: the saved one, and the ticks counted since. */
} saved_row_t;

typedef struct {
    uint32_t axis_count;
    uint32_t axes; /**< Bit n: axis n is restored. */
    uint32_t power_on;
    saved_row_t rows[ROBOT_AXIS_MAX];
} saved_plan_t;

/**
 * Compares what was saved with what is.
 *
 * @satisfies SWR-REF-020
 * @satisfies SWR-STORE-027
 */
void saved_plan_make(saved_plan_t *self, const saved_t *saved, const snapshot_t *snapshot,
                     const robot_t *robot);

/** `why` is one by which an axis is restored. */
bool saved_plan_restores(saved_why_t why);

/**
 * Each axis of `saved->miscounted` is one whose counter has moved.
 *
 * @satisfies SWR-REF-020
 */
bool saved_plan_fits(const saved_plan_t *self, const saved_t *saved);

/**
 * The plan `self`, which was shown, still agrees with `now`, made of the same positions.
 *
 * @satisfies SWR-STORE-030
 */
bool saved_plan_holds(const saved_plan_t *self, const saved_plan_t *now, const robot_t *robot);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Do the counts of a running axis come evenly? A motor does not change its speed from one count to
 * the next by much more than its model does; an encoder that loses counts now and then seems to.
 * That needs to be told neither how fast the motor truly is nor where it stands, from the first
 * counts on. The supervision of an axis owns one.
 */
#ifndef BORESIGHT_EDGE_PACE_H
#define BORESIGHT_EDGE_PACE_H

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    uint32_t speed_ticks_per_s_q8; /**< Of the model at the newest count; 0: the motor has not
                                      counted since its last rest. */
    uint32_t edge_us;              /**< Card time of that count. */
    uint32_t ticks;  /**< What was counted of the last way between two counts; 0: none yet. */
    uint32_t due;    /**< What the model made of it, in 1/15625 ticks. */
    uint32_t uneven; /**< The sum of changes, for which even paces give back. */
} edge_pace_t;

/** The position is sure, or lost: what was uneven does not matter any more. */
void edge_pace_settle(edge_pace_t *self);

/** The motor rests, turns, or is too slow: the next way begins at its next count. */
void edge_pace_rest(edge_pace_t *self);

/**
 * `ticks`, 1 or more, were counted in the direction of the drive, the newest at `edge_us` in the
 * card's time, where the motor runs at `speed_ticks_per_s_q8`, 1 or more, by its model.
 *
 * @return true when the sum reaches LIMIT_UNEVEN_MOST
 *
 * @satisfies SWR-AXIS-027
 */
bool edge_pace_step(edge_pace_t *self, uint32_t ticks, uint32_t edge_us,
                    uint32_t speed_ticks_per_s_q8);

#endif

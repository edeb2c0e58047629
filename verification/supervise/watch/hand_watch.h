/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Permitted acts of an insertion by hand, for a reader of commands, frames, the true hand and the
 * true needle, and no mode nor sensor. Holds some rules against every cycle.
 */
#ifndef BORESIGHT_HAND_WATCH_H
#define BORESIGHT_HAND_WATCH_H

#include "integration/support/rig.h"
#include "supervise/watch/order_watch.h"

#include <stdbool.h>
#include <stdint.h>

/** Each a bit of hand_watch_look(). */
typedef enum {
    HAND_ALONE = 0, /**< It drives the needle alone, and in; out by a vibration's way at most. */
    HAND_DEPTH = 1, /**< The true needle is never deeper than the target by more than 0.1 mm. */
    HAND_PUSH = 2,  /**< It drives while a hand truly pushes; by an untrue sensor not for long. */
    HAND_ROTATION =
        3, /**< A needle that is steered gains no 0.5 mm while its true rotation stands. */
    HAND_VIBRATION = 4 /**< From its puncture on it goes no deeper than a needle that stops. */
} hand_rule_t;

#define HAND_RULES 5U

/** At first all zero. */
typedef struct {
    bool is_untrue;  /**< A load cell is or was broken, or was zeroed under a force, since
                          all of them were zeroed whole and untouched. */
    bool is_touched; /**< Since a zeroing began, a hand has touched the handle or a cell was broken.
                      */
    bool is_zeroing; /**< It was zeroed in the cycle before. */
    bool is_vibrating;          /**< The answer to a puncture has begun, and not ended. */
    int32_t speed_q8;           /**< Of the needle's set-point in the cycle before. */
    double stop_ticks;          /**< So deep a needle goes that stops since the puncture. */
    bool is_insertion;          /**< The last order that was accepted is one. */
    uint32_t armed;             /**< Insertions that were accepted. */
    int32_t target_ticks;       /**< Depth of its target. */
    uint32_t idle_cycles;       /**< No hand has truly pushed for so long. */
    uint32_t ghost_cycles;      /**< The needle has been driven for so long meanwhile. */
    uint32_t off_cycles;        /**< It has not been driven for so long. */
    double deepest_ticks;       /**< The deepest place of the true needle in this insertion. */
    double turned_ticks;        /**< Where the true rotation had turned last, */
    double turned_needle_ticks; /**< and where the true needle was then. */
} hand_watch_t;

/** Looks at the cycle that `rig` has just run, and `order` has. @return the rules that it broke */
uint32_t hand_watch_look(hand_watch_t *self, const order_watch_t *order, const rig_t *rig,
                         const double truth[ROBOT_AXIS_MAX]);

#endif

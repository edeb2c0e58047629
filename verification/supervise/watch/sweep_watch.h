/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Permitted acts of a sweep, for a reader of commands, frames, events and the true positions, and
 * no mode. Holds some rules against every cycle.
 */
#ifndef BORESIGHT_SWEEP_WATCH_H
#define BORESIGHT_SWEEP_WATCH_H

#include "integration/support/rig.h"
#include "supervise/watch/order_watch.h"

#include <stdbool.h>
#include <stdint.h>

/** Each a bit of sweep_watch_look(). */
typedef enum {
    SWEEP_WAVES = 0, /**< Waves are of 45 to 55 kHz in every drive. */
    SWEEP_PLACE = 1, /**< It drives in MANUAL, with the needle truly out. */
    SWEEP_RUN = 2,   /**< The reported way is the true way of a whole run. */
    SWEEP_END = 3    /**< It is done with points both ways, and its end reported. */
} sweep_rule_t;

#define SWEEP_RULES 4U

/** At first all zero. */
typedef struct {
    uint32_t driven_us; /**< So long without a pause. */
    uint32_t run_us;    /**< The same of the run that has just ended. */
    double from;        /**< Where the axis was when it began, ticks. */
    uint32_t upwards;   /**< Ways that were reported. */
    uint32_t downwards; /**< The same. */
    bool is_over;       /**< Its end was reported. */
} sweep_watch_t;

/** Looks at the cycle that `rig` has just run; `order` has not yet. `is_disturbed`: something is or
 * was broken, and the ways are no matter of the sweep alone. @return the rules that it broke */
uint32_t sweep_watch_look(sweep_watch_t *self, const order_watch_t *order, const rig_t *rig,
                          const double truth[ROBOT_AXIS_MAX], bool is_disturbed);

#endif

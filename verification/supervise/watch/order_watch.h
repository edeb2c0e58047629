/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Axes that an order may drive, for a reader of commands, answers, frames and the true positions,
 * and no mode. Holds some rules against every cycle.
 */
#ifndef BORESIGHT_ORDER_WATCH_H
#define BORESIGHT_ORDER_WATCH_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** Each a bit of order_watch_look(). */
typedef enum {
    ORDER_POSE = 0,   /**< To a pose the needle is not driven. */
    ORDER_ALIGN = 1,  /**< To line up the needle is not driven in. */
    ORDER_INSERT = 2, /**< An insertion moves no other axis, but turns a needle that is steered. */
    ORDER_COMMANDED = 3, /**< Jogs, speeds, sweeps and programs drive the axes that they name. */
    ORDER_DISABLED = 4,  /**< An axis that was disabled is not driven. */
    ORDER_LISTED = 5,    /**< A trajectory keeps each axis between its rows. */
    ORDER_TOLD = 6       /**< The end of an order is reported. */
} order_rule_t;

#define ORDER_RULES 7U

/** At first all zero. */
typedef struct {
    uint32_t kind;       /**< command_kind_t of the order that was accepted and has not ended. */
    uint32_t swept_axis; /**< Axis of a sweep; of another order 0. */
    uint32_t axes;       /**< Bit n: axis n is named by it. */
    uint32_t disabled;   /**< Bit n: axis n was disabled, and not enabled since. */
    double from[ROBOT_AXIS_MAX];    /**< Where the axes were when it was accepted. */
    double before[ROBOT_AXIS_MAX];  /**< In the cycle before. */
    double inwards;                 /**< Way of the needle under drives that take it in, ticks. */
    double lowest[ROBOT_AXIS_MAX];  /**< Lowest of the accepted rows. */
    double highest[ROBOT_AXIS_MAX]; /**< The same. */
    uint32_t armed[COMMAND_KIND_COUNT]; /**< How many orders there were, by command_kind_t. */
    uint32_t done[COMMAND_KIND_COUNT];  /**< How many of them ended as asked. */
} order_watch_t;

/** The axis turns a needle that is steered to the accepted target. */
bool order_watch_is_steering(const rig_t *rig, uint32_t axis);

/** Looks at the cycle that `rig` has just run. `is_disturbed`: something is or was broken, and
 * where the axes truly are is no matter of the order alone. @return the rules that it broke */
uint32_t order_watch_look(order_watch_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                          bool is_disturbed);

#endif

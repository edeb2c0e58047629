/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Permitted acts of a treatment program, for a reader of commands, frames, events and the true
 * positions, and no mode. Holds some rules against every cycle.
 */
#ifndef BORESIGHT_PROGRAM_WATCH_H
#define BORESIGHT_PROGRAM_WATCH_H

#include "integration/support/rig.h"
#include "supervise/watch/order_watch.h"

#include <stdbool.h>
#include <stdint.h>

/** Each a bit of program_watch_look(). */
typedef enum {
    PROGRAM_GATE = 0, /**< While the gate says stop, nothing is driven. */
    PROGRAM_DWELL =
        1,          /**< A step ends at its place, after its dwell or by the dose it waits for. */
    PROGRAM_END = 2 /**< It is done once each of its steps is, one after the other. */
} program_rule_t;

#define PROGRAM_RULES 3U

/** A step, as it was accepted. */
typedef struct {
    int32_t ticks[ROBOT_AXIS_MAX];
    uint32_t dwell_ms;
    bool is_gated; /**< At most so long. */
} program_watch_step_t;

/** At first all zero. */
typedef struct {
    program_watch_step_t steps[LIMIT_PROGRAM_STEPS];
    uint32_t count;
    uint32_t done;      /**< Steps that have ended. */
    uint32_t rested_us; /**< At the place of the next one, under the pedal, with all drives off. */
    bool was_undosed;   /**< In this rest the gate has not said that the dose is reached. */
} program_watch_t;

/** Looks at the cycle that `rig` has just run; `order` has not yet. `is_disturbed`: something is or
 * was broken, and where the axes truly are is no matter of the program alone. @return the rules
 * that it broke */
uint32_t program_watch_look(program_watch_t *self, const order_watch_t *order, const rig_t *rig,
                            const double truth[ROBOT_AXIS_MAX], bool is_disturbed);

#endif

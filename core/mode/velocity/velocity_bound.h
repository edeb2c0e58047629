/* SPDX-License-Identifier: Apache-2.0 */
/** @file The way that one axis may go at its commanded speed, for itself, and the bound that ends
 * it. Without state. */
#ifndef BORESIGHT_VELOCITY_BOUND_H
#define BORESIGHT_VELOCITY_BOUND_H

#include "interface/event.h"
#include "interface/status.h"
#include "mode/leg/mode_frame.h"
#include "mode/velocity/velocity_state.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    int32_t ticks;
    velocity_end_t end; /**< VELOCITY_END_TIME: nothing but its time. */
} velocity_bound_t;

/**
 * The nearest bound of axis `index` in the direction of its speed: of its limits, while it is
 * homed, of the way that was asked for, of the short way of what is not known, and of its switch
 * while that is active.
 *
 * @satisfies SWR-VEL-005
 * @satisfies SWR-VEL-006
 * @satisfies SWR-VEL-008
 */
velocity_bound_t velocity_bound_of(const velocity_mode_t *self, const mode_frame_t *frame,
                                   uint32_t index);

/** Axis `index` is at its active switch, and its speed is towards it. */
bool velocity_bound_is_switch(const velocity_mode_t *self, const mode_frame_t *frame,
                              uint32_t index);

/** Status that reports that `end` has ended a speed; STATUS_OK for its time and its way, and for a
 * coupled limit, which is reported when it does. */
status_t velocity_bound_refusal(velocity_end_t end);

#endif

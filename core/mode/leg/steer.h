/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The rotation of a needle that is steered, while a mode inserts it: to and fro over whole turns,
 * with the speed of the law (motion/curv.h). It turns back beyond them, opposite of the direction,
 * while the insertion waits: so the needle advances over each angle as the law has it.
 */
#ifndef BORESIGHT_STEER_H
#define BORESIGHT_STEER_H

#include "mode/leg/mode_frame.h"
#include "robot/steering.h"

#include <stdbool.h>
#include <stdint.h>

/** At first all zero: it has not begun. */
typedef struct {
    int32_t low_ticks; /**< Ends of whole turns, between which the needle goes in; */
    int32_t high_ticks;
    int32_t run_out_ticks; /**< beyond each it turns back within this way. */
    int32_t heading;       /**< 1: upwards, -1: downwards, 0: it has not begun. */
    int32_t rest;          /**< As of ramp_place(). */
} steer_t;

/**
 * Share of its speed that the needle has while it is steered, percent, within that of the permit.
 *
 * @satisfies SWR-STEER-011
 */
uint32_t steer_needle_percent(const mode_frame_t *frame);

/** It begins anew, from where the axis is then. Without it a rotation that has rested goes on as it
 * did before: so no pause changes over which angles the needle has advanced. */
void steer_stop(steer_t *self);

/**
 * One cycle of the rotation of a needle that is steered. Its request is written to `result`.
 *
 * @return the needle may go deeper in this cycle: it is within its turns, and
 * steering_guard_follows()
 *
 * @satisfies SWR-STEER-005
 * @satisfies SWR-STEER-007
 */
bool steer_step(steer_t *self, const steering_t *steering, const mode_frame_t *frame,
                mode_result_t *result);

#endif

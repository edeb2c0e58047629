/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The speed of a set-point from one cycle to the next: ramps whose end is known before they begin.
 * Pure functions of magnitudes: speeds and steps, the change of a speed in a cycle, have 8 fraction
 * bits; a way is the sum of the speeds of its cycles.
 */
#ifndef BORESIGHT_RAMP_H
#define BORESIGHT_RAMP_H

#include <stdint.h>

/** Most that a cycle may change a speed by, neither 0. */
typedef struct {
    int64_t up_q8;
    int64_t down_q8;
} ramp_steps_t;

/** One step slower, or 0. */
int64_t ramp_slower(int64_t speed_q8, int64_t down_q8);

/** The way of a cycle at `speed_q8` and of a ramp down to 0 behind it. `down_q8` is not 0. */
int64_t ramp_way(int64_t speed_q8, int64_t down_q8);

/**
 * The speed after `now_q8`: the fastest of one step faster, the same and one step slower, not above
 * `most_q8` unless that is slower, whose way is not longer than `room`. One step slower if none is.
 *
 * @satisfies SWR-VEL-003
 * @satisfies SWR-PROFILE-270
 */
int64_t ramp_next(int64_t now_q8, int64_t most_q8, const ramp_steps_t *steps, int64_t room);

#endif

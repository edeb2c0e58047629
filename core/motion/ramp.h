/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The speed of a set-point from one cycle to the next: ramps whose end is known before they begin.
 * Pure functions of magnitudes: speeds and steps, the change of a speed in a cycle, have 8 fraction
 * bits; a way is the sum of the speeds of its cycles.
 */
#ifndef BORESIGHT_RAMP_H
#define BORESIGHT_RAMP_H

#include "limits/requirement_limits.h"

#include <stdint.h>

#define RAMP_CYCLES_PER_S (1000000U / LIMIT_CYCLE_US)
/** A tick in the unit of ways: what a speed of 1 ticks/s, 8 fraction bits, makes of it in a cycle.
 */
#define RAMP_TICK (INT64_C(256) * (INT64_C(1000000) / (int64_t)LIMIT_CYCLE_US))

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

/** The set-point after `way`, signed, from `ticks` and the part of a tick that is in `rest`: that
 * by which it is less than its place, in the unit of ways, replaced by the new one. */
int32_t ramp_place(int32_t ticks, int64_t way, int32_t *rest);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A leg: from where the axes stand, at rest, to where they shall stand, on one profile. There is
 * one, which mode.h lends to the mode that runs; a leg that was stopped begins anew from where the
 * axes are then.
 */
#ifndef BORESIGHT_LEG_H
#define BORESIGHT_LEG_H

#include "mode/leg/mode_frame.h"
#include "motion/profile.h"

#include <stdbool.h>
#include <stdint.h>

/** Bit of axis `index` in a mask of axes. */
#define LEG_AXIS(index) ((uint32_t)1U << (index))
#define LEG_EVERY_AXIS (LEG_AXIS(ROBOT_AXIS_MAX) - 1U)

/** At first all zero. */
typedef struct {
    profile_t profile;
    uint32_t axes;            /**< Bit n: axis n is of it; the others rest... */
    uint32_t lent;            /**< ...but for these (bits), which the mode drives by itself. */
    uint32_t is_running;      /**< 0 or 1. */
    uint32_t settled_cycles;  /**< At the end, in a row. */
    uint32_t overtime_cycles; /**< Since the end of the profile, on the way to its end. */
} leg_t;

/** Positions of the axes. */
void leg_positions(const mode_frame_t *frame, int32_t ticks[ROBOT_AXIS_MAX]);

/**
 * Begins: `axes` (LEG_AXIS bits) are driven to `ends`, within the cap of each; of the others `ends`
 * says nothing. None is lent.
 *
 * @satisfies SWR-AXIS-006
 * @satisfies SWR-PERMIT-005
 */
void leg_begin(leg_t *self, const mode_frame_t *frame, uint32_t axes,
               const int32_t ends[ROBOT_AXIS_MAX]);

/**
 * One cycle of a leg that has begun. Once all its axes have settled at its end it stops, and every
 * axis rests. If they are not there LIMIT_OVERTIME_US after the profile, the mode fails.
 *
 * @return it has arrived
 *
 * @satisfies SWR-DEMO-001
 * @satisfies SWR-MOTION-005
 * @satisfies SWR-MOTION-006
 */
bool leg_step(leg_t *self, const mode_frame_t *frame, mode_result_t *result);

/** The leg is given up, if one runs. */
void leg_stop(leg_t *self);

#endif

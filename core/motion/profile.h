/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A time-true trapezoid that several axes share: all start and end together, each within its own
 * speed and acceleration. Closed form in whole cycles, so it has no drift and ends exactly at the
 * target.
 *
 * With R ramp and C cruise cycles and N = 2R + C the fraction of the way at cycle k is
 * k^2 / (2R(R+C)) on the ramp up, (2k - R) / (2(R+C)) on the cruise, 1 - (N-k)^2 / (2R(R+C)) on the
 * ramp down; the peak speed is distance / (R+C) per cycle.
 */
#ifndef BORESIGHT_PROFILE_H
#define BORESIGHT_PROFILE_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    int32_t start_ticks[ROBOT_AXIS_MAX];
    int32_t end_ticks[ROBOT_AXIS_MAX];
    uint32_t ramp_cycles;   /**< R, at least 1 while anything moves. */
    uint32_t cruise_cycles; /**< C. */
    uint32_t cycle;         /**< k, 0..2R+C. */
} profile_t;

/**
 * Plans from rest at `start_ticks` to rest at `end_ticks` as fast as the slowest axis allows, at
 * `speed_percent` (1..100) of each axis' speed. Requires (contract 100) a percentage in that range.
 *
 * @satisfies SWR-MOTION-001
 * @satisfies SWR-MOTION-002
 * @satisfies SWR-PEDAL-005
 */
void profile_plan(profile_t *self, const robot_t *robot, const int32_t start_ticks[ROBOT_AXIS_MAX],
                  const int32_t end_ticks[ROBOT_AXIS_MAX], uint32_t speed_percent);

/**
 * Advances by one nominal cycle, whatever time has passed; does nothing when finished.
 *
 * @satisfies SWR-LOOP-003
 */
void profile_step(profile_t *self);

/** @return true when the set-point of every axis is at its end */
bool profile_is_finished(const profile_t *self);

/**
 * @return set-point of axis `axis` in this cycle, between start and end; the end when finished
 *
 * @satisfies SWR-MOTION-003
 * @satisfies SWR-PROFILE-800
 */
int32_t profile_position_ticks(const profile_t *self, uint32_t axis);

/**
 * @return set-point speed of axis `axis` in this cycle, signed; 0 at both ends
 *
 * @satisfies SWR-PROFILE-800
 */
int32_t profile_speed_ticks_per_s_q8(const profile_t *self, uint32_t axis);

#endif

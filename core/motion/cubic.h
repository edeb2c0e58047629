/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The way of one axis between two points in time: the cubic that has the position and the speed of
 * both (Hermite), kept as its four control points (Bezier). Curve, speed and acceleration lie
 * between the control points of each, so a whole way is judged by a few numbers. Integers alone;
 * positions to 1/256 tick.
 */
#ifndef BORESIGHT_CUBIC_H
#define BORESIGHT_CUBIC_H

#include <stdbool.h>
#include <stdint.h>

#define CUBIC_POINTS 4U
/** The whole way, as a share. */
#define CUBIC_ONE_Q20 UINT32_C(1048576)

/** A point: where and how fast, ticks and ticks/s. */
typedef struct {
    int32_t ticks;
    int32_t speed_ticks_per_s;
} cubic_end_t;

typedef struct {
    int64_t at_q8[CUBIC_POINTS]; /**< Control points, ticks with 8 fraction bits. */
    uint32_t span_ms;
} cubic_t;

/** From one point to the other in `span_ms`, 1..LIMIT_TRAJECTORY_STEP_MOST_MS. Speeds of at most
 * 10^7 ticks/s. */
void cubic_set(cubic_t *self, const cubic_end_t *from, const cubic_end_t *to, uint32_t span_ms);

/** Share of `span_ms` that `time_us` (at most all of it) is, 0..CUBIC_ONE_Q20. */
uint32_t cubic_share_q20(uint32_t time_us, uint32_t span_ms);

/**
 * @return position at `share_q20`, between the smallest and the largest of cubic_point_ticks();
 * both ends are exact
 *
 * @satisfies SWR-TRAJ-510
 */
int32_t cubic_position_ticks(const cubic_t *self, uint32_t share_q20);

/** @return speed at `share_q20`, signed */
int32_t cubic_speed_ticks_per_s_q8(const cubic_t *self, uint32_t share_q20);

/** @return control point `index` in whole ticks; the curve is between the smallest and the largest
 */
int32_t cubic_point_ticks(const cubic_t *self, uint32_t index);

/**
 * @return true when it is nowhere faster than `speed_ticks_per_s`. By the control points of the
 * speed, which is halved once: true for certain, and from rest to rest exact.
 *
 * @satisfies SWR-TRAJ-003
 */
bool cubic_keeps_speed(const cubic_t *self, int32_t speed_ticks_per_s);

/**
 * @return true when it gains and loses speed nowhere faster than `ticks_per_s2`, at most
 * LIMIT_ACCELERATION_MOST_TICKS_PER_S2, as far as ends that are rounded to whole ticks show it.
 * Control points within 10^9 ticks of each other.
 *
 * @satisfies SWR-TRAJ-003
 * @satisfies SWR-TRAJ-025
 */
bool cubic_keeps_acceleration(const cubic_t *self, int32_t ticks_per_s2);

#endif

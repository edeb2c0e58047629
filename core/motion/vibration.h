/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A train of strokes by which an axis vibrates on one side of the place where it began: back by the
 * amplitude A and forward again, with a rest before each stroke and behind the last. In a stroke of
 * N cycles the set-point x has a constant acceleration for one half and the opposite one for the
 * other, as of any motion from rest to rest that is the slowest to accelerate (a = 4 A / N^2):
 *
 *     x(k) = 2 A k^2 / N^2          for k <= N / 2
 *     x(k) = A - 2 A (N - k)^2 / N^2    beyond
 *
 * The thesis names the feedback (5.5) and gives no law: form and figures are a design of this
 * project. Pure functions; the count of cycles belongs to the mode that vibrates.
 */
#ifndef BORESIGHT_VIBRATION_H
#define BORESIGHT_VIBRATION_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The set-point of a cycle. */
typedef struct {
    int32_t behind_ticks;         /**< Way behind the place where it began, 0..amplitude. */
    int32_t speed_ticks_per_s_q8; /**< Below 0 on the way back. */
    bool is_over;                 /**< The train has ended: the rest is 0. */
} vibration_point_t;

/**
 * @param cycle since the train began, from 0 on; the first rest comes first
 * @return the set-point; of a law without periods, or with a stroke of more than
 * LIMIT_VIBRATION_STROKE_CYCLES, it is over
 *
 * @satisfies SWR-VIB-701
 * @satisfies SWR-VIB-702
 */
vibration_point_t vibration_at(const vibration_law_t *law, uint32_t cycle);

#endif

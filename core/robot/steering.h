/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * How a needle with a bevel tip is steered: the curvature that is wanted, and the strength alpha
 * of the rotation law (motion/curv.h) that gives it, by the calibrated table of the needle.
 */
#ifndef BORESIGHT_STEERING_H
#define BORESIGHT_STEERING_H

#include "interface/status.h"
#include "interface/steering_method.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Steering of an insertion. All zero: the needle is not steered. No padding. */
typedef struct {
    uint32_t method;           /**< steering_method_t. */
    uint32_t curvature_per_km; /**< Of the path: 1 / radius, 0..steering_law_t's most. */
    int32_t direction_deg;     /**< Of the rotation's axis, at which the bevel bends the needle the
                                   way that is wanted; as it was sent, */
    int32_t direction_bam;     /**< and wrapped. */
    uint32_t alpha_q16;        /**< Strength for that curvature, 0..most_alpha_q16. */
} steering_t;

/** The needle is steered. */
static inline bool steering_is_on(const steering_t *self)
{
    return self->method != (uint32_t)STEERING_NONE;
}

/**
 * Makes `self` of what is wanted: the strength lies between two points of the needle's table on a
 * straight line.
 *
 * @param direction_deg any angle of the rotation's axis, degrees
 * @return STATUS_OK; STATUS_NO_STEERING of a robot whose file says nothing of it;
 * STATUS_UNKNOWN_COMMAND of a method that is none; STATUS_STEERING_CURVATURE: no drive is so slow
 * that the needle would be bent so much. What is refused leaves `self` all zero.
 *
 * @satisfies SWR-STEER-002
 * @satisfies SWR-STEER-004
 */
status_t steering_set(steering_t *self, const steering_law_t *law, uint32_t method,
                      uint32_t curvature_per_km, int32_t direction_deg);

#endif

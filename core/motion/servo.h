/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * From set-point and position to a drive request for one ultrasonic motor. Speed demand = set-point
 * speed + gain of the axis x error. A speed below the motor's slowest is done in bursts: it runs as
 * long as even a motor that is faster than its model does not pass the set-point before it can be
 * stopped. The request is nothing but a wish: only the permit turns it into a drive.
 */
#ifndef BORESIGHT_SERVO_H
#define BORESIGHT_SERVO_H

#include "card/card_frame.h"
#include "motion/motor_model.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    motor_model_t model; /**< Model of a motor that obeys each request. */
    int64_t unseen_q16;  /**< Its way in ticks by the request before: no reading shows it yet. */
    uint32_t direction;  /**< Last requested drive direction bit. */
    uint32_t rest_us;    /**< Since the first cycle without a request, saturates. */
    uint32_t is_driving; /**< A drive was requested in the last cycle: 0 or 1. */
    uint32_t duty;       /**< Duty of the last request; 0 for an axis without magnitudes. */
} servo_t;

/** Starts at rest. */
void servo_init(servo_t *self);

/**
 * One cycle, `elapsed_us` after the one before. The drive of a cycle is seen by the next but one.
 *
 * @return the request: off inside the deadband with a resting set-point, ahead of a moving one, and
 * for the dwell of the axis' motor between the two directions; otherwise towards the set-point,
 * with a duty of 0 or between the axis' slowest and fastest
 *
 * @satisfies SWR-MOTION-004
 * @satisfies SWR-MOTION-007
 * @satisfies SWR-MOTION-020
 * @satisfies SWR-MOTION-021
 * @satisfies SWR-MOTION-022
 * @satisfies SWR-AXIS-007
 * @satisfies SWR-AXIS-008
 * @satisfies SWR-DRIVE-007
 * @satisfies SWR-DRIVE-010
 */
card_drive_t servo_step(servo_t *self, const axis_config_t *config, int32_t error_ticks,
                        int32_t setpoint_speed_ticks_per_s_q8, uint32_t elapsed_us);

/** Nothing is requested in this cycle. */
void servo_rest(servo_t *self, uint32_t elapsed_us);

#endif

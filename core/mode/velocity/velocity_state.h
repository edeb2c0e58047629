/* SPDX-License-Identifier: Apache-2.0 */
/** @file The state of the mode velocity, which velocity_mode.h owns and velocity_bound.h reads. */
#ifndef BORESIGHT_VELOCITY_STATE_H
#define BORESIGHT_VELOCITY_STATE_H

#include "robot/robot.h"

#include <stdint.h>

/** Request and progress; at first all zero but the request. */
typedef struct {
    uint32_t axes;                              /**< Asked for, bit n: axis n. */
    uint32_t time_ms;                           /**< Asked for; 0: a way. */
    uint32_t way_ticks;                         /**< Asked for, of one axis; 0: a time. */
    int32_t speeds_ticks_per_s[ROBOT_AXIS_MAX]; /**< Asked for, signed. */
    uint32_t stage;                             /**< Stage of this file; 0: it has not begun. */
    uint32_t left_cycles;                       /**< Cycles left of its time. */
    int32_t start_ticks[ROBOT_AXIS_MAX];        /**< Positions of the axes when it began. */
    int32_t rest[ROBOT_AXIS_MAX]; /**< Part by which the set-point of the axis is less than its
                                     place. */
    uint32_t barred;              /**< Bit n: a limit that axis n shares has ended its speed. */
    uint32_t refusal;             /**< status_t of the limit that ended it first. */
    uint32_t refused_axis;
} velocity_mode_t;

#endif

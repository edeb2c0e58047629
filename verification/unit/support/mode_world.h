/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The world of a mode in a test: the NeuroRobot's axes, homed and enabled, each of which is in the
 * next cycle where it was to be. In the header alone, so that only the tests that include it need
 * the axes.
 */
#ifndef BORESIGHT_MODE_WORLD_H
#define BORESIGHT_MODE_WORLD_H

#include "axis/axis.h"
#include "limits/requirement_limits.h"
#include "mode/leg/mode_frame.h"
#include "robot/robot_neuro.h"

#include <stdbool.h>
#include <stdint.h>

static robot_t robot;
static axis_t axes[ROBOT_AXIS_MAX];
static mode_frame_t frame;
static mode_result_t result;

/** Gives the axis a grade, with the inverse that its chart keeps of it. */
static inline void world_grade(uint32_t axis, axis_reference_t grade)
{
    axes[axis].chart.reference = grade;
    axes[axis].chart.reference_inverse = ~(uint32_t)grade;
}

static inline void world_start(void)
{
    robot = robot_neuro;
    frame = (mode_frame_t){.robot = &robot,
                           .axes = axes,
                           .axis_count = robot.axis_count,
                           .is_every_axis_homed = true,
                           .is_moving = true,
                           .elapsed_us = LIMIT_CYCLE_US};
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        axis_init(&axes[i]);
        axis_enable(&axes[i], false);
        axes[i].sealed.encoder.is_at_rest = 1U;
        world_grade(i, AXIS_REFERENCE_VERIFIED);
        frame.speed_cap_percent[i] = 100U;
    }
    mode_clear(&result);
}

static inline void world_put(uint32_t axis, int32_t ticks)
{
    axes[axis].sealed.encoder.position_ticks = ticks;
}

static inline void world_lose(uint32_t axis)
{
    world_grade(axis, AXIS_REFERENCE_LOST);
    frame.is_every_axis_homed = false;
}

/** The end of a cycle: every axis but `held`, which stands, has followed its set-point. */
static inline void world_follow_but(uint32_t held)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        if (i != held) {
            world_put(i, axes[i].sealed.setpoint_ticks);
        }
    }
}

static inline void world_follow(void)
{
    world_follow_but(ROBOT_AXIS_MAX);
}

/** The axis was asked to rest in this cycle. */
static inline bool world_rests(uint32_t axis)
{
    return (result.requests[axis].mode == (uint32_t)CARD_DRIVE_OFF) &&
           (axes[axis].sealed.setpoint_ticks == axes[axis].sealed.encoder.position_ticks) &&
           (axes[axis].sealed.setpoint_speed_ticks_per_s_q8 == 0);
}

#endif

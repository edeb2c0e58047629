/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Sources of a mode's request: its command, and how the robot stands. A mode with a payload of its
 * own has a function NAME_mode_ask(), which its row in core/interface/modes.yml names.
 */
#ifndef BORESIGHT_MODE_ASKED_H
#define BORESIGHT_MODE_ASKED_H

#include "axis/axis.h"
#include "interface/command.h"
#include "mode/leg/leg.h"
#include "mode/lists/trajectory_list.h"
#include "robot/robot.h"

#include <stdint.h>

typedef struct {
    const command_t *command;
    const robot_t *robot;
    const axis_t *axes;            /**< ROBOT_AXIS_MAX of them. */
    const trajectory_list_t *list; /**< The trajectory that is held, */
    const trajectory_row_t *rows;  /**< and its rows. */
} mode_asked_t;

/** Bit n: axis n; 0 for an axis that no robot has. */
static inline uint32_t mode_asked_axes(uint32_t axis)
{
    return (axis < ROBOT_AXIS_MAX) ? LEG_AXIS(axis) : 0U;
}

#endif

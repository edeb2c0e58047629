/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Homing: the needle leaves if it is in, then the axes find their home positions, stage after stage
 * of the robot's table (core/axis/homing.h says how one does), with those that follow them
 * (core/axis/follower.h), the last of a linkage with an escort (escort.h). At last all go to the
 * pose home, if the robot has one. Its state is that of the axes and of the escort.
 */
#ifndef BORESIGHT_HOMING_MODE_H
#define BORESIGHT_HOMING_MODE_H

#include "mode/leg/escort.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdbool.h>

/**
 * All is done: every axis is homed, and the leg has taken them to the pose home, if there is one.
 *
 * @satisfies SWR-ROBOT-024
 */
bool homing_mode_is_done(const leg_t *leg, const mode_frame_t *frame);

/**
 * One cycle. Fails when a coupled limit bars an axis from homing, one cannot follow, no escort is
 * found, or the way home would leave a coupled limit.
 *
 * @satisfies SWR-AXIS-029
 * @satisfies SWR-AXIS-030
 * @satisfies SWR-AXIS-033
 * @satisfies SWR-AXIS-052
 * @satisfies SWR-COUPLE-003
 * @satisfies SWR-ROBOT-026
 * @satisfies SWR-JOG-016
 * @satisfies SWR-ROBOT-024
 */
void homing_mode_step(leg_t *leg, escort_t *escort, const mode_frame_t *frame,
                      mode_result_t *result);

/**
 * @return the axis of a linkage whose position must be said before any of these can be homed; the
 * count of axes when there is none: of all but one the counts say where they are, or they stand as
 * they were parked
 *
 * @satisfies SWR-AXIS-055
 */
uint32_t homing_mode_unplaced(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * One cycle of axis `index` that is to be homed: it begins, is taken where it stands, or goes on.
 * Fails when a coupled limit bars it.
 */
void homing_mode_begin_axis(const mode_frame_t *frame, uint32_t index, mode_result_t *result);

#endif

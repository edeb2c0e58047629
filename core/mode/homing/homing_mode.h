/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Homing: the needle leaves if it is in, then the axes find their home positions, stage after stage
 * of the robot's table (core/axis/homing.h says how one does), with those that follow them
 * (core/axis/follower.h), the last of a linkage with an escort (escort.h). At last all go to the
 * pose home, if the robot has one. Its state is that of the axes and of the escort. Or a single
 * axis homes, by the same rules.
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
 * May axis `index` be homed alone?
 *
 * @return status STATUS_OK; STATUS_UNKNOWN_COMMAND for no axis; STATUS_HOMES_WITH_OTHERS of one of
 * a block; STATUS_HOMES_OTHERWISE without a switch, unless it is fresh; STATUS_NEEDLE_IN;
 * STATUS_NOT_HOMED or the refusal of a coupled limit as coupled_guard_judge_homing()
 *
 * @satisfies SWR-AXIS-036
 */
solution_t homing_mode_judge(uint32_t index, const robot_t *robot,
                             const axis_t axes[ROBOT_AXIS_MAX]);

/** Axis `index` is homed. */
bool homing_mode_is_axis_done(uint32_t index, const mode_frame_t *frame);

/**
 * One cycle of homing axis `index` alone; all others rest. Fails when a coupled limit bars it.
 *
 * @satisfies SWR-AXIS-034
 */
void homing_mode_step_axis(uint32_t index, const mode_frame_t *frame, mode_result_t *result);

#endif

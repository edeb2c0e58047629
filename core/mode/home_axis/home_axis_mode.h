/* SPDX-License-Identifier: Apache-2.0 */
/** @file A single axis homes, by the rules of homing_mode.h; all others rest. Without a state. */
#ifndef BORESIGHT_HOME_AXIS_MODE_H
#define BORESIGHT_HOME_AXIS_MODE_H

#include "mode/leg/mode_frame.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * May axis `index` be homed alone?
 *
 * @return status STATUS_OK; STATUS_UNKNOWN_COMMAND for no axis; STATUS_HOMES_WITH_OTHERS of one of
 * a block; STATUS_HOMES_OTHERWISE without a switch, unless it is fresh; STATUS_NEEDLE_IN;
 * STATUS_NOT_HOMED or the refusal of a coupled limit as coupled_guard_judge_homing()
 *
 * @satisfies SWR-AXIS-036
 */
solution_t home_axis_mode_judge(uint32_t index, const robot_t *robot,
                                const axis_t axes[ROBOT_AXIS_MAX]);

/** Axis `index` is homed. */
bool home_axis_mode_is_done(uint32_t index, const mode_frame_t *frame);

/**
 * One cycle of homing axis `index` alone. Fails when a coupled limit bars it.
 *
 * @satisfies SWR-AXIS-034
 */
void home_axis_mode_step(uint32_t index, const mode_frame_t *frame, mode_result_t *result);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * All axes but the needle go in step to a pose that the robot's file names. The needle has no part
 * in it: it must be out before, is not driven, and is never taken out for it.
 */
#ifndef BORESIGHT_POSE_MODE_H
#define BORESIGHT_POSE_MODE_H

#include "interface/status.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/move/move_mode.h"
#include "robot/joints.h"

#include <stdint.h>

/**
 * End positions of the axes that go to `pose` (pose_name_t), the needle where it is.
 *
 * @return STATUS_OK; STATUS_NO_POSE; STATUS_MEMORY_DAMAGED for a pose that is not as it was
 * compiled
 *
 * @satisfies SWR-POSE-003
 */
status_t pose_mode_find(uint32_t pose, const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                        move_mode_t *move);

/**
 * May the axes go there from where they are?
 *
 * @return status STATUS_OK; STATUS_NEEDLE_IN; or the refusal of the coupled limit that the way
 * would leave
 *
 * @satisfies SWR-POSE-002
 * @satisfies SWR-POSE-004
 */
solution_t pose_mode_judge(const move_mode_t *self, const robot_t *robot,
                           const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * One cycle; done once all axes have arrived.
 *
 * @satisfies SWR-POSE-001
 * @satisfies SWR-FLOW-004
 */
void pose_mode_step(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                    mode_result_t *result);

#endif

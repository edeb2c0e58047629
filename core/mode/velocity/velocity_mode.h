/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Velocity: one or several axes at commanded speeds, for a time or a way; the others are left
 * alone. Each set-point has a speed that the axis' acceleration lets it have, and of these the
 * fastest from which it would, ramped down, still come to rest in time and before its limits. So no
 * ramp down begins late, and none ends beyond. Axes that share a limit are looked at together.
 *
 * Time passes only while the pedal lets it run; where the way ends is fixed when it first does.
 */
#ifndef BORESIGHT_VELOCITY_MODE_H
#define BORESIGHT_VELOCITY_MODE_H

#include "mode/leg/leg.h"
#include "mode/leg/mode_asked.h"
#include "mode/leg/mode_frame.h"
#include "mode/velocity/velocity_state.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * May it be armed?
 *
 * @return status STATUS_OK; STATUS_UNKNOWN_COMMAND for no axis, or one that the robot does not
 * have; STATUS_OUT_OF_RANGE for neither time nor way or both, a time beyond LIMIT_VELOCITY_TIME_MS,
 * a way of several axes, or a speed of 0; STATUS_TOO_FAST beyond the axis' speed; STATUS_NEEDLE_IN
 *
 * @satisfies SWR-VEL-001
 * @satisfies SWR-VEL-002
 * @satisfies SWR-VEL-009
 */
solution_t velocity_mode_judge(const velocity_mode_t *asked, const robot_t *robot,
                               const axis_t axes[ROBOT_AXIS_MAX]);

/** It has begun, and not every set-point has come to rest. */
bool velocity_mode_runs(const velocity_mode_t *self);

/**
 * One cycle; done once all axes rest. Fails, by the name of the limit, if one has ended it. `leg`
 * takes the axes to where their set-points have come to rest.
 *
 * @satisfies SWR-VEL-003
 * @satisfies SWR-VEL-004
 * @satisfies SWR-VEL-005
 * @satisfies SWR-VEL-006
 * @satisfies SWR-VEL-007
 * @satisfies SWR-VEL-008
 * @satisfies SWR-VEL-010
 * @satisfies SWR-VEL-011
 * @satisfies SWR-VEL-012
 */
void velocity_mode_step(velocity_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                        mode_result_t *result);

/**
 * Request of a command VELOCITY.
 *
 * @return bit n: axis n
 */
uint32_t velocity_mode_ask(const mode_asked_t *asked, velocity_mode_t *self);

#endif

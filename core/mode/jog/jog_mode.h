/* SPDX-License-Identifier: Apache-2.0 */
/** @file A jog: one axis goes where it is commanded to, the others are left alone. */
#ifndef BORESIGHT_JOG_MODE_H
#define BORESIGHT_JOG_MODE_H

#include "mode/leg/leg.h"
#include "mode/leg/mode_asked.h"
#include "mode/leg/mode_frame.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdint.h>

/**
 * May the jog be armed?
 *
 * @return status STATUS_OK; STATUS_UNKNOWN_COMMAND for no axis; STATUS_NEEDLE_IN; of a homed axis
 * STATUS_AXIS_LIMIT, STATUS_SWITCH_ZONE, the refusal of a coupled limit, with axis and limit;
 * STATUS_JOG_TOO_FAR while it or one that shares a limit with it is not homed
 *
 * @satisfies SWR-AXIS-004
 * @satisfies SWR-JOG-002
 */
solution_t jog_mode_judge(const mode_way_t *asked, const robot_t *robot,
                          const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * One cycle; done once the axis has arrived. An axis that the robot does not have is not driven.
 *
 * @satisfies SWR-JOG-004
 */
void jog_mode_step(const mode_way_t *self, leg_t *leg, const mode_frame_t *frame,
                   mode_result_t *result);

/**
 * `way` of JOG, or of JOG_BY from where the axis stands.
 *
 * @return bit n: axis n
 *
 * @satisfies SWR-MODE-007
 */
uint32_t jog_mode_ask(const mode_asked_t *asked, mode_way_t *way);

#endif

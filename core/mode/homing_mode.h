/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Homing: the needle leaves if it is in, then the axes find their home positions, stage after stage
 * of the robot's table (core/axis/homing.h says how one does). Its state is that of the axes.
 */
#ifndef BORESIGHT_HOMING_MODE_H
#define BORESIGHT_HOMING_MODE_H

#include "mode/leg.h"
#include "mode/mode_frame.h"

/**
 * One cycle. Fails when a coupled limit bars an axis from homing.
 *
 * @satisfies SWR-COUPLE-003
 * @satisfies SWR-JOG-016
 */
void homing_mode_step(leg_t *leg, const mode_frame_t *frame, mode_result_t *result);

#endif

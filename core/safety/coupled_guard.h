/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Keeps two axes inside the limit that they share, wherever they would stop. Limits are in force
 * once both of their axes are homed, in every workphase. Without state.
 */
#ifndef BORESIGHT_COUPLED_GUARD_H
#define BORESIGHT_COUPLED_GUARD_H

#include "axis/axis.h"
#include "robot/coupled_limit.h"

#include <stdbool.h>
#include <stdint.h>

/** The axes in a cycle; arrays in the order of the robot's axes. */
typedef struct {
    const axis_t *axes;
    const card_drive_t *sent;     /**< What the cards apply now. */
    const card_drive_t *requests; /**< What they would apply next. */
} coupled_view_t;

/**
 * Looks ahead of the request of axis `index`.
 *
 * @return true when it takes a limit away from its range, and within LIMIT_COUPLED_STOP_US
 * the two axes might leave it: each as fast as it is measured or, if driven that way, as its motor
 * can be. That the other one comes towards the range counts for nothing. Of two axes of which only
 * the other is homed, true when the request goes towards its switch, and that is outside the range,
 * unless the two travel as a block (core/axis/follower.h).
 *
 * @satisfies SWR-COUPLE-001
 * @satisfies SWR-COUPLE-003
 */
bool coupled_guard_blocks(const robot_t *robot, const coupled_view_t *view, uint32_t index);

/**
 * @return true when axis `index` is not homed, another is that shares a limit with it, and homing
 * it would leave that; that axis does not follow it
 *
 * @satisfies SWR-COUPLE-003
 */
bool coupled_guard_bars_homing(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index);

/** @return true when axis `index` and all that share a limit with it are homed */
bool coupled_guard_is_known(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                            uint32_t index);

/**
 * May axis `index` be jogged to `ticks`, with the others where they are?
 *
 * @return STATUS_OK; or the refusal of the first limit in force that it would miss, with the axis
 *
 * @satisfies SWR-COUPLE-002
 */
solution_t coupled_guard_judge(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index, int32_t ticks);

#endif

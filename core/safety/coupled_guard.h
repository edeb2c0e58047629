/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Keeps axes inside the limits that they share, wherever they would stop. Limits are in force once
 * all of their axes are homed, in every workphase. Without state.
 *
 * Wherever they would stop: each axis somewhere between the end of its way down and that of its way
 * up, and the axes in the worst of all these places together. A way is what LIMIT_COUPLED_STOP_US
 * allow, as fast as the axis is measured or, if driven that way, as its motor can be. Another
 * axis that moves inwards gives no credit.
 *
 * No derivative is asked for and no shape is assumed: the limit's value is looked at with each axis
 * in turn at both ends of its way. For a curved limit these changes are added up, and the corner
 * that they point at is looked at as well; what a corner between them may add is of second order,
 * for ways of some hundredths of a millimetre less than a micrometre. A value farther from both
 * ends of the range than the margin that ends of motions keep is looked at once only: that margin
 * holds what all axes may run on at the full speed of their motors.
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
    const card_drive_t *sent;     /**< Drives that the cards apply now. */
    const card_drive_t *requests; /**< Drives that they would apply next. */
} coupled_view_t;

/**
 * Looks ahead of the requests of all axes.
 *
 * @return bit n: the request of axis n takes a limit in force away from its range, and the axes
 * might leave that; or axis n is the only one of a limit that is not homed, the request goes
 * towards its switch, and that is outside the range, unless another one travels
 * with it (core/axis/follower.h)
 *
 * @satisfies SWR-COUPLE-001
 * @satisfies SWR-COUPLE-003
 * @satisfies SWR-COUPLE-005
 */
uint32_t coupled_guard_blocks(const robot_t *robot, const coupled_view_t *view);

/**
 * @return true when axis `index` is not homed, all others are that share a limit with it, none of
 * them travels with it, and homing it would leave that
 *
 * @satisfies SWR-COUPLE-003
 */
bool coupled_guard_bars_homing(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index);

/**
 * @return true when axis `index` stands, with all that share a limit with it and are homed as well,
 * outside of that by more than the margin that ends keep
 *
 * @satisfies SWR-AXIS-033
 */
bool coupled_guard_is_missed(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                             uint32_t index);

/** @return true when axis `index` is not homed and shares a limit, and the counts of all that share
 * one with it say where these are */
bool coupled_guard_is_last(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index);

/** @return true when axis `index` and all that share a limit with it are homed */
bool coupled_guard_is_known(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                            uint32_t index);

/**
 * @return true when limit `limit_index` is in force and its axes, now at `from_ticks`, would end at
 * `to_ticks` closer to an end of its range than ends may be, and closer than they are
 *
 * @satisfies SWR-VEL-007
 */
bool coupled_guard_is_left(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                           uint32_t limit_index, const int32_t from_ticks[ROBOT_AXIS_MAX],
                           const int32_t to_ticks[ROBOT_AXIS_MAX]);

/**
 * May axis `index` be jogged to `ticks`, with the others where they are?
 *
 * @return STATUS_OK; or the refusal of the first limit in force that it would miss, with the axis
 *
 * @satisfies SWR-COUPLE-002
 */
solution_t coupled_guard_judge(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index, int32_t ticks);

/**
 * May axis `index` be homed alone, with the others where they are?
 *
 * @return STATUS_OK; STATUS_NOT_HOMED while another axis of one of its limits is not homed; or the
 * refusal of the first limit that its home position would miss, with the axis
 *
 * @satisfies SWR-AXIS-036
 */
solution_t coupled_guard_judge_homing(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                                      uint32_t index);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Is the needle out, and what may a jog do while it is not known to be? Without state.
 */
#ifndef BORESIGHT_NEEDLE_H
#define BORESIGHT_NEEDLE_H

#include "axis/axis.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** @return the deepest position that counts as out, ticks: LIMIT_NEEDLE_OUT_NM from home */
int32_t needle_out_ticks(const robot_t *robot);

/** Position to which a needle that is to be out is taken: halfway from home, so that it surely
 * counts as out.
 */
int32_t needle_retracted_ticks(const robot_t *robot);

/** @return true when the needle is homed and no deeper than needle_out_ticks() */
bool needle_is_out(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * @return false when nothing has been known of the needle since the power-on, so that it stands as
 * it was parked, or its counts have said ever since that it is no deeper than needle_out_ticks();
 * true also where its place was known and its counts cannot be believed
 *
 * @satisfies SWR-NEXT-029
 */
bool needle_may_be_in(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * @return true when the needle is homed and in, and an axis across it is not homed: it must leave
 * before that homes
 *
 * @satisfies SWR-JOG-016
 */
bool needle_must_leave(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * @return true when axis `index` must not be jogged this way: across a needle that is not homed and
 * out, or the needle itself deeper from an unknown place
 *
 * @satisfies SWR-JOG-001
 * @satisfies SWR-JOG-003
 */
bool needle_forbids_jog(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index,
                        bool is_upwards);

#endif

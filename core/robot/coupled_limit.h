/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Limits that two axes share (coupled_limits of the robot), and where positions are to them.
 */
#ifndef BORESIGHT_COUPLED_LIMIT_H
#define BORESIGHT_COUPLED_LIMIT_H

#include "robot/joints.h"
#include "robot/robot.h"

#include <stdint.h>

typedef enum {
    COUPLED_LIMIT_INSIDE = 0,
    COUPLED_LIMIT_BELOW = 1,
    COUPLED_LIMIT_ABOVE = 2
} coupled_side_t;

/** How far the first axis is above the second, nm. */
int64_t coupled_limit_nm(const robot_t *robot, const coupled_limit_t *limit, int32_t first_ticks,
                         int32_t second_ticks);

/** May a motion end at `above_nm`? Inside: LIMIT_COUPLED_MARGIN_NM or more from both ends. */
coupled_side_t coupled_limit_side(const coupled_limit_t *limit, int64_t above_nm);

/** What who would end on that side of `limit` is told: STATUS_OK inside, otherwise its refusal. */
solution_t coupled_limit_refusal(const coupled_limit_t *limit, coupled_side_t side);

/**
 * May a motion end with all axes at `ticks`? @return STATUS_OK, or the refusal of the first limit
 * that is missed
 *
 * @satisfies SWR-COUPLE-002
 */
solution_t coupled_limit_judge(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX]);

#endif

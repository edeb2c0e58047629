/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Limits that axes share (coupled_limits of the robot), and where positions are to them. The
 * measured value is the robot's own: kinematics_coupled().
 */
#ifndef BORESIGHT_COUPLED_LIMIT_H
#define BORESIGHT_COUPLED_LIMIT_H

#include "robot/joints.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

typedef enum {
    COUPLED_LIMIT_INSIDE = 0,
    COUPLED_LIMIT_BELOW = 1,
    COUPLED_LIMIT_ABOVE = 2
} coupled_side_t;

/** Axis `index` has part in `limit`. */
static inline bool coupled_limit_has(const coupled_limit_t *limit, uint32_t index)
{
    return ((limit->axes >> index) & 1U) != 0U;
}

/** Distance inside at which motions end: LIMIT_COUPLED_MARGIN_NM, or for an angle
 * LIMIT_COUPLED_MARGIN_BAM. */
int64_t coupled_limit_margin(const coupled_limit_t *limit);

/** May a motion end at `value`? Inside: the margin or more from both ends. */
coupled_side_t coupled_limit_side(const coupled_limit_t *limit, int64_t value);

/** Verdict on a motion that would end at `value`: STATUS_OK inside, otherwise the refusal of
 * `limit`. */
solution_t coupled_limit_refusal(const coupled_limit_t *limit, int64_t value);

/**
 * May a motion end at `joints`? @return STATUS_OK, or the refusal of the first limit that is missed
 *
 * @satisfies SWR-COUPLE-002
 */
solution_t coupled_limit_judge(const robot_t *robot, const joints_t *joints);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Check that axes that go in step keep the limits that they share all the way: each has gone the
 * same part of its way at any time, as on one profile (motion/profile.h).
 *
 * The value of a limit that is not curved rises or falls all the way, so its ends say everything.
 * A curved one is looked at in 16 steps. Between two looks it may be farther out than both by an
 * eighth of what it bends over them, its second difference; what three looks in a row show of that
 * is taken twice. As far as the margin that ends keep does not hold it, all looks must be so much
 * farther inside: nothing between them leaves the range.
 */
#ifndef BORESIGHT_COUPLED_PATH_H
#define BORESIGHT_COUPLED_PATH_H

#include "robot/joints.h"
#include "robot/robot.h"

#include <stdint.h>

/**
 * May the axes go in step from `from` to `to` (ticks)? Axes that begin outside may come back, but
 * go no farther out. 17 values of each curved limit.
 *
 * @return STATUS_OK, or the refusal of the first curved limit that the way would leave
 *
 * @satisfies SWR-COUPLE-006
 */
solution_t coupled_path_judge(const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                              const int32_t to[ROBOT_AXIS_MAX]);

#endif

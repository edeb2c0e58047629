/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * May a needle that is steered go deeper? Only while its rotation follows its law: a needle that
 * advances while its rotation stands, lags or turns back is bent in a direction that nobody wants.
 * Without state.
 */
#ifndef BORESIGHT_STEERING_GUARD_H
#define BORESIGHT_STEERING_GUARD_H

#include "axis/axis.h"
#include "robot/robot.h"
#include "robot/steering.h"

#include <stdbool.h>

/**
 * @return the rotation's axis is no farther from its set-point than LIMIT_STEERING_LAG_BAM, and
 * that goes by LIMIT_STEERING_PACE_PERCENT of the speed of the law at the place of the axis at
 * least; true of a needle that is not steered
 *
 * @satisfies SWR-STEER-006
 */
bool steering_guard_follows(const steering_t *steering, const robot_t *robot,
                            const axis_t axes[ROBOT_AXIS_MAX]);

#endif

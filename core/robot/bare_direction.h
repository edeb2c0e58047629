/* SPDX-License-Identifier: Apache-2.0 */
/** @file Where the needle of a robot goes to a target of which a point alone is known. */
#ifndef BORESIGHT_BARE_DIRECTION_H
#define BORESIGHT_BARE_DIRECTION_H

#include "base/rigid.h"
#include "robot/robot.h"

#include <stdbool.h>

/** Without one a point needs an entry point. */
bool bare_direction_is_there(const robot_t *robot);

/** A point on the needle's line before `target`, both in the z-frame: 0.1 m in each of x, y and z
 * in which the direction goes wholly. */
point_t bare_direction_before(const robot_t *robot, const point_t *target);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/bare_direction.h"

#include "base/fixed.h"

#define BEFORE_NM 100000000

bool bare_direction_is_there(const robot_t *robot)
{
    return (robot->bare_direction[0] != 0) || (robot->bare_direction[1] != 0) ||
           (robot->bare_direction[2] != 0);
}

point_t bare_direction_before(const robot_t *robot, const point_t *target)
{
    const int32_t *const way = robot->bare_direction;
    return (point_t){.x_nm = fixed_saturate((int64_t)target->x_nm - ((int64_t)way[0] * BEFORE_NM)),
                     .y_nm = fixed_saturate((int64_t)target->y_nm - ((int64_t)way[1] * BEFORE_NM)),
                     .z_nm = fixed_saturate((int64_t)target->z_nm - ((int64_t)way[2] * BEFORE_NM))};
}

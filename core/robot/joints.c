/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/joints.h"

#include "base/fixed.h"

#include <string.h>

/* A unit is not negative, and a whole turn or a metre at most: each product is one of 32 bits. */
int64_t joints_value(const axis_config_t *axis, int32_t ticks)
{
    const uint64_t unit_q16 = (uint64_t)axis->unit_per_tick_q16;
    const uint64_t upper = unit_q16 >> 16U;
    const uint64_t lower = unit_q16 & 0xFFFFU;
    const int64_t whole = (int64_t)(int32_t)upper;
    const int64_t fraction_q16 = (int64_t)(int32_t)lower;
    return (ticks * whole) + fixed_shift_rounded(ticks * fraction_q16, 16U);
}

int32_t joints_of(const axis_config_t *axis, int32_t ticks)
{
    const int64_t value = joints_value(axis, ticks);
    return (axis->unit == (uint8_t)AXIS_UNIT_RAD) ? fixed_wrap_bam(value) : fixed_saturate(value);
}

void joints_from_ticks(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX], joints_t *joints)
{
    (void)memset(joints, 0, sizeof *joints);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        joints->value[i] = joints_of(&robot->axes[i], ticks[i]);
    }
}

void joints_to_ticks(const robot_t *robot, const joints_t *joints, int32_t ticks[ROBOT_AXIS_MAX])
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const int64_t value_q16 = (int64_t)joints->value[i] * 65536;
        ticks[i] =
            fixed_saturate(fixed_divide_rounded(value_q16, robot->axes[i].unit_per_tick_q16));
    }
}

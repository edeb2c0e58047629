/* SPDX-License-Identifier: Apache-2.0 */
#include "common/axis_terms.h"

#include <math.h>
#include <string.h>

#define NM_PER_MM 1.0e6
#define BAM_PER_DEGREE (4294967296.0 / 360.0)
#define ONE_Q16 65536.0

uint32_t axis_terms_find(const robot_t *robot, const char *name)
{
    uint32_t axis = 0U;
    while ((axis < robot->axis_count) && (strcmp(robot->axes[axis].name, name) != 0)) {
        axis++;
    }
    return axis;
}

double axis_terms_unit(const axis_config_t *axis)
{
    const double unit = (axis->unit == (uint8_t)AXIS_UNIT_MM) ? NM_PER_MM : BAM_PER_DEGREE;
    return ((double)axis->unit_per_tick_q16 / ONE_Q16) / unit;
}

const char *axis_terms_unit_name(const axis_config_t *axis)
{
    return (axis->unit == (uint8_t)AXIS_UNIT_MM) ? "mm" : "deg";
}

bool axis_terms_ticks(const axis_config_t *axis, double way, int32_t *ticks)
{
    const double exact = round(way / axis_terms_unit(axis));
    const bool is_one = (exact >= (double)INT32_MIN) && (exact <= (double)INT32_MAX);
    *ticks = is_one ? (int32_t)exact : 0;
    return is_one;
}

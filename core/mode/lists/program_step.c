/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/lists/program_step.h"

#include "base/crc.h"

#include <stddef.h>

uint32_t program_step_turning_axis(const robot_t *robot)
{
    uint32_t axis = 0U;
    while ((axis < robot->axis_count) &&
           (robot->axes[axis].needle_motion != (uint32_t)NEEDLE_ABOUT)) {
        axis++;
    }
    return axis;
}

uint32_t program_step_crc(const program_step_t *step)
{
    return crc32c((const uint8_t *)step, offsetof(program_step_t, crc));
}

bool program_step_is_whole(const program_step_t *step)
{
    return step->crc == program_step_crc(step);
}

uint32_t program_list_crc(uint32_t crc, const program_step_t *step)
{
    const uint32_t words[2] = {crc, program_step_crc(step)};
    return crc32c((const uint8_t *)words, sizeof words);
}

void program_step_place(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX],
                        program_step_t *step)
{
    const uint32_t turning = program_step_turning_axis(robot);
    step->depth_ticks = ticks[robot->needle_axis];
    step->angle_ticks = (turning < robot->axis_count) ? ticks[turning] : 0;
}

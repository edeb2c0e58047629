/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/retract/retract_mode.h"

#include "base/fixed.h"
#include "safety/needle.h"

static int32_t end_ticks_of(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX])
{
    const axis_t *const needle = &axes[robot->needle_axis];
    const axis_config_t *const config = &robot->axes[robot->needle_axis];
    const int64_t stroke = (int64_t)config->maximum_ticks - (int64_t)config->minimum_ticks;
    const int64_t end = (int64_t)needle->sealed.encoder.position_ticks - stroke;
    return axis_is_homed(needle) ? needle_retracted_ticks(robot) : fixed_saturate(end);
}

bool retract_mode_is_done(int32_t end_ticks, const mode_frame_t *frame)
{
    const axis_t *const needle = &frame->axes[frame->robot->needle_axis];
    const axis_config_t *const config = &frame->robot->axes[frame->robot->needle_axis];
    const int64_t left = (int64_t)needle->sealed.encoder.position_ticks - (int64_t)end_ticks;
    return (left <= (int64_t)config->deadband_ticks) ||
           (!axis_is_homed(needle) && (needle->sealed.limit_switches != 0U));
}

void retract_mode_step(int32_t end_ticks, leg_t *leg, const mode_frame_t *frame,
                       mode_result_t *result)
{
    const uint32_t needle = frame->robot->needle_axis;
    if (leg->is_running == 0U) {
        int32_t ends[ROBOT_AXIS_MAX] = {0};
        ends[needle] = end_ticks;
        leg_begin(leg, frame, LEG_AXIS(needle), ends);
    }
    /* The end of the leg is not waited for: where it is, or beyond, the retraction is done. */
    (void)leg_step(leg, frame, result);
}

uint32_t retract_mode_ask(const mode_asked_t *asked, mode_way_t *way)
{
    way->axis = asked->robot->needle_axis;
    way->end_ticks = end_ticks_of(asked->robot, asked->axes);
    return mode_asked_axes(way->axis);
}

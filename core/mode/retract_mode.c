/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/retract_mode.h"

#include "safety/needle.h"

bool retract_mode_is_done(const mode_frame_t *frame)
{
    const uint32_t needle = frame->robot->needle_axis;
    return frame->axes[needle].encoder.position_ticks <=
           (needle_retracted_ticks(frame->robot) + frame->robot->axes[needle].deadband_ticks);
}

void retract_mode_step(leg_t *leg, const mode_frame_t *frame, mode_result_t *result)
{
    const uint32_t needle = frame->robot->needle_axis;
    if (leg->is_running == 0U) {
        int32_t ends[ROBOT_AXIS_MAX] = {0};
        leg_positions(frame, ends);
        ends[needle] = needle_retracted_ticks(frame->robot);
        leg_begin(leg, frame, LEG_EVERY_AXIS, ends);
    }
    /* The end of the leg is not waited for: where it is, or beyond, the retraction is done. */
    (void)leg_step(leg, frame, result);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/tremble/tremble_mode.h"

#include "safety/needle.h"

#define LEGS 2U
#define WAY_TICKS 200

solution_t tremble_mode_judge(const tremble_mode_t *self, const robot_t *robot,
                              const axis_t axes[ROBOT_AXIS_MAX])
{
    const solution_t result = {.status = needle_is_out(robot, axes) ? STATUS_OK : STATUS_NEEDLE_IN};
    (void)self;
    return result;
}

/* Towards the middle of its travel. */
static int32_t way_ticks(const axis_config_t *axis, int32_t from_ticks)
{
    return (from_ticks > ((axis->minimum_ticks + axis->maximum_ticks) / 2)) ? -WAY_TICKS
                                                                            : WAY_TICKS;
}

void tremble_mode_step(tremble_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                       mode_result_t *result)
{
    if (leg->is_running == 0U) {
        int32_t ends[ROBOT_AXIS_MAX] = {0};
        if (self->legs == 0U) {
            self->start_ticks = frame->axes[0].sealed.encoder.position_ticks;
        }
        self->legs++;
        ends[0] = self->start_ticks;
        if (self->legs < LEGS) {
            ends[0] += way_ticks(&frame->robot->axes[0], self->start_ticks);
        }
        leg_begin(leg, frame, LEG_AXIS(0U), ends);
    }
    if (leg_step(leg, frame, result) && (self->legs == LEGS)) {
        result->progress = MODE_DONE;
    }
}

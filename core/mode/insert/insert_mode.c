/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/insert/insert_mode.h"

status_t insert_mode_judge(const move_mode_t *self, const robot_t *robot,
                           const axis_t axes[ROBOT_AXIS_MAX])
{
    return move_mode_is_aligned(self, robot, axes) ? STATUS_OK : STATUS_NOT_ALIGNED;
}

void insert_mode_step(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                      mode_result_t *result)
{
    const status_t judged =
        (leg->is_running == 0U) ? insert_mode_judge(self, frame->robot, frame->axes) : STATUS_OK;
    if (judged == STATUS_OK) {
        move_mode_step(self, leg, frame, result);
    } else {
        mode_give_up(frame, result, judged);
    }
}

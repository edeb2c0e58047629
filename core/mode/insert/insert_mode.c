/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/insert/insert_mode.h"

solution_t insert_mode_judge(const move_mode_t *self, const robot_t *robot,
                             const axis_t axes[ROBOT_AXIS_MAX])
{
    const bool is_aligned = move_mode_is_aligned(self, robot, axes);
    const solution_t result = {.status = is_aligned ? STATUS_OK : STATUS_NOT_ALIGNED};
    return result;
}

void insert_mode_step(const move_mode_t *self, leg_t *leg, steer_t *steer,
                      const mode_frame_t *frame, mode_result_t *result)
{
    if ((leg->is_running != 0U) || move_mode_is_aligned(self, frame->robot, frame->axes)) {
        move_mode_step(self, leg, steer, frame, result);
    } else {
        mode_give_up(frame, result, STATUS_NOT_ALIGNED);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/align/align_mode.h"

#include "safety/needle.h"

#include <string.h>

move_mode_t align_mode_move(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                            const int32_t target_ticks[ROBOT_AXIS_MAX])
{
    const uint32_t needle = robot->needle_axis;
    move_mode_t move;
    (void)memset(&move, 0, sizeof move);
    (void)memcpy(move.target_ticks, target_ticks, sizeof move.target_ticks);
    move.target_ticks[needle] = needle_is_out(robot, axes)
                                    ? axes[needle].sealed.encoder.position_ticks
                                    : needle_retracted_ticks(robot);
    return move;
}

void align_mode_step(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                     mode_result_t *result)
{
    move_mode_go(self, leg, frame, result);
}

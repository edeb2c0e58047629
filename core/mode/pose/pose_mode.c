/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/pose/pose_mode.h"

#include "robot/coupled_path.h"
#include "robot/robot_damage.h"
#include "safety/needle.h"

#include <string.h>

status_t pose_mode_find(uint32_t pose, const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                        move_mode_t *move)
{
    const uint32_t needle = robot->needle_axis;
    status_t status = STATUS_OK;
    if (!robot_has_pose(robot, pose)) {
        status = STATUS_NO_POSE;
    } else if (robot_is_pose_damaged(robot, pose)) {
        status = STATUS_MEMORY_DAMAGED;
    } else {
        (void)memcpy(move->target_ticks, robot->poses[pose].ticks, sizeof move->target_ticks);
        move->target_ticks[needle] = axes[needle].sealed.encoder.position_ticks;
    }
    return status;
}

solution_t pose_mode_judge(const move_mode_t *self, const robot_t *robot,
                           const axis_t axes[ROBOT_AXIS_MAX])
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    if (!needle_is_out(robot, axes)) {
        return (solution_t){.status = STATUS_NEEDLE_IN, .axis = (uint8_t)robot->needle_axis};
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        ticks[i] = axes[i].sealed.encoder.position_ticks;
    }
    return coupled_path_judge(robot, ticks, self->target_ticks);
}

void pose_mode_step(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                    mode_result_t *result)
{
    if (leg->is_running == 0U) {
        leg_begin(leg, frame, LEG_EVERY_AXIS & ~LEG_AXIS(frame->robot->needle_axis),
                  self->target_ticks);
    }
    if (leg_step(leg, frame, result)) {
        result->progress = MODE_DONE;
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_aim.h"

#include "controller/controller_facts.h"
#include "controller/orders/controller_program.h"
#include "controller/orders/controller_trajectory.h"
#include "mode/align/align_mode.h"
#include "mode/pose/pose_mode.h"

#include <string.h>

solution_t controller_judge_way(controller_t *self, const cycle_t *cycle)
{
    solution_t result = {.status = STATUS_MEMORY_DAMAGED};
    if ((self->plan.has_probe == 0U) || plan_is_proved(&self->plan, cycle->robot)) {
        int32_t ticks[ROBOT_AXIS_MAX];
        controller_positions(self, ticks);
        result = plan_judge_way(&self->plan, cycle->robot, ticks);
    } else {
        plan_forget_target(&self->plan);
    }
    return result;
}

static solution_t judge_target(controller_t *self, const cycle_t *cycle)
{
    solution_t result = {.status = plan_judge_entry(&self->plan)};
    if (result.status == STATUS_OK) {
        result = controller_judge_way(self, cycle);
    }
    return result;
}

solution_t controller_aim(controller_t *self, const cycle_t *cycle, const command_t *command,
                          mode_kind_t kind, mode_request_t *request)
{
    const int32_t *const target_ticks = self->plan.target_ticks;
    solution_t result = {.status = STATUS_OK};
    const mode_aim_t aim = mode_aim_of((uint32_t)kind);
    if (aim == MODE_AIM_LINE) {
        result = judge_target(self, cycle);
        request->sealed.move = align_mode_move(cycle->robot, self->axes, target_ticks);
    } else if (aim != MODE_AIM_NONE) {
        result = judge_target(self, cycle);
        (void)memcpy(request->sealed.move.target_ticks, target_ticks,
                     sizeof request->sealed.move.target_ticks);
        if (aim == MODE_AIM_DEPTH) {
            request->sealed.move.steering = self->plan.steering;
        }
        if ((aim == MODE_AIM_STEPS) && (result.status == STATUS_OK)) {
            result = controller_judge_program(self, cycle, command_as_list(command)->checksum,
                                              &request->sealed.move);
        }
    } else if (kind == MODE_POSE) {
        result.status = pose_mode_find(command_as_pose_name(command)->pose, cycle->robot,
                                       self->axes, &request->sealed.move);
    } else if (kind == MODE_TRAJECTORY) {
        result = controller_judge_trajectory(self, cycle, command_as_list(command)->checksum);
    } else {
        /* Its command says where to. */
    }
    return result;
}

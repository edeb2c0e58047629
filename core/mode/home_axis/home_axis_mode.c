/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/home_axis/home_axis_mode.h"

#include "axis/follower.h"
#include "mode/homing/homing_mode.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"

/* As in START_UP: how it may be homed at all, then what its way may meet. */
static status_t judge_alone(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    const axis_config_t *const config = &robot->axes[index];
    const bool has_switch = config->home_method == (uint8_t)HOME_BY_SWITCH;
    status_t status = STATUS_OK;
    if (follower_is_in_block(robot, index)) {
        status = STATUS_HOMES_WITH_OTHERS;
    } else if (!has_switch && !axis_is_fresh(&axes[index])) {
        status = STATUS_HOMES_OTHERWISE;
    } else if (has_switch && needle_forbids_jog(robot, axes, index, false)) {
        status = STATUS_NEEDLE_IN;
    } else {
        status = STATUS_OK;
    }
    return status;
}

solution_t home_axis_mode_judge(uint32_t index, const robot_t *robot,
                                const axis_t axes[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_UNKNOWN_COMMAND, .axis = 0U, .is_maximum = 0U};
    if (index >= robot->axis_count) {
        return result;
    }
    const bool has_switch = robot->axes[index].home_method == (uint8_t)HOME_BY_SWITCH;
    result.status = judge_alone(robot, axes, index);
    if ((result.status == STATUS_OK) && has_switch) {
        result = coupled_guard_judge_homing(robot, axes, index);
    }
    return result;
}

bool home_axis_mode_is_done(uint32_t index, const mode_frame_t *frame)
{
    return (index < frame->axis_count) && axis_is_homed(&frame->axes[index]);
}

void home_axis_mode_step(uint32_t index, const mode_frame_t *frame, mode_result_t *result)
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        if (i == index) {
            homing_mode_begin_axis(frame, i, result);
        }
        result->requests[i] = ((i == index) && axis_is_homing(axis))
                                  ? axis_home(axis, &frame->robot->axes[i], frame->elapsed_us)
                                  : axis_rest(axis, frame->elapsed_us);
    }
}

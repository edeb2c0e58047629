/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/homing_mode.h"

#include "safety/coupled_guard.h"
#include "safety/needle.h"

#include <stdbool.h>

static void leave(leg_t *leg, const mode_frame_t *frame, mode_result_t *result)
{
    const uint32_t needle = frame->robot->needle_axis;
    if (leg->is_running == 0U) {
        int32_t ends[ROBOT_AXIS_MAX] = {0};
        ends[needle] = needle_retracted_ticks(frame->robot);
        leg_begin(leg, frame, LEG_AXIS(needle), ends);
    }
    (void)leg_step(leg, frame, result);
}

/* Stage 1 homes before stage 2: the needle leaves first. */
static uint8_t present_stage(const mode_frame_t *frame)
{
    uint8_t stage = 2U;
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        const uint8_t own = frame->robot->axes[i].home_stage;
        if (!axis_is_homed(&frame->axes[i]) && (own < stage)) {
            stage = own;
        }
    }
    return stage;
}

static void begin(const mode_frame_t *frame, uint32_t index, mode_result_t *result)
{
    axis_t *const axis = &frame->axes[index];
    if (coupled_guard_bars_homing(frame->robot, frame->axes, index)) {
        mode_fail(result, EVENT_HOMING_BARRED, index, 0);
    } else if (axis_begin_homing(axis, &frame->robot->axes[index]) != 0U) {
        mode_note(result, EVENT_AXIS_TAKEN, index, axis->home_correction_ticks);
    } else {
        /* It is on its way. */
    }
}

static void home(const mode_frame_t *frame, mode_result_t *result)
{
    const uint8_t stage = present_stage(frame);
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        const axis_config_t *const config = &frame->robot->axes[i];
        const bool is_due = (config->home_stage == stage) && !axis_is_homed(axis);
        if (is_due && (result->progress == MODE_RUNNING)) {
            begin(frame, i, result);
        }
        result->requests[i] = axis_is_homing(axis) ? axis_home(axis, config, frame->elapsed_us)
                                                   : axis_rest(axis, frame->elapsed_us);
    }
}

void homing_mode_step(leg_t *leg, const mode_frame_t *frame, mode_result_t *result)
{
    if (needle_must_leave(frame->robot, frame->axes)) {
        leave(leg, frame, result);
    } else {
        leg_stop(leg);
        home(frame, result);
    }
}

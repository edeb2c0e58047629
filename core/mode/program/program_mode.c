/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/program/program_mode.h"

#include "base/fixed.h"
#include "robot/coupled_path.h"

#include <stddef.h>
#include <string.h>

#define US_PER_MS 1000U
#define SLACK_TICKS 2 /* As that of an aligned base. */

/* A step, and the positions of the axes at it. */
typedef struct {
    const program_step_t *step;
    const move_mode_t *target;
    int32_t ends[ROBOT_AXIS_MAX];
} place_t;

/* The axes that it drives. */
static uint32_t driven_axes(const robot_t *robot)
{
    const uint32_t turning = program_step_turning_axis(robot);
    return LEG_AXIS(robot->needle_axis) | ((turning < robot->axis_count) ? LEG_AXIS(turning) : 0U);
}

/* Wherever the needle has been turned to. */
static bool is_base_aligned(const move_mode_t *target, const robot_t *robot,
                            const axis_t axes[ROBOT_AXIS_MAX])
{
    const uint32_t turning = program_step_turning_axis(robot);
    move_mode_t base;
    (void)memcpy(&base, target, sizeof base);
    if (turning < robot->axis_count) {
        base.target_ticks[turning] = axes[turning].sealed.encoder.position_ticks;
    }
    return move_mode_is_aligned(&base, robot, axes);
}

solution_t program_mode_judge(const program_list_t *list, uint32_t crc, const move_mode_t *target,
                              const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                              bool is_stopped)
{
    solution_t result = {.status = STATUS_OK};
    if (!program_list_is_meant(list, crc, target->target_ticks)) {
        result.status = STATUS_PROGRAM_OTHER;
    } else if (!is_base_aligned(target, robot, axes)) {
        result.status = STATUS_NOT_ALIGNED;
    } else if (is_stopped) {
        result.status = STATUS_PROGRAM_STOPPED;
    } else {
        int32_t from[ROBOT_AXIS_MAX] = {0};
        int32_t to[ROBOT_AXIS_MAX];
        for (uint32_t i = 0U; i < robot->axis_count; i++) {
            from[i] = axes[i].sealed.encoder.position_ticks;
        }
        program_list_ends(robot, target->target_ticks, &list->steps[0], to);
        result = coupled_path_judge(robot, from, to);
    }
    return result;
}

void program_mode_begin(program_mode_t *self)
{
    (void)memset(self, 0, sizeof *self);
    self->stage = (uint32_t)PROGRAM_STAGE_GOES;
}

void program_mode_stop(const program_mode_t *self, const mode_frame_t *frame, mode_result_t *result)
{
    const uint32_t dwelt_ms = self->dwelt_us / US_PER_MS;
    mode_note(result, EVENT_PROGRAM_STOPPED, self->step + 1U, (int32_t)dwelt_ms);
    mode_give_up(frame, result, STATUS_PROGRAM_STOPPED);
}

static bool stands_at(const mode_frame_t *frame, const place_t *place)
{
    const uint32_t driven = driven_axes(frame->robot);
    bool is_there = true;
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        const int64_t slack = (int64_t)frame->robot->axes[i].deadband_ticks + SLACK_TICKS;
        const int64_t way =
            (int64_t)place->ends[i] - (int64_t)frame->axes[i].sealed.encoder.position_ticks;
        const bool is_driven = (driven & LEG_AXIS(i)) != 0U;
        is_there = is_there && (!is_driven || (fixed_magnitude(way) <= slack));
    }
    return is_there;
}

static void go(program_mode_t *self, const place_t *place, leg_t *leg, const mode_frame_t *frame,
               mode_result_t *result)
{
    self->stage = (uint32_t)PROGRAM_STAGE_GOES;
    if (leg->is_running == 0U) {
        if (!is_base_aligned(place->target, frame->robot, frame->axes)) {
            mode_give_up(frame, result, STATUS_NOT_ALIGNED);
            return;
        }
        leg_begin(leg, frame, driven_axes(frame->robot), place->ends);
    }
    if (leg_step(leg, frame, result)) {
        self->stage = (uint32_t)PROGRAM_STAGE_DWELLS;
        self->dwell_ms = place->step->dwell_ms;
    }
}

static void end_step(program_mode_t *self, const mode_frame_t *frame, bool is_by_dose,
                     mode_result_t *result)
{
    self->step++;
    self->dwelt_us = 0U;
    self->is_dose_due = 0U;
    self->stage = (uint32_t)PROGRAM_STAGE_GOES;
    mode_note(result, EVENT_PROGRAM_STEP, self->step, is_by_dose ? 1 : 0);
    if (self->step == frame->program->count) {
        result->progress = MODE_DONE;
    }
}

/* A dose that was reached before is that of another step. */
static void dwell(program_mode_t *self, const place_t *place, const mode_frame_t *frame,
                  mode_result_t *result)
{
    const bool is_by_dose =
        (place->step->is_gated != 0U) && (self->is_dose_due != 0U) && frame->is_dose_reached;
    mode_rest(frame, result);
    self->dwelt_us += frame->elapsed_us;
    if (!frame->is_dose_reached) {
        self->is_dose_due = 1U;
    }
    if (is_by_dose || (self->dwelt_us >= (place->step->dwell_ms * US_PER_MS))) {
        end_step(self, frame, is_by_dose, result);
    }
}

void program_mode_step(program_mode_t *self, const move_mode_t *target, leg_t *leg,
                       const mode_frame_t *frame, mode_result_t *result)
{
    place_t place = {.step = program_list_step(frame->program, self->step), .target = target};
    if (place.step == NULL) {
        mode_rest(frame, result);
        mode_fail(result, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_PROGRAM,
                  (int32_t)self->step);
        result->axis = MODE_NO_AXIS;
        result->status = STATUS_MEMORY_DAMAGED;
        return;
    }
    program_list_ends(frame->robot, target->target_ticks, place.step, place.ends);
    if ((self->stage == (uint32_t)PROGRAM_STAGE_DWELLS) && stands_at(frame, &place)) {
        dwell(self, &place, frame, result);
    } else {
        go(self, &place, leg, frame, result);
    }
}

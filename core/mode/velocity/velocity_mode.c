/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/velocity/velocity_mode.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "mode/velocity/velocity_bound.h"
#include "motion/ramp.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"

#include <string.h>

#define STAGE_NEW 0U
#define STAGE_RUNS 1U
#define STAGE_ENDED 2U /* And its end was reported. */

/* The speeds of a cycle. */
typedef struct {
    int64_t speeds_q8[ROBOT_AXIS_MAX]; /* Magnitudes. */
    int64_t steps_q8[ROBOT_AXIS_MAX];  /* Most that a cycle may change them by. */
    int32_t from_ticks[ROBOT_AXIS_MAX];
    int32_t to_ticks[ROBOT_AXIS_MAX]; /* Positions at which they would come to rest. */
} velocity_plan_t;

static bool has_axis(const velocity_mode_t *self, uint32_t index)
{
    return (self->axes & LEG_AXIS(index)) != 0U;
}

static bool is_upwards(const velocity_mode_t *self, uint32_t index)
{
    return self->speeds_ticks_per_s[index] > 0;
}

static bool goes_in(const velocity_mode_t *self, const robot_t *robot)
{
    return has_axis(self, robot->needle_axis) && is_upwards(self, robot->needle_axis);
}

static status_t judge_axis(const velocity_mode_t *asked, const robot_t *robot,
                           const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    const axis_config_t *const config = &robot->axes[index];
    const bool is_across = config->needle_motion == (uint32_t)NEEDLE_ACROSS;
    const int64_t speed = fixed_magnitude((int64_t)asked->speeds_ticks_per_s[index]);
    status_t status = STATUS_OK;
    if (speed == 0) {
        status = STATUS_OUT_OF_RANGE;
    } else if (speed > (int64_t)config->speed_ticks_per_s) {
        status = STATUS_TOO_FAST;
    } else if (needle_forbids_jog(robot, axes, index, is_upwards(asked, index)) ||
               (is_across && goes_in(asked, robot))) {
        status = STATUS_NEEDLE_IN;
    } else {
        status = STATUS_OK;
    }
    return status;
}

static bool is_bound_known(const velocity_mode_t *asked)
{
    const bool is_one = (asked->axes & (asked->axes - 1U)) == 0U;
    const bool is_time = (asked->time_ms != 0U) && (asked->time_ms <= LIMIT_VELOCITY_TIME_MS);
    const bool is_way = (asked->way_ticks != 0U) && is_one;
    return ((asked->way_ticks == 0U) && is_time) || ((asked->time_ms == 0U) && is_way);
}

solution_t velocity_mode_judge(const velocity_mode_t *asked, const robot_t *robot,
                               const axis_t axes[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_OK};
    if ((asked->axes == 0U) || (asked->axes >= LEG_AXIS(robot->axis_count))) {
        result.status = STATUS_UNKNOWN_COMMAND;
    } else if (!is_bound_known(asked)) {
        result.status = STATUS_OUT_OF_RANGE;
    } else {
        for (uint32_t i = 0U; (i < robot->axis_count) && (result.status == STATUS_OK); i++) {
            if (has_axis(asked, i)) {
                result.status = judge_axis(asked, robot, axes, i);
                result.axis = (uint8_t)i;
            }
        }
    }
    result.axis = (result.status == STATUS_OK) ? 0U : result.axis;
    return result;
}

bool velocity_mode_runs(const velocity_mode_t *self)
{
    return self->stage == STAGE_RUNS;
}

static void begin(velocity_mode_t *self, const mode_frame_t *frame)
{
    const uint32_t time_ms = (self->time_ms > 0U) ? self->time_ms : LIMIT_VELOCITY_TIME_MS;
    self->stage = STAGE_RUNS;
    self->left_cycles = (time_ms * 1000U) / LIMIT_CYCLE_US;
    leg_positions(frame, self->start_ticks);
}

/* The first limit is reported. */
static void refuse(velocity_mode_t *self, status_t status, uint32_t index)
{
    if (self->refusal == (uint32_t)STATUS_OK) {
        self->refusal = (uint32_t)status;
        self->refused_axis = index;
    }
}

static int64_t now_q8(const mode_frame_t *frame, uint32_t index)
{
    return fixed_magnitude((int64_t)frame->axes[index].sealed.setpoint_speed_ticks_per_s_q8);
}

/* The fastest of all that the axis may have. */
static int64_t most_q8(const velocity_mode_t *self, const mode_frame_t *frame, uint32_t index,
                       int64_t step_q8)
{
    const axis_config_t *const config = &frame->robot->axes[index];
    const int64_t left = (int64_t)self->left_cycles - 1;
    int64_t most = fixed_divide_by(
        (int64_t)config->speed_ticks_per_s * 256 * (int64_t)frame->speed_cap_percent[index], 100U);
    if (!axis_is_homed(&frame->axes[index])) {
        most = fixed_within(most, 0, (int64_t)config->home_speed_ticks_per_s * 256);
    }
    most = fixed_within(most, 0, fixed_magnitude((int64_t)self->speeds_ticks_per_s[index]) * 256);
    most = fixed_within(most, 0, fixed_within(step_q8 * left, 0, most));
    return ((self->barred & LEG_AXIS(index)) == 0U) ? most : 0;
}

/* From the set-point to the bound, in the direction of the speed. */
static int64_t room_of(const velocity_mode_t *self, const mode_frame_t *frame, uint32_t index)
{
    const velocity_bound_t bound = velocity_bound_of(self, frame, index);
    const int64_t ticks = (int64_t)bound.ticks - (int64_t)frame->axes[index].sealed.setpoint_ticks;
    const int64_t room = (ticks * RAMP_TICK) - (int64_t)self->rest[index];
    return is_upwards(self, index) ? room : -room;
}

static int64_t next_q8(const velocity_mode_t *self, const mode_frame_t *frame, uint32_t index,
                       int64_t step_q8)
{
    const ramp_steps_t steps = {.up_q8 = step_q8, .down_q8 = step_q8};
    return ramp_next(now_q8(frame, index), most_q8(self, frame, index, step_q8), &steps,
                     room_of(self, frame, index));
}

/* Set-point after `way` more, and the rest of a tick that remains. */
static int32_t place_after(const velocity_mode_t *self, const axis_t *axis, uint32_t index,
                           int64_t way, int32_t *rest)
{
    *rest = self->rest[index];
    return ramp_place(axis->sealed.setpoint_ticks, is_upwards(self, index) ? way : -way, rest);
}

static void set_speed(const velocity_mode_t *self, const mode_frame_t *frame, uint32_t index,
                      int64_t speed_q8, velocity_plan_t *plan)
{
    int32_t rest = 0;
    plan->speeds_q8[index] = speed_q8;
    plan->to_ticks[index] = place_after(self, &frame->axes[index], index,
                                        ramp_way(speed_q8, plan->steps_q8[index]), &rest);
}

/* Each axis for itself. */
static void plan_axes(const velocity_mode_t *self, const mode_frame_t *frame, velocity_plan_t *plan)
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        const axis_t *const axis = &frame->axes[i];
        plan->speeds_q8[i] = 0;
        plan->steps_q8[i] = 0;
        plan->from_ticks[i] = axis->sealed.encoder.position_ticks;
        plan->to_ticks[i] = plan->from_ticks[i];
        if (has_axis(self, i)) {
            const int64_t step = fixed_divide_by(
                (int64_t)frame->robot->axes[i].acceleration_ticks_per_s2 * 256, RAMP_CYCLES_PER_S);
            plan->from_ticks[i] = axis->sealed.setpoint_ticks;
            plan->steps_q8[i] = step;
            set_speed(self, frame, i, next_q8(self, frame, i, step), plan);
        }
    }
}

/* A limit that is shared ends the speeds of all of its axes. */
static void bar(velocity_mode_t *self, const mode_frame_t *frame, const coupled_limit_t *limit,
                velocity_plan_t *plan)
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        if (coupled_limit_has(limit, i) && has_axis(self, i)) {
            const int64_t now = now_q8(frame, i);
            set_speed(self, frame, i, ramp_slower(now, plan->steps_q8[i]), plan);
            self->barred |= LEG_AXIS(i);
            refuse(self, (status_t)limit->refusal, i);
        }
    }
}

static void keep_limits(velocity_mode_t *self, const mode_frame_t *frame, velocity_plan_t *plan)
{
    for (uint32_t i = 0U; i < frame->robot->coupled_limit_count; i++) {
        if (coupled_guard_is_left(frame->robot, frame->axes, i, plan->from_ticks, plan->to_ticks)) {
            bar(self, frame, &frame->robot->coupled_limits[i], plan);
        }
    }
}

static bool moves(const mode_frame_t *frame, const velocity_plan_t *plan)
{
    bool is_any = false;
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        is_any = is_any || (plan->speeds_q8[i] != 0);
    }
    return is_any;
}

static card_drive_t follow(velocity_mode_t *self, const mode_frame_t *frame, uint32_t index,
                           int64_t speed_q8)
{
    axis_t *const axis = &frame->axes[index];
    const int32_t ticks = place_after(self, axis, index, speed_q8, &self->rest[index]);
    return axis_follow(axis, &frame->robot->axes[index], ticks,
                       (int32_t)(is_upwards(self, index) ? speed_q8 : -speed_q8),
                       frame->elapsed_us);
}

static void run(velocity_mode_t *self, const mode_frame_t *frame, const velocity_plan_t *plan,
                mode_result_t *result)
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        result->requests[i] = has_axis(self, i) ? follow(self, frame, i, plan->speeds_q8[i])
                                                : axis_rest(axis, frame->elapsed_us);
    }
    self->left_cycles--;
}

static velocity_end_t end_of(const velocity_mode_t *self, const mode_frame_t *frame, uint32_t index)
{
    const velocity_bound_t bound = velocity_bound_of(self, frame, index);
    const int64_t left = (int64_t)bound.ticks - (int64_t)frame->axes[index].sealed.setpoint_ticks;
    const bool is_there = is_upwards(self, index) ? (left <= 0) : (left >= 0);
    velocity_end_t end = VELOCITY_END_TIME;
    if ((self->barred & LEG_AXIS(index)) != 0U) {
        end = VELOCITY_END_COUPLED_LIMIT;
    } else if (is_there) {
        end = bound.end;
    } else {
        end = VELOCITY_END_TIME;
    }
    return end;
}

/* Every set-point has come to rest: its end is reported once. */
static void conclude(velocity_mode_t *self, const mode_frame_t *frame, mode_result_t *result)
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        if (has_axis(self, i)) {
            const velocity_end_t end = end_of(self, frame, i);
            mode_note(result, EVENT_VELOCITY_ENDED, i, (int32_t)end);
            refuse(self, velocity_bound_refusal(end), i);
        }
    }
    self->stage = STAGE_ENDED;
}

/* To where the set-points are; what has met its switch stays. */
static void begin_rest(const velocity_mode_t *self, leg_t *leg, const mode_frame_t *frame)
{
    int32_t ends[ROBOT_AXIS_MAX] = {0};
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        const axis_t *const axis = &frame->axes[i];
        ends[i] = velocity_bound_is_switch(self, frame, i) ? axis->sealed.encoder.position_ticks
                                                           : axis->sealed.setpoint_ticks;
    }
    leg_begin(leg, frame, self->axes, ends);
}

static void come_to_rest(const velocity_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                         mode_result_t *result)
{
    if (leg->is_running == 0U) {
        begin_rest(self, leg, frame);
    }
    if (leg_step(leg, frame, result)) {
        result->progress = (self->refusal == (uint32_t)STATUS_OK) ? MODE_DONE : MODE_FAILED;
        result->status = (status_t)self->refusal;
        result->axis = self->refused_axis;
    }
}

void velocity_mode_step(velocity_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                        mode_result_t *result)
{
    velocity_plan_t plan;
    if (self->stage == STAGE_NEW) {
        begin(self, frame);
    }
    if (self->stage == STAGE_RUNS) {
        plan_axes(self, frame, &plan);
        keep_limits(self, frame, &plan);
        if (moves(frame, &plan)) {
            run(self, frame, &plan, result);
            return;
        }
        conclude(self, frame, result);
    }
    come_to_rest(self, leg, frame, result);
}

uint32_t velocity_mode_ask(const mode_asked_t *asked, velocity_mode_t *self)
{
    const command_velocity_t *const sent = command_as_velocity(asked->command);
    self->axes = sent->axes;
    self->time_ms = sent->time_ms;
    self->way_ticks = sent->way_ticks;
    (void)memcpy(self->speeds_ticks_per_s, sent->speeds_ticks_per_s,
                 sizeof self->speeds_ticks_per_s);
    return sent->axes;
}

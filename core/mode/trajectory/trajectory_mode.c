/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/trajectory/trajectory_mode.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "motion/cubic.h"
#include "robot/coupled_path.h"
#include "safety/needle.h"

#define RAMP_CYCLES (LIMIT_TRAJECTORY_RAMP_US / LIMIT_CYCLE_US)
#define US_PER_MS 1000U

/* The two rows that the axes are between; at the end both are the last one. */
typedef struct {
    const trajectory_row_t *from;
    const trajectory_row_t *to;
} pair_t;

static pair_t pair_at(const trajectory_t *trajectory, uint32_t row)
{
    const uint32_t last = trajectory->list->count - 1U;
    const uint32_t next = row + 1U;
    const pair_t pair = {.from = &trajectory->rows[(row < last) ? row : last],
                         .to = &trajectory->rows[(next < last) ? next : last]};
    return pair;
}

/* Sideways only while the needle is out, where the axes stand and in the first row. */
static bool cuts(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                 const int32_t ticks[ROBOT_AXIS_MAX], uint32_t axis)
{
    const axis_config_t *const config = &robot->axes[axis];
    const bool is_out =
        needle_is_out(robot, axes) && (ticks[robot->needle_axis] <= needle_out_ticks(robot));
    return (config->needle_motion == (uint32_t)NEEDLE_ACROSS) && !is_out &&
           !axis_is_at(&axes[axis], config, ticks[axis]);
}

static status_t judge_axis(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                           const int32_t ticks[ROBOT_AXIS_MAX], uint32_t axis)
{
    const axis_config_t *const config = &robot->axes[axis];
    const int64_t way = (int64_t)ticks[axis] - (int64_t)axes[axis].sealed.encoder.position_ticks;
    status_t status = STATUS_OK;
    if (!axis_is_homed(&axes[axis])) {
        status = STATUS_NOT_HOMED;
    } else if (joints_is_beyond(config, fixed_magnitude(way), LIMIT_TRAJECTORY_LEAD_NM,
                                LIMIT_TRAJECTORY_LEAD_BAM)) {
        status = STATUS_TRAJECTORY_FAR;
    } else if (cuts(robot, axes, ticks, axis)) {
        status = STATUS_NEEDLE_IN;
    } else if (trajectory_list_is_in_zone(config, ticks[axis]) &&
               !axis_is_at(&axes[axis], config, ticks[axis])) {
        status = STATUS_SWITCH_ZONE;
    } else {
        status = STATUS_OK;
    }
    return status;
}

solution_t trajectory_mode_judge_start(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                                       const int32_t ticks[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_OK};
    int32_t from[ROBOT_AXIS_MAX] = {0};
    for (uint32_t i = 0U; (i < robot->axis_count) && (result.status == STATUS_OK); i++) {
        from[i] = axes[i].sealed.encoder.position_ticks;
        result.axis = (uint8_t)i;
        result.status = judge_axis(robot, axes, ticks, i);
    }
    return (result.status == STATUS_OK) ? coupled_path_judge(robot, from, ticks) : result;
}

solution_t trajectory_mode_judge(const trajectory_t *asked, uint32_t crc, const robot_t *robot,
                                 const axis_t axes[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_OK};
    if (asked->list->is_whole == 0U) {
        result.status = STATUS_TRAJECTORY_EMPTY;
    } else if (asked->list->crc != crc) {
        result.status = STATUS_TRAJECTORY_SUM;
    } else if (!trajectory_row_is_whole(&asked->rows[0])) {
        result.status = STATUS_MEMORY_DAMAGED;
    } else {
        result = trajectory_mode_judge_start(robot, axes, asked->rows[0].ticks);
    }
    return result;
}

void trajectory_mode_begin(trajectory_mode_t *self, uint32_t start_ms)
{
    self->row = 0U;
    self->time_us = start_ms * US_PER_MS;
    self->is_on_way = 0U;
    self->pace = RAMP_CYCLES; /* The first row is at rest. */
    self->behind_us = 0U;
}

uint32_t trajectory_mode_left_ms(const trajectory_mode_t *self, uint32_t end_ms)
{
    const uint32_t time_ms = self->time_us / US_PER_MS;
    uint32_t left_ms = 0U;
    if (time_ms < end_ms) {
        left_ms = end_ms - time_ms;
    }
    return left_ms;
}

void trajectory_mode_pause(trajectory_mode_t *self)
{
    if (self->is_on_way != 0U) {
        self->is_on_way = 0U;
        self->pace = 0U;
    }
}

static uint32_t share_of(const trajectory_mode_t *self, const pair_t *pair)
{
    const uint32_t begin_us = pair->from->time_ms * US_PER_MS;
    const uint32_t span_ms = pair->to->time_ms - pair->from->time_ms;
    return (span_ms == 0U) ? 0U : cubic_share_q20(self->time_us - begin_us, span_ms);
}

/* A leg to where time stands. */
static void step_leg(trajectory_mode_t *self, const pair_t *pair, leg_t *leg,
                     const mode_frame_t *frame, mode_result_t *result)
{
    if (leg->is_running == 0U) {
        const uint32_t share_q20 = share_of(self, pair);
        int32_t ends[ROBOT_AXIS_MAX] = {0};
        for (uint32_t i = 0U; i < frame->axis_count; i++) {
            cubic_t way;
            trajectory_list_way(pair->from, pair->to, i, &way);
            ends[i] = cubic_position_ticks(&way, share_q20);
        }
        leg_begin(leg, frame, LEG_EVERY_AXIS, ends);
    }
    if (leg_step(leg, frame, result)) {
        self->is_on_way = 1U;
        result->progress = (pair->from == pair->to) ? MODE_DONE : MODE_RUNNING;
    }
}

/* Time goes on by one nominal cycle, as profiles do; slower for a while after a pause. */
static uint32_t pass_time(trajectory_mode_t *self, const mode_frame_t *frame)
{
    const uint32_t behind_us = self->behind_us + frame->elapsed_us;
    self->behind_us = (behind_us > LIMIT_CYCLE_US) ? (behind_us - LIMIT_CYCLE_US) : 0U;
    if (self->pace < RAMP_CYCLES) {
        self->pace++;
    }
    return (LIMIT_CYCLE_US * self->pace) / RAMP_CYCLES;
}

static void drive(const trajectory_mode_t *self, const pair_t *pair, const mode_frame_t *frame,
                  mode_result_t *result)
{
    const uint32_t share_q20 = share_of(self, pair);
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        cubic_t way;
        trajectory_list_way(pair->from, pair->to, i, &way);
        const int64_t paced_us = (int64_t)self->pace * (int64_t)LIMIT_CYCLE_US;
        const int64_t full_q8 = (int64_t)cubic_speed_ticks_per_s_q8(&way, share_q20);
        const int64_t speed_q8 = (full_q8 * paced_us) / (int64_t)LIMIT_TRAJECTORY_RAMP_US;
        axis_t *const axis = &frame->axes[i];
        result->requests[i] =
            axis_follow(axis, &frame->robot->axes[i], cubic_position_ticks(&way, share_q20),
                        (int32_t)speed_q8, frame->elapsed_us);
    }
}

static void step_way(trajectory_mode_t *self, const trajectory_t *trajectory, leg_t *leg,
                     const mode_frame_t *frame, mode_result_t *result)
{
    pair_t pair = pair_at(trajectory, self->row);
    self->time_us += pass_time(self, frame);
    if (self->time_us >= (pair.to->time_ms * US_PER_MS)) {
        self->row++;
        pair = pair_at(trajectory, self->row);
    }
    if (pair.from == pair.to) {
        self->is_on_way = 0U;
        step_leg(self, &pair, leg, frame, result);
    } else if (self->behind_us >= LIMIT_TRAJECTORY_LATE_US) {
        mode_rest(frame, result);
        mode_fail(result, EVENT_TRAJECTORY_LATE, self->row, (int32_t)self->behind_us);
        result->axis = MODE_NO_AXIS;
    } else {
        drive(self, &pair, frame, result);
    }
}

static bool is_pair_whole(const pair_t *pair)
{
    return trajectory_row_is_whole(pair->from) &&
           ((pair->to == pair->from) || trajectory_row_is_whole(pair->to));
}

void trajectory_mode_step(trajectory_mode_t *self, const trajectory_list_t *list, leg_t *leg,
                          const mode_frame_t *frame, mode_result_t *result)
{
    const trajectory_t trajectory = {.list = list, .rows = frame->rows};
    if (list->is_whole == 0U) {
        mode_rest(frame, result);
        mode_fail(result, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_TRAJECTORY, 0);
        result->axis = MODE_NO_AXIS;
        return;
    }
    const pair_t pair = pair_at(&trajectory, self->row);
    if (!is_pair_whole(&pair)) {
        mode_rest(frame, result);
        mode_fail(result, EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_TRAJECTORY,
                  (int32_t)self->row);
        result->axis = MODE_NO_AXIS;
        result->status = STATUS_MEMORY_DAMAGED;
    } else if (self->is_on_way != 0U) {
        step_way(self, &trajectory, leg, frame, result);
    } else {
        step_leg(self, &pair, leg, frame, result);
    }
}

uint32_t trajectory_mode_ask(const mode_asked_t *asked, trajectory_span_t *span)
{
    span->start_ms = asked->rows[0].time_ms;
    span->end_ms = trajectory_list_end_ms(asked->list, asked->rows);
    return 0U;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/leg/leg.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

/* At the end for this long before it has arrived: the motors' fall time is about 1.5 ms. */
#define SETTLED_CYCLES 50U

void leg_positions(const mode_frame_t *frame, int32_t ticks[ROBOT_AXIS_MAX])
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        ticks[i] = frame->axes[i].sealed.encoder.position_ticks;
    }
}

static bool has_axis(const leg_t *self, uint32_t index)
{
    return (self->axes & LEG_AXIS(index)) != 0U;
}

/* All axes of a leg share its cycles, so the slowest cap is everybody's. */
static uint32_t cap_percent(const leg_t *self, const mode_frame_t *frame)
{
    uint32_t percent = 100U;
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        if (has_axis(self, i) && (frame->speed_cap_percent[i] < percent)) {
            percent = frame->speed_cap_percent[i];
        }
    }
    return percent;
}

void leg_begin(leg_t *self, const mode_frame_t *frame, uint32_t axes,
               const int32_t ends[ROBOT_AXIS_MAX])
{
    int32_t from[ROBOT_AXIS_MAX] = {0};
    int32_t to[ROBOT_AXIS_MAX] = {0};
    self->axes = axes;
    self->lent = 0U;
    leg_positions(frame, from);
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        to[i] = has_axis(self, i) ? ends[i] : from[i];
    }
    profile_plan(&self->profile, frame->robot, from, to, cap_percent(self, frame));
    self->is_running = 1U;
    self->settled_cycles = 0U;
    self->overtime_cycles = 0U;
}

/* An axis that the profile leaves where it is costs no division. */
static card_drive_t follow(const leg_t *self, const mode_frame_t *frame, uint32_t index)
{
    const profile_t *const profile = &self->profile;
    axis_t *const axis = &frame->axes[index];
    int32_t position_ticks = profile->end_ticks[index];
    int32_t speed_q8 = 0;
    if (profile->start_ticks[index] != position_ticks) {
        position_ticks = profile_position_ticks(profile, index);
        speed_q8 = profile_speed_ticks_per_s_q8(profile, index);
    }
    return axis_follow(axis, &frame->robot->axes[index], position_ticks, speed_q8,
                       frame->elapsed_us);
}

static bool is_astray(const leg_t *self, const mode_frame_t *frame, uint32_t index)
{
    return has_axis(self, index) && !axis_is_at(&frame->axes[index], &frame->robot->axes[index],
                                                self->profile.end_ticks[index]);
}

/* An axis that is astray, if any is. */
static uint32_t find_astray(const leg_t *self, const mode_frame_t *frame)
{
    uint32_t index = 0U;
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        if (is_astray(self, frame, i)) {
            index = i;
        }
    }
    return index;
}

static bool is_at_end(const leg_t *self, const mode_frame_t *frame)
{
    bool is_there = profile_is_finished(&self->profile);
    for (uint32_t i = 0U; is_there && (i < frame->axis_count); i++) {
        is_there = !is_astray(self, frame, i);
    }
    return is_there;
}

/* A leg that does not end is given up. */
static void watch_time(leg_t *self, const mode_frame_t *frame, mode_result_t *result)
{
    self->overtime_cycles = profile_is_finished(&self->profile) ? (self->overtime_cycles + 1U) : 0U;
    if ((self->overtime_cycles * LIMIT_CYCLE_US) >= LIMIT_OVERTIME_US) {
        const uint32_t index = find_astray(self, frame);
        mode_fail(result, EVENT_ORDER_OVERDUE, index,
                  fixed_saturate((int64_t)self->profile.end_ticks[index] -
                                 (int64_t)frame->axes[index].sealed.encoder.position_ticks));
    }
}

bool leg_step(leg_t *self, const mode_frame_t *frame, mode_result_t *result)
{
    profile_step(&self->profile);
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        if ((self->lent & LEG_AXIS(i)) == 0U) {
            result->requests[i] =
                has_axis(self, i) ? follow(self, frame, i) : axis_rest(axis, frame->elapsed_us);
        }
    }
    self->settled_cycles = is_at_end(self, frame) ? (self->settled_cycles + 1U) : 0U;
    const bool has_arrived = self->settled_cycles >= SETTLED_CYCLES;
    if (has_arrived) {
        leg_stop(self);
        mode_rest(frame, result);
    } else {
        watch_time(self, frame, result);
    }
    return has_arrived;
}

void leg_stop(leg_t *self)
{
    self->is_running = 0U;
    self->settled_cycles = 0U;
}

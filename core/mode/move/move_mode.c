/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/move/move_mode.h"

#include "base/fixed.h"
#include "safety/needle.h"

#include <string.h>

/* Slack around a target inside which an axis counts as aligned when the next leg is chosen. */
#define ALIGNED_TICKS 2

/* Those that stand elsewhere while the needle goes in. */
static bool is_free(const move_mode_t *self, const robot_t *robot, uint32_t index)
{
    return (index == robot->needle_axis) ||
           (steering_is_on(&self->steering) && (index == robot->steering.axis));
}

bool move_mode_is_aligned(const move_mode_t *self, const robot_t *robot,
                          const axis_t axes[ROBOT_AXIS_MAX])
{
    bool is_aligned = true;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const int64_t slack = (int64_t)robot->axes[i].deadband_ticks + ALIGNED_TICKS;
        const int64_t way =
            (int64_t)self->target_ticks[i] - (int64_t)axes[i].sealed.encoder.position_ticks;
        is_aligned = is_aligned && (is_free(self, robot, i) || ((way <= slack) && (way >= -slack)));
    }
    return is_aligned;
}

/* Tissue is not cut sideways: the base is aligned with the needle out. All axes are held. */
static void begin_leg(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame)
{
    const robot_t *const robot = frame->robot;
    const int32_t needle_ticks = frame->axes[robot->needle_axis].sealed.encoder.position_ticks;
    int32_t ends[ROBOT_AXIS_MAX];
    (void)memcpy(ends, self->target_ticks, sizeof ends);
    if (move_mode_is_aligned(self, robot, frame->axes)) {
        /* Only the needle is left. */
    } else if (needle_ticks > needle_out_ticks(robot)) {
        leg_positions(frame, ends);
        ends[robot->needle_axis] = needle_retracted_ticks(robot);
    } else {
        ends[robot->needle_axis] = needle_ticks;
    }
    leg_begin(leg, frame, LEG_EVERY_AXIS, ends);
}

static bool is_last(const move_mode_t *self, const leg_t *leg)
{
    return memcmp(leg->profile.end_ticks, self->target_ticks, sizeof self->target_ticks) == 0;
}

void move_mode_go(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                  mode_result_t *result)
{
    if (leg->is_running == 0U) {
        begin_leg(self, leg, frame);
    }
    if (leg_step(leg, frame, result) && is_last(self, leg)) {
        result->progress = MODE_DONE;
    }
}

static uint32_t rotation_of(const mode_frame_t *frame)
{
    return frame->robot->steering.axis % ROBOT_AXIS_MAX; /* Of a damaged table. */
}

/* The needle rests, and the base is kept at the target. */
static void hold(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                 mode_result_t *result)
{
    leg_stop(leg);
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        if (i == frame->robot->needle_axis) {
            result->requests[i] = axis_rest(axis, frame->elapsed_us);
        } else if (i != rotation_of(frame)) {
            result->requests[i] = axis_follow(axis, &frame->robot->axes[i], self->target_ticks[i],
                                              0, frame->elapsed_us);
        } else {
            /* It turns. */
        }
    }
}

static void begin_insertion(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame)
{
    const uint32_t rotation = LEG_AXIS(rotation_of(frame));
    mode_frame_t slow;
    (void)memcpy(&slow, frame, sizeof slow);
    slow.speed_cap_percent[frame->robot->needle_axis] = steer_needle_percent(frame);
    leg_begin(leg, &slow, LEG_EVERY_AXIS & ~rotation, self->target_ticks);
    leg->lent = rotation;
}

static bool is_at_depth(const move_mode_t *self, const mode_frame_t *frame)
{
    const uint32_t needle = frame->robot->needle_axis % ROBOT_AXIS_MAX;
    const int64_t way = (int64_t)self->target_ticks[needle] -
                        (int64_t)frame->axes[needle].sealed.encoder.position_ticks;
    return fixed_magnitude(way) <= (int64_t)frame->robot->axes[needle].deadband_ticks;
}

/* The needle goes in while its rotation follows its law, and stands otherwise. It is never drawn
 * out for a base that has moved: it waits until that stands at the target again. */
static void insert_steered(const move_mode_t *self, leg_t *leg, steer_t *steer,
                           const mode_frame_t *frame, mode_result_t *result)
{
    const bool may_go_in = steer_step(steer, &self->steering, frame, result);
    const bool is_running = leg->is_running != 0U;
    if (result->progress == MODE_FAILED) {
        mode_rest(frame, result);
    } else if (!may_go_in ||
               (!is_running && !move_mode_is_aligned(self, frame->robot, frame->axes))) {
        hold(self, leg, frame, result);
    } else {
        if (!is_running) {
            begin_insertion(self, leg, frame);
        }
        if (leg_step(leg, frame, result)) {
            result->progress = MODE_DONE;
        }
    }
}

/* The base is aligned by a leg that ends before the needle goes in. */
static bool may_begin(const move_mode_t *self, const leg_t *leg, const mode_frame_t *frame)
{
    return steering_is_on(&self->steering) && (leg->is_running == 0U) &&
           move_mode_is_aligned(self, frame->robot, frame->axes);
}

void move_mode_step(const move_mode_t *self, leg_t *leg, steer_t *steer, const mode_frame_t *frame,
                    mode_result_t *result)
{
    const bool begins = !steer_is_turning(steer) && may_begin(self, leg, frame);
    if (begins && is_at_depth(self, frame)) {
        mode_rest(frame, result);
        result->progress = MODE_DONE;
    } else if (begins || steer_is_turning(steer)) {
        insert_steered(self, leg, steer, frame, result);
    } else {
        steer_stop(steer);
        move_mode_go(self, leg, frame, result);
    }
}

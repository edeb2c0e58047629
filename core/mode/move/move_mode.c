/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/move/move_mode.h"

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

/* All but the rotation. */
static void hold_others(const mode_frame_t *frame, uint32_t rotation, mode_result_t *result)
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        if (i != rotation) {
            result->requests[i] = axis_rest(axis, frame->elapsed_us);
        }
    }
}

/* The needle goes in while its rotation follows its law, and stands otherwise. */
static void insert_steered(const move_mode_t *self, leg_t *leg, steer_t *steer,
                           const mode_frame_t *frame, mode_result_t *result)
{
    const uint32_t rotation = frame->robot->steering.axis;
    if (!steer_step(steer, &self->steering, frame, result)) {
        leg_stop(leg);
        hold_others(frame, rotation, result);
    } else {
        if (leg->is_running == 0U) {
            mode_frame_t slow;
            (void)memcpy(&slow, frame, sizeof slow);
            slow.speed_cap_percent[frame->robot->needle_axis] = steer_needle_percent(frame);
            leg_begin(leg, &slow, LEG_EVERY_AXIS & ~LEG_AXIS(rotation), self->target_ticks);
            leg->lent = LEG_AXIS(rotation);
        }
        if (leg_step(leg, frame, result)) {
            result->progress = MODE_DONE;
        }
    }
}

/* The base is aligned by a leg that ends before the needle goes in. */
static bool is_inserting(const move_mode_t *self, const leg_t *leg, const mode_frame_t *frame)
{
    const bool is_aligning = (leg->is_running != 0U) && (leg->lent == 0U);
    return steering_is_on(&self->steering) && !is_aligning &&
           move_mode_is_aligned(self, frame->robot, frame->axes);
}

void move_mode_step(const move_mode_t *self, leg_t *leg, steer_t *steer, const mode_frame_t *frame,
                    mode_result_t *result)
{
    if (is_inserting(self, leg, frame)) {
        insert_steered(self, leg, steer, frame, result);
    } else {
        steer_stop(steer);
        move_mode_go(self, leg, frame, result);
    }
}

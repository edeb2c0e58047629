/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/cooperate/cooperate_mode.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "motion/admittance.h"
#include "motion/ramp.h"
#include "motion/vibration.h"

/* Way of the needle to its depth; negative beyond it. */
static int64_t left_ticks(const move_mode_t *move, const robot_t *robot,
                          const axis_t axes[ROBOT_AXIS_MAX])
{
    const uint32_t needle = robot->needle_axis;
    return (int64_t)move->target_ticks[needle] -
           (int64_t)axes[needle].sealed.encoder.position_ticks;
}

/* Beyond its depth by more than it may go on by while its drive ends. */
static bool is_too_deep(const move_mode_t *move, const robot_t *robot,
                        const axis_t axes[ROBOT_AXIS_MAX])
{
    const int64_t deadband_ticks = (int64_t)robot->axes[robot->needle_axis].deadband_ticks;
    return left_ticks(move, robot, axes) < -(deadband_ticks * (int64_t)LIMIT_HAND_BEYOND_DEADBANDS);
}

solution_t cooperate_mode_judge(const move_mode_t *move, const robot_t *robot,
                                const axis_t axes[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_OK};
    if (robot->hand.gain_q8 == 0U) {
        result.status = STATUS_NO_HAND;
    } else if (!move_mode_is_aligned(move, robot, axes)) {
        result.status = STATUS_NOT_ALIGNED;
    } else if (is_too_deep(move, robot, axes)) {
        result.status = STATUS_TOO_DEEP;
    } else {
        /* It may. */
    }
    return result;
}

/* Change of a speed in a cycle. */
static int64_t step_q8(uint32_t ticks_per_s2)
{
    return fixed_divide_by((int64_t)ticks_per_s2 * 256, RAMP_CYCLES_PER_S);
}

/* The speed that the hand asks for. */
static int64_t asked_q8(const mode_frame_t *frame)
{
    return admittance_speed_q8(&frame->robot->hand, frame->hand.force_mn);
}

/* That speed as far as the axis may have it, and 0 behind a puncture. */
static int64_t most_q8(const cooperate_mode_t *self, const move_mode_t *move,
                       const mode_frame_t *frame, uint32_t index)
{
    const axis_config_t *const config = &frame->robot->axes[index];
    const uint32_t percent = steering_is_on(&move->steering) ? steer_needle_percent(frame)
                                                             : frame->speed_cap_percent[index];
    const int64_t wanted_q8 = cooperate_mode_is_vibrating(self) ? 0 : asked_q8(frame);
    const int64_t axis_q8 =
        fixed_divide_by((int64_t)config->speed_ticks_per_s * 256 * (int64_t)percent, 100U);
    return fixed_within(wanted_q8, 0, axis_q8);
}

/* Where the set-point goes on from: a needle that rests begins where it stands. */
static int32_t from_ticks(const axis_t *axis)
{
    return (axis->sealed.setpoint_speed_ticks_per_s_q8 > 0) ? axis->sealed.setpoint_ticks
                                                            : axis->sealed.encoder.position_ticks;
}

/* Speed of the set-point in this cycle. It ends at the target, whatever the force. */
static int64_t next_q8(const cooperate_mode_t *self, const move_mode_t *move,
                       const mode_frame_t *frame, uint32_t index)
{
    const int32_t target_ticks = move->target_ticks[index];
    const axis_t *const axis = &frame->axes[index];
    const int64_t room_ticks = (int64_t)target_ticks - (int64_t)from_ticks(axis);
    const int64_t now_q8 = fixed_larger((int64_t)axis->sealed.setpoint_speed_ticks_per_s_q8, 0);
    const ramp_steps_t steps = {
        .up_q8 = step_q8((uint32_t)frame->robot->axes[index].acceleration_ticks_per_s2),
        .down_q8 = step_q8(frame->robot->hand.stop_ticks_per_s2)};
    return ramp_next(now_q8, most_q8(self, move, frame, index), &steps,
                     (room_ticks * RAMP_TICK) - (int64_t)self->rest);
}

/* No rest of the way is made up for once the hand has let go: the set-point is the position. */
static card_drive_t push(cooperate_mode_t *self, const move_mode_t *move, const mode_frame_t *frame,
                         uint32_t index)
{
    axis_t *const axis = &frame->axes[index];
    const int64_t speed_q8 = next_q8(self, move, frame, index);
    if (speed_q8 == 0) {
        self->rest = 0;
        return axis_rest(axis, frame->elapsed_us);
    }
    const int32_t ticks = ramp_place(from_ticks(axis), speed_q8, &self->rest);
    return axis_follow(axis, &frame->robot->axes[index], ticks, (int32_t)speed_q8,
                       frame->elapsed_us);
}

/* No motion begins that the axis has no room for behind it. */
static bool may_vibrate(const mode_frame_t *frame, uint32_t index)
{
    const int64_t room_ticks = (int64_t)frame->axes[index].sealed.encoder.position_ticks -
                               (int64_t)frame->robot->axes[index].minimum_ticks;
    return room_ticks > (int64_t)frame->robot->vibration.amplitude_ticks;
}

/* A hand that has let go, or pulls, ends it. */
static void choose_stage(cooperate_mode_t *self, const mode_frame_t *frame, uint32_t index)
{
    const bool is_resting = frame->axes[index].sealed.setpoint_speed_ticks_per_s_q8 == 0;
    if (asked_q8(frame) == 0) {
        self->stage = (uint32_t)COOPERATE_FOLLOWS;
    } else if ((self->stage == (uint32_t)COOPERATE_FOLLOWS) && frame->is_puncture &&
               (frame->robot->vibration.periods != 0U) && may_vibrate(frame, index)) {
        self->stage = (uint32_t)COOPERATE_BRAKES;
    } else if ((self->stage == (uint32_t)COOPERATE_BRAKES) && is_resting) {
        self->stage = (uint32_t)COOPERATE_VIBRATES;
        self->cycle = 0U;
    } else if ((self->stage == (uint32_t)COOPERATE_VIBRATES) &&
               vibration_at(&frame->robot->vibration, self->cycle).is_over) {
        self->stage = (uint32_t)COOPERATE_ENDED;
    } else {
        /* As before. */
    }
}

/* It begins where the needle stands at the end of the first rest. */
static card_drive_t vibrate(cooperate_mode_t *self, const mode_frame_t *frame, uint32_t index)
{
    const vibration_law_t *const law = &frame->robot->vibration;
    axis_t *const axis = &frame->axes[index];
    const vibration_point_t point = vibration_at(law, self->cycle);
    self->cycle++;
    if (self->cycle <= law->dwell_cycles) {
        self->begin_ticks = axis->sealed.encoder.position_ticks;
        return axis_rest(axis, frame->elapsed_us);
    }
    return axis_follow(axis, &frame->robot->axes[index], self->begin_ticks - point.behind_ticks,
                       point.speed_ticks_per_s_q8, frame->elapsed_us);
}

/* Without its rotation it rests where it is. */
static card_drive_t drive_needle(cooperate_mode_t *self, const move_mode_t *move,
                                 const mode_frame_t *frame, uint32_t index, bool may_go_in)
{
    card_drive_t drive;
    if (cooperate_mode_is_stroke(self)) {
        drive = vibrate(self, frame, index);
    } else if (may_go_in) {
        drive = push(self, move, frame, index);
    } else {
        self->rest = 0;
        axis_t *const axis = &frame->axes[index];
        drive = axis_rest(axis, frame->elapsed_us);
    }
    return drive;
}

/* What the axes but the needle do: only the rotation of one that is steered turns, while a hand
 * pushes: the permit stands against every drive otherwise. */
static bool drive_others(const move_mode_t *move, steer_t *steer, const mode_frame_t *frame,
                         mode_result_t *result)
{
    const bool is_steered = steering_is_on(&move->steering);
    const bool is_turning = is_steered && (asked_q8(frame) > 0);
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        if ((i != frame->robot->needle_axis) &&
            !(is_turning && (i == frame->robot->steering.axis))) {
            result->requests[i] = axis_rest(axis, frame->elapsed_us);
        }
    }
    bool may_go_in = !is_steered;
    if (is_turning) {
        may_go_in = steer_step(steer, &move->steering, frame, result);
    }
    return may_go_in;
}

static void go(cooperate_mode_t *self, const move_mode_t *move, steer_t *steer,
               const mode_frame_t *frame, mode_result_t *result)
{
    const uint32_t needle = frame->robot->needle_axis;
    choose_stage(self, frame, needle);
    const bool may_go_in = drive_others(move, steer, frame, result);
    result->requests[needle] = drive_needle(self, move, frame, needle, may_go_in);
    /* At its depth, and the set-point rests. */
    if ((left_ticks(move, frame->robot, frame->axes) <=
         (int64_t)frame->robot->axes[needle].deadband_ticks) &&
        (frame->axes[needle].sealed.setpoint_speed_ticks_per_s_q8 == 0)) {
        result->progress = MODE_DONE;
    }
}

void cooperate_mode_step(cooperate_mode_t *self, const move_mode_t *move, steer_t *steer,
                         const mode_frame_t *frame, mode_result_t *result)
{
    const solution_t judged = cooperate_mode_judge(move, frame->robot, frame->axes);
    if (judged.status != STATUS_OK) {
        mode_give_up(frame, result, judged.status);
    } else {
        go(self, move, steer, frame, result);
    }
}

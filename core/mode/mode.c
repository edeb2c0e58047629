/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/mode.h"

#include "interface/command.h"
#include "limits/requirement_limits.h"
#include "mode/mode_dispatch.h"
#include "mode/velocity/velocity_share.h"
#include "safety/steering_guard.h"

bool mode_runs_in(mode_kind_t kind, workphase_t workphase)
{
    return ((uint32_t)workphase < WORKPHASE_COUNT) &&
           (((mode_rows[kind].workphases >> (uint32_t)workphase) & 1U) != 0U);
}

mode_kind_t mode_of(workphase_t workphase)
{
    mode_kind_t found = MODE_NONE;
    for (uint32_t i = 0U; i < MODE_KIND_COUNT; i++) {
        const mode_kind_t kind = (mode_kind_t)i;
        if ((mode_rows[i].command == (uint32_t)COMMAND_WORKPHASE) &&
            mode_runs_in(kind, workphase)) {
            found = kind;
        }
    }
    return found;
}

mode_kind_t mode_in(const mode_state_t *self, workphase_t workphase)
{
    const bool is_of_it = (self->sealed.kind < MODE_KIND_COUNT) &&
                          mode_runs_in((mode_kind_t)self->sealed.kind, workphase);
    return is_of_it ? (mode_kind_t)self->sealed.kind : MODE_NONE;
}

uint32_t mode_axes(mode_kind_t kind, uint32_t commanded, const robot_t *robot)
{
    uint32_t axes = LEG_EVERY_AXIS;
    if (mode_rows[kind].axes == (uint32_t)MODE_AXES_COMMANDED) {
        axes = commanded;
    } else if (mode_rows[kind].axes == (uint32_t)MODE_AXES_NEEDLE) {
        axes = LEG_AXIS(robot->needle_axis);
    } else {
        /* All. */
    }
    return axes;
}

bool mode_needs(const mode_state_t *self, uint32_t index)
{
    return ((self->request.sealed.axes >> index) & 1U) != 0U;
}

void mode_begin(mode_state_t *self, mode_kind_t kind, const mode_request_t *request)
{
    self->sealed.kind = (uint32_t)kind;
    self->request = *request;
    trajectory_mode_begin(&self->sealed.trajectory, request->sealed.span.start_ms);
    self->sealed.program.stage = (uint32_t)PROGRAM_STAGE_NONE;
    if (kind == MODE_PROGRAM) {
        program_mode_begin(&self->sealed.program);
    }
    leg_stop(&self->sealed.leg);
    steer_stop(&self->sealed.steer);
    escort_end(&self->sealed.escort);
}

/* An armed mode that is not known any more fails. */
static void run(mode_state_t *self, mode_kind_t kind, const mode_frame_t *frame,
                mode_result_t *result)
{
    if (!mode_dispatch_step(self, kind, frame, result)) {
        mode_rest(frame, result);
        result->progress = MODE_FAILED;
        result->status = STATUS_FAULT_PRESENT;
    }
}

static uint32_t homed_per_mille(const axis_t axes[ROBOT_AXIS_MAX], uint32_t axis_count)
{
    uint32_t homed = 0U;
    for (uint32_t i = 0U; i < axis_count; i++) {
        homed += axis_is_homed(&axes[i]) ? 1U : 0U;
    }
    return (homed * 1000U) / axis_count;
}

/* In whole cycles; a profile lasts less than an hour, so that 32 bits hold the products. */
static mode_share_t leg_share(const leg_t *leg)
{
    const profile_t *const profile = &leg->profile;
    const uint32_t cycles = (2U * profile->ramp_cycles) + profile->cruise_cycles;
    mode_share_t share = {.done_per_mille = 1000U, .left_ms = 0U};
    if (profile->cycle < cycles) {
        share.done_per_mille = (profile->cycle * 1000U) / cycles;
        share.left_ms = ((cycles - profile->cycle) * LIMIT_CYCLE_US) / 1000U;
    }
    return share;
}

void mode_step(mode_state_t *self, const mode_frame_t *frame, mode_result_t *result)
{
    const mode_kind_t kind = mode_in(self, frame->workphase);
    const bool is_done = mode_dispatch_is_done(self, kind, frame);
    const bool is_armed_program = self->sealed.program.stage != (uint32_t)PROGRAM_STAGE_NONE;
    mode_clear(result);
    if (is_armed_program && frame->is_treatment_stopped) {
        program_mode_stop(&self->sealed.program, frame, result);
    } else if (frame->is_moving && !is_done) {
        run(self, kind, frame, result);
    } else {
        leg_stop(&self->sealed.leg);
        trajectory_mode_pause(&self->sealed.trajectory);
        if (kind == MODE_COOPERATE) {
            cooperate_mode_pause(&self->request.own.cooperate);
        }
        mode_rest(frame, result);
        result->progress = is_done ? MODE_DONE : MODE_RUNNING;
    }
}

/* `left_ms` of `span_ms` are left; an hour at most, so that 32 bits hold the product. */
static mode_share_t time_share(uint32_t left_ms, uint32_t span_ms)
{
    mode_share_t share = {.done_per_mille = 1000U, .left_ms = left_ms};
    if (left_ms > 0U) {
        share.done_per_mille = ((span_ms - left_ms) * 1000U) / span_ms;
    }
    return share;
}

mode_share_t mode_share(const mode_state_t *self, mode_kind_t kind,
                        const axis_t axes[ROBOT_AXIS_MAX], uint32_t axis_count)
{
    mode_share_t share = {.done_per_mille = 0U, .left_ms = 0U};
    const uint32_t list_ms = self->request.sealed.span.end_ms - self->request.sealed.span.start_ms;
    if ((kind == MODE_TRAJECTORY) && (list_ms > 0U)) {
        share = time_share(
            trajectory_mode_left_ms(&self->sealed.trajectory, self->request.sealed.span.end_ms),
            list_ms);
    } else if (kind == MODE_VELOCITY) {
        share = time_share(velocity_share_left_ms(&self->request.own.velocity, axes),
                           velocity_share_span_ms(&self->request.own.velocity));
    } else if (self->sealed.leg.is_running != 0U) {
        share = leg_share(&self->sealed.leg);
    } else if (self->sealed.program.stage == (uint32_t)PROGRAM_STAGE_DWELLS) {
        share =
            time_share(program_mode_left_ms(&self->sealed.program), self->sealed.program.dwell_ms);
    } else if (kind == MODE_HOMING) {
        share.done_per_mille = homed_per_mille(axes, axis_count);
    } else {
        /* Unknown: one axis homes, or nothing has begun. */
    }
    return share;
}

void mode_stop(mode_state_t *self, axis_t axes[ROBOT_AXIS_MAX], uint32_t axis_count)
{
    const bool has_swept = (self->sealed.kind == (uint32_t)MODE_SWEEP) &&
                           sweep_mode_has_begun(&self->request.own.sweep);
    leg_stop(&self->sealed.leg);
    self->sealed.program.stage = (uint32_t)PROGRAM_STAGE_NONE;
    for (uint32_t i = 0U; i < axis_count; i++) {
        axis_stop_homing(&axes[i]);
        if (has_swept && (i == self->request.sealed.way.axis)) {
            axis_doubt(&axes[i]);
        }
    }
}

mode_aim_t mode_aim_of(uint32_t kind)
{
    return (kind < MODE_KIND_COUNT) ? (mode_aim_t)mode_rows[kind].aim : MODE_AIM_NONE;
}

bool mode_is_by_hand(mode_kind_t kind)
{
    return mode_rows[kind].is_by_hand;
}

bool mode_is_vibrating(const mode_state_t *self, mode_kind_t kind)
{
    return (kind == MODE_COOPERATE) && cooperate_mode_is_vibrating(&self->request.own.cooperate);
}

bool mode_waits_for_rotation(const mode_state_t *self, mode_kind_t kind, const robot_t *robot,
                             const axis_t axes[ROBOT_AXIS_MAX])
{
    const bool is_stroke =
        (kind == MODE_COOPERATE) && cooperate_mode_is_stroke(&self->request.own.cooperate);
    return (mode_aim_of((uint32_t)kind) == MODE_AIM_DEPTH) && !is_stroke &&
           !steering_guard_follows(&self->request.sealed.move.steering, robot, axes);
}

bool mode_wants_hand_off(const mode_state_t *self, mode_kind_t kind)
{
    return (kind == MODE_COOPERATE) && cooperate_mode_wants_hand_off(&self->request.own.cooperate);
}

bool mode_may_be_unhomed(mode_kind_t kind)
{
    return mode_rows[kind].may_be_unhomed;
}

static uint32_t across_needle(const robot_t *robot, uint32_t axes)
{
    uint32_t across = 0U;
    for (uint32_t i = 0U; (axes >> i) != 0U; i++) {
        const bool is_across = robot->axes[i].needle_motion == (uint32_t)NEEDLE_ACROSS;
        across |= is_across ? (axes & LEG_AXIS(i)) : 0U;
    }
    return across;
}

uint32_t mode_heeding_needle(const mode_state_t *self, mode_kind_t kind, const robot_t *robot,
                             uint32_t driven)
{
    const uint32_t needle = mode_rows[kind].needle;
    uint32_t heeding = 0U;
    if (needle == (uint32_t)MODE_NEEDLE_ACROSS) {
        heeding = across_needle(robot, driven);
    } else if (needle == (uint32_t)MODE_NEEDLE_COMMANDED) {
        heeding = self->request.sealed.axes;
    } else {
        /* Nothing to heed. */
    }
    return heeding;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_move.h"

#include "controller/controller_facts.h"
#include "controller/controller_jog.h"
#include "controller/controller_order.h"

#include "safety/coupled_guard.h"
#include "safety/needle.h"
#include "safety/permit.h"

#include <string.h>

/* Slack around a target inside which an axis counts as aligned when the next leg of a move is
 * chosen. */
#define ALIGNED_TICKS 2
/* At the target for this long before the order is done: the motors' fall time is about 1.5 ms. */
#define SETTLED_CYCLES 50U

static void rest_all(controller_t *self, const cycle_t *cycle,
                     card_drive_t requests[ROBOT_AXIS_MAX])
{
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        requests[i] = axis_rest(&self->axes[i], cycle->inputs->elapsed_us);
    }
    self->is_profile_running = 0U;
    self->settled_cycles = 0U;
}

/* Stage 1 homes before stage 2: the needle leaves first. */
static uint8_t home_stage(const controller_t *self, const robot_t *robot)
{
    uint8_t stage = 2U;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        if (!axis_is_homed(&self->axes[i]) && (robot->axes[i].home_stage < stage)) {
            stage = robot->axes[i].home_stage;
        }
    }
    return stage;
}

static bool is_barred(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const bool is_found = coupled_guard_bars_homing(cycle->robot, self->axes, index);
    if (is_found) {
        controller_note(self, cycle, EVENT_HOMING_BARRED, index, 0);
        controller_fail_order(self, cycle, EVENT_CAUSE_AXIS, index);
    }
    return is_found;
}

static void run_homing(controller_t *self, const cycle_t *cycle,
                       card_drive_t requests[ROBOT_AXIS_MAX])
{
    const uint8_t stage = home_stage(self, cycle->robot);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        axis_t *const axis = &self->axes[i];
        const axis_config_t *const config = &cycle->robot->axes[i];
        uint32_t notes = 0U;
        if ((config->home_stage == stage) && !is_barred(self, cycle, i)) {
            notes = axis_begin_homing(axis, config);
        }
        if (notes != 0U) {
            controller_note(self, cycle, EVENT_AXIS_TAKEN, i, axis->home_correction_ticks);
        }
        requests[i] = axis_is_homing(axis) ? axis_home(axis, config, cycle->inputs->elapsed_us)
                                           : axis_rest(axis, cycle->inputs->elapsed_us);
    }
}

static void positions(const controller_t *self, int32_t ticks[ROBOT_AXIS_MAX])
{
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        ticks[i] = self->axes[i].encoder.position_ticks;
    }
}

static bool is_base_aligned(const controller_t *self, const robot_t *robot)
{
    bool is_aligned = true;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        const int64_t slack = (int64_t)robot->axes[i].deadband_ticks + ALIGNED_TICKS;
        const int64_t way =
            (int64_t)self->plan.target_ticks[i] - (int64_t)self->axes[i].encoder.position_ticks;
        is_aligned =
            is_aligned && ((i == robot->needle_axis) || ((way <= slack) && (way >= -slack)));
    }
    return is_aligned;
}

/* Halfway, so that it surely counts as out. */
static int32_t retracted_ticks(const robot_t *robot)
{
    const int32_t home_ticks = robot->axes[robot->needle_axis].home_ticks;
    return home_ticks + ((needle_out_ticks(robot) - home_ticks) / 2);
}

/* End of the next leg of the move: retract the needle, align everything else, insert. */
static void choose_leg(const controller_t *self, const robot_t *robot, int32_t ends[ROBOT_AXIS_MAX])
{
    const uint32_t needle = robot->needle_axis;
    const int32_t needle_ticks = self->axes[needle].encoder.position_ticks;
    if (is_base_aligned(self, robot)) {
        (void)memcpy(ends, self->plan.target_ticks, sizeof self->plan.target_ticks);
    } else if (needle_ticks > needle_out_ticks(robot)) {
        positions(self, ends);
        ends[needle] = retracted_ticks(robot);
    } else {
        (void)memcpy(ends, self->plan.target_ticks, sizeof self->plan.target_ticks);
        ends[needle] = needle_ticks;
    }
}

/* A jog leaves the other axes alone, so does the needle that leaves; a move holds them all. */
static bool is_moved(const controller_t *self, const robot_t *robot, uint32_t index)
{
    const workphase_t workphase = procedure_workphase(&self->procedure);
    const bool is_leaving = (workphase == WORKPHASE_START_UP) && (index == robot->needle_axis);
    return (workphase == WORKPHASE_MOVE_TO_TARGET) || is_leaving ||
           controller_is_jogged(self, index);
}

static bool is_at(const controller_t *self, const robot_t *robot,
                  const int32_t ticks[ROBOT_AXIS_MAX])
{
    bool is_there = true;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        is_there = is_there && (!is_moved(self, robot, i) ||
                                axis_is_at(&self->axes[i], &robot->axes[i], ticks[i]));
    }
    return is_there;
}

/* Begins the next leg from the actual position, at rest. */
static void begin_leg(controller_t *self, const robot_t *robot)
{
    int32_t starts[ROBOT_AXIS_MAX] = {0};
    int32_t ends[ROBOT_AXIS_MAX] = {0};
    positions(self, starts);
    positions(self, ends);
    const workphase_t workphase = procedure_workphase(&self->procedure);
    if (workphase == WORKPHASE_MOVE_TO_TARGET) {
        choose_leg(self, robot, ends);
    } else if (workphase == WORKPHASE_START_UP) {
        ends[robot->needle_axis] = retracted_ticks(robot);
    } else {
        ends[self->jog_axis % ROBOT_AXIS_MAX] = self->jog_ticks;
    }
    profile_plan(&self->profile, robot, starts, ends,
                 permit_cap_percent(controller_is_homed(self)));
    self->is_profile_running = 1U;
    self->settled_cycles = 0U;
    self->overtime_cycles = 0U;
}

/* An axis that the profile leaves where it is costs no division. */
static card_drive_t follow(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const profile_t *const profile = &self->profile;
    int32_t position_ticks = profile->end_ticks[index];
    int32_t speed_q8 = 0;
    if (profile->start_ticks[index] != position_ticks) {
        position_ticks = profile_position_ticks(profile, index);
        speed_q8 = profile_speed_ticks_per_s_q8(profile, index);
    }
    return axis_follow(&self->axes[index], &cycle->robot->axes[index], position_ticks, speed_q8,
                       cycle->inputs->elapsed_us);
}

static void follow_profile(controller_t *self, const cycle_t *cycle,
                           card_drive_t requests[ROBOT_AXIS_MAX])
{
    if (self->is_profile_running == 0U) {
        begin_leg(self, cycle->robot);
    }
    profile_step(&self->profile);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        requests[i] = is_moved(self, cycle->robot, i)
                          ? follow(self, cycle, i)
                          : axis_rest(&self->axes[i], cycle->inputs->elapsed_us);
    }
    if (profile_is_finished(&self->profile) && is_at(self, cycle->robot, self->profile.end_ticks)) {
        self->settled_cycles++;
    } else {
        self->settled_cycles = 0U;
    }
}

/* The end of the whole order, not only of a leg. */
static bool is_order_at_end(const controller_t *self)
{
    const workphase_t workphase = procedure_workphase(&self->procedure);
    bool is_end = true;
    if (workphase == WORKPHASE_MOVE_TO_TARGET) {
        is_end = memcmp(self->profile.end_ticks, self->plan.target_ticks,
                        sizeof self->plan.target_ticks) == 0;
    }
    return is_end;
}

/* An axis that is not where its profile ended. */
static uint32_t astray(const controller_t *self, const robot_t *robot)
{
    uint32_t index = 0U;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        if (is_moved(self, robot, i) &&
            !axis_is_at(&self->axes[i], &robot->axes[i], self->profile.end_ticks[i])) {
            index = i;
        }
    }
    return index;
}

/* A motion that does not end is given up. */
static void watch_time(controller_t *self, const cycle_t *cycle)
{
    self->overtime_cycles = profile_is_finished(&self->profile) ? (self->overtime_cycles + 1U) : 0U;
    if ((self->overtime_cycles * LIMIT_CYCLE_US) >= LIMIT_OVERTIME_US) {
        const uint32_t index = astray(self, cycle->robot);
        controller_note(self, cycle, EVENT_ORDER_OVERDUE, index,
                        self->profile.end_ticks[index] - self->axes[index].encoder.position_ticks);
        controller_fail_order(self, cycle, EVENT_CAUSE_AXIS, index);
    }
}

static void run_profile(controller_t *self, const cycle_t *cycle,
                        card_drive_t requests[ROBOT_AXIS_MAX])
{
    follow_profile(self, cycle, requests);
    if (self->settled_cycles >= SETTLED_CYCLES) {
        const bool is_end = is_order_at_end(self);
        rest_all(self, cycle, requests);
        if (is_end) {
            controller_tell_order(self, cycle, ARMING_EVENT_DONE, STATUS_OK);
        }
    } else {
        watch_time(self, cycle);
    }
}

static void follow_pedal(controller_t *self, const cycle_t *cycle)
{
    const bool is_open = pedal_gate_is_open(&self->pedal);
    if (is_open && !procedure_is_moving(&self->procedure)) {
        controller_tell_order(self, cycle, ARMING_EVENT_PEDAL_DOWN, STATUS_OK);
    } else if (!is_open && procedure_is_moving(&self->procedure)) {
        controller_tell_order(self, cycle, ARMING_EVENT_PEDAL_UP, STATUS_OK);
    } else {
        /* Nothing has changed. */
    }
}

void controller_move(controller_t *self, const cycle_t *cycle,
                     card_drive_t requests[ROBOT_AXIS_MAX])
{
    follow_pedal(self, cycle);
    const bool is_start_up = procedure_workphase(&self->procedure) == WORKPHASE_START_UP;
    if (is_start_up && controller_is_homed(self)) {
        controller_tell_order(self, cycle, ARMING_EVENT_DONE, STATUS_OK);
    }
    if (!procedure_is_moving(&self->procedure)) {
        rest_all(self, cycle, requests);
    } else if (is_start_up && needle_must_leave(cycle->robot, self->axes)) {
        follow_profile(self, cycle, requests);
        watch_time(self, cycle);
    } else if (is_start_up) {
        self->is_profile_running = 0U;
        run_homing(self, cycle, requests);
    } else {
        run_profile(self, cycle, requests);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/show/controller_show.h"

#include "controller/orders/controller_authority.h"
#include "controller/controller_facts.h"
#include "controller/show/controller_ready.h"

#include "base/clear.h"

#include "robot/robot_damage.h"
#include "safety/needle.h"
#include "safety/permit.h"

#include <string.h>

typedef struct {
    permit_reason_t reason;
    next_step_t step;
} remedy_t;

/* Steps that each reason asks of the operator, the most pressing first. */
static const remedy_t remedies[] = {
    {PERMIT_REASON_MEMORY, NEXT_STEP_MEMORY},
    {PERMIT_REASON_INPUTS_UNREAD, NEXT_STEP_CHECK_BOX},
    {PERMIT_REASON_ESTOP_PULLED, NEXT_STEP_RELEASE_ESTOP},
    {PERMIT_REASON_LINK_LOST, NEXT_STEP_CHECK_CARDS},
    {PERMIT_REASON_CARDS_UNPROTECTED, NEXT_STEP_ACCEPT_CARDS},
    {PERMIT_REASON_PEDAL_FAULT, NEXT_STEP_PEDAL_FAULT},
    {PERMIT_REASON_ESTOP_LATCHED, NEXT_STEP_START_UP},
    {PERMIT_REASON_LOOP_STOPPED, NEXT_STEP_START_UP},
    {PERMIT_REASON_AXIS_FAULT, NEXT_STEP_START_UP},
    {PERMIT_REASON_AXIS_DISABLED, NEXT_STEP_START_UP},
    {PERMIT_REASON_NEEDLE_IN, NEXT_STEP_START_UP},
    {PERMIT_REASON_NOTHING_ARMED, NEXT_STEP_NOTHING}, /* The plan decides. */
    {PERMIT_REASON_NOT_HOMED, NEXT_STEP_START_UP},
    {PERMIT_REASON_SCANNER_ACTIVE, NEXT_STEP_SCANNER},
    {PERMIT_REASON_PEDAL_UNPROVEN, NEXT_STEP_RELEASE_PEDAL},
    {PERMIT_REASON_PEDAL_RELEASED, NEXT_STEP_PRESS_PEDAL},
    {PERMIT_REASON_HAND_UNPROVEN, NEXT_STEP_LET_GO},
    {PERMIT_REASON_HAND_OFF, NEXT_STEP_PUSH},
    {PERMIT_REASON_LIMIT_SWITCH, NEXT_STEP_HOLD_PEDAL},
    {PERMIT_REASON_SOFT_LIMIT, NEXT_STEP_HOLD_PEDAL},
    {PERMIT_REASON_COUPLED_LIMIT, NEXT_STEP_HOLD_PEDAL},
};

/* At the target, or at the last step of a program, which may lie before it. */
static next_step_t step_after_arrival(const controller_t *self)
{
    return (self->mode.sealed.kind == (uint32_t)MODE_PROGRAM) ? NEXT_STEP_PROGRAM_DONE
                                                              : NEXT_STEP_NOTHING;
}

/* `workphase` is entered from the present one, in the chart's words. After START_UP comes PLANNING,
 * though CALIBRATION is entered from there as well. */
static bool is_entered(const procedure_t *procedure, workphase_t workphase)
{
    const workphase_chart_t *const chart = &procedure->workphase;
    const bool is_entered = (workphase == WORKPHASE_TARGETING)
                                ? workphase_chart_enters_by_request_targeting(chart)
                                : workphase_chart_enters_by_request_calibration(chart);
    return is_entered && (procedure_workphase(procedure) != WORKPHASE_START_UP);
}

/* `step` where it is obeyed, in `workphase`; elsewhere the way there. */
static next_step_t step_in(const procedure_t *procedure, workphase_t workphase, next_step_t step)
{
    next_step_t there = NEXT_STEP_PLANNING;
    if (workphase == procedure_workphase(procedure)) {
        there = step;
    } else if (is_entered(procedure, workphase)) {
        there = (workphase == WORKPHASE_TARGETING) ? NEXT_STEP_TARGETING : NEXT_STEP_CALIBRATION;
    } else {
        there = NEXT_STEP_PLANNING;
    }
    return there;
}

/* Round what the way would leave: the pose is one of MANUAL, and needs the needle out. */
static next_step_t step_by_pose(const controller_t *self, const robot_t *robot, workphase_t present)
{
    next_step_t step = NEXT_STEP_MANUAL;
    if (present == WORKPHASE_MANUAL) {
        step = needle_is_out(robot, self->axes) ? NEXT_STEP_DRAPING : NEXT_STEP_RETRACT;
    }
    return step;
}

/* The reason, which every axis has, stays for the operator after it has ended an insertion by hand.
 */
static bool is_hand_doubtful(const controller_t *self)
{
    return (self->records[0].sealed.reason_hold.shown &
            permit_reason(true, PERMIT_REASON_FORCE_DOUBTFUL)) != 0U;
}

static next_step_t step_to_target(const controller_t *self, const robot_t *robot,
                                  workphase_t present)
{
    next_step_t step = NEXT_STEP_MOVE;
    if (self->way.kind >= (uint32_t)TARGET_WAY_UNKNOWN) {
        step = NEXT_STEP_WAIT; /* Two cycles. */
    } else if (self->way.kind == (uint32_t)TARGET_WAY_BY_POSE) {
        step = step_by_pose(self, robot, present);
    } else if (self->way.kind == (uint32_t)TARGET_WAY_NONE) {
        step = step_in(&self->procedure, WORKPHASE_TARGETING, NEXT_STEP_TARGET);
    } else if (present != WORKPHASE_MOVE_TO_TARGET) {
        step = step_in(&self->procedure, WORKPHASE_TARGETING, NEXT_STEP_MOVE);
    } else if (is_hand_doubtful(self)) {
        step = robot_is_force_damaged(robot) ? NEXT_STEP_MEMORY : NEXT_STEP_ZERO_FORCE;
    } else {
        /* Commanded once more. */
    }
    return step;
}

static next_step_t step_for_plan(const controller_t *self, const robot_t *robot, bool is_homed)
{
    const workphase_t present = procedure_workphase(&self->procedure);
    const bool is_going = present == WORKPHASE_MOVE_TO_TARGET;
    next_step_t step = NEXT_STEP_START_UP;
    if ((present == WORKPHASE_EMERGENCY) || !is_homed) {
        step = NEXT_STEP_START_UP;
    } else if (self->plan.has_probe == 0U) {
        step = is_going ? NEXT_STEP_PLANNING : NEXT_STEP_PROBE;
    } else if (self->plan.is_registered == 0U) {
        step = step_in(&self->procedure, WORKPHASE_CALIBRATION, NEXT_STEP_REGISTER);
    } else if (self->plan.has_target == 0U) {
        step = step_in(&self->procedure, WORKPHASE_TARGETING, NEXT_STEP_TARGET);
    } else if (is_going && (self->sealed.has_arrived != 0U)) {
        step = step_after_arrival(self);
    } else {
        step = step_to_target(self, robot, present);
    }
    return step;
}

/* The pedal has done its part, and is to be seen released before the next one. */
static next_step_t release_first(const controller_t *self, next_step_t step)
{
    return (self->pedal.sealed.is_released == 0U) ? NEXT_STEP_RELEASE_PEDAL : step;
}

/* Follows the reasons of every axis, and the workphase when nothing but an order is missing. */
static next_step_t next_step(const controller_t *self, const robot_t *robot, bool is_homed)
{
    uint32_t reasons = 0U;
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        reasons |= self->records[i].sealed.reason_hold.shown;
    }
    const uint32_t count = (uint32_t)(sizeof(remedies) / sizeof(remedies[0]));
    next_step_t step = NEXT_STEP_HOLD_PEDAL;
    for (uint32_t i = (reasons != 0U) ? count : 0U; i > 0U; i--) {
        const remedy_t *const remedy = &remedies[i - 1U];
        if ((reasons & ((uint32_t)1U << (uint32_t)remedy->reason)) != 0U) {
            step = remedy->step;
        }
    }
    return (step == NEXT_STEP_NOTHING) ? release_first(self, step_for_plan(self, robot, is_homed))
                                       : step;
}

static bool is_one_of(next_step_t step, uint64_t steps)
{
    return ((steps >> (uint32_t)step) & 1U) != 0U;
}

/* The axes rest, and it is not about to go to a party that was granted it. */
static bool is_anybodys(const authority_t *authority)
{
    return authority_is_free(authority) &&
           (authority->sealed.request != (uint32_t)AUTHORITY_REQUEST_GRANTED);
}

/* Puts authority before a step that a command fulfils while no client may send one, and the grant
 * before a step that can wait while a client waits for the button. */
static next_step_t authority_first(const controller_t *self, next_step_t step)
{
    next_step_t first = step;
    if (!is_one_of(step, NEXT_STEPS_CALM)) {
        /* An act at the box, or a wait: for every client. */
    } else if (controller_awaits_grant(self)) {
        first = NEXT_STEP_GRANT;
    } else if (!authority_is_held(&self->authority) && is_one_of(step, NEXT_STEPS_COMMANDED)) {
        first = is_anybodys(&self->authority) ? NEXT_STEP_AUTHORITY : NEXT_STEP_WAIT;
    } else {
        /* The commanding client continues. */
    }
    return first;
}

/*
 * Names the recorder where the needle is out and a command of the plan is all that is missing:
 * START_UP is not put off by a lack that does not refuse it, and a needle that may be in comes
 * first.
 *
 * @satisfies SWR-REC-034
 */
static named_step_t recorder_first(const controller_t *self, const cycle_t *cycle,
                                   const named_step_t *named)
{
    const bool is_in_time =
        is_one_of(named->step, NEXT_STEPS_PLANNED) && needle_is_out(cycle->robot, self->axes);
    return is_in_time ? controller_step_only(NEXT_STEP_RECORDER) : *named;
}

static void show_step(const controller_t *self, const cycle_t *cycle, snapshot_t *shown)
{
    named_step_t named = controller_step_only(next_step(self, cycle->robot, shown->is_homed != 0U));
    if (is_one_of(named.step, NEXT_STEPS_STARTING)) {
        named = controller_ready(self, cycle);
    } else if (named.step == NEXT_STEP_MOVE) {
        named = controller_ready_to_move(self);
    } else {
        /* It needs no more than it says. */
    }
    if (cycle->inputs->is_recorder_failing != 0U) {
        named = recorder_first(self, cycle, &named);
    }
    shown->step_axis = named.axis;
    shown->step_card = named.card;
    shown->step_event = named.event;
    shown->next_step = (uint32_t)authority_first(self, named.step);
}

static void show_axis(const controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const axis_t *const axis = &self->axes[index];
    const axis_record_t *const record = &self->records[index];
    const card_drive_t *const sent = &controller_link(self, index)->sealed.sent;
    snapshot_axis_t *const shown = &cycle->outputs->snapshot.axes[index];
    shown->power = (uint32_t)axis->chart.power;
    shown->reference = (uint32_t)axis->chart.reference;
    shown->stall = (uint32_t)axis->supervision.stall.state;
    shown->permit_reasons = record->sealed.reason_hold.shown;
    shown->permit_since_cycle = record->sealed.permit_since_cycle;
    shown->speed_cap_percent = record->sealed.speed_cap_percent;
    shown->position_ticks = axis->sealed.encoder.position_ticks;
    shown->reading_ticks = axis->sealed.encoder.reading;
    shown->setpoint_ticks = axis->sealed.setpoint_ticks;
    shown->target_ticks = axis->sealed.setpoint_ticks;
    shown->speed_ticks_per_s_q8 = axis->sealed.encoder.speed_ticks_per_s_q8;
    shown->setpoint_speed_ticks_per_s_q8 = axis->sealed.setpoint_speed_ticks_per_s_q8;
    shown->drive_mode = sent->mode;
    shown->drive_direction = sent->direction;
    shown->drive_duty = sent->duty;
    shown->limit_switches = axis->sealed.limit_switches;
}

static void show_card(const controller_t *self, const cycle_t *cycle, uint32_t slot)
{
    const link_t *const link = &self->links[slot];
    snapshot_card_t *const shown = &cycle->outputs->snapshot.cards[slot];
    shown->link = (uint32_t)link->chart.state;
    shown->age_cycles = link->sealed.age_cycles;
    shown->frame_errors = link->sealed.frame_errors;
    shown->frames_out_of_order = link->frames_out_of_order;
    shown->frames_missed = link->frames_missed;
    shown->heartbeat = link->report.heartbeat;
    shown->status = link->report.status;
    shown->card_type = link->report.card_type;
    shown->driver_temperature_dc = link->report.driver_temperature_dc;
    shown->motor_temperature_dc = link->report.motor_temperature_dc;
    shown->supply_mv = link->report.supply_mv;
    shown->current_ma = link->report.current_ma;
    shown->adc_words[0] = link->report.adc_words[0];
    shown->adc_words[1] = link->report.adc_words[1];
    shown->rx_crc_errors = link->report.rx_crc_errors;
    shown->sequence_gaps = link->report.sequence_gaps;
    shown->watchdog_trips = link->report.watchdog_trips;
    shown->uptime_s = link->report.uptime_s;
    shown->troubles = self->health[slot].troubles;
}

static void show_plan(const controller_t *self, snapshot_t *shown)
{
    shown->has_probe = self->plan.has_probe;
    (void)memcpy(shown->probe_nm, self->plan.probe.length_nm, sizeof shown->probe_nm);
    shown->is_registered = self->plan.is_registered;
    shown->is_rotation_ignored = self->plan.is_rotation_ignored;
    shown->registered_source = self->plan.registered_source;
    shown->registered_peer = self->plan.registered_peer;
    shown->registered_cycle = self->plan.registered_cycle;
    shown->has_target = self->plan.has_target;
    shown->has_entry = self->plan.has_entry;
    shown->has_seen_needle = self->plan.has_seen_needle;
    shown->has_proposed_registration = self->plan.has_proposed_registration;
    shown->has_proposed_entry = self->plan.has_proposed_entry;
    shown->has_proposed_target = self->plan.has_proposed_target;
    shown->is_proposal_reachable = self->plan.is_proposal_reachable;
    shown->scanner_zframe = self->plan.scanner_zframe;
    shown->scanner_target = self->plan.scanner_target;
    shown->entry = self->plan.entry;
    shown->seen_needle = self->plan.scanner_seen_needle;
    shown->proposed_registration = self->plan.proposed_registration;
    shown->proposed_entry = self->plan.proposed_entry;
    shown->proposed_target = self->plan.proposed_target;
    shown->registration_proposer_peer = self->plan.registration_proposer.peer;
    shown->registration_proposed_cycle = self->plan.registration_proposer.cycle;
    shown->entry_proposer_peer = self->plan.entry_proposer.peer;
    shown->entry_proposed_cycle = self->plan.entry_proposer.cycle;
    shown->target_proposer_peer = self->plan.target_proposer.peer;
    shown->target_proposed_cycle = self->plan.target_proposer.cycle;
    shown->scanner_desired = self->plan.scanner_desired;
    (void)memcpy(shown->desired_ticks, self->plan.desired_ticks, sizeof shown->desired_ticks);
    shown->is_entry_of_target = self->plan.is_entry_of_target;
    (void)memcpy(shown->target_ticks, self->plan.target_ticks, sizeof shown->target_ticks);
}

static void show_authority(const controller_t *self, snapshot_t *shown)
{
    const authority_t *const authority = &self->authority;
    shown->authority = (uint32_t)authority->chart.state;
    shown->holder = authority->sealed.holder.source;
    shown->holder_peer = authority->sealed.holder.peer;
    shown->held_since_cycle = authority->sealed.since_cycle;
    shown->request = authority->sealed.request;
    shown->request_axis = authority->sealed.request_axis;
    shown->requester = authority->sealed.requester.source;
    shown->requester_peer = authority->sealed.requester.peer;
    shown->request_left_us = authority_request_left_us(authority, self->sealed.time_us);
}

static void show_trajectory(const controller_t *self, snapshot_t *shown)
{
    const trajectory_list_t *const list = &self->mode.sealed.list;
    shown->trajectory_rows = (list->is_whole != 0U) ? list->count : 0U;
    shown->trajectory_crc = list->crc;
    shown->trajectory_source = list->source;
    shown->trajectory_row = self->mode.sealed.trajectory.row;
    shown->trajectory_time_us = self->mode.sealed.trajectory.time_us;
}

static void show_program(const controller_t *self, const cycle_t *cycle, snapshot_t *shown)
{
    const program_list_t *const list = &self->program;
    shown->program_steps = (list->is_whole != 0U) ? list->count : 0U;
    shown->program_crc = list->crc;
    shown->program_target_crc = list->target_crc;
    shown->program_source = list->source;
    shown->program_step = self->mode.sealed.program.step;
    shown->program_dwelt_us = self->mode.sealed.program.dwelt_us;
    shown->is_dose_reached = cycle->inputs->dose_reached;
    shown->is_treatment_stopped = cycle->inputs->treatment_stopped;
}

static status_t pose_status(const controller_t *self, bool is_homed)
{
    status_t status = STATUS_OK;
    if (controller_is_table_invalid(self)) {
        status = STATUS_MEMORY_DAMAGED;
    } else if (!is_homed) {
        status = STATUS_NOT_HOMED;
    } else if (self->plan.has_probe == 0U) {
        status = STATUS_NO_PROBE;
    } else if (self->plan.is_registered == 0U) {
        status = STATUS_NOT_REGISTERED;
    } else {
        /* Both are known. */
    }
    return status;
}

static void show_pose(const controller_t *self, const robot_t *robot, snapshot_t *shown)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    joints_t joints;
    shown->pose_status = (uint32_t)pose_status(self, shown->is_homed != 0U);
    if (controller_is_table_invalid(self)) {
        (void)memset(&shown->zframe_treatment, 0, sizeof shown->zframe_treatment);
        (void)memset(&shown->scanner_treatment, 0, sizeof shown->scanner_treatment);
        return;
    }
    controller_positions(self, ticks);
    joints_from_ticks(robot, ticks, &joints);
    kinematics_forward(robot, &self->plan.probe, &joints, &shown->zframe_treatment);
    rigid_multiply(&self->plan.scanner_zframe, &shown->zframe_treatment, &shown->scanner_treatment);
}

/* Shows the depth that a mode goes to, or the end of a jog that is armed. */
static void show_way(const controller_t *self, mode_kind_t kind, snapshot_t *shown)
{
    if (mode_aim_of((uint32_t)kind) == MODE_AIM_DEPTH) {
        for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
            shown->axes[i].target_ticks = self->plan.target_ticks[i];
        }
    } else if ((kind == MODE_JOG) && procedure_is_armed(&self->procedure)) {
        const mode_way_t *const way = &self->mode.request.sealed.way;
        /* Damaged memory is shown before it is repaired. */
        if (way->axis < self->sealed.axis_count) {
            shown->axes[way->axis].target_ticks = way->end_ticks;
        }
    } else {
        /* Each where its set-point is. */
    }
}

/* Shows the armed order and its progress. `kind`: the mode of the workphase. */
static void show_mode(const controller_t *self, mode_kind_t kind, snapshot_t *shown)
{
    mode_share_t share = {.done_per_mille = 0U, .left_ms = 0U};
    if (procedure_is_moving(&self->procedure)) {
        share = mode_share(&self->mode, kind, self->axes, self->sealed.axis_count);
    }
    shown->mode = (uint32_t)(procedure_is_armed(&self->procedure) ? kind : MODE_NONE);
    shown->done_per_mille = share.done_per_mille;
    shown->left_ms = share.left_ms;
}

/* Axes that the robot has not. */
static void clear_unused(const controller_t *self, snapshot_t *shown)
{
    clear_aligned_words((uint8_t *)&shown->axes[self->sealed.axis_count],
                        (ROBOT_AXIS_MAX - self->sealed.axis_count) * sizeof shown->axes[0]);
}

static void show_forces(const controller_t *self, const robot_t *robot, snapshot_t *shown)
{
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        const force_channel_config_t *const config = &robot->force.channels[i];
        const force_channel_t *const channel = &self->force.sealed.channels[i];
        snapshot_force_t *const force = &shown->forces[i];
        force->force_mn = self->force.sealed.force_mn[i];
        force->reading = channel->counts[0];
        force->zero_mn = force_channel_zero_mn(channel, config);
        force->noise_mn = force_channel_noise_mn(channel, config);
        force->is_zeroing = ((uint32_t)self->force.sealed.zeroing >> i) & 1U;
        force->doubts = channel->doubts;
    }
}

static void show_membranes(const membrane_watch_t *watch, snapshot_membranes_t *shown)
{
    const membrane_list_t *const list = &watch->plan.list;
    shown->left = 0U;
    for (uint32_t i = 0U; i < LIMIT_MEMBRANES_MOST; i++) {
        const membrane_t *const membrane = &list->membranes[i];
        const bool is_used = i < list->count;
        shown->membranes[i].depth_um = is_used ? membrane->depth_um : 0;
        shown->membranes[i].found_um = is_used ? membrane->found_um : 0;
        shown->membranes[i].state = is_used ? membrane->state : 0U;
        shown->left += (is_used && (membrane->state == (uint32_t)MEMBRANE_AHEAD)) ? 1U : 0U;
    }
    shown->count = list->count;
    shown->unexpected = list->unexpected;
    shown->sight = watch->sight;
    shown->depth_um = watch->depth_um;
    shown->least_fall_mn = watch->least_fall_mn;
}

static void show_steering(const controller_t *self, const cycle_t *cycle, mode_kind_t kind,
                          snapshot_t *shown)
{
    const steering_t *const steering = &self->plan.steering;
    shown->steering_method = steering->method;
    shown->steering_curvature_per_km = steering->curvature_per_km;
    shown->steering_direction_deg = steering->direction_deg;
    shown->steering_most_per_km = cycle->robot->steering.most_per_km;
    shown->is_rotation_awaited = 0U;
    if (procedure_is_moving(&self->procedure) &&
        mode_waits_for_rotation(&self->mode, kind, cycle->robot, self->axes)) {
        shown->is_rotation_awaited = 1U;
    }
}

void controller_look_ahead(controller_t *self, const cycle_t *cycle, uint32_t guards)
{
    if ((self->plan.has_target != 0U) && guards_have(guards, GUARD_HOMED) &&
        !procedure_is_moving(&self->procedure)) {
        int32_t ticks[ROBOT_AXIS_MAX];
        controller_positions(self, ticks);
        target_way_look(&self->way, cycle->robot, ticks, self->plan.target_ticks);
    }
}

/* Late or not: an interval is longer than a cycle by so much. */
static void show_lateness(const loop_lateness_t *lateness, snapshot_t *shown)
{
    shown->late_stage = lateness->longest_stage;
    shown->late_us =
        (lateness->longest_us > LIMIT_CYCLE_US) ? (lateness->longest_us - LIMIT_CYCLE_US) : 0U;
    shown->late_count = lateness->count;
    shown->late_span_us = lateness->span_us;
}

void controller_show(const controller_t *self, const cycle_t *cycle, uint32_t guards)
{
    snapshot_t *const shown = &cycle->outputs->snapshot;
    const mode_kind_t kind = mode_in(&self->mode, procedure_workphase(&self->procedure));
    shown->cycle = self->sealed.cycle;
    shown->time_us = self->sealed.time_us;
    shown->robot_crc = cycle->robot->crc;
    shown->axis_count = self->sealed.axis_count;
    shown->power_on = self->sealed.power_on;
    shown->positions_awaited = self->sealed.awaited;
    shown->workphase = (uint32_t)procedure_workphase(&self->procedure);
    shown->order = (uint32_t)self->procedure.arming.state;
    shown->pedal = (uint32_t)self->pedal.chart.state;
    shown->estop = (uint32_t)self->estop.state;
    shown->loop = (uint32_t)self->loop.chart.state;
    show_lateness(&self->loop.sealed.lateness, shown);
    shown->guards = guards;
    shown->is_homed = guards_have(guards, GUARD_HOMED) ? 1U : 0U;
    show_step(self, cycle, shown);
    shown->is_scanner_active = self->sealed.was_scanner_active;
    shown->unread_inputs = cycle->inputs->unread;
    shown->unfit = cycle->inputs->unfit;
    shown->unrecorded = self->unrecorded;
    shown->is_recorder_failing = cycle->inputs->is_recorder_failing;
    shown->recording_left_min = cycle->inputs->recording_left_min;
    shown->overruns = self->loop.sealed.overruns;
    shown->events = self->sealed.events;
    shown->events_lost = self->sealed.events_lost;
    show_mode(self, kind, shown);
    show_authority(self, shown);
    show_trajectory(self, shown);
    show_program(self, cycle, shown);
    show_plan(self, shown);
    show_pose(self, cycle->robot, shown);
    clear_unused(self, shown);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        show_axis(self, cycle, i);
    }
    if (cycle->robot->force.is_there != 0U) {
        show_forces(self, cycle->robot, shown);
        show_membranes(&self->membranes, &shown->membranes);
    } else {
        clear_aligned_words((uint8_t *)shown->forces, sizeof shown->forces);
        clear_aligned_words((uint8_t *)&shown->membranes, sizeof shown->membranes);
    }
    show_steering(self, cycle, kind, shown);
    show_way(self, kind, shown);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        show_card(self, cycle, slot);
    }
}

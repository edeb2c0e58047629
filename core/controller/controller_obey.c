/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_parts.h"

/* What a source may send. */
typedef struct {
    bool kinds[COMMAND_KIND_COUNT];
    bool workphases[WORKPHASE_COUNT];
} rights_t;

static bool is_hardware_ready(const controller_t *self, const controller_inputs_t *inputs)
{
    bool is_ready = (inputs->estop_open == 0U) && (inputs->pedal_a == inputs->pedal_b);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        is_ready = is_ready && link_is_healthy_now(&self->links[i]);
    }
    return is_ready;
}

/* What START_UP clears must be clear before a motion is armed. */
static bool is_able(const controller_t *self)
{
    bool is_every_part_able = (self->estop.state == ESTOP_LATCH_STATE_CLEAR) &&
                              (self->loop.chart.state != LOOP_GUARD_STATE_STOPPED) &&
                              (self->pedal.chart.state != PEDAL_GATE_STATE_FAULT);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        is_every_part_able = is_every_part_able && link_is_usable(&self->links[i]) &&
                             axis_is_enabled(&self->axes[i]);
    }
    return is_every_part_able;
}

static bool is_confirmation_due(const controller_t *self, const robot_t *robot)
{
    bool is_any_due = false;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        is_any_due = is_any_due || axis_needs_confirmation(&self->axes[i], &robot->axes[i]);
    }
    return is_any_due;
}

bool controller_is_homed(const controller_t *self)
{
    bool is_every_axis_homed = true;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        is_every_axis_homed = is_every_axis_homed && axis_is_homed(&self->axes[i]);
    }
    return is_every_axis_homed;
}

workphases_inputs_t controller_guards(const controller_t *self, const cycle_t *cycle)
{
    const workphases_inputs_t guards = {
        .is_hardware_ready = is_hardware_ready(self, cycle->inputs),
        .is_confirmation_due = is_confirmation_due(self, cycle->robot),
        .is_able = is_able(self),
        .is_homed = controller_is_homed(self),
        .is_registered = (self->plan.is_registered != 0U),
        .has_target = (self->plan.has_target != 0U),
    };
    return guards;
}

static answer_t *add_answer(const controller_t *self, const cycle_t *cycle)
{
    answer_t *const answer = &cycle->outputs->answers[cycle->outputs->answer_count];
    cycle->outputs->answer_count++;
    answer->workphase = (uint32_t)workphase_present(&self->workphases);
    rigid_set_identity(&answer->pose);
    return answer;
}

/* Ends the pending long command, if there is one. */
static void answer_pending(controller_t *self, const cycle_t *cycle, answer_kind_t kind,
                           status_t status)
{
    if (self->pending.is_waiting == 0U) {
        return;
    }
    self->pending.is_waiting = 0U;
    answer_t *const answer = add_answer(self, cycle);
    answer->id = self->pending.id;
    answer->source = self->pending.source;
    answer->command = self->pending.kind;
    answer->argument = self->pending.argument;
    answer->kind = (uint32_t)kind;
    answer->status = (uint32_t)status;
    answer->is_final = 1U;
}

static void end_order(controller_t *self)
{
    self->is_profile_running = 0U;
    self->settled_cycles = 0U;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        axis_stop_homing(&self->axes[i]);
    }
}

void controller_abandon_order(controller_t *self, const cycle_t *cycle)
{
    answer_pending(self, cycle, ANSWER_ABORTED, STATUS_FAULT_PRESENT);
    end_order(self);
}

void controller_report_order(controller_t *self, const cycle_t *cycle, uint32_t actions,
                             status_t fault)
{
    if ((actions & WORKPHASES_ACTION_REPORT_DISCARDED) != 0U) {
        controller_note(self, cycle, EVENT_ORDER_DISCARDED, 0U, (int32_t)fault);
        answer_pending(self, cycle, ANSWER_ABORTED, fault);
        end_order(self);
    }
    if ((actions & WORKPHASES_ACTION_REPORT_EXPIRED) != 0U) {
        controller_note(self, cycle, EVENT_ORDER_EXPIRED, 0U, 0);
        answer_pending(self, cycle, ANSWER_ABORTED, STATUS_EXPIRED);
        end_order(self);
    }
    if ((actions & WORKPHASES_ACTION_REPORT_DONE) != 0U) {
        controller_note(self, cycle, EVENT_ORDER_DONE, 0U, 0);
        self->is_order_done = 1U;
        answer_pending(self, cycle, ANSWER_DONE, STATUS_OK);
        end_order(self);
    }
    if ((actions & WORKPHASES_ACTION_RENEW_PEDAL) != 0U) {
        self->is_order_done = 0U;
        pedal_gate_renew(&self->pedal);
        controller_note(self, cycle, EVENT_ORDER_ARMED,
                        (uint32_t)workphase_present(&self->workphases), 0);
    }
}

void controller_tell_order(controller_t *self, const cycle_t *cycle, workphases_event_t event,
                           status_t fault)
{
    const workphases_inputs_t guards = controller_guards(self, cycle);
    const workphase_t before = workphase_present(&self->workphases);
    const uint32_t actions = workphases_chart_dispatch(&self->workphases, &guards, event);
    controller_report_order(self, cycle, actions, fault);
    if (workphase_present(&self->workphases) != before) {
        controller_note(self, cycle, EVENT_WORKPHASE,
                        (uint32_t)workphase_present(&self->workphases), 0);
    }
}

void controller_fail_order(controller_t *self, const cycle_t *cycle, event_cause_t cause,
                           uint32_t peer)
{
    controller_because(self, cause, peer);
    controller_tell_order(self, cycle, WORKPHASES_EVENT_FAULT, STATUS_FAULT_PRESENT);
    controller_because(self, EVENT_CAUSE_NONE, 0U);
}

/* START_UP is the operator's act that clears what was latched. */
static void begin_start_up(controller_t *self, const cycle_t *cycle)
{
    const estop_latch_state_t before = self->estop.state;
    estop_latch_reset(&self->estop);
    if (self->estop.state != before) {
        controller_note(self, cycle, EVENT_ESTOP_CLEARED, 0U, 0);
    }
    pedal_gate_reset(&self->pedal);
    loop_guard_reset(&self->loop);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        link_reset(&self->links[i]);
        axis_enable(&self->axes[i], !link_is_usable(&self->links[i]));
    }
}

static void remember_pending(controller_t *self, const command_t *command)
{
    self->pending.id = command->id;
    self->pending.source = command->source;
    self->pending.kind = command->kind;
    self->pending.argument = command->argument;
    self->pending.is_waiting = 1U;
}

static status_t obey_workphase(controller_t *self, const cycle_t *cycle, const command_t *command,
                               uint32_t *is_final)
{
    uint32_t actions = 0U;
    if ((command->argument == (uint32_t)WORKPHASE_MOVE_TO_TARGET) &&
        !plan_is_proved(&self->plan, cycle->robot)) {
        plan_forget_target(&self->plan);
        return STATUS_MEMORY_DAMAGED;
    }
    const workphases_inputs_t guards = controller_guards(self, cycle);
    const status_t status =
        workphase_request(&self->workphases, &guards, command->argument, &actions);
    controller_report_order(self, cycle, actions, STATUS_DISCARDED);
    if (status != STATUS_OK) {
        return status;
    }
    controller_note(self, cycle, EVENT_WORKPHASE, command->argument, 0);
    if ((actions & WORKPHASES_ACTION_BEGIN_START_UP) != 0U) {
        begin_start_up(self, cycle);
    }
    if ((actions & WORKPHASES_ACTION_RENEW_PEDAL) != 0U) {
        remember_pending(self, command);
        *is_final = 0U;
    }
    return STATUS_OK;
}

static status_t obey_jog(controller_t *self, const cycle_t *cycle, const command_t *command,
                         answer_t *answer)
{
    uint32_t actions = 0U;
    status_t status = controller_judge_jog(self, cycle->robot, command, answer);
    if (status != STATUS_OK) {
        return status;
    }
    const workphases_inputs_t guards = controller_guards(self, cycle);
    status = workphase_request_jog(&self->workphases, &guards, &actions);
    controller_report_order(self, cycle, actions, STATUS_DISCARDED);
    if (status == STATUS_OK) {
        self->jog_axis = command->argument;
        self->jog_ticks = command->value;
        remember_pending(self, command);
        answer->is_final = 0U;
    }
    return status;
}

static status_t obey_registration(controller_t *self, const cycle_t *cycle,
                                  const command_t *command)
{
    if (workphase_present(&self->workphases) != WORKPHASE_CALIBRATION) {
        return STATUS_WRONG_WORKPHASE;
    }
    const status_t status = plan_register(&self->plan, cycle->robot, &command->pose);
    if (status == STATUS_OK) {
        controller_note(self, cycle, EVENT_REGISTERED, 0U, 0);
    }
    return status;
}

static status_t obey_target(controller_t *self, const cycle_t *cycle, const command_t *command,
                            answer_t *answer)
{
    if (workphase_present(&self->workphases) != WORKPHASE_TARGETING) {
        return STATUS_WRONG_WORKPHASE;
    }
    const solution_t result = plan_set_target(&self->plan, cycle->robot, &command->pose);
    answer->axis = (uint32_t)result.axis;
    answer->is_maximum = (uint32_t)result.is_maximum;
    if (result.status == STATUS_OK) {
        answer->pose = self->plan.scanner_target;
        controller_note(self, cycle, EVENT_TARGET_ACCEPTED, 0U, 0);
    }
    return result.status;
}

static status_t obey_proposal(controller_t *self, const cycle_t *cycle, const command_t *command)
{
    status_t status = STATUS_OK;
    if (command->kind == (uint32_t)COMMAND_PROPOSE_REGISTRATION) {
        status = plan_propose_registration(&self->plan, cycle->robot, &command->pose);
    } else if (command->kind == (uint32_t)COMMAND_PROPOSE_ENTRY) {
        status = plan_propose_entry(&self->plan, cycle->robot, &command->pose.translation);
    } else {
        status = plan_propose_target(&self->plan, cycle->robot, &command->pose.translation);
    }
    if (status == STATUS_OK) {
        controller_note(self, cycle, EVENT_PROPOSAL, command->kind, 0);
    }
    return status;
}

static bool is_known(const command_t *command)
{
    const bool is_workphase = command->kind == (uint32_t)COMMAND_WORKPHASE;
    return (command->kind > (uint32_t)COMMAND_NONE) && (command->kind < COMMAND_KIND_COUNT) &&
           (!is_workphase || ((command->argument > (uint32_t)WORKPHASE_UNDEFINED) &&
                              (command->argument < WORKPHASE_COUNT)));
}

/* What is not known at all is left to be refused as unknown. */
static bool is_allowed(const command_t *command)
{
    static const rights_t rights[COMMAND_SOURCE_COUNT] = {
        [COMMAND_SOURCE_IGTL] = {.kinds = {[COMMAND_REGISTRATION] = true,
                                           [COMMAND_TARGET] = true,
                                           [COMMAND_PROPOSE_REGISTRATION] = true,
                                           [COMMAND_PROPOSE_ENTRY] = true,
                                           [COMMAND_PROPOSE_TARGET] = true},
                                 .workphases = {[WORKPHASE_START_UP] = true,
                                                [WORKPHASE_PLANNING] = true,
                                                [WORKPHASE_CALIBRATION] = true,
                                                [WORKPHASE_TARGETING] = true,
                                                [WORKPHASE_MOVE_TO_TARGET] = true,
                                                [WORKPHASE_MANUAL] = true,
                                                [WORKPHASE_STOP] = true,
                                                [WORKPHASE_EMERGENCY] = true}},
        [COMMAND_SOURCE_HTTP] = {.kinds = {[COMMAND_JOG] = true},
                                 .workphases = {[WORKPHASE_STOP] = true}}};
    bool is_right = false;
    if (command->source >= COMMAND_SOURCE_COUNT) {
        is_right = false;
    } else if (is_known(command)) {
        is_right = (command->kind == (uint32_t)COMMAND_WORKPHASE)
                       ? rights[command->source].workphases[command->argument]
                       : rights[command->source].kinds[command->kind];
    } else {
        is_right = true;
    }
    return is_right;
}

/* Changes of the workphase that drive nothing do without the robot's table. */
static bool needs_table(const command_t *command)
{
    return (command->kind != (uint32_t)COMMAND_WORKPHASE) ||
           (command->argument == (uint32_t)WORKPHASE_START_UP);
}

static status_t obey(controller_t *self, const cycle_t *cycle, const command_t *command,
                     answer_t *answer)
{
    status_t status = STATUS_UNKNOWN_COMMAND;
    if (!is_allowed(command)) {
        return STATUS_NOT_ALLOWED;
    }
    if (controller_is_blind(self) && needs_table(command)) {
        return STATUS_MEMORY_DAMAGED;
    }
    switch (command->kind) {
    case (uint32_t)COMMAND_WORKPHASE:
        status = obey_workphase(self, cycle, command, &answer->is_final);
        break;
    case (uint32_t)COMMAND_REGISTRATION:
        status = obey_registration(self, cycle, command);
        break;
    case (uint32_t)COMMAND_TARGET:
        status = obey_target(self, cycle, command, answer);
        break;
    case (uint32_t)COMMAND_PROPOSE_REGISTRATION:
    case (uint32_t)COMMAND_PROPOSE_ENTRY:
    case (uint32_t)COMMAND_PROPOSE_TARGET:
        status = obey_proposal(self, cycle, command);
        break;
    case (uint32_t)COMMAND_JOG:
        status = obey_jog(self, cycle, command, answer);
        break;
    default:
        status = STATUS_UNKNOWN_COMMAND;
        break;
    }
    return status;
}

static event_cause_t cause_of(const command_t *command)
{
    return (command->source == (uint32_t)COMMAND_SOURCE_HTTP) ? EVENT_CAUSE_CONSOLE
                                                              : EVENT_CAUSE_IGTL;
}

void controller_obey(controller_t *self, const cycle_t *cycle)
{
    for (uint32_t i = 0U; i < cycle->inputs->command_count; i++) {
        const command_t *const command = &cycle->inputs->commands[i];
        controller_because(self, cause_of(command), command->peer);
        answer_t draft = {.id = command->id,
                          .source = command->source,
                          .command = command->kind,
                          .argument = command->argument,
                          .is_final = 1U};
        rigid_set_identity(&draft.pose);
        const status_t status = obey(self, cycle, command, &draft);
        draft.kind = (status == STATUS_OK) ? (uint32_t)ANSWER_ACCEPTED : (uint32_t)ANSWER_REFUSED;
        draft.status = (uint32_t)status;
        draft.workphase = (uint32_t)workphase_present(&self->workphases);
        if (status != STATUS_OK) {
            controller_note(self, cycle, EVENT_COMMAND_REFUSED, command->kind, (int32_t)status);
        }
        *add_answer(self, cycle) = draft;
    }
    controller_because(self, EVENT_CAUSE_NONE, 0U);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_order.h"

#include "controller/controller_facts.h"
#include "procedure/command_kinds.h"

answer_t *controller_add_answer(const controller_t *self, const cycle_t *cycle)
{
    answer_t *const answer = &cycle->outputs->answers[cycle->outputs->answer_count];
    cycle->outputs->answer_count++;
    answer->workphase = (uint32_t)procedure_workphase(&self->procedure);
    return answer;
}

void controller_blame(answer_t *answer, const solution_t *judged)
{
    if (judged->status != STATUS_OK) {
        answer_refuse(answer, (uint32_t)judged->status, judged->axis, judged->is_maximum);
    }
}

static void begin_account(controller_t *self, const cycle_t *cycle)
{
    if (self->sealed.account_state == (uint32_t)HOMING_ACCOUNT_EMPTY) {
        homing_account_init(&self->account);
        self->sealed.account_state = (uint32_t)HOMING_ACCOUNT_OPEN;
    }
    homing_account_begin(&self->account, cycle->robot, self->axes);
}

void controller_arm(controller_t *self, const cycle_t *cycle, const command_t *command,
                    mode_kind_t kind, const mode_request_t *request)
{
    mode_begin(&self->mode, kind, request);
    if (kind == MODE_HOMING) {
        begin_account(self, cycle);
    }
    self->sealed.has_arrived = 0U;
    controller_note(self, cycle, EVENT_ORDER_ARMED, (uint32_t)kind,
                    (int32_t)procedure_workphase(&self->procedure));
    self->sealed.pending.id = command->id;
    self->sealed.pending.source = command->source;
    self->sealed.pending.kind = command->kind;
    self->sealed.pending.asked = (uint32_t)command_kinds_workphase(command);
    self->sealed.pending.is_waiting = 1U;
}

/* Ends the pending long command, if there is one. */
static void answer_pending(controller_t *self, const cycle_t *cycle, answer_kind_t kind,
                           status_t status)
{
    if (self->sealed.pending.is_waiting == 0U) {
        return;
    }
    self->sealed.pending.is_waiting = 0U;
    answer_t *const answer = controller_add_answer(self, cycle);
    answer->id = self->sealed.pending.id;
    answer->source = self->sealed.pending.source;
    answer->command = self->sealed.pending.kind;
    answer->asked = self->sealed.pending.asked;
    answer->kind = (uint32_t)kind;
    answer->status = (uint32_t)status;
    answer->is_final = 1U;
    if (kind == ANSWER_ABORTED) {
        answer->as.ended.axis = (cycle->cause == EVENT_CAUSE_AXIS) ? cycle->peer : ROBOT_AXIS_MAX;
    }
}

void controller_abandon_order(controller_t *self, const cycle_t *cycle)
{
    answer_pending(self, cycle, ANSWER_ABORTED, STATUS_FAULT_PRESENT);
    mode_stop(&self->mode, self->axes, self->sealed.axis_count);
}

static void count_vain_start_up(controller_t *self, const cycle_t *cycle)
{
    self->sealed.vain_start_ups++;
    homing_account_charge(&self->account, cycle->robot, self->axes, self->sealed.vain_axis);
    if ((self->sealed.vain_start_ups >= LIMIT_SERVICE_START_UPS) &&
        homing_account_is_beyond(&self->account, cycle->robot)) {
        self->sealed.account_state = (uint32_t)HOMING_ACCOUNT_SPENT;
    }
}

/* An axis or a card has ended START_UP or a move; what it was, was noted just before. */
static void count_vain(controller_t *self, const cycle_t *cycle)
{
    const bool is_of_axis = cycle->cause == EVENT_CAUSE_AXIS;
    const bool is_of_card = cycle->cause == EVENT_CAUSE_CARD;
    const bool is_homing = self->mode.sealed.kind == (uint32_t)MODE_HOMING;
    const bool is_move = self->mode.sealed.kind == (uint32_t)MODE_MOVE;
    if ((!is_homing && !is_move) || (!is_of_axis && !is_of_card)) {
        return;
    }
    self->sealed.vain_axis = is_of_axis ? cycle->peer : ROBOT_AXIS_MAX;
    self->sealed.vain_card = is_of_card ? cycle->peer : CARD_SLOT_COUNT;
    self->sealed.vain_event = self->last_event;
    if (is_homing) {
        count_vain_start_up(self, cycle);
    } else {
        self->sealed.vain_moves++;
    }
}

static void close_account(controller_t *self)
{
    self->sealed.vain_start_ups = 0U;
    self->sealed.account_state = (uint32_t)HOMING_ACCOUNT_EMPTY;
}

/* Moves that fail between START_UPs add up until service has been called. */
static void close_moves(controller_t *self)
{
    const bool is_served = (self->mode.sealed.kind == (uint32_t)MODE_HOMING) &&
                           (self->sealed.vain_moves >= LIMIT_SERVICE_MOVES);
    if (is_served || (self->mode.sealed.kind == (uint32_t)MODE_MOVE)) {
        self->sealed.vain_moves = 0U;
    }
}

void controller_renew_account(controller_t *self)
{
    if (controller_is_spent(self)) {
        close_account(self);
    }
}

void controller_be_mended(controller_t *self, const cycle_t *cycle)
{
    controller_note(self, cycle, EVENT_MENDED, 0U, 0);
    close_account(self);
    self->sealed.vain_moves = 0U;
}

void controller_report_order(controller_t *self, const cycle_t *cycle, uint32_t actions,
                             status_t fault)
{
    if ((actions & ARMING_ACTION_REPORT_DISCARDED) != 0U) {
        count_vain(self, cycle);
        controller_note(self, cycle, EVENT_ORDER_DISCARDED, self->mode.sealed.kind, (int32_t)fault);
        answer_pending(self, cycle, ANSWER_ABORTED, fault);
        mode_stop(&self->mode, self->axes, self->sealed.axis_count);
    }
    if ((actions & ARMING_ACTION_REPORT_EXPIRED) != 0U) {
        controller_note(self, cycle, EVENT_ORDER_EXPIRED, self->mode.sealed.kind, 0);
        answer_pending(self, cycle, ANSWER_ABORTED, STATUS_EXPIRED);
        mode_stop(&self->mode, self->axes, self->sealed.axis_count);
    }
    if ((actions & ARMING_ACTION_REPORT_DONE) != 0U) {
        controller_note(self, cycle, EVENT_ORDER_DONE, self->mode.sealed.kind, 0);
        const mode_aim_t aim = mode_aim_of(self->mode.sealed.kind);
        if ((aim == MODE_AIM_DEPTH) || (aim == MODE_AIM_STEPS)) {
            self->sealed.has_arrived = 1U;
        }
        if (self->mode.sealed.kind == (uint32_t)MODE_HOMING) {
            close_account(self);
        }
        close_moves(self);
        answer_pending(self, cycle, ANSWER_DONE, STATUS_OK);
        mode_stop(&self->mode, self->axes, self->sealed.axis_count);
    }
    if ((actions & ARMING_ACTION_RENEW_PEDAL) != 0U) {
        pedal_gate_renew(&self->pedal);
    }
}

void controller_notify_order(controller_t *self, const cycle_t *cycle, arming_event_t event,
                             status_t fault)
{
    controller_report_order(self, cycle, procedure_notify(&self->procedure, event), fault);
}

void controller_enter_emergency(controller_t *self, const cycle_t *cycle)
{
    const workphase_t before = procedure_workphase(&self->procedure);
    controller_report_order(self, cycle, procedure_estop(&self->procedure), STATUS_DISCARDED);
    if (procedure_workphase(&self->procedure) != before) {
        controller_note(self, cycle, EVENT_WORKPHASE,
                        (uint32_t)procedure_workphase(&self->procedure), 0);
    }
}

void controller_fail_order(controller_t *self, const cycle_t *cycle, event_cause_t cause,
                           uint32_t peer)
{
    const cycle_t because = controller_with_cause(cycle, cause, peer);
    controller_notify_order(self, &because, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
}

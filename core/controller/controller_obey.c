/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_obey.h"

#include "controller/controller_aim.h"
#include "controller/controller_authority.h"
#include "controller/controller_axis.h"
#include "controller/controller_facts.h"
#include "controller/controller_motion.h"
#include "controller/controller_order.h"
#include "controller/controller_plan.h"
#include "controller/controller_program.h"
#include "controller/controller_restore.h"
#include "controller/controller_trajectory.h"
#include "controller/controller_values.h"
#include "interface/note_kind.h"

#include <string.h>

/* What a source may send. */
static const bool rights[COMMAND_SOURCE_COUNT][COMMAND_KIND_COUNT] = {
    [COMMAND_SOURCE_IGTL] = {[COMMAND_WORKPHASE] = true,     [COMMAND_REGISTRATION] = true,
                             [COMMAND_TARGET] = true,        [COMMAND_PROPOSE_REGISTRATION] = true,
                             [COMMAND_PROPOSE_ENTRY] = true, [COMMAND_PROPOSE_TARGET] = true,
                             [COMMAND_RETRACT] = true,       [COMMAND_ALIGN] = true,
                             [COMMAND_INSERT] = true,        [COMMAND_POSE] = true,
                             [COMMAND_NEEDLE] = true,        [COMMAND_ENTRY] = true,
                             [COMMAND_ACCEPT_ENTRY] = true,  [COMMAND_WITHDRAW] = true,
                             [COMMAND_RELEASE] = true,       [COMMAND_JOG] = true,
                             [COMMAND_JOG_BY] = true,        [COMMAND_VELOCITY] = true,
                             [COMMAND_PROBE] = true,         [COMMAND_SWEEP] = true,
                             [COMMAND_LIST_BEGIN] = true,    [COMMAND_LIST_ROW] = true,
                             [COMMAND_LIST_END] = true,      [COMMAND_RUN_TRAJECTORY] = true,
                             [COMMAND_PROGRAM_BEGIN] = true, [COMMAND_PROGRAM_STEP] = true,
                             [COMMAND_PROGRAM_END] = true,   [COMMAND_RUN_PROGRAM] = true},
    [COMMAND_SOURCE_HTTP] = {
        [COMMAND_WORKPHASE] = true,      [COMMAND_REGISTRATION] = true,
        [COMMAND_TARGET] = true,         [COMMAND_JOG] = true,
        [COMMAND_RETRACT] = true,        [COMMAND_ALIGN] = true,
        [COMMAND_INSERT] = true,         [COMMAND_POSE] = true,
        [COMMAND_ENTRY] = true,          [COMMAND_ACCEPT_ENTRY] = true,
        [COMMAND_WITHDRAW] = true,       [COMMAND_LIST_BEGIN] = true,
        [COMMAND_LIST_ROW] = true,       [COMMAND_LIST_END] = true,
        [COMMAND_RUN_TRAJECTORY] = true, [COMMAND_TAKE] = true,
        [COMMAND_RENEW] = true,          [COMMAND_RELEASE] = true,
        [COMMAND_REQUEST] = true,        [COMMAND_RESTORE] = true,
        [COMMAND_NOTE] = true,           [COMMAND_HOME_AXIS] = true,
        [COMMAND_CLEAR_AXIS] = true,     [COMMAND_CONFIRM_AXIS] = true,
        [COMMAND_SET_HOME] = true,       [COMMAND_VELOCITY] = true,
        [COMMAND_PROBE] = true,          [COMMAND_JOG_BY] = true,
        [COMMAND_ENABLE_AXIS] = true,    [COMMAND_DISABLE_AXIS] = true,
        [COMMAND_PROGRAM_BEGIN] = true,  [COMMAND_PROGRAM_STEP] = true,
        [COMMAND_PROGRAM_END] = true,    [COMMAND_RUN_PROGRAM] = true,
        [COMMAND_SWEEP] = true,          [COMMAND_ACCEPT_NO_BLACK_BOX] = true}};

/* START_UP is the operator's act that clears what was latched. */
static void begin_start_up(controller_t *self, const cycle_t *cycle)
{
    const estop_latch_state_t before = self->estop.state;
    self->is_box_settled = 1U;
    estop_latch_reset(&self->estop);
    if (self->estop.state != before) {
        controller_note(self, cycle, EVENT_ESTOP_CLEARED, 0U, 0);
    }
    pedal_gate_reset(&self->pedal);
    loop_guard_reset(&self->loop);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        link_t *const link = &self->links[self->cards.slots[i]];
        link_reset(link);
        axis_enable(&self->axes[i], !link_is_usable(link));
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (((self->cards.sensor_slots >> slot) & 1U) != 0U) {
            link_reset(&self->links[slot]);
        }
    }
}

/*
 * Nothing is accepted ahead: what is recorded now may be missing when START_UP comes.
 *
 * @satisfies SWR-CMD-006
 */
static status_t accept_no_box(controller_t *self, const cycle_t *cycle)
{
    if (!controller_lacks_box(self, cycle)) {
        return STATUS_BLACK_BOX_THERE;
    }
    self->is_box_settled = 1U;
    controller_note(self, cycle, EVENT_NO_BLACK_BOX_ACCEPTED, 0U, 0);
    return STATUS_OK;
}

/* What a command for a workphase asks the mode of that workphase for: the target, if it is a move.
 */
static mode_request_t request_of(const controller_t *self, const cycle_t *cycle, mode_kind_t kind)
{
    mode_request_t request = {.axes = mode_axes(kind, 0U, cycle->robot)};
    (void)memcpy(request.move.target_ticks, self->plan.target_ticks,
                 sizeof request.move.target_ticks);
    return request;
}

static status_t obey_workphase(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer)
{
    procedure_actions_t actions;
    if (command->argument == (uint32_t)WORKPHASE_MOVE_TO_TARGET) {
        const solution_t judged = controller_judge_way(self, cycle);
        answer->is_maximum = (uint32_t)judged.is_maximum;
        if (judged.status != STATUS_OK) {
            return judged.status;
        }
    }
    const mode_kind_t kind = mode_of((workphase_t)command->argument);
    const mode_request_t request = request_of(self, cycle, kind);
    const workphase_inputs_t guards = controller_guards(self, cycle, kind, request.axes);
    const workphase_t before = procedure_workphase(&self->procedure);
    const status_t status =
        procedure_request(&self->procedure, &guards, command->argument, &actions);
    controller_report_order(self, cycle, actions.arming, STATUS_DISCARDED);
    if (status != STATUS_OK) {
        return status;
    }
    if (procedure_workphase(&self->procedure) != before) {
        controller_note(self, cycle, EVENT_WORKPHASE, command->argument, 0);
    }
    if ((actions.workphase & WORKPHASE_ACTION_BEGIN_START_UP) != 0U) {
        begin_start_up(self, cycle);
    }
    if ((actions.arming & ARMING_ACTION_RENEW_PEDAL) != 0U) {
        controller_arm(self, cycle, command, kind, &request);
        answer->is_final = 0U;
    }
    return STATUS_OK;
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
    return (command->source < COMMAND_SOURCE_COUNT) &&
           (!is_known(command) || rights[command->source][command->kind]);
}

static status_t carry_out(controller_t *self, const cycle_t *cycle, const command_t *command,
                          answer_t *answer)
{
    status_t status = STATUS_UNKNOWN_COMMAND;
    if (mode_of_command(command->kind) != MODE_NONE) {
        return controller_obey_motion(self, cycle, command, answer);
    }
    switch (command->kind) {
    case (uint32_t)COMMAND_WORKPHASE:
        status = obey_workphase(self, cycle, command, answer);
        break;
    case (uint32_t)COMMAND_CLEAR_AXIS:
    case (uint32_t)COMMAND_CONFIRM_AXIS:
    case (uint32_t)COMMAND_SET_HOME:
    case (uint32_t)COMMAND_ENABLE_AXIS:
    case (uint32_t)COMMAND_DISABLE_AXIS:
        status = controller_obey_axis(self, cycle, command);
        break;
    case (uint32_t)COMMAND_TAKE:
    case (uint32_t)COMMAND_RENEW:
    case (uint32_t)COMMAND_RELEASE:
    case (uint32_t)COMMAND_REQUEST:
        status = controller_obey_authority(self, cycle, command);
        break;
    case (uint32_t)COMMAND_ACCEPT_NO_BLACK_BOX:
        status = accept_no_box(self, cycle);
        break;
    case (uint32_t)COMMAND_RESTORE:
        status = controller_obey_restore(self, cycle, command, answer);
        break;
    case (uint32_t)COMMAND_LIST_BEGIN:
    case (uint32_t)COMMAND_LIST_ROW:
    case (uint32_t)COMMAND_LIST_END:
        status = controller_obey_trajectory(self, cycle, command, answer);
        break;
    case (uint32_t)COMMAND_PROGRAM_BEGIN:
    case (uint32_t)COMMAND_PROGRAM_STEP:
    case (uint32_t)COMMAND_PROGRAM_END:
        status = controller_obey_program(self, cycle, command, answer);
        break;
    default:
        status = controller_tell_plan(self, cycle, command, answer);
        break;
    }
    return status;
}

static status_t obey_note(controller_t *self, const cycle_t *cycle, const command_t *command)
{
    if (command->argument >= NOTE_KIND_COUNT) {
        return STATUS_UNKNOWN_COMMAND;
    }
    const bool is_refusal = command->argument == (uint32_t)NOTE_LOGIN_REFUSED;
    controller_note(self, cycle, is_refusal ? EVENT_LOGIN_REFUSED : EVENT_NOTE, command->argument,
                    command->value);
    return STATUS_OK;
}

/* What only START_UP clears must not stay for ever where START_UP is refused: the needle has to
 * come out. */
static void clear_only(controller_t *self, const cycle_t *cycle, const command_t *command)
{
    if ((command->kind == (uint32_t)COMMAND_WORKPHASE) &&
        guards_have(controller_facts(self, cycle), GUARD_HARDWARE_READY) &&
        !procedure_is_armed(&self->procedure)) {
        begin_start_up(self, cycle);
    }
}

static status_t obey(controller_t *self, const cycle_t *cycle, const command_t *command,
                     answer_t *answer)
{
    if (!is_allowed(command)) {
        return STATUS_NOT_ALLOWED;
    }
    if (command->kind == (uint32_t)COMMAND_NOTE) {
        return obey_note(self, cycle, command); /* Everyone's, and no sign of life of anybody. */
    }
    if (is_known(command) && !controller_has_authority(self, command)) {
        return STATUS_NO_AUTHORITY;
    }
    const status_t barred =
        guards_bar(controller_bars(self, cycle), command->kind, command->argument);
    if (barred == STATUS_MOVED_IN_VAIN) {
        clear_only(self, cycle, command);
    }
    if (barred != STATUS_OK) {
        return barred;
    }
    const status_t status = carry_out(self, cycle, command, answer);
    if (status == STATUS_OK) {
        controller_credit(self, cycle, command);
    }
    return status;
}

static void note_refusal(controller_t *self, const cycle_t *cycle, const command_t *command,
                         status_t status)
{
    if (controller_is_unlogged(command)) {
        return;
    }
    if (status == STATUS_NO_AUTHORITY) {
        controller_note(self, cycle, EVENT_AUTHORITY_REFUSED, command->kind, 0);
    } else {
        controller_note(self, cycle, EVENT_COMMAND_REFUSED, command->kind, (int32_t)status);
    }
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
        draft.workphase = (uint32_t)procedure_workphase(&self->procedure);
        if (status != STATUS_OK) {
            note_refusal(self, cycle, command, status);
        }
        controller_note_values(self, cycle, command, &draft);
        *controller_add_answer(self, cycle) = draft;
    }
    controller_because(self, EVENT_CAUSE_NONE, 0U);
}

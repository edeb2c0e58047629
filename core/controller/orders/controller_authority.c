/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_authority.h"

#include "controller/controller_order.h"
#include "procedure/command_kinds.h"

static authority_time_t now_of(const controller_t *self)
{
    const authority_time_t now = {.cycle = self->sealed.cycle, .time_us = self->sealed.time_us};
    return now;
}

static authority_party_t party_of(const command_t *command)
{
    const authority_party_t party = {.source = command->source, .peer = command->peer};
    return party;
}

static void note_taken(controller_t *self, const cycle_t *cycle)
{
    controller_note(self, cycle, EVENT_AUTHORITY_TAKEN, self->authority.sealed.holder.peer,
                    (int32_t)self->authority.sealed.holder.source);
}

/* The order of the party that has lost it is discarded: the pedal must be pressed anew for another
 * one. */
static void lose(controller_t *self, const cycle_t *cycle, authority_loss_t loss)
{
    const uint32_t peer = self->authority.sealed.holder.peer;
    const uint32_t actions = authority_lose(&self->authority, self->sealed.time_us);
    if ((actions & AUTHORITY_ACTION_DISCARD_ORDER) != 0U) {
        controller_note(self, cycle, EVENT_AUTHORITY_LOST, peer, (int32_t)loss);
        controller_notify_order(self, cycle, ARMING_EVENT_DISCARD, STATUS_NO_AUTHORITY);
    }
}

static bool are_axes_at_rest(const controller_t *self)
{
    bool is_every_one = true;
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        is_every_one = is_every_one && (self->axes[i].sealed.encoder.speed_ticks_per_s_q8 == 0);
    }
    return is_every_one;
}

static bool is_silent(const cycle_t *cycle, const authority_party_t *party)
{
    const uint32_t bit = (uint32_t)1U << (party->source % COMMAND_SOURCE_COUNT);
    return (party->peer != 0U) && ((cycle->inputs->silent_sources & bit) != 0U);
}

void controller_end_request(controller_t *self)
{
    authority_forget_request(&self->authority);
    confirm_button_renew(&self->confirm);
}

static void observe_request(controller_t *self, const cycle_t *cycle)
{
    const bool is_over = (self->authority.sealed.request != (uint32_t)AUTHORITY_REQUEST_GRANTED) &&
                         (authority_request_left_us(&self->authority, self->sealed.time_us) == 0U);
    if (is_over || is_silent(cycle, &self->authority.sealed.requester)) {
        controller_end_request(self);
    }
}

static void observe_holder(controller_t *self, const cycle_t *cycle)
{
    if (is_silent(cycle, &self->authority.sealed.holder)) {
        lose(self, cycle, AUTHORITY_LOSS_SILENT);
    } else if (authority_is_unrenewed(&self->authority, self->sealed.time_us)) {
        lose(self, cycle, AUTHORITY_LOSS_UNRENEWED);
    } else {
        /* It lives. */
    }
}

void controller_observe_authority(controller_t *self, const cycle_t *cycle)
{
    if (authority_check(&self->authority)) {
        controller_note(self, cycle, EVENT_CHART_REPAIRED, (uint32_t)EVENT_CHART_AUTHORITY, 0);
        confirm_button_renew(&self->confirm);
        controller_notify_order(self, cycle, ARMING_EVENT_FAULT, STATUS_FAULT_PRESENT);
    }
    const bool is_at_rest = authority_is_ending(&self->authority) && are_axes_at_rest(self);
    if (authority_step(&self->authority, is_at_rest, cycle->inputs->elapsed_us, now_of(self))) {
        note_taken(self, cycle);
    }
    observe_holder(self, cycle);
    if (self->authority.sealed.requester.peer != 0U) {
        observe_request(self, cycle);
    }
}

static bool is_everyones(const command_t *command)
{
    bool is_free = true;
    switch (command->kind) {
    case (uint32_t)COMMAND_WORKPHASE:
        is_free = command_kinds_is_stop(command);
        break;
    case (uint32_t)COMMAND_WITHDRAW:
        is_free = (command->source == (uint32_t)COMMAND_SOURCE_IGTL) &&
                  (command_as_withdrawal(command)->of != (uint32_t)COMMAND_ENTRY);
        break;
    case (uint32_t)COMMAND_REQUEST:
        is_free = command_as_request(command)->request != (uint32_t)AUTHORITY_REQUEST_CONFIRM;
        break;
    case (uint32_t)COMMAND_PROPOSE_REGISTRATION:
    case (uint32_t)COMMAND_PROPOSE_ENTRY:
    case (uint32_t)COMMAND_PROPOSE_TARGET:
    case (uint32_t)COMMAND_TAKE:
    case (uint32_t)COMMAND_RELEASE:
        break;
    default:
        is_free = false;
        break;
    }
    return is_free;
}

/* Navigation programs know of no authority: they take it by what they command. */
static bool may_take_by_it(const controller_t *self, const command_t *command)
{
    return (command->source == (uint32_t)COMMAND_SOURCE_IGTL) && (command->peer != 0U) &&
           authority_is_free(&self->authority);
}

/* A command that only shows something: that of a connection, unless another one commands. */
static bool may_show(const controller_t *self, const command_t *command)
{
    const bool is_anothers =
        authority_is_held(&self->authority) &&
        (self->authority.sealed.holder.source == (uint32_t)COMMAND_SOURCE_IGTL);
    return (command->kind == (uint32_t)COMMAND_NEEDLE) && !is_anothers;
}

bool controller_has_authority(const controller_t *self, const command_t *command)
{
    const authority_party_t party = party_of(command);
    return is_everyones(command) || authority_is_of(&self->authority, &party) ||
           may_take_by_it(self, command) || may_show(self, command);
}

/* `party` has sent `command`; one without a peer is of every party of its source. */
static bool is_of_sender(const authority_party_t *party, const command_t *command)
{
    return (party->peer != 0U) && (party->source == command->source) &&
           ((command->peer == 0U) || (party->peer == command->peer));
}

/* A party that has it by now needs no button for it. */
static void take(controller_t *self, const cycle_t *cycle, const command_t *command)
{
    const authority_party_t party = party_of(command);
    if (authority_take(&self->authority, &party, now_of(self))) {
        note_taken(self, cycle);
        if (is_of_sender(&self->authority.sealed.requester, command)) {
            controller_end_request(self);
        }
    }
}

void controller_credit(controller_t *self, const cycle_t *cycle, const command_t *command)
{
    const authority_party_t party = party_of(command);
    if (authority_is_of(&self->authority, &party)) {
        authority_renew(&self->authority, self->sealed.time_us);
    } else if (!is_everyones(command) && (command->kind != (uint32_t)COMMAND_NEEDLE)) {
        take(self, cycle, command);
    } else {
        /* It takes nothing. */
    }
}

status_t controller_obey_take(controller_t *self, const cycle_t *cycle, const command_t *command,
                              answer_t *answer)
{
    (void)answer;
    const authority_party_t party = party_of(command);
    take(self, cycle, command);
    return authority_is_of(&self->authority, &party) ? STATUS_OK : STATUS_NO_AUTHORITY;
}

/* That it is accepted renews. */
status_t controller_obey_renew(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer)
{
    (void)self;
    (void)cycle;
    (void)command;
    (void)answer;
    return STATUS_OK;
}

status_t controller_obey_release(controller_t *self, const cycle_t *cycle, const command_t *command,
                                 answer_t *answer)
{
    (void)answer;
    if (is_of_sender(&self->authority.sealed.requester, command)) {
        controller_end_request(self);
    }
    if (is_of_sender(&self->authority.sealed.holder, command)) {
        lose(self, cycle, AUTHORITY_LOSS_RELEASED);
    }
    return STATUS_OK;
}

status_t controller_ask_button(controller_t *self, const cycle_t *cycle, const command_t *command,
                               authority_request_t request, uint32_t axis)
{
    const authority_party_t party = party_of(command);
    if (cycle->inputs->has_button == 0U) {
        return STATUS_NO_BUTTON;
    }
    if (authority_is_asked(&self->authority, request, axis, &party)) {
        return STATUS_OK;
    }
    if (!authority_ask(&self->authority, request, axis, &party, self->sealed.time_us)) {
        return STATUS_BUSY;
    }
    confirm_button_renew(&self->confirm);
    return STATUS_OK;
}

status_t controller_obey_request(controller_t *self, const cycle_t *cycle, const command_t *command,
                                 answer_t *answer)
{
    (void)answer;
    const uint32_t request = command_as_request(command)->request;
    if ((request != (uint32_t)AUTHORITY_REQUEST_CONFIRM) &&
        (request != (uint32_t)AUTHORITY_REQUEST_TAKE)) {
        return STATUS_UNKNOWN_COMMAND;
    }
    const authority_party_t party = party_of(command);
    if (party.peer == 0U) {
        return STATUS_NO_AUTHORITY;
    }
    if ((request == (uint32_t)AUTHORITY_REQUEST_TAKE) &&
        authority_is_of(&self->authority, &party)) {
        return STATUS_OK;
    }
    const status_t status =
        controller_ask_button(self, cycle, command, (authority_request_t)request, 0U);
    if (status == STATUS_OK) {
        controller_note(self, cycle, EVENT_AUTHORITY_ASKED, request, 0);
    }
    return status;
}

void controller_grant(controller_t *self, const cycle_t *cycle)
{
    self->authority.sealed.request = (uint32_t)AUTHORITY_REQUEST_GRANTED;
    lose(self, cycle, AUTHORITY_LOSS_TAKEN);
}

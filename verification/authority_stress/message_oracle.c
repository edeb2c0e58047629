/* SPDX-License-Identifier: Apache-2.0 */
#include "authority_stress/message_oracle.h"

#include "charts/arming_chart.h"
#include "charts/authority_chart.h"
#include "interface/authority_list.h"
#include "oracle/commanding.h"
#include "oracle/replies.h"
#include "procedure/command_kinds.h"

#include <stddef.h>

static const char *const sentences[SENTENCE_COUNT] = {
    [SENTENCE_ONE] = "one holds at a time, and it is who is shown",
    [SENTENCE_REST] = "between two holders the axes rest",
    [SENTENCE_WAY] = "who takes it has commanded it, or pressed the button for it",
    [SENTENCE_OBEYED] = "nobody is obeyed who does not have it",
    [SENTENCE_ARMED] = "an order is of who has it, and does not outlive that",
    [SENTENCE_OFF] = "without who armed its order no axis is driven",
    [SENTENCE_STOP] = "a stop is refused to nobody for want of authority",
    [SENTENCE_ANSWERED] = "each command is answered, and each refusal has a name"};

const char *message_oracle_sentence(sentence_t sentence)
{
    return sentences[sentence];
}

static void hold(message_oracle_t *self, sentence_t sentence, bool is_true, uint32_t cycle)
{
    if (is_true) {
        return;
    }
    if (self->broken[sentence] == 0U) {
        self->first_cycle[sentence] = cycle;
    }
    self->broken[sentence]++;
}

static bool is_same(party_t one, party_t other)
{
    return (one.peer != 0U) && (one.peer == other.peer) && (one.source == other.source);
}

static party_t sender(const command_t *command)
{
    const party_t party = {.source = command->source, .peer = command->peer};
    return party;
}

/* It is to `command`, and has a name if it is a refusal. */
static bool is_proper(const answer_t *answer, const command_t *command)
{
    return (answer != NULL) && (answer->id == command->id) && (answer->source == command->source) &&
           (answer->command == command->kind) &&
           (answer->asked == (uint32_t)command_kinds_workphase(command)) &&
           ((answer->kind == (uint32_t)ANSWER_REFUSED) == (answer->status != (uint32_t)STATUS_OK));
}

/* It is `party` who takes authority in this cycle. */
static bool takes_now(const controller_outputs_t *outputs, party_t party)
{
    for (uint32_t i = 0U; i < outputs->event_count; i++) {
        const event_t *event = &outputs->events[i];
        const party_t taker = {.source = (uint32_t)event->value, .peer = event->subject};
        if ((event->id == (uint32_t)EVENT_AUTHORITY_TAKEN) && is_same(taker, party)) {
            return true;
        }
    }
    return false;
}

static void look_at_command(message_oracle_t *self, uint32_t cycle,
                            const controller_inputs_t *inputs, uint32_t number,
                            const controller_outputs_t *outputs)
{
    const command_t *command = &inputs->commands[number];
    const answer_t *answer = replies_to(outputs, number);
    const bool is_of_holder = is_same(self->holder, sender(command));
    hold(self, SENTENCE_ANSWERED, is_proper(answer, command), cycle);
    if (answer == NULL) {
        return;
    }
    const bool is_refused = answer->status == (uint32_t)STATUS_NO_AUTHORITY;
    if (commanding_is_stop(command)) {
        hold(self, SENTENCE_STOP, !is_refused, cycle);
        self->stops += is_of_holder ? 0U : 1U;
    } else if (commanding_needs_authority(command)) {
        hold(self, SENTENCE_OBEYED,
             (answer->kind == (uint32_t)ANSWER_REFUSED) || is_of_holder ||
                 takes_now(outputs, sender(command)),
             cycle);
    } else {
        /* It needs none. */
    }
    self->refused += is_refused ? 1U : 0U;
}

/* A repeated request for the same waits no longer. */
static bool is_asked_already(const message_oracle_t *self, const command_t *command)
{
    return (command->as.request.request == (uint32_t)AUTHORITY_REQUEST_TAKE) &&
           is_same(self->asker, sender(command));
}

/* The request that stands for the button, and whether that was pressed for it. */
static void look_at_button(message_oracle_t *self, const controller_inputs_t *inputs,
                           const controller_outputs_t *outputs)
{
    const bool is_down = inputs->confirm_pressed != 0U;
    const bool is_pedal_up = (inputs->pedal_a == 0U) && (inputs->pedal_b == 0U);
    self->is_pressed = self->is_pressed || (self->was_released && is_down && is_pedal_up);
    self->was_released = self->was_released || !is_down;
    if (!self->is_pressed && ((self->time_us - self->asked_us) > LIMIT_AUTHORITY_ASK_US)) {
        self->asker.peer = 0U;
    }
    for (uint32_t i = 0U; i < inputs->command_count; i++) {
        const command_t *command = &inputs->commands[i];
        if ((command->kind == (uint32_t)COMMAND_REQUEST) && replies_accept(outputs, i) &&
            !is_same(self->holder, sender(command)) && !is_asked_already(self, command)) {
            self->asker = sender(command);
            self->asker.peer = (command->as.request.request == (uint32_t)AUTHORITY_REQUEST_TAKE)
                                   ? command->peer
                                   : 0U;
            self->asked_us = self->time_us;
            self->was_released = false;
            self->is_pressed = false;
        }
    }
}

/* A command of this cycle that is a way to authority while none has it. */
static bool has_commanded(const controller_inputs_t *inputs, const controller_outputs_t *outputs,
                          party_t party)
{
    for (uint32_t i = 0U; i < inputs->command_count; i++) {
        const command_t *command = &inputs->commands[i];
        if (is_same(party, sender(command)) && commanding_needs_authority(command) &&
            replies_accept(outputs, i)) {
            return true;
        }
    }
    return false;
}

static bool has_pressed(const message_oracle_t *self, party_t party)
{
    return self->is_pressed && is_same(self->asker, party);
}

static void note_taken(message_oracle_t *self, uint32_t cycle, const event_t *event,
                       const controller_inputs_t *inputs, const controller_outputs_t *outputs)
{
    const party_t taker = {.source = (uint32_t)event->value, .peer = event->subject};
    const bool has_said = has_commanded(inputs, outputs, taker);
    const bool was_asked = !has_said && has_pressed(self, taker);
    hold(self, SENTENCE_ONE, (self->holder.peer == 0U) && (taker.peer != 0U), cycle);
    hold(self, SENTENCE_REST, !self->is_ending, cycle);
    hold(self, SENTENCE_WAY, was_asked || has_said, cycle);
    self->takes[taker.source % COMMAND_SOURCE_COUNT]++;
    self->holder = taker;
    self->asker.peer = is_same(self->asker, taker) ? 0U : self->asker.peer;
}

static void note_lost(message_oracle_t *self, uint32_t cycle, const event_t *event)
{
    hold(self, SENTENCE_ONE, (self->holder.peer != 0U) && (event->subject == self->holder.peer),
         cycle);
    if (event->value == (int32_t)AUTHORITY_LOSS_TAKEN) {
        hold(self, SENTENCE_WAY, self->is_pressed && (self->asker.peer != 0U), cycle);
    }
    self->losses[(uint32_t)event->value % LOSSES]++;
    self->cut += self->was_driven ? 1U : 0U;
    self->holder.peer = 0U;
    self->lost_us = self->time_us;
    self->is_ending = true;
    self->is_over = true;
}

static void note_armed(message_oracle_t *self, const event_t *event)
{
    self->owner.source = (event->cause == (uint32_t)EVENT_CAUSE_CONSOLE)
                             ? (uint32_t)COMMAND_SOURCE_HTTP
                             : (uint32_t)COMMAND_SOURCE_IGTL;
    self->owner.peer = event->peer;
    self->orders[self->owner.source]++;
    self->is_over = false;
}

static void look_at_events(message_oracle_t *self, uint32_t cycle,
                           const controller_inputs_t *inputs, const controller_outputs_t *outputs)
{
    for (uint32_t i = 0U; i < outputs->event_count; i++) {
        const event_t *event = &outputs->events[i];
        switch (event->id) {
        case (uint32_t)EVENT_AUTHORITY_TAKEN:
            note_taken(self, cycle, event, inputs, outputs);
            break;
        case (uint32_t)EVENT_AUTHORITY_LOST:
            note_lost(self, cycle, event);
            break;
        case (uint32_t)EVENT_ORDER_ARMED:
            note_armed(self, event);
            break;
        default:
            break;
        }
    }
}

static void look_at_holder(message_oracle_t *self, uint32_t cycle, const snapshot_t *snapshot)
{
    const party_t shown = {.source = snapshot->holder, .peer = snapshot->holder_peer};
    const bool is_held = snapshot->authority == (uint32_t)AUTHORITY_STATE_HELD;
    hold(self, SENTENCE_ONE,
         is_held ? is_same(shown, self->holder) : ((self->holder.peer == 0U) && (shown.peer == 0U)),
         cycle);
    hold(self, SENTENCE_ARMED,
         (snapshot->order == (uint32_t)ARMING_STATE_NONE) || is_same(self->owner, self->holder),
         cycle);
    hold(self, SENTENCE_REST,
         !self->is_ending || (snapshot->authority == (uint32_t)AUTHORITY_STATE_ENDING), cycle);
}

/* States that end with the axes' rest, or with the time for it. */
static void look_at_rest(message_oracle_t *self, const snapshot_t *snapshot)
{
    bool is_at_rest = true;
    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        is_at_rest = is_at_rest && (snapshot->axes[i].speed_ticks_per_s_q8 == 0);
    }
    self->is_ending = self->is_ending && !is_at_rest &&
                      ((self->time_us - self->lost_us) < LIMIT_AUTHORITY_END_US);
}

static void look_at_drives(message_oracle_t *self, uint32_t cycle, const snapshot_t *snapshot)
{
    bool is_driven = false;
    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        is_driven = is_driven || (snapshot->axes[i].drive_mode != (uint32_t)CARD_DRIVE_OFF);
    }
    hold(self, SENTENCE_OFF, !is_driven || !self->is_over, cycle);
    self->driven += is_driven ? 1U : 0U;
    self->was_driven = is_driven;
}

void message_oracle_look(message_oracle_t *self, uint32_t cycle, const controller_inputs_t *inputs,
                         const controller_outputs_t *outputs)
{
    self->cycles++;
    self->time_us += inputs->elapsed_us;
    for (uint32_t i = 0U; i < inputs->command_count; i++) {
        look_at_command(self, cycle, inputs, i, outputs);
    }
    look_at_button(self, inputs, outputs);
    look_at_rest(self, &outputs->snapshot);
    look_at_events(self, cycle, inputs, outputs);
    look_at_holder(self, cycle, &outputs->snapshot);
    look_at_drives(self, cycle, &outputs->snapshot);
}

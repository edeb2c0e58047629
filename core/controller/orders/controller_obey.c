/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_obey.h"

#include "controller/orders/controller_authority.h"
#include "controller/orders/controller_dispatch.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"
#include "controller/orders/controller_values.h"
#include "controller/orders/controller_workphase.h"
#include "procedure/command_kinds.h"

static bool is_known(const command_t *command)
{
    const bool is_workphase = command->kind == (uint32_t)COMMAND_WORKPHASE;
    return (command->kind > (uint32_t)COMMAND_NONE) && (command->kind < COMMAND_KIND_COUNT) &&
           (!is_workphase || (command_kinds_workphase(command) != WORKPHASE_UNDEFINED));
}

/* An unknown command is left to be refused as unknown. */
static bool is_allowed(const command_t *command)
{
    const bool is_named = command->kind < COMMAND_KIND_COUNT;
    const uint32_t sources = is_named ? command_traits[command->kind].sources : 0U;
    return (command->source < COMMAND_SOURCE_COUNT) &&
           (!is_known(command) || (((sources >> command->source) & 1U) != 0U));
}

/* Faults that only START_UP clears must not stay for ever where START_UP is refused: the needle has
 * to come out. */
static void clear_only(controller_t *self, const cycle_t *cycle, const command_t *command)
{
    if ((command->kind == (uint32_t)COMMAND_WORKPHASE) &&
        guards_have(controller_facts(self, cycle), GUARD_HARDWARE_READY) &&
        !procedure_is_armed(&self->procedure)) {
        controller_begin_start_up(self, cycle);
    }
}

static status_t obey(controller_t *self, const cycle_t *cycle, const command_t *command,
                     answer_t *answer)
{
    if (!is_allowed(command)) {
        return STATUS_NOT_ALLOWED;
    }
    if (command->kind == (uint32_t)COMMAND_NOTE) {
        return controller_dispatch(self, cycle, command,
                                   answer); /* Everyone's, and no sign of life of a peer. */
    }
    if (is_known(command) && !controller_has_authority(self, command)) {
        return STATUS_NO_AUTHORITY;
    }
    const status_t barred = guards_bar(controller_bars(self, cycle), command->kind,
                                       (uint32_t)command_kinds_workphase(command));
    if (barred == STATUS_MOVED_IN_VAIN) {
        clear_only(self, cycle, command);
    }
    if (barred != STATUS_OK) {
        return barred;
    }
    const status_t status = controller_dispatch(self, cycle, command, answer);
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

static void answer(controller_t *self, const cycle_t *cycle, const command_t *command)
{
    answer_t draft = {.id = command->id,
                      .source = command->source,
                      .command = command->kind,
                      .asked = (uint32_t)command_kinds_workphase(command),
                      .is_final = 1U};
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

void controller_obey(controller_t *self, const cycle_t *cycle)
{
    for (uint32_t i = 0U; i < cycle->inputs->command_count; i++) {
        const command_t *const command = &cycle->inputs->commands[i];
        const cycle_t because = controller_with_cause(cycle, cause_of(command), command->peer);
        answer(self, &because, command);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/operator/operator_promise.h"

#include "charts/card_link_chart.h"
#include "supervise/operator/operator_command.h"

#define PROMISE_ID (OPERATOR_COMMAND_ID + 1U)

/* Outcome of the command in the next cycle, beside those of the rig. */
static status_t send(rig_t *rig, const command_t *command)
{
    rig->commands[0] = *command;
    rig->command_count = 1U;
    rig_cycle(rig);
    for (uint32_t i = 0U; i < rig->outputs.answer_count; i++) {
        if (rig->outputs.answers[i].id == command->id) {
            return (status_t)rig->outputs.answers[i].status;
        }
    }
    return STATUS_NO_ANSWER;
}

/* No person has pressed or pulled anything between what was shown and what is decided. */
static bool is_box_same(const controller_inputs_t *one, const controller_inputs_t *other)
{
    return (one->pedal_a == other->pedal_a) && (one->pedal_b == other->pedal_b) &&
           (one->estop_open == other->estop_open);
}

/* A frame that is missing now, of a card in use, makes START_UP wait for the next one. */
static bool is_any_late(const rig_t *rig)
{
    bool is_any = false;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const uint32_t link =
            (uint32_t)rig->outputs.snapshot.cards[rig->box.robot->axes[i].slot].link;
        is_any = is_any || (link == (uint32_t)CARD_LINK_STATE_LATE);
    }
    return is_any;
}

/* Without a command the next cycle shows the same step: no axis has just left its place. */
static bool is_lasting(const rig_t *rig, uint32_t step)
{
    static rig_t copy;
    copy = *rig;
    copy.command_count = 0U;
    copy.is_page_away = true;
    rig_cycle(&copy);
    return copy.outputs.snapshot.next_step == step;
}

bool operator_promise_try(const rig_t *rig, status_t *answer)
{
    static rig_t copy;
    const uint32_t step = rig->outputs.snapshot.next_step;
    command_t command;
    if ((step == (uint32_t)NEXT_STEP_COMPARE) || !operator_command_of(rig, step, &command) ||
        is_any_late(rig)) {
        return false;
    }
    copy = *rig;
    copy.command_count = 0U;
    copy.is_page_away = true;
    command.id = PROMISE_ID; /* The order that it discards has another, and is answered as well. */
    *answer = send(&copy, &command);
    const bool is_judged =
        !is_any_late(&copy) && is_box_same(&rig->inputs, &copy.inputs) && is_lasting(rig, step);
    *answer = is_judged ? *answer : STATUS_OK;
    return true;
}

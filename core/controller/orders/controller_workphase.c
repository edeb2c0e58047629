/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_workphase.h"

#include "controller/orders/controller_aim.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"

#include <string.h>

void controller_begin_start_up(controller_t *self, const cycle_t *cycle)
{
    const estop_latch_state_t before = self->estop.state;
    self->sealed.is_box_settled = 1U;
    estop_latch_reset(&self->estop);
    if (self->estop.state != before) {
        controller_note(self, cycle, EVENT_ESTOP_CLEARED, 0U, 0);
    }
    pedal_gate_reset(&self->pedal);
    loop_guard_reset(&self->loop);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
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

/* Nothing is accepted ahead: what is recorded now may be missing when START_UP comes. */
status_t controller_obey_no_box(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer)
{
    (void)command;
    (void)answer;
    if (!controller_lacks_box(self, cycle)) {
        return STATUS_BLACK_BOX_THERE;
    }
    self->sealed.is_box_settled = 1U;
    controller_note(self, cycle, EVENT_NO_BLACK_BOX_ACCEPTED, 0U, 0);
    return STATUS_OK;
}

/* Request of a command for a workphase to the mode of that workphase: the target, if it is a move.
 */
static mode_request_t request_of(const controller_t *self, const cycle_t *cycle, mode_kind_t kind)
{
    mode_request_t request = {.sealed.axes = mode_axes(kind, 0U, cycle->robot)};
    (void)memcpy(request.sealed.move.target_ticks, self->plan.target_ticks,
                 sizeof request.sealed.move.target_ticks);
    request.sealed.move.steering = self->plan.steering;
    return request;
}

status_t controller_obey_workphase(controller_t *self, const cycle_t *cycle,
                                   const command_t *command, answer_t *answer)
{
    const workphase_t asked = (workphase_t)command_as_workphase(command)->workphase;
    procedure_actions_t actions;
    if (asked == WORKPHASE_MOVE_TO_TARGET) {
        const solution_t judged = controller_judge_way(self, cycle);
        controller_blame(answer, &judged);
        if (judged.status != STATUS_OK) {
            return judged.status;
        }
    }
    const mode_kind_t kind = mode_of(asked);
    const mode_request_t request = request_of(self, cycle, kind);
    const workphase_inputs_t guards = controller_guards(self, cycle, kind, request.sealed.axes);
    const workphase_t before = procedure_workphase(&self->procedure);
    const status_t status = procedure_request(&self->procedure, &guards, (uint32_t)asked, &actions);
    controller_report_order(self, cycle, actions.arming, STATUS_DISCARDED);
    if (status != STATUS_OK) {
        return status;
    }
    if (procedure_workphase(&self->procedure) != before) {
        controller_note(self, cycle, EVENT_WORKPHASE, (uint32_t)asked, 0);
    }
    if ((actions.workphase & WORKPHASE_ACTION_BEGIN_START_UP) != 0U) {
        controller_begin_start_up(self, cycle);
    }
    if ((actions.arming & ARMING_ACTION_RENEW_PEDAL) != 0U) {
        controller_arm(self, cycle, command, kind, &request);
        answer->is_final = 0U;
    }
    return STATUS_OK;
}

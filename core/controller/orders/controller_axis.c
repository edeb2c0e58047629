/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_axis.h"

#include "controller/orders/controller_authority.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"
#include "safety/needle.h"

void controller_forget_reference(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    axis_t *const axis = &self->axes[index];
    const axis_reference_t before = axis->chart.reference;
    axis_lose_reference(axis);
    plan_forget_target(&self->plan);
    if (axis->chart.reference != before) {
        self->records[index].sealed.grade = (uint32_t)axis->chart.reference;
        controller_note(self, cycle, EVENT_AXIS_REFERENCE_LOST, index,
                        axis->sealed.encoder.position_ticks);
    }
}

/* The axis of a command that may act on it; the first one, and why not, of another command. */
static uint32_t find_axis(const controller_t *self, const command_t *command, status_t *status)
{
    uint32_t index = command_as_axis(command)->axis;
    *status = STATUS_OK;
    if (!controller_is_of_workphase(self, command)) {
        *status = STATUS_WRONG_WORKPHASE;
        index = 0U;
    } else if (index >= self->sealed.axis_count) {
        *status = STATUS_UNKNOWN_COMMAND;
        index = 0U;
    } else {
        /* It is its own. */
    }
    return index;
}

status_t controller_obey_clear_axis(controller_t *self, const cycle_t *cycle,
                                    const command_t *command, answer_t *answer)
{
    status_t status = STATUS_OK;
    const uint32_t index = find_axis(self, command, &status);
    (void)answer;
    if ((status == STATUS_OK) && procedure_is_armed(&self->procedure)) {
        status = STATUS_NOT_AT_REST;
    }
    if (status == STATUS_OK) {
        controller_forget_reference(self, cycle, index);
    }
    return status;
}

static status_t confirm(controller_t *self, const cycle_t *cycle, const command_t *command,
                        uint32_t index)
{
    const axis_t *const axis = &self->axes[index];
    if (!axis_is_confirmable(axis, &cycle->robot->axes[index])) {
        return STATUS_NOTHING_TO_CONFIRM;
    }
    const status_t status =
        controller_ask_button(self, cycle, command, AUTHORITY_REQUEST_CONFIRM_AXIS, index);
    if (status == STATUS_OK) {
        controller_note(self, cycle, EVENT_CONFIRM_ASKED, index,
                        axis->sealed.encoder.position_ticks);
    }
    return status;
}

status_t controller_obey_confirm_axis(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer)
{
    status_t status = STATUS_OK;
    const uint32_t index = find_axis(self, command, &status);
    (void)answer;
    return (status == STATUS_OK) ? confirm(self, cycle, command, index) : status;
}

static status_t judge_set_home(const controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const bool is_at_rest = !procedure_is_armed(&self->procedure) &&
                            (self->pedal.sealed.is_released != 0U) &&
                            encoder_is_at_rest(&self->axes[index].sealed.encoder);
    status_t status = STATUS_OK;
    if (cycle->robot->axes[index].home_method == (uint8_t)HOME_BY_SWITCH) {
        status = STATUS_HOMES_OTHERWISE;
    } else if (!link_is_healthy_now(controller_link(self, index))) {
        status = STATUS_HARDWARE_NOT_READY;
    } else if (!is_at_rest) {
        status = STATUS_NOT_AT_REST;
    } else if (!needle_is_out(cycle->robot, self->axes)) {
        status = STATUS_NEEDLE_IN;
    } else {
        status = STATUS_OK;
    }
    return status;
}

static status_t set_home(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    axis_t *const axis = &self->axes[index];
    const status_t status = judge_set_home(self, cycle, index);
    if (status == STATUS_OK) {
        const axis_config_t *const config = &cycle->robot->axes[index];
        axis_place(axis, config, config->home_ticks);
        controller_note(self, cycle, EVENT_HOME_SET, index, axis->sealed.home_correction_ticks);
        controller_renew_account(self);
        plan_forget_target(&self->plan);
        /* An operator who presses the button already has compared another position. */
        confirm_button_renew(&self->confirm);
    }
    return status;
}

status_t controller_obey_set_home(controller_t *self, const cycle_t *cycle,
                                  const command_t *command, answer_t *answer)
{
    status_t status = STATUS_OK;
    const uint32_t index = find_axis(self, command, &status);
    (void)answer;
    return (status == STATUS_OK) ? set_home(self, cycle, index) : status;
}

/* As START_UP enables all; what START_UP clears besides stays. */
static status_t enable(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    axis_t *const axis = &self->axes[index];
    status_t status = STATUS_OK;
    if (self->estop.state != ESTOP_LATCH_STATE_CLEAR) {
        status = STATUS_FAULT_PRESENT;
    } else if (procedure_is_armed(&self->procedure)) {
        status = STATUS_NOT_AT_REST;
    } else if (!link_is_usable(controller_link(self, index))) {
        status = STATUS_HARDWARE_NOT_READY;
    } else {
        axis_enable(axis, false);
        controller_note(self, cycle, EVENT_AXIS_ENABLED, index,
                        axis->sealed.encoder.position_ticks);
    }
    return status;
}

status_t controller_obey_enable_axis(controller_t *self, const cycle_t *cycle,
                                     const command_t *command, answer_t *answer)
{
    status_t status = STATUS_OK;
    const uint32_t index = find_axis(self, command, &status);
    (void)answer;
    return (status == STATUS_OK) ? enable(self, cycle, index) : status;
}

/* One with a fault keeps that. */
status_t controller_obey_disable_axis(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer)
{
    status_t status = STATUS_OK;
    const uint32_t index = find_axis(self, command, &status);
    (void)answer;
    if ((status == STATUS_OK) && procedure_is_armed(&self->procedure)) {
        status = STATUS_NOT_AT_REST;
    }
    if (status == STATUS_OK) {
        axis_t *const axis = &self->axes[index];
        axis_disable(axis);
        controller_note(self, cycle, EVENT_AXIS_DISABLED, index,
                        axis->sealed.encoder.position_ticks);
    }
    return status;
}

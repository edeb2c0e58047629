/* SPDX-License-Identifier: Apache-2.0 */
#include "procedure/procedure.h"

static status_t refusal(uint32_t actions)
{
    status_t status = STATUS_WRONG_WORKPHASE;
    if ((actions & WORKPHASE_ACTION_ACCEPT) != 0U) {
        status = STATUS_OK;
    } else if ((actions & WORKPHASE_ACTION_REFUSE_HARDWARE_NOT_READY) != 0U) {
        status = STATUS_HARDWARE_NOT_READY;
    } else if ((actions & WORKPHASE_ACTION_REFUSE_CONFIRM_POSITIONS) != 0U) {
        status = STATUS_CONFIRM_POSITIONS;
    } else if ((actions & WORKPHASE_ACTION_REFUSE_NOT_REGISTERED) != 0U) {
        status = STATUS_NOT_REGISTERED;
    } else if ((actions & WORKPHASE_ACTION_REFUSE_NO_TARGET) != 0U) {
        status = STATUS_NO_TARGET;
    } else if ((actions & WORKPHASE_ACTION_REFUSE_NOT_HOMED) != 0U) {
        status = STATUS_NOT_HOMED;
    } else if ((actions & WORKPHASE_ACTION_REFUSE_FAULT_PRESENT) != 0U) {
        status = STATUS_FAULT_PRESENT;
    } else {
        /* Not on the allow-list. */
    }
    return status;
}

/* Sends the event to the workphase, and its actions to the order. */
static procedure_actions_t dispatch(procedure_t *self, const workphase_inputs_t *inputs,
                                    workphase_event_t event)
{
    procedure_actions_t actions = {0U, 0U};
    actions.workphase = workphase_chart_dispatch(&self->workphase, inputs, event);
    if ((actions.workphase & WORKPHASE_ACTION_DISCARD_ORDER) != 0U) {
        actions.arming |= arming_chart_dispatch(&self->arming, ARMING_EVENT_DISCARD);
    }
    if ((actions.workphase & WORKPHASE_ACTION_ARM_ORDER) != 0U) {
        actions.arming |= arming_chart_dispatch(&self->arming, ARMING_EVENT_ARM);
    }
    return actions;
}

void procedure_init(procedure_t *self)
{
    workphase_chart_init(&self->workphase);
    arming_chart_init(&self->arming);
}

uint32_t procedure_check(procedure_t *self)
{
    uint32_t repaired = 0U;
    if (workphase_chart_check(&self->workphase) != 0U) {
        repaired |= PROCEDURE_WORKPHASE_REPAIRED;
    }
    if (arming_chart_check(&self->arming) != 0U) {
        repaired |= PROCEDURE_ARMING_REPAIRED;
    }
    if (repaired != 0U) {
        (void)procedure_estop(self);
    }
    return repaired;
}

uint32_t procedure_step(procedure_t *self, uint32_t elapsed_us)
{
    (void)workphase_chart_advance(&self->workphase, elapsed_us);
    return arming_chart_advance(&self->arming, elapsed_us);
}

status_t procedure_request(procedure_t *self, const workphase_inputs_t *inputs, uint32_t workphase,
                           procedure_actions_t *actions)
{
    static const workphase_event_t requests[WORKPHASE_COUNT] = {
        WORKPHASE_EVENT_REQUEST_STOP, /* UNDEFINED cannot be requested. */
        WORKPHASE_EVENT_REQUEST_START_UP,       WORKPHASE_EVENT_REQUEST_PLANNING,
        WORKPHASE_EVENT_REQUEST_CALIBRATION,    WORKPHASE_EVENT_REQUEST_TARGETING,
        WORKPHASE_EVENT_REQUEST_MOVE_TO_TARGET, WORKPHASE_EVENT_REQUEST_MANUAL,
        WORKPHASE_EVENT_REQUEST_STOP,           WORKPHASE_EVENT_REQUEST_EMERGENCY,
    };
    *actions = (procedure_actions_t){0U, 0U};
    if ((workphase == (uint32_t)WORKPHASE_UNDEFINED) || (workphase >= WORKPHASE_COUNT)) {
        return STATUS_UNKNOWN_COMMAND;
    }
    *actions = dispatch(self, inputs, requests[workphase]);
    return refusal(actions->workphase);
}

status_t procedure_request_motion(procedure_t *self, const workphase_inputs_t *inputs,
                                  procedure_actions_t *actions)
{
    *actions = dispatch(self, inputs, WORKPHASE_EVENT_REQUEST_MOTION);
    return refusal(actions->workphase);
}

uint32_t procedure_estop(procedure_t *self)
{
    const workphase_inputs_t nothing = {.is_hardware_ready = false};
    return dispatch(self, &nothing, WORKPHASE_EVENT_ESTOP).arming;
}

uint32_t procedure_notify(procedure_t *self, arming_event_t event)
{
    return workphase_chart_is_sound(&self->workphase) ? arming_chart_dispatch(&self->arming, event)
                                                      : 0U;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "procedure/workphase.h"

static status_t refusal(uint32_t actions)
{
    status_t status = STATUS_WRONG_WORKPHASE;
    if ((actions & WORKPHASES_ACTION_ACCEPT) != 0U) {
        status = STATUS_OK;
    } else if ((actions & WORKPHASES_ACTION_REFUSE_HARDWARE_NOT_READY) != 0U) {
        status = STATUS_HARDWARE_NOT_READY;
    } else if ((actions & WORKPHASES_ACTION_REFUSE_CONFIRM_POSITIONS) != 0U) {
        status = STATUS_CONFIRM_POSITIONS;
    } else if ((actions & WORKPHASES_ACTION_REFUSE_NOT_REGISTERED) != 0U) {
        status = STATUS_NOT_REGISTERED;
    } else if ((actions & WORKPHASES_ACTION_REFUSE_NO_TARGET) != 0U) {
        status = STATUS_NO_TARGET;
    } else if ((actions & WORKPHASES_ACTION_REFUSE_NOT_HOMED) != 0U) {
        status = STATUS_NOT_HOMED;
    } else if ((actions & WORKPHASES_ACTION_REFUSE_FAULT_PRESENT) != 0U) {
        status = STATUS_FAULT_PRESENT;
    } else {
        /* Not on the allow-list. */
    }
    return status;
}

status_t workphase_request(workphases_chart_t *self, const workphases_inputs_t *inputs,
                           uint32_t workphase, uint32_t *actions)
{
    static const workphases_event_t requests[WORKPHASE_COUNT] = {
        WORKPHASES_EVENT_REQUEST_STOP, /* UNDEFINED cannot be requested. */
        WORKPHASES_EVENT_REQUEST_START_UP,       WORKPHASES_EVENT_REQUEST_PLANNING,
        WORKPHASES_EVENT_REQUEST_CALIBRATION,    WORKPHASES_EVENT_REQUEST_TARGETING,
        WORKPHASES_EVENT_REQUEST_MOVE_TO_TARGET, WORKPHASES_EVENT_REQUEST_MANUAL,
        WORKPHASES_EVENT_REQUEST_STOP,           WORKPHASES_EVENT_REQUEST_EMERGENCY,
    };
    *actions = 0U;
    if ((workphase == (uint32_t)WORKPHASE_UNDEFINED) || (workphase >= WORKPHASE_COUNT)) {
        return STATUS_UNKNOWN_COMMAND;
    }
    *actions = workphases_chart_dispatch(self, inputs, requests[workphase]);
    return refusal(*actions);
}

status_t workphase_request_jog(workphases_chart_t *self, const workphases_inputs_t *inputs,
                               uint32_t *actions)
{
    *actions = workphases_chart_dispatch(self, inputs, WORKPHASES_EVENT_REQUEST_JOG);
    return refusal(*actions);
}

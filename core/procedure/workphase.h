/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Requests for workphases and the one armed order. Behaviour: statecharts/workphases.scxml.
 */
#ifndef BORESIGHT_WORKPHASE_H
#define BORESIGHT_WORKPHASE_H

#include "charts/workphases_chart.h"
#include "interface/status.h"
#include "interface/workphase_list.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * Asks for a workphase.
 *
 * @param actions receives the chart's actions (WORKPHASES_ACTION_ bits)
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND outside the enumeration or for UNDEFINED;
 * STATUS_WRONG_WORKPHASE, STATUS_HARDWARE_NOT_READY, STATUS_CONFIRM_POSITIONS,
 * STATUS_FAULT_PRESENT, STATUS_NOT_REGISTERED, STATUS_NO_TARGET, STATUS_NOT_HOMED as refused by the
 * chart
 *
 * @satisfies SWR-PHASE-001
 * @satisfies SWR-PHASE-002
 * @satisfies SWR-PHASE-006
 * @satisfies SWR-REF-008
 */
status_t workphase_request(workphases_chart_t *self, const workphases_inputs_t *inputs,
                           uint32_t workphase, uint32_t *actions);

/**
 * Asks for a jog to be armed. Same meaning.
 *
 * @satisfies SWR-AXIS-010
 */
status_t workphase_request_jog(workphases_chart_t *self, const workphases_inputs_t *inputs,
                               uint32_t *actions);

/** The present workphase. */
static inline workphase_t workphase_present(const workphases_chart_t *self)
{
    /* The chart's states stand in the order of workphase_t. */
    return (workphase_t)self->phase;
}

/** An order is armed: waiting for the pedal or moving. */
static inline bool workphase_is_armed(const workphases_chart_t *self)
{
    return self->order != WORKPHASES_ORDER_NONE;
}

/** The armed order runs in this cycle. */
static inline bool workphase_is_moving(const workphases_chart_t *self)
{
    return self->order == WORKPHASES_ORDER_MOVING;
}

#endif

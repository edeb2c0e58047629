/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The workphase and the one order that may be armed in it. The controller owns one. The actions of
 * the first chart on the order are sent to the second one here, in the same step. Behaviour:
 * statecharts/workphase.scxml, statecharts/arming.scxml.
 */
#ifndef BORESIGHT_PROCEDURE_H
#define BORESIGHT_PROCEDURE_H
#include "charts/arming_chart.h"
#include "charts/workphase_chart.h"
#include "interface/status.h"
#include "interface/workphase_list.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    workphase_chart_t workphase;
    arming_chart_t arming;
} procedure_t;

/** Actions that a step asks of the caller. */
typedef struct {
    uint32_t workphase; /**< WORKPHASE_ACTION_ bits. */
    uint32_t arming;    /**< ARMING_ACTION_ bits. */
} procedure_actions_t;

/* Charts that were repaired. */
#define PROCEDURE_WORKPHASE_REPAIRED 1U
#define PROCEDURE_ARMING_REPAIRED 2U

/** Starts in UNDEFINED with nothing armed. */
void procedure_init(procedure_t *self);

/**
 * Before each step: where a chart was damaged, the workphase is EMERGENCY and nothing is armed.
 *
 * @return PROCEDURE_..._REPAIRED bits; 0 when both were sound
 */
uint32_t procedure_check(procedure_t *self);

/** Once a cycle, before any event; `elapsed_us` since the one before. Returns ARMING_ACTION_
 * bits.
 */
uint32_t procedure_step(procedure_t *self, uint32_t elapsed_us);

/**
 * Asks for a workphase.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND outside the enumeration or for UNDEFINED;
 * STATUS_WRONG_WORKPHASE, STATUS_HARDWARE_NOT_READY, STATUS_CONFIRM_POSITIONS,
 * STATUS_FAULT_PRESENT, STATUS_NOT_REGISTERED, STATUS_NO_TARGET, STATUS_NOT_HOMED as refused by the
 * chart
 *
 * @satisfies SWR-PERMIT-270
 * @satisfies SWR-PHASE-001
 * @satisfies SWR-PHASE-002
 * @satisfies SWR-PHASE-005
 * @satisfies SWR-PHASE-006
 * @satisfies SWR-REF-008
 */
status_t procedure_request(procedure_t *self, const workphase_inputs_t *inputs, uint32_t workphase,
                           procedure_actions_t *actions);

/**
 * Asks for a motion to be armed that has a command of its own; `inputs` are those of its mode. Same
 * meaning.
 *
 * @satisfies SWR-AXIS-010
 * @satisfies SWR-MODE-001
 * @satisfies SWR-MODE-002
 * @satisfies SWR-PHASE-008
 * @satisfies SWR-PHASE-009
 */
status_t procedure_request_motion(procedure_t *self, const workphase_inputs_t *inputs,
                                  procedure_actions_t *actions);

/** The e-stop was pulled. Returns ARMING_ACTION_ bits. */
uint32_t procedure_estop(procedure_t *self);

/** Sends the order `event`, on its outcome or on the pedal. Returns ARMING_ACTION_ bits; 0 while
 * the workphase is damaged: a damaged chart takes no event, nor does the one beside it. */
uint32_t procedure_notify(procedure_t *self, arming_event_t event);

/** The present workphase. */
static inline workphase_t procedure_workphase(const procedure_t *self)
{
    /* The chart's states stand in the order of workphase_t. */
    return (workphase_t)self->workphase.state;
}

/** An order is armed: waiting for the pedal or moving. */
static inline bool procedure_is_armed(const procedure_t *self)
{
    return self->arming.state != ARMING_STATE_NONE;
}

/** The armed order runs in this cycle. */
static inline bool procedure_is_moving(const procedure_t *self)
{
    return self->arming.state == ARMING_STATE_MOVING;
}

#endif

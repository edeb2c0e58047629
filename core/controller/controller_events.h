/* SPDX-License-Identifier: Apache-2.0 */
/** @file Events that the controller notes in a cycle, and data that all parts of a cycle share. For
 * the files of this folder only, as are the headers of the other parts. */
#ifndef BORESIGHT_CONTROLLER_EVENTS_H
#define BORESIGHT_CONTROLLER_EVENTS_H

#include "controller/controller.h"

/** Data that the parts of one cycle share. */
typedef struct {
    const robot_t *robot;
    const controller_inputs_t *inputs;
    controller_outputs_t *outputs;
    event_cause_t cause; /**< Cause of the events noted with it. */
    uint32_t peer;       /**< Peer of the cause, as event_t. */
} cycle_t;

/**
 * Adds an event to this cycle's outputs; counts it as lost when they are full.
 *
 * @satisfies SWR-EVENT-001
 * @satisfies SWR-EVENT-002
 * @satisfies SWR-EVENT-004
 */
void controller_note(controller_t *self, const cycle_t *cycle, event_id_t id, uint32_t subject,
                     int32_t value);

/**
 * The same cycle, for what happens because of this. `peer`: as event_t.
 *
 * @satisfies SWR-EVENT-005
 * @satisfies SWR-EVENT-006
 */
cycle_t controller_with_cause(const cycle_t *cycle, event_cause_t cause, uint32_t peer);

/**
 * A note of the exchange, which is in the log of events.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for a note_kind_t that there is not
 */
status_t controller_obey_note(controller_t *self, const cycle_t *cycle, const command_t *command,
                              answer_t *answer);

#endif

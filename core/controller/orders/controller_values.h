/* SPDX-License-Identifier: Apache-2.0 */
/** @file The numbers that were sent, in the log of events: registration, target, entry point,
 * probe, and the limit that refused something. */
#ifndef BORESIGHT_CONTROLLER_VALUES_H
#define BORESIGHT_CONTROLLER_VALUES_H

#include "controller/controller_events.h"

/**
 * Notes the numbers of `command`, which was answered by `answer`, behind the event that says so.
 * Those of refused commands are noted once in LIMIT_REFUSED_VALUES_MS.
 *
 * @satisfies SWR-EVENT-020
 * @satisfies SWR-EVENT-021
 * @satisfies SWR-EVENT-033
 */
void controller_note_values(controller_t *self, const cycle_t *cycle, const command_t *command,
                            const answer_t *answer);

#endif

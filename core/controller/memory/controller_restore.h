/* SPDX-License-Identifier: Apache-2.0 */
/** @file Positions from another time: kept from before the start, or saved by an operator. */
#ifndef BORESIGHT_CONTROLLER_RESTORE_H
#define BORESIGHT_CONTROLLER_RESTORE_H

#include "controller/controller_events.h"

#include <stdint.h>

/**
 * At the first report of an axis of which a reading was kept: is it the same? Then what was known
 * is restored, otherwise the axis is lost.
 *
 * @satisfies SWR-STORE-005
 * @satisfies SWR-STORE-006
 */
void controller_compare(controller_t *self, const cycle_t *cycle, uint32_t index);

/**
 * RESTORE. The operator compares the positions with the robot afterwards: they are no better than
 * unverified.
 *
 * @return STATUS_OK; otherwise nothing has changed, and `answer` names the axis, if it is one:
 * STATUS_UNKNOWN_COMMAND of no axis or one that the robot does not have; STATUS_WRONG_WORKPHASE;
 * STATUS_NOT_AT_REST; STATUS_HARDWARE_NOT_READY of a card that does not answer;
 * STATUS_OUT_OF_RANGE where the axis cannot stand
 *
 * @satisfies SWR-STORE-020
 * @satisfies SWR-STORE-021
 * @satisfies SWR-STORE-022
 * @satisfies SWR-STORE-023
 */
status_t controller_obey_restore(controller_t *self, const cycle_t *cycle, const command_t *command,
                                 answer_t *answer);

#endif

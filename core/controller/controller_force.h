/* SPDX-License-Identifier: Apache-2.0 */
/** @file The force sensor of the robot in a cycle: its readings, its doubts in the log, its zero.
 * No motion asks it, and none ends by it. */
#ifndef BORESIGHT_CONTROLLER_FORCE_H
#define BORESIGHT_CONTROLLER_FORCE_H

#include "controller/controller_events.h"

/** After the link to the card in `slot`, one without an axis, was stepped: nothing, if that is not
 * the card of the force sensor.
 *
 * @satisfies SWR-FORCE-575
 * @satisfies SWR-FORCE-577
 */
void controller_observe_force(controller_t *self, const cycle_t *cycle, uint32_t slot);

/**
 * Begins to zero the force sensor.
 *
 * @return STATUS_OK; or as SWR-FORCE-573 says: STATUS_NO_FORCE_SENSOR, NOT_AT_REST, NEEDLE_IN,
 * HARDWARE_NOT_READY, WRONG_WORKPHASE
 *
 * @satisfies SWR-FORCE-573
 */
status_t controller_obey_force(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer);

#endif

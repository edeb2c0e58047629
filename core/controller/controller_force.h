/* SPDX-License-Identifier: Apache-2.0 */
/** @file The force sensor of the robot in a cycle: its readings, its doubts in the log, its zero.
 * Only a mode in which a hand moves the needle asks it. */
#ifndef BORESIGHT_CONTROLLER_FORCE_H
#define BORESIGHT_CONTROLLER_FORCE_H

#include "controller/controller_events.h"
#include "safety/hand_guard.h"

/** Force of the hand in this cycle; not trusted of a robot without a sensor for it. */
static inline hand_t controller_hand(const controller_t *self, const cycle_t *cycle)
{
    const force_channel_t *const channel = &self->force.sealed.channels[FORCE_CHANNEL_HAND];
    const hand_t hand = {.force_mn = self->force.sealed.force_mn[FORCE_CHANNEL_HAND],
                         .is_trusted = (cycle->robot->force.is_there != 0U) &&
                                       force_channel_is_believed(channel)};
    return hand;
}

/**
 * Reasons against every drive while a hand moves the needle in the mode `kind`, and that its force
 * is doubtful also after that has ended such an order; 0 in all other modes.
 *
 * @satisfies SWR-COOP-008
 * @satisfies SWR-COOP-015
 */
uint32_t controller_hand_reasons(const controller_t *self, const cycle_t *cycle, mode_kind_t kind);

/** After the link to the card in `slot`, one without an axis, was stepped: nothing, if that is not
 * the card of the force sensor.
 *
 * @satisfies SWR-FORCE-575
 * @satisfies SWR-FORCE-577
 * @satisfies SWR-FORCE-610
 */
void controller_observe_force(controller_t *self, const cycle_t *cycle, uint32_t slot);

/**
 * Begins to zero the force sensor.
 *
 * @return STATUS_OK; or as SWR-FORCE-573 says: STATUS_NO_FORCE_SENSOR, NOT_AT_REST, NEEDLE_IN,
 * MEMORY_DAMAGED, HARDWARE_NOT_READY, WRONG_WORKPHASE
 *
 * @satisfies SWR-FORCE-573
 */
status_t controller_obey_force(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer);

#endif

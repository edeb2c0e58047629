/* SPDX-License-Identifier: Apache-2.0 */
/** @file What must be done or waited for before START_UP, where START_UP is wanted. */
#ifndef BORESIGHT_CONTROLLER_READY_H
#define BORESIGHT_CONTROLLER_READY_H

#include "controller/controller_events.h"

/** A next step, and the axis, card or event that it names. */
typedef struct {
    next_step_t step;
    uint32_t axis;  /**< ROBOT_AXIS_MAX: none. */
    uint32_t card;  /**< Slot; CARD_SLOT_COUNT: none. */
    uint32_t event; /**< event_id_t: what is wrong there; EVENT_ID_COUNT: neither is named. */
} named_step_t;

/** A step that names nothing. */
static inline named_step_t controller_step_only(next_step_t step)
{
    return (named_step_t){step, ROBOT_AXIS_MAX, CARD_SLOT_COUNT, EVENT_ID_COUNT};
}

/**
 * Next step where START_UP is wanted.
 *
 * @return the first obstacle to it: the computer, the black box, a card, the pedal, heat, a
 * position to be confirmed, a fault that came back in LIMIT_SERVICE_START_UPS tries; without one
 * START_UP
 *
 * @satisfies SWR-NEXT-003
 * @satisfies SWR-NEXT-004
 * @satisfies SWR-NEXT-005
 * @satisfies SWR-NEXT-007
 * @satisfies SWR-NEXT-021
 * @satisfies SWR-NEXT-022
 * @satisfies SWR-NEXT-028
 * @satisfies SWR-NEXT-035
 * @satisfies SWR-AXIS-081
 */
named_step_t controller_ready(const controller_t *self, const cycle_t *cycle);

/**
 * Next step where a move is wanted.
 *
 * @return MOVE, or SERVICE with the cause that has ended LIMIT_SERVICE_MOVES of them
 *
 * @satisfies SWR-NEXT-036
 */
named_step_t controller_ready_to_move(const controller_t *self);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the cards say in this cycle, and what follows when one is lost. */
#ifndef BORESIGHT_CONTROLLER_CARDS_H
#define BORESIGHT_CONTROLLER_CARDS_H

#include "controller/controller_events.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * The card of axis `index` was lost: so are the target, the order and, unless it is only
 * `is_in_doubt`, its reference.
 *
 * @satisfies SWR-CARD-015
 */
void controller_lose_card(controller_t *self, const cycle_t *cycle, uint32_t index,
                          bool is_in_doubt);

/**
 * The card of axis `index`.
 *
 * @satisfies SWR-LINK-009
 * @satisfies SWR-REF-009
 */
void controller_observe_card(controller_t *self, const cycle_t *cycle, uint32_t index);

/**
 * The cards without an axis, and those that the robot does not name.
 *
 * @satisfies SWR-LINK-009
 * @satisfies SWR-LINK-010
 * @satisfies SWR-LINK-011
 * @satisfies SWR-DRIVE-012
 */
void controller_observe_other_cards(controller_t *self, const cycle_t *cycle);

/**
 * How the card of one slot is, after all were observed; each slot has its turn within
 * CARD_SLOT_COUNT cycles.
 *
 * @satisfies SWR-CARD-011
 * @satisfies SWR-CARD-012
 * @satisfies SWR-CARD-013
 */
void controller_watch_card(controller_t *self, const cycle_t *cycle);

#endif

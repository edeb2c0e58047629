/* SPDX-License-Identifier: Apache-2.0 */
/** @file Reports of the cards in this cycle, and the consequences when one is lost. */
#ifndef BORESIGHT_CONTROLLER_CARDS_H
#define BORESIGHT_CONTROLLER_CARDS_H

#include "controller/controller_events.h"

#include <stdbool.h>
#include <stdint.h>

/** Effect of the loss of a card on the trust in a position. */
typedef enum {
    CARD_LOSS_KEEPS = 0, /**< It stays, as does the target. */
    CARD_LOSS_DOUBTS = 1,
    CARD_LOSS_LOSES = 2
} card_loss_t;

/**
 * The card of axis `index` was lost, and with it the order; `loss` states the effect on its
 * reference and on the target.
 *
 * @satisfies SWR-CARD-015
 */
void controller_lose_card(controller_t *self, const cycle_t *cycle, uint32_t index,
                          card_loss_t loss);

/**
 * The card of axis `index`.
 *
 * @satisfies SWR-LINK-009
 * @satisfies SWR-REF-009
 * @satisfies SWR-REF-014
 * @satisfies SWR-REF-015
 * @satisfies SWR-REF-031
 * @satisfies SWR-LOOP-010
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
 * Health of the card of one slot, after all were observed; each slot has its turn within
 * CARD_SLOT_COUNT cycles.
 *
 * @satisfies SWR-CARD-011
 * @satisfies SWR-CARD-012
 * @satisfies SWR-CARD-013
 */
void controller_watch_card(controller_t *self, const cycle_t *cycle);

#endif

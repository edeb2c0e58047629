/* SPDX-License-Identifier: Apache-2.0 */
/** @file Orders to the simulated box that are about a bent needle: its curvature and torsion,
 * images of its tip, a target that moves; and its true place. Stateless. */
#ifndef BORESIGHT_BOX_NEEDLE_ORDERS_H
#define BORESIGHT_BOX_NEEDLE_ORDERS_H

#include "sim/box.h"
#include "sim/orders/box_reply.h"
#include "sim/orders/box_words.h"

#include <stdbool.h>

/**
 * Carries out an order that begins with "needle", "images" or "target"; false: it is refused, and
 * nothing has changed.
 *
 * @satisfies SWR-BOX-776
 */
bool box_needle_order(box_t *self, const box_words_t *order);

/** States where tip, target and the newest image truly are. */
void box_needle_reply(box_reply_t *reply, const box_t *self);

#endif

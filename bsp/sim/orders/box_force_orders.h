/* SPDX-License-Identifier: Apache-2.0 */
/** @file Orders to the simulated box that are about forces and the needle in its tissue: a hand
 * like a spring, its grip, load cells, tissue, and what bends the needle. Stateless. */
#ifndef BORESIGHT_BOX_FORCE_ORDERS_H
#define BORESIGHT_BOX_FORCE_ORDERS_H

#include "sim/box.h"
#include "sim/orders/box_words.h"

#include <stdbool.h>

/** `order` is about these. */
bool box_force_order_is(const box_words_t *order);

/** Carries it out; false: it is refused, and nothing has changed. */
bool box_force_order(box_t *self, const box_words_t *order);

#endif

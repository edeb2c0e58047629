/* SPDX-License-Identifier: Apache-2.0 */
/** @file The link to a card of the dialect aim32, which reports too little for link_step(). */
#ifndef BORESIGHT_LINK_AIM32_H
#define BORESIGHT_LINK_AIM32_H

#include "card/link.h"

#include <stdint.h>

/**
 * One cycle, as link_step(). Only start word, sum and age are judged: a valid frame is a good one.
 * That it is new, of this slot, of the card that must be there and without a fault is believed, for
 * nothing in it shows that; heartbeat, time and the time of an edge are counted here, by the
 * board's samples.
 *
 * @satisfies SWR-NI-004
 */
void link_aim32_step(link_t *self, uint32_t slot, const uint8_t *bytes,
                     const card_samples_t *samples, uint32_t elapsed_us);

#endif

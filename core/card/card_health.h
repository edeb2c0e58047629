/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Health of a card that still answers: supply, temperature of its driver, commands that it refuses,
 * trips of its watchdog. The controller owns one per slot and looks at one slot a cycle. It counts
 * only: damaged, it reports something once too often, or once too late.
 */
#ifndef BORESIGHT_CARD_HEALTH_H
#define BORESIGHT_CARD_HEALTH_H

#include "card/card_frame.h"
#include "interface/card_trouble.h"

#include <stdbool.h>
#include <stdint.h>

/** All zero before the first look. */
typedef struct {
    uint32_t troubles;     /**< Bits of card_trouble_t that stand. */
    uint32_t odd_looks;    /**< In a row at a supply out of its range. */
    uint32_t refused;      /**< Commands that the card had refused at the last look. */
    uint32_t trips;        /**< Trips of its watchdog until then. */
    uint32_t calm_refused; /**< Looks since one was refused. */
    uint32_t calm_trips;   /**< Looks since one came. */
    uint32_t has_looked;   /**< 0 or 1. */
} card_health_t;

/** The bit of a trouble. */
static inline uint32_t card_health_bit(card_trouble_t trouble)
{
    return (uint32_t)1U << (uint32_t)trouble;
}

/**
 * Looks at a report of this cycle. The supply counts while `has_supply`: the e-stop takes it away.
 *
 * @return the bits of `troubles` that have changed
 *
 * @satisfies SWR-CARD-011
 * @satisfies SWR-CARD-012
 * @satisfies SWR-CARD-013
 */
uint32_t card_health_look(card_health_t *self, const card_report_t *report, bool has_supply);

#endif

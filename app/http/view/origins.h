/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Origins of registration, target and entry point, from the log of events, and of the proposals,
 * from the snapshot. A target or entry point that was accepted before the oldest event that is kept
 * has no known origin; the origin of the registration stands in the snapshot as well.
 */
#ifndef BORESIGHT_ORIGINS_H
#define BORESIGHT_ORIGINS_H

#include "exchange/exchange.h"
#include "exchange/exchange_peers.h"

#include <stdbool.h>
#include <stdint.h>

/** The origin of one of them. */
typedef struct {
    bool is_known;
    uint32_t source;                 /**< command_source_t. */
    uint32_t peer;                   /**< Its connection or page. */
    uint32_t cycle;                  /**< In which it was accepted, or proposed. */
    char title[EXCHANGE_TITLE_SIZE]; /**< Its title then. */
} origin_t;

typedef struct {
    origin_t registration;
    origin_t target;
    origin_t entry;
    origin_t proposed_registration;
    origin_t proposed_entry;
    origin_t proposed_target;
} origins_t;

/**
 * Takes an event; each once, in their order. All zero at first.
 *
 * @satisfies SWR-HTTP-032
 */
void origins_take(origins_t *self, const exchange_t *exchange, const event_t *event);

/**
 * After origins_take(): the proposals in `snapshot`, and its registration, if no event reports it.
 *
 * @satisfies SWR-IGTL-071
 * @satisfies SWR-PLAN-022
 */
void origins_take_shown(origins_t *self, const exchange_t *exchange, const snapshot_t *snapshot);

#endif

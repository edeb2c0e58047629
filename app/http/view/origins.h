/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * From whom registration, target and entry point are, as the log of events tells it, and what is
 * proposed, as the snapshot does. A target or entry point that was accepted before the oldest event
 * that is kept is from nobody that is known; whose the registration is, the snapshot says as well.
 */
#ifndef BORESIGHT_ORIGINS_H
#define BORESIGHT_ORIGINS_H

#include "exchange/exchange.h"
#include "exchange/exchange_peers.h"

#include <stdbool.h>
#include <stdint.h>

/** From whom one of them is. */
typedef struct {
    bool is_known;
    uint32_t source;                 /**< command_source_t. */
    uint32_t peer;                   /**< Its connection or page. */
    uint32_t cycle;                  /**< In which it was accepted, or proposed. */
    char title[EXCHANGE_TITLE_SIZE]; /**< As people called it then. */
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
 * After origins_take(): what is proposed in `snapshot`, and its registration, if the events do not
 * tell of it.
 *
 * @satisfies SWR-IGTL-071
 * @satisfies SWR-PLAN-022
 */
void origins_take_shown(origins_t *self, const exchange_t *exchange, const snapshot_t *snapshot);

#endif

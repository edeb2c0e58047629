/* SPDX-License-Identifier: Apache-2.0 */
/** @file Passes the commands of a dialect on to the controller. */
#ifndef BORESIGHT_IGTL_RELAY_H
#define BORESIGHT_IGTL_RELAY_H

#include "igtl/dialect/igtl_requests.h"
#include "exchange/exchange.h"

#include <stdbool.h>
#include <stdint.h>

/** Takes the answer to a command that was not passed on. */
typedef bool (*igtl_relay_hand_in_t)(const answer_t *answer);

/**
 * Passes on the queue of `requests`. A command that the exchange does not take is handed in as
 * refused, in `workphase`; STOP and EMERGENCY wait for the next turn, and until they are through no
 * later command goes ahead.
 */
void igtl_relay_requests(exchange_t *exchange, igtl_requests_t *requests, uint32_t workphase,
                         igtl_relay_hand_in_t hand_in);

/** A command is on its way to the controller. */
bool igtl_relay_awaits_answer(const igtl_requests_t *requests);

#endif

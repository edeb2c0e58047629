/* SPDX-License-Identifier: Apache-2.0 */
/** @file Time that clients wait for control. */
#ifndef BORESIGHT_ANSWER_TIMEOUT_H
#define BORESIGHT_ANSWER_TIMEOUT_H

#include "exchange/exchange.h"

#include <stdint.h>

#define ANSWER_POLL_MS 2U /**< From one look for the answer to the next. */

/** Looks without an answer before control counts as silent: 500 ms of the board's time.
 * Looks are counted and no time, as a pause of the machine is one look; a slow board answers
 * slowly.
 */
uint32_t answer_timeout_looks(const exchange_t *exchange);

/** Waits until the next look. */
void answer_timeout_wait(void);

#endif

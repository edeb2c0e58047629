/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Gathers what the events say of a sweep and keeps its curve once it is done. Owned by the
 * recorder; one that was started again goes through the events that are still there, and writes the
 * same once more.
 */
#ifndef BORESIGHT_SWEEP_KEEPER_H
#define BORESIGHT_SWEEP_KEEPER_H

#include "exchange/exchange.h"
#include "sweep/sweep_curve.h"

#include <stdbool.h>
#include <stdint.h>

/** At first all zero but directory and robot. */
typedef struct {
    const char *directory; /**< Lives as long as the keeper. */
    const robot_t *robot;  /**< The same. */
    uint32_t next;         /**< Number of the event that is looked at next. */
    bool is_gathering;     /**< Since a sweep has begun. */
    sweep_curve_t curve;
    sweep_point_t point; /**< The present one. */
} sweep_keeper_t;

/**
 * Takes one event, the next after those before; `lost`: there were others between.
 *
 * @return false when the curve of a sweep that was done could not be kept, with errno set
 *
 * @satisfies SWR-SWEEP-010
 */
bool sweep_keeper_hear(sweep_keeper_t *self, const exchange_event_t *event, uint32_t lost);

/** Takes all events that the exchange has gained. A curve that cannot be kept is reported on
 * stderr. */
void sweep_keeper_drain(sweep_keeper_t *self, const exchange_t *exchange);

#endif

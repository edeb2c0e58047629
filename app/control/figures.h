/* SPDX-License-Identifier: Apache-2.0 */
/** @file The loop's punctuality as histograms of one microsecond, from which the published figures
 * are read. */
#ifndef BORESIGHT_FIGURES_H
#define BORESIGHT_FIGURES_H

#include "exchange/exchange.h"

#include <stdint.h>

#define FIGURES_BUCKETS 4096U /**< The last one collects everything longer. */

typedef struct {
    uint32_t count[FIGURES_BUCKETS];
    uint64_t total;
    uint32_t worst_us;
} histogram_t;

typedef struct {
    histogram_t stages[LOOP_STAGE_COUNT];
    uint32_t second_worst_us; /**< To wake up. */
} figures_t;

/** Counts one value. */
void histogram_add(histogram_t *self, uint64_t value_us);

/** Smallest value that `per_mille` of the counts do not exceed; 0 when empty. */
uint32_t histogram_quantile_us(const histogram_t *self, uint32_t per_mille);

/** Counts one cycle with the duration of each of its stages. */
void figures_add(figures_t *self, const uint64_t stage_ns[LOOP_STAGE_COUNT]);

/**
 * Fills the times of `published` and begins a new second.
 *
 * @satisfies SWR-LOOP-005
 */
void figures_publish(figures_t *self, loop_figures_t *published);

#endif

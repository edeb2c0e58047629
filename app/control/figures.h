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
    histogram_t wake; /**< Actual minus intended wake-up. */
    histogram_t step; /**< Duration of controller_step. */
    uint32_t second_worst_us;
} figures_t;

/** Counts one value. */
void histogram_add(histogram_t *self, uint64_t value_us);

/** Smallest value that `per_mille` of the counts do not exceed; 0 when empty. */
uint32_t histogram_quantile_us(const histogram_t *self, uint32_t per_mille);

/** Counts one cycle. */
void figures_add(figures_t *self, uint64_t wake_us, uint64_t step_us);

/** Fills the times of `published` and begins a new second. */
void figures_publish(figures_t *self, loop_figures_t *published);

#endif

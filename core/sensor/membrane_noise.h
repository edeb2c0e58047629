/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Noise of the force as the membrane detector sees it: behind its filter, measured while the needle
 * stands out of the tissue, as at zeroing. The zeroing owns one. The design is ours.
 */
#ifndef BORESIGHT_MEMBRANE_NOISE_H
#define BORESIGHT_MEMBRANE_NOISE_H

#include "sensor/membrane_filter.h"

#include <stdbool.h>
#include <stdint.h>

/** All zero at first. */
typedef struct {
    membrane_filter_t filter;
    uint32_t count;           /**< Of milliseconds, LIMIT_MEMBRANE_SETTLE_MS among them. */
    int32_t first_mn_q12;     /**< Filtered force from which the sums are counted. */
    int64_t sum_mn_q12;       /**< Of the differences from it. */
    uint64_t squares_mn2_q24; /**< Of the same, squared. */
} membrane_noise_t;

/**
 * One millisecond at rest.
 *
 * @param force_mn any; what is further than 4 N from the first is counted as 4 N
 */
void membrane_noise_step(membrane_noise_t *self, int32_t force_mn);

/** LIMIT_MEMBRANE_NOISE_MS have been measured; further ones change nothing. */
bool membrane_noise_is_done(const membrane_noise_t *self);

/**
 * Standard deviation of the filtered force, uN, 0..4,000,000, rounded down:
 *
 *     sqrt(sum d^2 / n - (sum d / n)^2)
 *
 * 0 before membrane_noise_is_done().
 *
 * @satisfies SWR-PUNCT-542
 */
uint32_t membrane_noise_un(const membrane_noise_t *self);

#endif

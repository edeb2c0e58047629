/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Noise of the force as the membrane detector sees it: behind its filter, measured while the needle
 * stands out of the tissue, as at zeroing. The zeroing owns one. The design is ours:
 *
 *     s = max(deviation of the filtered force, LIMIT_MEMBRANE_WHITE_PERMILLE of that of the force)
 *     deviation = sqrt(sum d^2 / n - (sum d / n)^2)
 *
 * The first is right for noise of any colour, and uncertain: behind a filter of 20 Hz a second has
 * some forty independent values. The second, the share of white noise that passes the filter, is
 * certain and holds the first up.
 */
#ifndef BORESIGHT_MEMBRANE_NOISE_H
#define BORESIGHT_MEMBRANE_NOISE_H

#include "sensor/membrane_filter.h"

#include <stdbool.h>
#include <stdint.h>

/** Sums of values, counted from their first. */
typedef struct {
    int32_t first_mn_q12;
    int64_t sum_mn_q12;
    int64_t squares_mn2_q24;
} membrane_sums_t;

/** All zero at first. */
typedef struct {
    membrane_filter_t filter;
    uint32_t count; /**< Of milliseconds, LIMIT_MEMBRANE_SETTLE_MS among them. */
    membrane_sums_t filtered;
    membrane_sums_t forces;
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
 * s, uN, 0..4,000,000, rounded down; 0 before membrane_noise_is_done().
 *
 * @satisfies SWR-PUNCT-542
 */
uint32_t membrane_noise_un(const membrane_noise_t *self);

#endif

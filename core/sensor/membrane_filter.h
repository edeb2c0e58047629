/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Low-pass of the force in which membranes are looked for: Butterworth of second order,
 * LIMIT_MEMBRANE_FILTER_HZ, for one sample each millisecond. The design is ours; the equation is
 * the bilinear transform of Oppenheim and Schafer, Discrete-Time Signal Processing:
 *
 *     K = tan(pi f / fs),  n = 1 + sqrt(2) K + K^2
 *     y = b (x + 2 x' + x'') - a1 y' - a2 y''
 *     b = K^2 / n,  a1 = 2 (K^2 - 1) / n,  a2 = (1 - sqrt(2) K + K^2) / n
 *
 * In integers its gain at rest is exactly one. It delays by 11 ms. White noise of one sample each
 * millisecond leaves it with 0.21 of its standard deviation. Detector and noise own one each.
 */
#ifndef BORESIGHT_MEMBRANE_FILTER_H
#define BORESIGHT_MEMBRANE_FILTER_H

#include <stdbool.h>
#include <stdint.h>

/** One millinewton, in the unit of filtered forces. */
#define MEMBRANE_MN_Q12 INT32_C(4096)

/** All zero at first: the next force is taken as one that has been there always. */
typedef struct {
    int32_t in_mn_q12[2];  /**< x' and x''. */
    int32_t out_mn_q12[2]; /**< y' and y''. */
    uint32_t is_running;   /**< 0 or 1. */
} membrane_filter_t;

/**
 * One millisecond.
 *
 * @param force_mn any; beyond LIMIT_MEMBRANE_MOST_MN to either side it counts as that
 * @return the filtered force, mN with 12 fraction bits
 *
 * @satisfies SWR-PUNCT-543
 */
int32_t membrane_filter_step(membrane_filter_t *self, int32_t force_mn);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Chance that is the same on every run. */
#ifndef BORESIGHT_PRNG_H
#define BORESIGHT_PRNG_H

#include <stdint.h>

/** 0 to below `bound`, by xorshift32; `random` is not 0. */
static inline uint32_t prng_below(uint32_t *random, uint32_t bound)
{
    *random ^= *random << 13;
    *random ^= *random >> 17;
    *random ^= *random << 5;
    return *random % bound;
}

#endif

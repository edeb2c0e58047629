/* SPDX-License-Identifier: Apache-2.0 */
/** @file Reproducible chance for the simulated box: the same seed gives the same sequence on every
 * machine. */
#ifndef BORESIGHT_SIM_RANDOM_H
#define BORESIGHT_SIM_RANDOM_H

#include <stdint.h>

/** A stream of pseudo-random numbers (splitmix64, Steele et al. 2014). Seed it by assigning
 * `state`. */
typedef struct {
    uint64_t state;
} sim_random_t;

#define SIM_RANDOM_STEP UINT64_C(0x9E3779B97F4A7C15)

/** Leaves out the next `count` numbers. */
static inline void sim_random_pass(sim_random_t *self, uint32_t count)
{
    self->state += SIM_RANDOM_STEP * count;
}

/** The next number, all 32-bit values equally likely. */
static inline uint32_t sim_random_next(sim_random_t *self)
{
    self->state += SIM_RANDOM_STEP;
    uint64_t mixed = self->state;
    mixed = (mixed ^ (mixed >> 30U)) * UINT64_C(0xBF58476D1CE4E5B9);
    mixed = (mixed ^ (mixed >> 27U)) * UINT64_C(0x94D049BB133111EB);
    return (uint32_t)((mixed ^ (mixed >> 31U)) >> 32U);
}

/** The next number in 0..`count` - 1; `count` is at least 1. */
static inline uint32_t sim_random_below(sim_random_t *self, uint32_t count)
{
    return (uint32_t)(((uint64_t)sim_random_next(self) * count) >> 32U);
}

/** The next number in [-1, 1). */
static inline double sim_random_signed(sim_random_t *self)
{
    return (double)sim_random_next(self) / 2147483648.0 - 1.0;
}

/** The next number of a distribution near the normal one, of standard deviation 1 and at most 3.5:
 * a sum of four equally distributed numbers from -1 to 1, whose own deviation is sqrt(4 / 3). */
static inline double sim_random_normal(sim_random_t *self)
{
    double sum = 0.0;

    for (uint32_t i = 0U; i < 4U; i++) {
        sum += sim_random_signed(self);
    }
    return sum * 0.86602540378443865;
}

#endif

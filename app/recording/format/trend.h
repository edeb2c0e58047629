/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The expectation of a word: that it continues as before. It stands still, or it changes by as much
 * as twice before, as a counter does, or by as much as the time that has passed, as a clock does.
 * A word that is as expected needs not be stored. All zero is the beginning: still, at zero.
 */
#ifndef BORESIGHT_TREND_H
#define BORESIGHT_TREND_H

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    uint32_t value;    /**< In the cycle before. */
    uint32_t change;   /**< Since the one before that. */
    uint32_t step;     /**< The last change that came twice in a row. */
    uint32_t is_clock; /**< 0 or 1: it changes by the time that passes. */
} trend_t;

static inline uint32_t trend_expected(const trend_t *self, uint32_t elapsed_us)
{
    return self->value + ((self->is_clock != 0U) ? elapsed_us : self->step);
}

/**
 * Takes the value of this cycle.
 *
 * @return it was as expected; otherwise `expected` is what was
 */
static inline bool trend_take(trend_t *self, uint32_t value, uint32_t elapsed_us,
                              uint32_t *expected)
{
    const uint32_t change = value - self->value;

    /* Most words stand still most of the time. */
    if ((change | self->change | self->step | self->is_clock) == 0U) {
        return true;
    }
    *expected = trend_expected(self, elapsed_us);
    const bool is_expected = value == *expected;
    if (!is_expected) {
        self->is_clock = (change == elapsed_us) ? 1U : 0U;
    }
    if (change == self->change) {
        self->step = change;
    }
    self->change = change;
    self->value = value;
    return is_expected;
}

#endif

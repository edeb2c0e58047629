/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The clock by which timeouts of answers run. Control owes an answer in its own time: the time of
 * the board may be slow, a pause of the machine stops control as well, and on a busy machine it has
 * fewer cycles. A silent control has no cycles, so the time of this process counts then. The
 * process owns one.
 */
#ifndef BORESIGHT_IGTL_TIMEOUT_CLOCK_H
#define BORESIGHT_IGTL_TIMEOUT_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

/** At first all zero. */
typedef struct {
    uint64_t listened_ns; /**< Time of this process, in the board's time, without its pauses. */
    uint64_t timeout_ns;  /**< Time that counts for a timeout. */
    uint64_t cycles_ns;   /**< Time of control's cycles, as far as it is not in timeout_ns. */
    uint32_t beats;       /**< Cycles of control that are counted so far. */
} igtl_timeout_clock_t;

/**
 * A turn of the process has ended. `elapsed_us`: since the one before; `slowness`: of the board's
 * time, at least 1; `beats`: cycles of control, wraps; `is_silent`: control has had none for long.
 *
 * @satisfies SWR-IGTL-100
 * @satisfies SWR-IGTL-101
 */
void igtl_timeout_clock_step(igtl_timeout_clock_t *self, uint64_t elapsed_us, uint32_t slowness,
                             uint32_t beats, bool is_silent);

/** Time that counts for a timeout. */
static inline uint64_t igtl_timeout_clock_us(const igtl_timeout_clock_t *self)
{
    return self->timeout_ns / 1000U;
}

/** Time for which this process has listened to control. */
static inline uint64_t igtl_timeout_clock_listened_us(const igtl_timeout_clock_t *self)
{
    return self->listened_ns / 1000U;
}

#endif

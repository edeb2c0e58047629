/* SPDX-License-Identifier: Apache-2.0 */
/** @file The clocks of the machine. */
#ifndef BORESIGHT_CLOCK_H
#define BORESIGHT_CLOCK_H

#include <stdint.h>

/** Monotonic time in us, for durations. */
uint64_t clock_monotonic_us(void);

/** UTC in us since 1970; may jump. */
uint64_t clock_utc_us(void);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
#include "common/clock.h"

#include <time.h>

static uint64_t read_us(clockid_t clock)
{
    struct timespec now;

    (void)clock_gettime(clock, &now);
    return ((uint64_t)now.tv_sec * UINT64_C(1000000)) + ((uint64_t)now.tv_nsec / 1000U);
}

uint64_t clock_monotonic_us(void)
{
    return read_us(CLOCK_MONOTONIC);
}

uint64_t clock_utc_us(void)
{
    return read_us(CLOCK_REALTIME);
}

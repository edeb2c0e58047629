/* SPDX-License-Identifier: Apache-2.0 */
/** @file How much time has passed. Threads ask for the time before they wait for each other, so it
 * may seem to go back. */
#ifndef BORESIGHT_PASSED_H
#define BORESIGHT_PASSED_H

#include <stdint.h>

/** From `since_ms` to `now_ms`; 0 when that is earlier. */
static inline uint64_t passed_ms(uint64_t since_ms, uint64_t now_ms)
{
    return (now_ms > since_ms) ? (now_ms - since_ms) : 0U;
}

#endif

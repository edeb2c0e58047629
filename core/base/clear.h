/* SPDX-License-Identifier: Apache-2.0 */
/** @file Zeros for words of memory, cheap enough for every cycle: memset() of the C library takes
 * nearly two instructions a word. */
#ifndef BORESIGHT_CLEAR_H
#define BORESIGHT_CLEAR_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/** So many bytes at a time; what the compiler writes straight on is a quarter of it. */
#define CLEAR_STRIDE 64U

/** Sets `length` bytes to zero, a multiple of 4. */
static inline void clear_words(uint8_t *bytes, size_t length)
{
    uint8_t *at = bytes;
    size_t left = length;
    for (; left >= CLEAR_STRIDE; left -= CLEAR_STRIDE) {
        (void)memset(at, 0, CLEAR_STRIDE / 4U);
        (void)memset(&at[CLEAR_STRIDE / 4U], 0, CLEAR_STRIDE / 4U);
        (void)memset(&at[CLEAR_STRIDE / 2U], 0, CLEAR_STRIDE / 4U);
        (void)memset(&at[(CLEAR_STRIDE / 4U) * 3U], 0, CLEAR_STRIDE / 4U);
        at = &at[CLEAR_STRIDE];
    }
    for (; left >= (CLEAR_STRIDE / 4U); left -= CLEAR_STRIDE / 4U) {
        (void)memset(at, 0, CLEAR_STRIDE / 4U);
        at = &at[CLEAR_STRIDE / 4U];
    }
    for (; left > 0U; left -= 4U) {
        (void)memset(at, 0, 4U);
        at = &at[4];
    }
}

#endif

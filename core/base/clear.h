/* SPDX-License-Identifier: Apache-2.0 */
/** @file Zeros for words of memory, cheap enough for every cycle: memset() of the C library takes
 * nearly two instructions a word. */
#ifndef BORESIGHT_CLEAR_H
#define BORESIGHT_CLEAR_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/** Sixteen words. */
static inline void clear_sixteen(uint8_t *bytes)
{
    (void)memset(bytes, 0, 16U);
    (void)memset(&bytes[16], 0, 16U);
    (void)memset(&bytes[32], 0, 16U);
    (void)memset(&bytes[48], 0, 16U);
}

/** Sets `length` bytes to zero, a multiple of 4. Thirty-two words at a time, which the compiler
 * writes straight on. */
static inline void clear_words(uint8_t *bytes, size_t length)
{
    uint8_t *at = bytes;
    size_t left = length;
    for (; left >= 128U; left -= 128U) {
        clear_sixteen(at);
        clear_sixteen(&at[64]);
        at = &at[128];
    }
    for (; left >= 64U; left -= 64U) {
        clear_sixteen(at);
        at = &at[64];
    }
    for (; left >= 16U; left -= 16U) {
        (void)memset(at, 0, 16U);
        at = &at[16];
    }
    for (; left > 0U; left -= 4U) {
        (void)memset(at, 0, 4U);
        at = &at[4];
    }
}

/** The same for an address that is a multiple of 4, too, as those of our structures are: with that
 * known, the compiler writes two words at once. */
static inline void clear_aligned_words(uint8_t *bytes, size_t length)
{
    clear_words((uint8_t *)__builtin_assume_aligned(bytes, 4U), length);
}

#endif

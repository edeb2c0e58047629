/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/wire/igtl_crc64.h"

#include "igtl/wire/big_endian.h"
#include "message/crc64_table.h"

#define WORD_BYTES 8U

/* The remainders of eight bytes do not wait for each other. */
static inline uint64_t after_word(uint64_t word)
{
    return crc64_table[7][word >> 56U] ^ crc64_table[6][(word >> 48U) & 0xFFU] ^
           crc64_table[5][(word >> 40U) & 0xFFU] ^ crc64_table[4][(word >> 32U) & 0xFFU] ^
           crc64_table[3][(word >> 24U) & 0xFFU] ^ crc64_table[2][(word >> 16U) & 0xFFU] ^
           crc64_table[1][(word >> 8U) & 0xFFU] ^ crc64_table[0][word & 0xFFU];
}

uint64_t igtl_crc64(uint64_t crc, const uint8_t *bytes, size_t length)
{
    const size_t in_words = length - (length % WORD_BYTES);
    uint64_t state = crc;

    for (size_t i = 0U; i < in_words; i += WORD_BYTES) {
        state = after_word(state ^ get_u64(&bytes[i]));
    }
    for (size_t i = in_words; i < length; i++) {
        state = (state << 8U) ^ crc64_table[0][(state >> 56U) ^ bytes[i]];
    }
    return state;
}

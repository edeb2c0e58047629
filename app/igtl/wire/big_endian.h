/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Numbers as OpenIGTLink sends them, first byte highest. By shifts, so that neither the machine's
 * order of bytes nor an alignment matters; a compiler makes one instruction of each.
 */
#ifndef BORESIGHT_BIG_ENDIAN_H
#define BORESIGHT_BIG_ENDIAN_H

#include <stdint.h>

static inline uint32_t get_u16(const uint8_t *bytes)
{
    return ((uint32_t)bytes[0] << 8U) | bytes[1];
}

static inline uint32_t get_u32(const uint8_t *bytes)
{
    return ((uint32_t)bytes[0] << 24U) | ((uint32_t)bytes[1] << 16U) | ((uint32_t)bytes[2] << 8U) |
           bytes[3];
}

static inline uint64_t get_u64(const uint8_t *bytes)
{
    return ((uint64_t)bytes[0] << 56U) | ((uint64_t)bytes[1] << 48U) | ((uint64_t)bytes[2] << 40U) |
           ((uint64_t)bytes[3] << 32U) | ((uint64_t)bytes[4] << 24U) | ((uint64_t)bytes[5] << 16U) |
           ((uint64_t)bytes[6] << 8U) | bytes[7];
}

static inline void put_u16(uint8_t *bytes, uint32_t value)
{
    bytes[0] = (uint8_t)(value >> 8U);
    bytes[1] = (uint8_t)value;
}

static inline void put_u32(uint8_t *bytes, uint32_t value)
{
    bytes[0] = (uint8_t)(value >> 24U);
    bytes[1] = (uint8_t)(value >> 16U);
    bytes[2] = (uint8_t)(value >> 8U);
    bytes[3] = (uint8_t)value;
}

static inline void put_u64(uint8_t *bytes, uint64_t value)
{
    bytes[0] = (uint8_t)(value >> 56U);
    bytes[1] = (uint8_t)(value >> 48U);
    bytes[2] = (uint8_t)(value >> 40U);
    bytes[3] = (uint8_t)(value >> 32U);
    bytes[4] = (uint8_t)(value >> 24U);
    bytes[5] = (uint8_t)(value >> 16U);
    bytes[6] = (uint8_t)(value >> 8U);
    bytes[7] = (uint8_t)value;
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Numbers as they stand in files: the lowest byte first, on each machine. */
#ifndef BORESIGHT_LITTLE_ENDIAN_H
#define BORESIGHT_LITTLE_ENDIAN_H

#include <stdint.h>

static inline void put32(uint8_t *bytes, uint32_t value)
{
    for (uint32_t i = 0U; i < 4U; i++) {
        bytes[i] = (uint8_t)(value >> (8U * i));
    }
}

static inline void put64(uint8_t *bytes, uint64_t value)
{
    put32(bytes, (uint32_t)value);
    put32(&bytes[4], (uint32_t)(value >> 32));
}

static inline uint32_t get32(const uint8_t *bytes)
{
    return (uint32_t)bytes[0] | ((uint32_t)bytes[1] << 8) | ((uint32_t)bytes[2] << 16) |
           ((uint32_t)bytes[3] << 24);
}

static inline uint64_t get64(const uint8_t *bytes)
{
    return (uint64_t)get32(bytes) | ((uint64_t)get32(&bytes[4]) << 32);
}

#endif

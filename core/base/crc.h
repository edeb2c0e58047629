/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * CRC-32C (Castagnoli; RFC 3720, appendix B.4), the checksum of card frames, of the robot table and
 * of records. Four bytes a step, by tables of 5 kB.
 */
#ifndef BORESIGHT_CRC_H
#define BORESIGHT_CRC_H

#include <stddef.h>
#include <stdint.h>

/** How many zeros crc32c_extend_over_zeros() passes. */
typedef enum {
    CRC32C_ZEROS_132 = 0, /**< 132 bytes. */
    CRC32C_ZEROS_172 = 1  /**< 172 bytes. */
} crc32c_zeros_t;

/** CRC-32C of `length` bytes; 0 for none. "123456789" gives 0xE3069283. */
uint32_t crc32c(const uint8_t *bytes, size_t length);

/** CRC-32C of what gave `crc`, followed by `before` bytes, by `zeros`, which are not read, and by
 * `after` bytes; both are multiples of 4. */
uint32_t crc32c_extend_over_zeros(uint32_t crc, const uint8_t *bytes, size_t before,
                                  crc32c_zeros_t zeros, size_t after);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * CRC-32C (Castagnoli; RFC 3720, appendix B.4), the checksum of card frames, of the robot table and
 * of records. Four bytes a step, by tables of 4.5 kB.
 */
#ifndef BORESIGHT_CRC_H
#define BORESIGHT_CRC_H

#include <stddef.h>
#include <stdint.h>

#define CRC32C_ZEROS 128U /**< Bytes that crc32c_extend_by_zeros() adds. */

/** CRC-32C of `length` bytes; 0 for none. "123456789" gives 0xE3069283. */
uint32_t crc32c(const uint8_t *bytes, size_t length);

/** CRC-32C of what gave `crc`, followed by `length` bytes. */
uint32_t crc32c_extend(uint32_t crc, const uint8_t *bytes, size_t length);

/** CRC-32C of what gave `crc`, followed by CRC32C_ZEROS bytes of zero, without reading them. */
uint32_t crc32c_extend_by_zeros(uint32_t crc);

#endif

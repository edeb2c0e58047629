/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * CRC-32C (Castagnoli; RFC 3720, appendix B.4), the checksum of card frames, of the robot table and
 * of records. Four bytes a step, by tables of 5.5 kB.
 */
#ifndef BORESIGHT_CRC_H
#define BORESIGHT_CRC_H

#include <stddef.h>
#include <stdint.h>

/** CRC-32C of `length` bytes; 0 for none. "123456789" gives 0xE3069283. */
uint32_t crc32c(const uint8_t *bytes, size_t length);

/** CRC-32C of what gave `crc`, followed by the 244 bytes that a frame has between its header and
 * its checksum: 108, then 132 zeros, which are not read, and 4 more. */
uint32_t crc32c_over_132(uint32_t crc, const uint8_t *bytes);

/** The same of 64 bytes, 172 zeros, and 8 more. */
uint32_t crc32c_over_172(uint32_t crc, const uint8_t *bytes);

/** As crc32c_over_132(), where 28 of the 108 bytes, from the 72nd on, are zeros: not read, either.
 */
uint32_t crc32c_over_28_and_132(uint32_t crc, const uint8_t *bytes);

/** As crc32c_over_172(), where 28 of the 64 bytes, from the 16th on, are zeros: not read, either.
 */
uint32_t crc32c_over_28_and_172(uint32_t crc, const uint8_t *bytes);

#endif

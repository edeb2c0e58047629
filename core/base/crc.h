/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * CRC-32C (Castagnoli; RFC 3720, appendix B.4), the checksum of card frames, of the robot table and
 * of records.
 */
#ifndef BORESIGHT_CRC_H
#define BORESIGHT_CRC_H

#include <stddef.h>
#include <stdint.h>

/** CRC-32C of `length` bytes; 0 for none. "123456789" gives 0xE3069283. */
uint32_t crc32c(const uint8_t *bytes, size_t length);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Contract of core/base/crc.h for Eva, in place of it: the bytes can be read and are
 * initialised, and the checksum is any. Under names of their own: `sums.c`
 * follows the real ones. */
#ifndef BORESIGHT_CRC_H
#define BORESIGHT_CRC_H

#include <stddef.h>
#include <stdint.h>

#define crc32c any_crc32c
#define crc32c_over_132 any_crc32c_over_132
#define crc32c_over_172 any_crc32c_over_172
#define crc32c_over_28_and_132 any_crc32c_over_28_and_132
#define crc32c_over_28_and_172 any_crc32c_over_28_and_172

/*@ requires readable: length > 0 ==> \valid_read(bytes + (0 .. length - 1));
    requires initialised: length > 0 ==> \initialized(bytes + (0 .. length - 1));
    assigns \result \from length, bytes[0 .. length - 1]; */
uint32_t any_crc32c(const uint8_t *bytes, size_t length);

/*@ requires readable: \valid_read(bytes + (0 .. 243));
    requires initialised: \initialized(bytes + (0 .. 243));
    assigns \result \from crc, bytes[0 .. 243]; */
uint32_t any_crc32c_over_132(uint32_t crc, const uint8_t *bytes);

/*@ requires readable: \valid_read(bytes + (0 .. 243));
    requires initialised: \initialized(bytes + (0 .. 243));
    assigns \result \from crc, bytes[0 .. 243]; */
uint32_t any_crc32c_over_172(uint32_t crc, const uint8_t *bytes);

/*@ requires readable: \valid_read(bytes + (0 .. 243));
    requires initialised: \initialized(bytes + (0 .. 243));
    assigns \result \from crc, bytes[0 .. 243]; */
uint32_t any_crc32c_over_28_and_132(uint32_t crc, const uint8_t *bytes);

/*@ requires readable: \valid_read(bytes + (0 .. 243));
    requires initialised: \initialized(bytes + (0 .. 243));
    assigns \result \from crc, bytes[0 .. 243]; */
uint32_t any_crc32c_over_28_and_172(uint32_t crc, const uint8_t *bytes);

#endif

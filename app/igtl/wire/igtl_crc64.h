/* SPDX-License-Identifier: Apache-2.0 */
/** @file The checksum of OpenIGTLink: CRC-64 of ECMA-182, not reflected, starts at 0. */
#ifndef BORESIGHT_IGTL_CRC64_H
#define BORESIGHT_IGTL_CRC64_H

#include <stddef.h>
#include <stdint.h>

/** Continues `crc` over `length` bytes. "123456789" gives 0x6C40DF5F0B497347. */
uint64_t igtl_crc64(uint64_t crc, const uint8_t *bytes, size_t length);

#endif

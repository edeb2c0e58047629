/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A seal over words of memory, cheap enough for every cycle: seal = (seal rotated by 5) + word, two
 * instructions a word. Each step can be undone, so any change within one word of 32 bits, of
 * however many of its bits, changes the seal for certain. Changes of several words that have
 * nothing to do with each other are missed once in 2^32. Two words that are a multiple of 32 words
 * apart and change by the opposite amount are missed. It is no CRC: what crosses a wire has one
 * (crc.h).
 */
#ifndef BORESIGHT_SEAL_H
#define BORESIGHT_SEAL_H

#include <stddef.h>
#include <stdint.h>

/** Where a seal begins; so that memory that was cleared, and its seal with it, is damaged. */
#define SEAL_START 0x5EA1ED00U

/** The seal of `length` bytes, a multiple of 4, in continuation of `seal`. */
uint32_t seal_of(uint32_t seal, const uint8_t *bytes, size_t length);

#endif

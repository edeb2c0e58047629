/* SPDX-License-Identifier: Apache-2.0 */
/** @file Contract of core/base/seal.h for Eva, in place of it: the bytes can be read and are
 * initialised, and the seal is any. `sums.c` follows the real one. */
#ifndef BORESIGHT_SEAL_H
#define BORESIGHT_SEAL_H

#include <stddef.h>
#include <stdint.h>

#define SEAL_START 0x5EA1ED00U

/* The compiler has judged it. */
#define WHOLE_WORDS(bytes) ((size_t)(bytes))

/*@ requires readable: length > 0 ==> \valid_read(bytes + (0 .. length - 1));
    requires initialised: length > 0 ==> \initialized(bytes + (0 .. length - 1));
    assigns \result \from seal, length, bytes[0 .. length - 1]; */
uint32_t seal_of(uint32_t seal, const uint8_t *bytes, size_t length);

#endif

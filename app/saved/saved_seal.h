/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The seal of saved positions: an HMAC-SHA-256 over their record with a key that only this box has.
 * A changed position or time does not match the seal.
 */
#ifndef BORESIGHT_SAVED_SEAL_H
#define BORESIGHT_SAVED_SEAL_H

#include "positions/position_record.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define SAVED_KEY_SIZE 32U
#define SAVED_SEAL_SIZE 32U

typedef struct {
    uint8_t bytes[SAVED_KEY_SIZE];
} saved_key_t;

/**
 * Reads the key in the file `path`; makes it, of random bytes, if none exists.
 *
 * @return false with a sentence in `error`: it cannot be made or read, is not a whole key, or is
 * not its owner's alone
 *
 * @satisfies SWR-STORE-025
 */
bool saved_key_open(saved_key_t *self, const char *path, char *error, size_t error_size);

/** Fills SAVED_SEAL_SIZE bytes. False when the library is out of memory. */
bool saved_seal_make(const saved_key_t *key, const position_record_t *record, uint8_t *seal);

/** Whether SAVED_SEAL_SIZE bytes are the seal of `record`; takes as long wherever they differ. */
bool saved_seal_fits(const saved_key_t *key, const position_record_t *record, const uint8_t *seal);

#endif

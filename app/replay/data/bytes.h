/* SPDX-License-Identifier: Apache-2.0 */
/** @file Bytes in memory that grow as they are written; without memory for them the process ends.
 * Numbers are little endian. All zero is empty. */
#ifndef BORESIGHT_BYTES_H
#define BORESIGHT_BYTES_H

#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint8_t *at;
    size_t used;
    size_t room;
} bytes_t;

/** Empties; keeps the room. */
void bytes_clear(bytes_t *self);
void bytes_free(bytes_t *self);

void bytes_put(bytes_t *self, const void *from, size_t size);
void bytes_put8(bytes_t *self, uint8_t value);
void bytes_put16(bytes_t *self, uint16_t value);
void bytes_put32(bytes_t *self, uint32_t value);
void bytes_put64(bytes_t *self, uint64_t value);

/** Puts text as printf() makes it, without its end. */
void bytes_print(bytes_t *self, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Puts `text` in quotes, as JSON has it. */
void bytes_quote(bytes_t *self, const char *text);

#endif

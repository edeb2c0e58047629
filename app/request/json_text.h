/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * JSON text, piece by piece, as strict as RFC 8259: no leading zeros, no control characters, only
 * well-formed UTF-8. A zero byte is no part of a text. Every byte is looked at once; nothing is
 * allocated.
 */
#ifndef BORESIGHT_JSON_TEXT_H
#define BORESIGHT_JSON_TEXT_H

#include "request/request_fault.h"

#include <stdbool.h>
#include <stddef.h>

/** Where the reading stands. */
typedef struct {
    const char *bytes;
    size_t size;
    size_t place;
} json_text_t;

/** The next byte that is no white space, '\0' at the end. */
char json_text_peek(json_text_t *self);

/** Takes `wanted` if it is the next byte that is no white space. */
bool json_text_take(json_text_t *self, char wanted);

/** Nothing but white space is left. */
bool json_text_is_at_end(json_text_t *self);

/**
 * Reads a string into `text`, which has room for `size` bytes, the zero byte at the end included.
 *
 * @return REQUEST_OK; REQUEST_TOO_LONG; REQUEST_NOT_JSON
 */
request_fault_t json_text_string(json_text_t *self, char *text, size_t size);

/** Takes a word or a number as it stands. Returns its length, 0 when none exists. */
size_t json_text_scalar(json_text_t *self, const char **start);

/** Something else that JSON may have at this place: a value of another type. */
bool json_text_is_value(json_text_t *self);

#endif

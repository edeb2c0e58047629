/* SPDX-License-Identifier: Apache-2.0 */
/** @file A single value as text becomes what its field says. */
#ifndef BORESIGHT_REQUEST_VALUE_H
#define BORESIGHT_REQUEST_VALUE_H

#include "request/request_fault.h"
#include "request/request_fields.h"

#define REQUEST_NUMBER_SIZE 64U /**< Longest number, its end included. */

/** Whether `size` bytes are a word or a number of JSON. */
bool request_value_is_json(const char *text, size_t size);

/** Reads flag and numbers: `size` bytes that shall be nothing else. */
request_fault_t request_value_read(const request_field_t *field, const char *text, size_t size,
                                   void *value);

/** Finds the word of `field` that `text` is. */
request_fault_t request_value_word(const request_field_t *field, const char *text, void *value);

#endif

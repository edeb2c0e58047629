/* SPDX-License-Identifier: Apache-2.0 */
/** @file Sentences about the value that a field expects: its type, unit and range. */
#ifndef BORESIGHT_REQUEST_EXPECTED_H
#define BORESIGHT_REQUEST_EXPECTED_H

#include "request/request_fault.h"

/** Where a value stands, and its type where that is another one than expected. */
typedef struct {
    const request_field_t *field;
    bool is_element;   /**< It is one value of a list, not the list. */
    const char *found; /**< Type of the value, of request_expected_type(); NULL: not of interest. */
} request_asked_t;

/**
 * The type of a value by its first byte, as people call it, such as "a string". `is_whole` asks
 * for a whole number, which this one is not. Lives as long as the process.
 */
const char *request_expected_type(char first, bool is_whole);

/**
 * Adds to the text of `result` the type, unit and range that are expected; where the type was
 * found to be another one, that sentence replaces the text.
 *
 * @satisfies SWR-HTTP-079
 * @satisfies SWR-HTTP-153
 * @satisfies SWR-HTTP-300
 */
void request_expected_add(request_result_t *result, const request_asked_t *asked);

#endif

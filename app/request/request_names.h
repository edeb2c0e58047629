/* SPDX-License-Identifier: Apache-2.0 */
/** @file What bodies and queries have in common: fields are found by their names, once each. */
#ifndef BORESIGHT_REQUEST_NAMES_H
#define BORESIGHT_REQUEST_NAMES_H

#include "request/request_fault.h"
#include "request/request_fields.h"

/** Finds the field `name` and marks it in `seen`. REQUEST_UNKNOWN or REQUEST_TWICE otherwise. */
request_fault_t request_names_find(const request_message_t *message, const char *name,
                                   uint32_t *seen, const request_field_t **field);

/** The first field that must be there and is not in `seen`; NULL: none. */
const request_field_t *request_names_missing(const request_message_t *message, uint32_t seen);

/** Notes in `structure` that an optional value is there, or the number of values in a list. */
void request_names_report(const request_field_t *field, uint32_t count, void *structure);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Reads the body of a request into a structure, by tables (request_fields.h) and with no regard to
 * anything else: what is not expected is refused where it stands, so nothing has to be skipped and
 * no input decides how deep the reading goes. Nothing is allocated; each byte is looked at once.
 */
#ifndef BORESIGHT_REQUEST_BODY_H
#define BORESIGHT_REQUEST_BODY_H

#include "request/request_fault.h"
#include "request/request_fields.h"

/**
 * Reads a body, `size` bytes of JSON text, into `structure`. An empty body is an object without
 * members. After a fault `structure` holds what was read before it.
 *
 * @satisfies SWR-HTTP-011
 */
request_result_t request_read_body(const request_message_t *message, const char *bytes, size_t size,
                                   void *structure);

#endif

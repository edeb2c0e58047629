/* SPDX-License-Identifier: Apache-2.0 */
/** @file Reads the query of a request into a structure, as request_body.h does with the body. */
#ifndef BORESIGHT_REQUEST_QUERY_H
#define BORESIGHT_REQUEST_QUERY_H

#include "request/request_fault.h"
#include "request/request_fields.h"

/**
 * Reads a query, what stands behind the question mark (NULL: nothing does), into `structure`. Lists
 * and objects cannot stand in it.
 *
 * @satisfies SWR-HTTP-012
 */
request_result_t request_read_query(const request_message_t *message, const char *query,
                                    void *structure);

#endif

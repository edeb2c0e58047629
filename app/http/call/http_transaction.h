/* SPDX-License-Identifier: Apache-2.0 */
/** @file What one request asks and is answered, as the log has it: bounded, without secrets. */
#ifndef BORESIGHT_HTTP_TRANSACTION_H
#define BORESIGHT_HTTP_TRANSACTION_H

#include "limits/requirement_limits.h"

#include <civetweb.h>
#include <stddef.h>

#define HTTP_TRANSACTION_REQUEST_SIZE (LIMIT_TRANSACTION_REQUEST_BYTES + 1U)
#define HTTP_TRANSACTION_ANSWER_SIZE (LIMIT_TRANSACTION_ANSWER_BYTES + 1U)

typedef struct {
    char request[HTTP_TRANSACTION_REQUEST_SIZE]; /**< "": no body was read. */
    char answer[HTTP_TRANSACTION_ANSWER_SIZE];   /**< "": none was sent. */
} http_transaction_t;

/**
 * Writes JSON of `size` bytes, the body of a request, to the `room` bytes of `text`: without
 * spaces between its words, "***" for the values of password, code, token and hmac, cut with its
 * size in bytes when it is longer.
 *
 * @satisfies SWR-EVENT-018
 */
void http_transaction_write_request(char *text, size_t room, const char *json, size_t size);

/** The same of an answer, in which nothing is hidden. */
void http_transaction_write_answer(char *text, size_t room, const char *json, size_t size);

/** Requests of `connection` and their answers are kept in `self` from now on, until
 * http_transaction_end(). */
void http_transaction_begin(http_transaction_t *self, const struct mg_connection *connection);

void http_transaction_end(const struct mg_connection *connection);

/** Keeps the body of its request; of one that is no JSON, by NULL, only the size. */
void http_transaction_keep_request(const struct mg_connection *connection, const char *json,
                                   size_t size);

/** Keeps its answer, JSON. */
void http_transaction_keep_answer(const struct mg_connection *connection, const char *json,
                                  size_t size);

#endif

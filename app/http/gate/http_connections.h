/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The connections of the console's port. Each has one of the library's workers to itself until its
 * request is answered. When workers run short, the connections whose request is not complete are
 * closed, the oldest first. A request that has come whole is answered all the same.
 */
#ifndef BORESIGHT_HTTP_CONNECTIONS_H
#define BORESIGHT_HTTP_CONNECTIONS_H

#include <civetweb.h>
#include <stdbool.h>
#include <stdint.h>

#define HTTP_CONNECTIONS_WORKERS 64U /**< Workers of the library. */

/** State of a connection. */
typedef enum {
    HTTP_LINE_READS = 0, /**< The body of its request is awaited. */
    HTTP_LINE_ASKS = 1   /**< Its request, or the head of it, has come. */
} http_line_t;

/**
 * A connection has got a worker, and its request is awaited. If few workers are left, the
 * oldest one that waits is closed.
 *
 * @satisfies SWR-LOAD-008
 * @satisfies SWR-LOAD-009
 */
void http_connections_enter(const struct mg_connection *connection);

/** It does something else now. */
void http_connections_note(const struct mg_connection *connection, http_line_t state);

/** Bytes that have come. */
uint64_t http_connections_received(const struct mg_connection *connection);

/** It is about to be closed. */
void http_connections_leave(const struct mg_connection *connection);

/** It is being closed for want of workers, its request unfinished. */
bool http_connections_is_leaving(const struct mg_connection *connection);

#endif

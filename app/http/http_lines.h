/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The connections of the console's port. Each has one of the library's workers to itself as long as
 * it is open, also between two requests. When workers run short, those that wait for a further
 * request are closed, the oldest first: nobody who asks something waits for somebody who does not.
 */
#ifndef BORESIGHT_HTTP_LINES_H
#define BORESIGHT_HTTP_LINES_H

#include <civetweb.h>
#include <stdbool.h>
#include <stdint.h>

#define HTTP_LINES_WORKERS 64U /**< Of the library. */

/** Forgets all. `port`: the console's; `front_port`: that of TLS, 0 without. To be called once,
 * before any connection. */
void http_lines_init(unsigned port, unsigned front_port);

/** A connection has got a worker. If few workers are left, the oldest idle one is closed. */
void http_lines_enter(const struct mg_connection *connection);

/** A request of it begins, or has been answered: then it is idle. */
void http_lines_note(const struct mg_connection *connection, bool is_idle);

/** Bytes that have come since its last request. */
uint64_t http_lines_received(const struct mg_connection *connection);

/** It is about to be closed. */
void http_lines_leave(const struct mg_connection *connection);

/**
 * There are workers enough to leave a connection open.
 *
 * @satisfies SWR-HTTP-018
 */
bool http_lines_has_room(void);

#endif

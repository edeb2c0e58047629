/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is served at which path. */
#ifndef BORESIGHT_HTTP_ROUTES_H
#define BORESIGHT_HTTP_ROUTES_H

#include "http/http_server.h"

#include <civetweb.h>

#define HTTP_ROUTES_BODY_MOST 256 /**< Longest body accepted, bytes. */

/**
 * Answers one request completely: a file of the console, /api/v1/status, motors, targeting, log or
 * events by GET, /api/v1/stop by POST, or a refusal.
 *
 * @return the status sent, never 0
 *
 * @satisfies SWR-HTTP-001
 * @satisfies SWR-HTTP-002
 * @satisfies SWR-HTTP-004
 */
int http_routes_answer(http_server_t *server, struct mg_connection *connection);

#endif

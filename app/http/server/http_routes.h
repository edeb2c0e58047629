/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is served at which path. */
#ifndef BORESIGHT_HTTP_ROUTES_H
#define BORESIGHT_HTTP_ROUTES_H

#include "http/server/http_server.h"

#include <civetweb.h>

/**
 * Answers one request completely: a route of routes.yml, a file of the console, or a refusal.
 *
 * @return the status sent, never 0
 *
 * @satisfies SWR-HTTP-001
 * @satisfies SWR-HTTP-002
 * @satisfies SWR-HTTP-004
 * @satisfies SWR-HTTP-015
 * @satisfies SWR-HTTP-016
 * @satisfies SWR-HTTP-019
 */
int http_routes_answer(http_server_t *server, struct mg_connection *connection);

#endif

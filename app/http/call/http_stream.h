/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Live values as server-sent events. One frame is kept, the newest: each client is served by a
 * thread of its own, takes whole frames, and misses some when it is slow. A client that takes
 * nothing is dropped; no other client waits for it.
 */
#ifndef BORESIGHT_HTTP_STREAM_H
#define BORESIGHT_HTTP_STREAM_H

#include "exchange/exchange.h"
#include "http/call/http_context.h"

#include <civetweb.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Starts without clients. `exchange` outlives `self`. */
void http_stream_init(http_stream_t *self, const exchange_t *exchange);

/** Whether a client listens. */
bool http_stream_is_watched(http_stream_t *self);

/** Hands `state`, JSON on one line, to all clients. False, and nothing sent, when too long. */
bool http_stream_publish(http_stream_t *self, const char *state);

/** Begins with `hello`, JSON on one line, and the acts from here on. False, as of those that
 * follow: the client has not taken it. */
bool http_stream_greet(http_stream_client_t *client, http_server_t *server, const char *hello);

/** Sends what happened since the time before. */
bool http_stream_send_news(http_stream_client_t *client, http_server_t *server);

/** Copies the frame if it is new to the client; under the lock. Returns its size; 0: it is not. */
size_t http_stream_take_frame(http_stream_t *self, http_stream_client_t *client);

/** Sends the `size` bytes of its copy; 0: that there is nothing new. */
bool http_stream_send_frame(const http_stream_client_t *client, size_t size);

/**
 * Serves one client until it goes away, takes nothing, or its session has ended: `hello` (JSON on
 * one line), the events from `next_event` on, then each new state and event. Refuses the client
 * when there are HTTP_STREAM_CLIENTS already.
 *
 * @return the status sent
 *
 * @satisfies SWR-HTTP-003
 * @satisfies SWR-HTTP-010
 * @satisfies SWR-HTTP-028
 * @satisfies SWR-LOAD-005
 */
int http_stream_serve(http_stream_t *self, struct mg_connection *connection, const char *hello,
                      uint32_t next_event);

#endif

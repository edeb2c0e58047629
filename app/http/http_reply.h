/* SPDX-License-Identifier: Apache-2.0 */
/** @file Every answer leaves through here, so that none lacks the headers that protect browsers. */
#ifndef BORESIGHT_HTTP_REPLY_H
#define BORESIGHT_HTTP_REPLY_H

#include "http/http_problem.h"
#include "session/tls_front.h"

#include <cjson/cJSON.h>
#include <civetweb.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HTTP_REPLY_GO_ON "HTTP/1.1 100 Continue\r\n\r\n"
#define HTTP_REPLY_JSON "application/json"
#define HTTP_REPLY_PROBLEM "application/problem+json"
#define HTTP_REPLY_NO_STORE "no-store"
#define HTTP_REPLY_REVALIDATE "private, no-cache"
#define HTTP_REPLY_HEAD_SIZE 1536 /**< Room for the head of every answer. */

/** What is particular to one answer. */
typedef struct {
    int status;
    const char *type;       /**< Content type. */
    const char *cache;      /**< Cache-Control. */
    const char *allow;      /**< Allow, or NULL. */
    const char *origin;     /**< Origin that may read the answer though it is another; or NULL. */
    const char *etag;       /**< ETag with its quotes, or NULL. */
    const char *encoding;   /**< Content-Encoding, or NULL. */
    const char *cookie;     /**< Set-Cookie, or NULL. */
    const char *file_name;  /**< Under which to keep it; NULL: it is to be shown. */
    uint32_t retry_after_s; /**< Retry-After; 0: without. */
    bool is_chosen;         /**< Another client may get it in another encoding. */
    bool is_stream;         /**< Only the head is sent; the body follows without a known end. */
    bool is_apart;          /**< Only the head is sent; `size` bytes follow. */
    const void *body;
    size_t size;
} http_reply_t;

/** Lets pages ask for a stop at `port` of the hosts that are served, too, and where TLS leads there
 * (`front`, NULL: nowhere). To be called once, before anything is sent. */
void http_reply_allow_stops(const char *address, uint32_t port, const tls_front_t *front);

/** Writes the head of `reply`, the empty line included. Returns its size. */
size_t http_reply_head(const http_reply_t *reply, char head[HTTP_REPLY_HEAD_SIZE]);

/** The request asks for the head of the answer only. */
bool http_reply_is_head_asked(const struct mg_connection *connection);

/**
 * Sends `reply`, of which HEAD and 304 get the head. The connection ends with it: a later request
 * comes through the gates, where a stop needs no worker.
 *
 * @return its status, or 0 when the client did not take it in time
 *
 * @satisfies SWR-HTTP-014
 * @satisfies SWR-HTTP-018
 */
int http_reply_send(struct mg_connection *connection, const http_reply_t *reply);

/** Sends JSON text. Returns as http_reply_send(). */
int http_reply_json(struct mg_connection *connection, int status, const char *json);

/** Sends `object` as JSON and frees it. Returns as http_reply_send(). */
int http_reply_object(struct mg_connection *connection, int status, cJSON *object);

/** Sends a refusal, with `allow` if it is not NULL. Returns as http_reply_send(). */
int http_reply_problem(struct mg_connection *connection, const http_problem_t *problem,
                       const char *allow);

/** Sends a refusal of which there is nothing more to say. */
int http_reply_refuse(struct mg_connection *connection, problem_t problem);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The head of every answer is written here, so that none lacks the headers that protect browsers.
 */
#ifndef BORESIGHT_HTTP_HEAD_H
#define BORESIGHT_HTTP_HEAD_H

#include "http/login/tls_front.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HTTP_REPLY_GO_ON "HTTP/1.1 100 Continue\r\n\r\n"
#define HTTP_REPLY_JSON "application/json"
#define HTTP_REPLY_PROBLEM "application/problem+json"
#define HTTP_REPLY_NO_STORE "no-store"
#define HTTP_REPLY_REVALIDATE "private, no-cache"
#define HTTP_REPLY_HEAD_SIZE 2048 /**< Room for the head of every answer. */

/** The particulars of one answer. */
typedef struct {
    int status;
    const char *type;       /**< Content type. */
    const char *cache;      /**< Cache-Control. */
    const char *allow;      /**< Allow, or NULL. */
    const char *origin;     /**< Origin that may read the answer though it is another; or NULL. */
    const char *etag;       /**< ETag with its quotes, or NULL. */
    const char *encoding;   /**< Content-Encoding, or NULL. */
    const char *cookie;     /**< Set-Cookie, or NULL. */
    const char *device;     /**< A second Set-Cookie, or NULL. */
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
void http_head_allow_stops(const char *address, uint32_t port, const tls_front_t *front);

/** The answer goes on behind its head. */
bool http_head_has_body(const http_reply_t *reply);

/** Writes the head of `reply`, the empty line included. Returns its size. */
size_t http_head_write(const http_reply_t *reply, char head[HTTP_REPLY_HEAD_SIZE]);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/gate/http_head.h"

#include "http/gate/http_problem.h"

#include <stdio.h>
#include <string.h>

#define DISPOSITION_SIZE 128U

static const char safety_headers[] =
    "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; "
    "img-src 'self'; connect-src 'self'%s; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "X-Frame-Options: DENY\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n\r\n";

static char stop_sources[120U + (TLS_FRONT_HOSTS *
                                 (TLS_FRONT_HOST_SIZE + 16U))]; /* As the policy names them. */

void http_head_allow_stops(const char *address, uint32_t port, const tls_front_t *front)
{
    (void)snprintf(stop_sources, sizeof stop_sources,
                   " http://%s:%u http://127.0.0.1:%u http://localhost:%u", address, (unsigned)port,
                   (unsigned)port, (unsigned)port);
    for (uint32_t i = 0U; (front != NULL) && (i < front->host_count); i++) {
        const size_t size = strlen(stop_sources);
        (void)snprintf(&stop_sources[size], sizeof stop_sources - size, " https://%s:%u",
                       front->hosts[i], (unsigned)front->stop);
    }
}

/* A header that may be missing. */
static void add(char head[HTTP_REPLY_HEAD_SIZE], const char *name, const char *value)
{
    const size_t size = strlen(head);
    if (value != NULL) {
        (void)snprintf(&head[size], HTTP_REPLY_HEAD_SIZE - size, "%s: %s\r\n", name, value);
    }
}

bool http_head_has_body(const http_reply_t *reply)
{
    return !reply->is_stream && (reply->status != 304);
}

size_t http_head_write(const http_reply_t *reply, char head[HTTP_REPLY_HEAD_SIZE])
{
    char length[24];
    char again[16];
    char disposition[DISPOSITION_SIZE];
    (void)snprintf(length, sizeof length, "%zu", reply->size);
    (void)snprintf(again, sizeof again, "%u", (unsigned)reply->retry_after_s);
    (void)snprintf(disposition, sizeof disposition, "attachment; filename=\"%s\"",
                   (reply->file_name != NULL) ? reply->file_name : "");
    (void)snprintf(head, HTTP_REPLY_HEAD_SIZE, "HTTP/1.1 %d %s\r\n", reply->status,
                   http_problem_title(reply->status));
    add(head, "Content-Type", reply->type);
    add(head, "Cache-Control", reply->cache);
    add(head, "Content-Length", http_head_has_body(reply) ? length : NULL);
    add(head, "Allow", reply->allow);
    add(head, "Access-Control-Allow-Origin", reply->origin);
    add(head, "Vary", (reply->origin != NULL) ? "Origin" : NULL);
    add(head, "ETag", reply->etag);
    add(head, "Content-Encoding", reply->encoding);
    add(head, "Vary", reply->is_chosen ? "Accept-Encoding" : NULL);
    add(head, "Set-Cookie", reply->cookie);
    add(head, "Set-Cookie", reply->device);
    add(head, "Content-Disposition", (reply->file_name != NULL) ? disposition : NULL);
    add(head, "Retry-After", (reply->retry_after_s > 0U) ? again : NULL);
    add(head, "Connection", "close");
    const size_t size = strlen(head);
    const size_t room = HTTP_REPLY_HEAD_SIZE - size;
    return size + (size_t)snprintf(&head[size], room, safety_headers, stop_sources);
}

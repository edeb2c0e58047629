/* SPDX-License-Identifier: Apache-2.0 */
#include "http_reply.h"

#include <stdio.h>
#include <string.h>

static const char safety_headers[] =
    "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; "
    "img-src 'self'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "X-Frame-Options: DENY\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Connection: close\r\n";

static bool write_all(struct mg_connection *connection, const void *bytes, size_t size)
{
    return (size == 0U) || (mg_write(connection, bytes, size) == (int)size);
}

int http_reply_send(struct mg_connection *connection, const http_reply_t *reply)
{
    char length[48] = "";
    if (!reply->is_stream) {
        (void)snprintf(length, sizeof(length), "Content-Length: %zu\r\n", reply->size);
    }
    char allow[48] = "";
    if (reply->allow != NULL) {
        (void)snprintf(allow, sizeof(allow), "Allow: %s\r\n", reply->allow);
    }
    char head[1024];
    int size = snprintf(head, sizeof(head),
                        "HTTP/1.1 %d %s\r\nContent-Type: %s\r\nCache-Control: %s\r\n%s%s%s\r\n",
                        reply->status, mg_get_response_code_text(connection, reply->status),
                        reply->type, reply->cache, length, allow, safety_headers);
    if ((size < 0) || ((size_t)size >= sizeof(head)) ||
        !write_all(connection, head, (size_t)size)) {
        return 0;
    }
    return (reply->is_stream || write_all(connection, reply->body, reply->size)) ? reply->status
                                                                                 : 0;
}

int http_reply_json(struct mg_connection *connection, int status, const char *json)
{
    http_reply_t reply = {.status = status,
                          .type = HTTP_REPLY_JSON,
                          .cache = HTTP_REPLY_NO_STORE,
                          .body = json,
                          .size = strlen(json)};
    return http_reply_send(connection, &reply);
}

int http_reply_error(struct mg_connection *connection, int status, const char *code,
                     const char *message)
{
    char json[512];
    (void)snprintf(json, sizeof(json), "{\"code\":\"%s\",\"message\":\"%s\"}", code, message);
    return http_reply_json(connection, status, json);
}

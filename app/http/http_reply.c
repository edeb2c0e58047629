/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_reply.h"

#include "interface/app/messages.h"

#include <stdio.h>
#include <string.h>

static const char safety_headers[] =
    "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; "
    "img-src 'self'; connect-src 'self'%s; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "X-Frame-Options: DENY\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Connection: close\r\n";

static char stop_sources[120]; /* As the policy names them. */

void http_reply_allow_stops(const char *address, uint32_t port)
{
    (void)snprintf(stop_sources, sizeof stop_sources,
                   " http://%s:%u http://127.0.0.1:%u http://localhost:%u", address, (unsigned)port,
                   (unsigned)port, (unsigned)port);
}

static bool write_all(struct mg_connection *connection, const void *bytes, size_t size)
{
    return (size == 0U) || (mg_write(connection, bytes, size) == (int)size);
}

size_t http_reply_head(const http_reply_t *reply, char head[HTTP_REPLY_HEAD_SIZE])
{
    char safety[640];
    (void)snprintf(safety, sizeof safety, safety_headers, stop_sources);
    char length[48] = "";
    if (!reply->is_stream) {
        (void)snprintf(length, sizeof length, "Content-Length: %zu\r\n", reply->size);
    }
    char allow[48] = "";
    if (reply->allow != NULL) {
        (void)snprintf(allow, sizeof allow, "Allow: %s\r\n", reply->allow);
    }
    char origin[120] = "";
    if (reply->origin != NULL) {
        (void)snprintf(origin, sizeof origin, "Access-Control-Allow-Origin: %s\r\nVary: Origin\r\n",
                       reply->origin);
    }
    int size = snprintf(head, HTTP_REPLY_HEAD_SIZE,
                        "HTTP/1.1 %d %s\r\nContent-Type: %s\r\nCache-Control: %s\r\n%s%s%s%s\r\n",
                        reply->status, mg_get_response_code_text(NULL, reply->status), reply->type,
                        reply->cache, length, allow, origin, safety);
    return (size_t)size;
}

int http_reply_send(struct mg_connection *connection, const http_reply_t *reply)
{
    char head[HTTP_REPLY_HEAD_SIZE];
    if (!write_all(connection, head, http_reply_head(reply, head))) {
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
    const json_error_answer_t answer = {.code = code, .message = message};
    char json[512];
    cJSON *object = json_error_answer(&answer);
    const bool is_whole = cJSON_PrintPreallocated(object, json, (int)sizeof json, 0) != 0;
    cJSON_Delete(object);
    return http_reply_json(connection, status, is_whole ? json : "{}");
}

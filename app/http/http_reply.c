/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_reply.h"

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

void http_reply_allow_stops(const char *address, uint32_t port, const tls_front_t *front)
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

static bool write_all(struct mg_connection *connection, const void *bytes, size_t size)
{
    return (size == 0U) || (mg_write(connection, bytes, size) == (int)size);
}

/* A header that may be missing. */
static void add(char head[HTTP_REPLY_HEAD_SIZE], const char *name, const char *value)
{
    const size_t size = strlen(head);
    if (value != NULL) {
        (void)snprintf(&head[size], HTTP_REPLY_HEAD_SIZE - size, "%s: %s\r\n", name, value);
    }
}

static bool has_body(const http_reply_t *reply)
{
    return !reply->is_stream && (reply->status != 304);
}

size_t http_reply_head(const http_reply_t *reply, char head[HTTP_REPLY_HEAD_SIZE])
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
    add(head, "Content-Length", has_body(reply) ? length : NULL);
    add(head, "Allow", reply->allow);
    add(head, "Access-Control-Allow-Origin", reply->origin);
    add(head, "Vary", (reply->origin != NULL) ? "Origin" : NULL);
    add(head, "ETag", reply->etag);
    add(head, "Content-Encoding", reply->encoding);
    add(head, "Vary", reply->is_chosen ? "Accept-Encoding" : NULL);
    add(head, "Set-Cookie", reply->cookie);
    add(head, "Content-Disposition", (reply->file_name != NULL) ? disposition : NULL);
    add(head, "Retry-After", (reply->retry_after_s > 0U) ? again : NULL);
    add(head, "Connection", "close");
    const size_t size = strlen(head);
    const size_t room = HTTP_REPLY_HEAD_SIZE - size;
    return size + (size_t)snprintf(&head[size], room, safety_headers, stop_sources);
}

bool http_reply_is_head_asked(const struct mg_connection *connection)
{
    const char *method = mg_get_request_info(connection)->request_method;
    return (method != NULL) && (strcmp(method, "HEAD") == 0);
}

int http_reply_send(struct mg_connection *connection, const http_reply_t *reply)
{
    char head[HTTP_REPLY_HEAD_SIZE];
    if (!write_all(connection, head, http_reply_head(reply, head))) {
        return 0;
    }
    const bool is_whole = !has_body(reply) || reply->is_apart ||
                          http_reply_is_head_asked(connection) ||
                          write_all(connection, reply->body, reply->size);
    return is_whole ? reply->status : 0;
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

int http_reply_object(struct mg_connection *connection, int status, cJSON *object)
{
    char *json = cJSON_PrintUnformatted(object);
    const int sent = (json != NULL) ? http_reply_json(connection, status, json)
                                    : http_reply_refuse(connection, PROBLEM_NO_MEMORY);
    cJSON_free(json);
    cJSON_Delete(object);
    return sent;
}

int http_reply_problem(struct mg_connection *connection, const http_problem_t *problem,
                       const char *allow)
{
    char json[HTTP_PROBLEM_SIZE];
    const http_reply_t reply = {.status = problem->http,
                                .type = HTTP_REPLY_PROBLEM,
                                .cache = HTTP_REPLY_NO_STORE,
                                .allow = allow,
                                .retry_after_s = problem->retry_after_s,
                                .body = json,
                                .size = http_problem_write(problem, json)};
    return http_reply_send(connection, &reply);
}

int http_reply_refuse(struct mg_connection *connection, problem_t problem)
{
    const http_problem_t told = http_problem_of(problem);
    return http_reply_problem(connection, &told, NULL);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_call.h"

#include "http/http_reply.h"
#include "limits/requirement_limits.h"
#include "request/request_body.h"
#include "request/request_headers.h"
#include "request/request_query.h"

#include <string.h>
#include <strings.h>

#define LINE_MARKS                                                                                 \
    4U /* Colon, space and the end of a line; those of the request's line are as many. */

/* The client did not take the refusal. */
#define NOT_SENT 499

static int refuse(struct mg_connection *connection, problem_t problem)
{
    const int status = http_reply_refuse(connection, problem);
    return (status != 0) ? status : NOT_SENT;
}

static int refuse_as(struct mg_connection *connection, const http_problem_t *problem)
{
    const int status = http_reply_problem(connection, problem, NULL);
    return (status != 0) ? status : NOT_SENT;
}

static size_t length_of(const char *text)
{
    return (text != NULL) ? strlen(text) : 0U;
}

/* The library drops headers without a word from its MG_MAX_HEADERS on. */
static bool is_head_short(const struct mg_request_info *request)
{
    size_t size = length_of(request->request_method) + length_of(request->request_uri) +
                  length_of(request->query_string) + LINE_MARKS;
    for (int i = 0; i < request->num_headers; i++) {
        const struct mg_header *header = &request->http_headers[i];
        size += strlen(header->name) + strlen(header->value) + LINE_MARKS;
    }
    return (size <= LIMIT_HEAD_BYTES) && ((unsigned)request->num_headers <= LIMIT_HEAD_FIELDS);
}

static unsigned count(const struct mg_request_info *request, const char *name)
{
    unsigned found = 0U;
    for (int i = 0; i < request->num_headers; i++) {
        found += (strcasecmp(request->http_headers[i].name, name) == 0) ? 1U : 0U;
    }
    return found;
}

static problem_t problem_of(http_guard_verdict_t verdict)
{
    switch (verdict) {
    case HTTP_GUARD_NO_HOST:
        return PROBLEM_HOST_MISSING;
    case HTTP_GUARD_HOST:
        return PROBLEM_HOST_REFUSED;
    case HTTP_GUARD_ORIGIN:
    case HTTP_GUARD_CROSS_SITE:
    case HTTP_GUARD_PASS:
    default:
        return PROBLEM_ORIGIN_REFUSED;
    }
}

int http_call_judge(struct mg_connection *connection, const http_guard_t *guard)
{
    static const char *const singles[] = {
        "Host",         "Content-Length", "Transfer-Encoding", "Origin",
        "Content-Type", "Cookie",         "X-Boresight-Token"};
    const struct mg_request_info *request = mg_get_request_info(connection);
    const http_provenance_t provenance = {.host = mg_get_header(connection, "Host"),
                                          .origin = mg_get_header(connection, "Origin"),
                                          .fetch_site =
                                              mg_get_header(connection, "Sec-Fetch-Site")};
    if (!is_head_short(request)) {
        return refuse(connection, PROBLEM_TOO_MANY_HEADERS);
    }
    for (size_t i = 0U; i < (sizeof singles / sizeof singles[0]); i++) {
        if (count(request, singles[i]) > 1U) {
            return refuse(connection, PROBLEM_BAD_REQUEST);
        }
    }
    const http_guard_verdict_t verdict = http_guard_judge(guard, &provenance);
    return (verdict == HTTP_GUARD_PASS) ? 0 : refuse(connection, problem_of(verdict));
}

static bool has_method(const struct mg_connection *connection, const route_t *route)
{
    const bool is_head =
        http_reply_is_head_asked(connection) && (strcmp(route->method, "GET") == 0);
    return is_head || (strcmp(mg_get_request_info(connection)->request_method, route->method) == 0);
}

const route_t *http_call_find(const struct mg_connection *connection, const char **allowed)
{
    const char *path = mg_get_request_info(connection)->local_uri_raw;
    *allowed = NULL;
    for (size_t i = 0U; (path != NULL) && (i < ROUTE_COUNT); i++) {
        if (strcmp(routes[i].path, path) == 0) {
            *allowed = routes[i].allowed;
            if (has_method(connection, &routes[i])) {
                return &routes[i];
            }
        }
    }
    return NULL;
}

/* The body, before it is read: how it is sent, how long it is, and what it is. */
static int judge_body(const http_call_t *self)
{
    const struct mg_request_info *request = mg_get_request_info(self->connection);
    const bool is_chunked = mg_get_header(self->connection, "Transfer-Encoding") != NULL;
    const bool is_unsaid = (self->route->body != NULL) && (request->content_length < 0);
    if (is_chunked || is_unsaid) {
        return refuse(self->connection, PROBLEM_LENGTH_REQUIRED);
    }
    if (request->content_length > (long long)self->route->body_most) {
        return refuse(self->connection, PROBLEM_BODY_TOO_LONG);
    }
    const char *media = mg_get_header(self->connection, "Content-Type");
    const bool is_other = (request->content_length > 0) && !request_headers_are_json(media);
    return (is_other && !self->route->is_lenient) ? refuse(self->connection, PROBLEM_MEDIA_TYPE)
                                                  : 0;
}

static int read_body(http_call_t *self)
{
    char bytes[ROUTE_BODY_MOST];
    const long long length = mg_get_request_info(self->connection)->content_length;
    const int size = (length > 0) ? mg_read(self->connection, bytes, (size_t)length) : 0;
    if ((length > 0) && (size != (int)length)) {
        return refuse(self->connection, PROBLEM_BAD_BODY);
    }
    const request_result_t result =
        request_read_body(self->route->body, bytes, (size_t)size, &self->body);
    const http_problem_t problem = http_problem_of_body(&result);
    return (result.fault == REQUEST_OK) ? 0 : refuse_as(self->connection, &problem);
}

static int read_query(http_call_t *self)
{
    const char *query = mg_get_request_info(self->connection)->query_string;
    const request_result_t result = request_read_query(self->route->query, query, &self->query);
    const http_problem_t problem = http_problem_of_query(&result);
    return (result.fault == REQUEST_OK) ? 0 : refuse_as(self->connection, &problem);
}

int http_call_read(http_call_t *self)
{
    int status = judge_body(self);
    if ((status == 0) && (self->route->body != NULL)) {
        status = read_body(self);
    }
    if ((status == 0) && !self->route->is_lenient) {
        status = read_query(self);
    }
    return status;
}

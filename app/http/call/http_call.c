/* SPDX-License-Identifier: Apache-2.0 */
#include "http/call/http_call.h"

#include "common/axis_terms.h"
#include "http/gate/http_connections.h"
#include "http/call/http_reply.h"
#include "http/call/http_transaction.h"
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
        "Content-Type", "Cookie",         "X-Boresight-Token", "X-Boresight-Page"};
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

/* The part of `path` where that of the route has braces, and its length; NULL: it is another
 * path. */
static const char *find_value(const route_t *route, const char *path, size_t *size)
{
    const char *braces = strchr(route->path, '{');
    const size_t before = (braces != NULL) ? (size_t)(braces - route->path) : 0U;
    if ((braces == NULL) || (strncmp(route->path, path, before) != 0)) {
        return NULL;
    }
    *size = strcspn(&path[before], "/");
    const bool is_same = strcmp(&path[before + *size], strchr(braces, '}') + 1) == 0;
    return (is_same && (*size > 0U)) ? &path[before] : NULL;
}

/* A path that is one of ours to the letter comes before those with braces. */
static const route_t *find(const struct mg_connection *connection, const char *path, bool is_plain,
                           const char **allowed)
{
    size_t size = 0U;
    for (size_t i = 0U; (path != NULL) && (i < ROUTE_COUNT); i++) {
        const bool is_path = is_plain ? (strcmp(routes[i].path, path) == 0)
                                      : (find_value(&routes[i], path, &size) != NULL);
        *allowed = is_path ? routes[i].allowed : *allowed;
        if (is_path && has_method(connection, &routes[i])) {
            return &routes[i];
        }
    }
    return NULL;
}

const route_t *http_call_find(const struct mg_connection *connection, const char **allowed)
{
    const char *path = mg_get_request_info(connection)->local_uri_raw;
    *allowed = NULL;
    const route_t *route = find(connection, path, true, allowed);
    return ((route != NULL) || (*allowed != NULL)) ? route : find(connection, path, false, allowed);
}

static bool read_axis(http_call_t *self, const robot_t *robot, const char *text)
{
    const uint32_t axis = axis_terms_find(robot, text);
    const bool is_number =
        (axis == robot->axis_count) && request_headers_number(text, &self->path.number);
    self->path.axis = is_number ? self->path.number : axis;
    return self->path.axis < robot->axis_count;
}

/* Letters, digits, _, . and -; none of these begins it. */
static bool read_name(http_call_t *self, const char *text)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.-";
    (void)strcpy(self->path.name, text);
    return (strspn(text, letters) == strlen(text)) && (strchr("_.-", text[0]) == NULL);
}

static bool read_value(http_call_t *self, const robot_t *robot)
{
    size_t size = 0U;
    char text[HTTP_CALL_NAME_SIZE];
    const char *path = mg_get_request_info(self->connection)->local_uri_raw;
    const char *value = find_value(self->route, path, &size);
    if ((value == NULL) || (size >= sizeof text)) {
        return self->route->value == ROUTE_PLAIN;
    }
    (void)memcpy(text, value, size);
    text[size] = '\0';
    switch (self->route->value) {
    case ROUTE_OF_AXIS:
        return read_axis(self, robot, text);
    case ROUTE_OF_NUMBER:
        return request_headers_number(text, &self->path.number);
    case ROUTE_OF_NAME:
        return read_name(self, text);
    case ROUTE_PLAIN:
    default:
        return true;
    }
}

/* The body, before it is read: its transfer, its length and its type. */
static int judge_body(const http_call_t *self)
{
    const struct mg_request_info *request = mg_get_request_info(self->connection);
    const bool is_chunked = mg_get_header(self->connection, "Transfer-Encoding") != NULL;
    const bool has_body = (self->route->body != NULL) || (self->route->sends != NULL);
    const bool is_unsaid = has_body && (request->content_length < 0);
    if (is_chunked || is_unsaid) {
        return refuse(self->connection, PROBLEM_LENGTH_REQUIRED);
    }
    if (request->content_length > (long long)self->route->body_most) {
        return refuse(self->connection, PROBLEM_BODY_TOO_LONG);
    }
    const char *media = mg_get_header(self->connection, "Content-Type");
    const bool is_expected = (self->route->sends != NULL)
                                 ? request_headers_are(media, self->route->sends)
                                 : request_headers_are_json(media);
    const bool is_other = (request->content_length > 0) && !is_expected;
    return (is_other && !self->route->is_lenient) ? refuse(self->connection, PROBLEM_MEDIA_TYPE)
                                                  : 0;
}

int http_call_receive(struct mg_connection *connection, char *bytes)
{
    const struct mg_request_info *request = mg_get_request_info(connection);
    const long long length = request->content_length;
    if ((length > 0) &&
        request_headers_expect(request->http_version, mg_get_header(connection, "Expect"))) {
        (void)mg_write(connection, HTTP_REPLY_GO_ON, strlen(HTTP_REPLY_GO_ON));
    }
    http_connections_note(connection, HTTP_LINE_READS);
    const int size = (length > 0) ? mg_read(connection, bytes, (size_t)length) : 0;
    http_connections_note(connection, HTTP_LINE_ASKS);
    if ((length <= 0) || (size == (int)length)) {
        return 0;
    }
    return refuse(connection,
                  http_connections_is_leaving(connection) ? PROBLEM_GAVE_WAY : PROBLEM_BAD_BODY);
}

static int read_body(http_call_t *self)
{
    char bytes[ROUTE_BODY_MOST];
    const long long length = mg_get_request_info(self->connection)->content_length;
    const int refusal = http_call_receive(self->connection, bytes);
    if (refusal != 0) {
        return refusal;
    }
    const size_t size = (length > 0) ? (size_t)length : 0U;
    const request_result_t result = request_read_body(self->route->body, bytes, size, &self->body);
    const http_problem_t problem = http_problem_of_body(&result);
    http_transaction_keep_request(self->connection,
                                  (result.fault != REQUEST_NOT_JSON) ? bytes : NULL, size);
    return (result.fault == REQUEST_OK) ? 0 : refuse_as(self->connection, &problem);
}

static int read_query(http_call_t *self)
{
    const char *query = mg_get_request_info(self->connection)->query_string;
    const request_result_t result = request_read_query(self->route->query, query, &self->query);
    const http_problem_t problem = http_problem_of_query(&result);
    return (result.fault == REQUEST_OK) ? 0 : refuse_as(self->connection, &problem);
}

int http_call_read(http_call_t *self, const robot_t *robot)
{
    if (!read_value(self, robot)) {
        return refuse(self->connection, PROBLEM_NOT_THERE);
    }
    int status = judge_body(self);
    if ((status == 0) && (self->route->body != NULL)) {
        status = read_body(self);
    }
    if ((status == 0) && !self->route->is_lenient) {
        status = read_query(self);
    }
    return status;
}

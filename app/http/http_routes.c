/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_routes.h"

#include "http/asset.h"
#include "http/http_reply.h"
#include "http/stop_desk.h"
#include "interface/app/messages.h"

#include <stdlib.h>
#include <string.h>

#define EVENTS_MOST 200U
#define QUERY_NUMBER_SIZE 16U

typedef struct {
    const char *path;
    const char *method;
    int (*answer)(http_server_t *server, struct mg_connection *connection);
} route_t;

/* Sends `object` and frees it. */
static int reply_object(struct mg_connection *connection, int status, cJSON *object)
{
    char *json = cJSON_PrintUnformatted(object);
    int sent = (json != NULL)
                   ? http_reply_json(connection, status, json)
                   : http_reply_error(connection, 500, "NO_MEMORY", "The server is out of memory.");
    cJSON_free(json);
    cJSON_Delete(object);
    return sent;
}

static bool look(http_server_t *server, struct mg_connection *connection, telemetry_view_t *view)
{
    telemetry_look(&server->telemetry, view);
    if (!view->has_snapshot) {
        (void)http_reply_error(connection, 503, "NO_DATA",
                               "Control has not published anything yet.");
    }
    return view->has_snapshot;
}

static int answer_status(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    return look(server, connection, &view)
               ? reply_object(connection, 200, telemetry_json_status(&server->identity, &view))
               : 503;
}

static int answer_motors(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    return look(server, connection, &view)
               ? reply_object(connection, 200, telemetry_json_motors(&view))
               : 503;
}

static int answer_targeting(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    return look(server, connection, &view)
               ? reply_object(connection, 200, telemetry_json_targeting(&view))
               : 503;
}

/* A number of the query. False when it is there and no number. */
static bool read_query(struct mg_connection *connection, const char *name, bool *is_given,
                       uint32_t *value)
{
    const char *query = mg_get_request_info(connection)->query_string;
    char text[QUERY_NUMBER_SIZE];
    int size = (query != NULL) ? mg_get_var(query, strlen(query), name, text, sizeof text) : -1;
    *is_given = size >= 0;
    if (size == -1) {
        return true;
    }
    if ((size < 1) || (size > 10) || (strspn(text, "0123456789") != (size_t)size)) {
        return false;
    }
    unsigned long long number = strtoull(text, NULL, 10);
    *value = (uint32_t)number;
    return number <= UINT32_MAX;
}

static int reply_log(http_server_t *server, struct mg_connection *connection, uint32_t next)
{
    event_t events[EVENTS_MOST];
    uint32_t lost = 0U;
    uint32_t count = exchange_read_events(server->exchange, &next, events, EVENTS_MOST, &lost);
    const robot_t *robot = exchange_robot(server->exchange);
    cJSON *entries = cJSON_CreateArray();
    for (uint32_t i = 0U; i < count; i++) {
        (void)cJSON_AddItemToArray(entries, telemetry_json_event(robot, &events[i]));
    }
    const json_log_t log = {.entries = entries, .next = next, .lost = lost};
    return reply_object(connection, 200, json_log(&log));
}

static int answer_log(http_server_t *server, struct mg_connection *connection)
{
    bool is_given = false;
    uint32_t after = 0U;
    if (!read_query(connection, "after", &is_given, &after)) {
        return http_reply_error(connection, 400, "BAD_QUERY",
                                "The value of after is not an event's number.");
    }
    telemetry_view_t view;
    if (!look(server, connection, &view)) {
        return 503;
    }
    uint32_t events = view.snapshot.events;
    uint32_t newest = (events > EVENTS_MOST) ? (events - EVENTS_MOST) : 0U;
    return reply_log(server, connection, is_given ? (after + 1U) : newest);
}

static int answer_events(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    telemetry_look(&server->telemetry, &view);
    uint32_t events = view.snapshot.events;
    uint32_t first = (events > HTTP_STREAM_HISTORY) ? (events - HTTP_STREAM_HISTORY) : 0U;
    const json_hello_t identity = {.boot_id = server->identity.boot_id,
                                   .build_id = server->identity.build_id};
    char hello[160] = "{}";
    cJSON *object = json_hello(&identity);
    (void)cJSON_PrintPreallocated(object, hello, (int)sizeof hello, 0);
    cJSON_Delete(object);
    return http_stream_serve(&server->stream, connection, hello, first);
}

/* The body of stop says nothing: it is empty or an empty object. */
static bool read_body(struct mg_connection *connection, long long length)
{
    char body[HTTP_ROUTES_BODY_MOST + 1];
    int read = (length > 0) ? mg_read(connection, body, (size_t)length) : 0;
    if (read != (int)length) {
        return false;
    }
    body[read] = '\0';
    return (read == 0) || (strcmp(body, "{}") == 0);
}

static int answer_stop(http_server_t *server, struct mg_connection *connection)
{
    char json[STOP_DESK_JSON_SIZE];
    answer_t answer;
    status_t status = stop_desk_converse(server->exchange, &answer);
    int told = stop_desk_tell(status, &answer, json);
    return http_reply_json(connection, told, json);
}

static const route_t routes[] = {
    {"/api/v1/status", "GET", answer_status},       {"/api/v1/motors", "GET", answer_motors},
    {"/api/v1/targeting", "GET", answer_targeting}, {"/api/v1/log", "GET", answer_log},
    {"/api/v1/events", "GET", answer_events},       {"/api/v1/stop", "POST", answer_stop}};

static const route_t *find_route(const char *path)
{
    for (size_t i = 0; i < (sizeof routes / sizeof routes[0]); i++) {
        if (strcmp(routes[i].path, path) == 0) {
            return &routes[i];
        }
    }
    return NULL;
}

static int refuse_method(struct mg_connection *connection, const char *allowed)
{
    static const char body[] =
        "{\"code\":\"METHOD_NOT_ALLOWED\",\"message\":\"This path has another method.\"}";
    http_reply_t reply = {.status = 405,
                          .type = HTTP_REPLY_JSON,
                          .cache = HTTP_REPLY_NO_STORE,
                          .allow = allowed,
                          .body = body,
                          .size = sizeof body - 1U};
    return http_reply_send(connection, &reply);
}

static int refuse_provenance(struct mg_connection *connection, http_guard_verdict_t verdict)
{
    switch (verdict) {
    case HTTP_GUARD_NO_HOST:
        return http_reply_error(connection, 400, "HOST_MISSING", "The request names no host.");
    case HTTP_GUARD_HOST:
        return http_reply_error(connection, 403, "HOST_REFUSED",
                                "The request names a host that is not served.");
    case HTTP_GUARD_ORIGIN:
    case HTTP_GUARD_CROSS_SITE:
    case HTTP_GUARD_PASS:
    default:
        return http_reply_error(connection, 403, "ORIGIN_REFUSED",
                                "The request comes from another site.");
    }
}

static int answer_route(http_server_t *server, struct mg_connection *connection,
                        const route_t *route)
{
    const struct mg_request_info *request = mg_get_request_info(connection);
    if (strcmp(request->request_method, route->method) != 0) {
        return refuse_method(connection, route->method);
    }
    bool is_post = strcmp(route->method, "POST") == 0;
    if (is_post && (request->content_length < 0)) {
        return http_reply_error(connection, 411, "LENGTH_REQUIRED",
                                "The request must say how long its body is.");
    }
    if (request->content_length > (is_post ? HTTP_ROUTES_BODY_MOST : 0)) {
        return http_reply_error(connection, 413, "BODY_TOO_LONG",
                                "The request's body is too long.");
    }
    if (is_post && !read_body(connection, request->content_length)) {
        return http_reply_error(connection, 400, "BAD_BODY",
                                "The request's body is neither empty nor {}.");
    }
    return route->answer(server, connection);
}

static int answer_asset(struct mg_connection *connection, const char *method, const char *path)
{
    const asset_t *asset = asset_find(path);
    if (asset == NULL) {
        return http_reply_error(connection, 404, "NOT_FOUND", "There is nothing at this path.");
    }
    if (strcmp(method, "GET") != 0) {
        return refuse_method(connection, "GET");
    }
    http_reply_t reply = {.status = 200,
                          .type = asset->type,
                          .cache = asset->cache,
                          .body = asset->bytes,
                          .size = asset->size};
    return http_reply_send(connection, &reply);
}

static int dispatch(http_server_t *server, struct mg_connection *connection)
{
    const struct mg_request_info *request = mg_get_request_info(connection);
    http_provenance_t provenance = {.host = mg_get_header(connection, "Host"),
                                    .origin = mg_get_header(connection, "Origin"),
                                    .fetch_site = mg_get_header(connection, "Sec-Fetch-Site")};
    const char *path = (request->local_uri_raw != NULL) ? request->local_uri_raw : "";
    if (request->num_headers >= MG_MAX_HEADERS) {
        return http_reply_error(connection, 431, "TOO_MANY_HEADERS",
                                "The request has too many headers.");
    }
    http_guard_verdict_t verdict = http_guard_judge(&server->guard, &provenance);
    if (verdict != HTTP_GUARD_PASS) {
        return refuse_provenance(connection, verdict);
    }
    const route_t *route = find_route(path);
    return (route != NULL) ? answer_route(server, connection, route)
                           : answer_asset(connection, request->request_method, path);
}

int http_routes_answer(http_server_t *server, struct mg_connection *connection)
{
    int status = dispatch(server, connection);
    return (status != 0) ? status : 499;
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes that show what control has published last, and the stream of it. */
#include "interface/app/handlers.h"

#include "http/call/http_reply.h"
#include "interface/app/messages.h"
#include "request/request_headers.h"
#include "http/call/http_stream.h"

static bool look(http_server_t *server, struct mg_connection *connection, telemetry_view_t *view)
{
    telemetry_look(&server->telemetry, view);
    if (!view->has_snapshot) {
        (void)http_reply_refuse(connection, PROBLEM_NO_DATA);
    }
    return view->has_snapshot;
}

int http_state_status(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    telemetry_view_t view;
    return look(server, connection, &view)
               ? http_reply_object(connection, 200, telemetry_json_status(&server->identity, &view))
               : 503;
}

int http_state_robot(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    telemetry_view_t view;
    return look(server, connection, &view)
               ? http_reply_object(connection, 200, telemetry_json_robot(&view))
               : 503;
}

int http_state_motors(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    telemetry_view_t view;
    return look(server, connection, &view)
               ? http_reply_object(connection, 200, telemetry_json_motors(&view))
               : 503;
}

int http_state_targeting(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    telemetry_view_t view;
    return look(server, connection, &view)
               ? http_reply_object(connection, 200, telemetry_json_targeting(&view))
               : 503;
}

/* Where the log goes on: after what the client has, or else with the last events. Numbers begin
 * anew with control; one that has not been yet is of an earlier control. */
static uint32_t first_event(const struct mg_connection *connection, uint32_t events)
{
    uint32_t last = 0U;
    const bool is_said = request_headers_number(mg_get_header(connection, "Last-Event-ID"), &last);
    if (is_said && (last < events)) {
        return last + 1U;
    }
    return (events > HTTP_STREAM_HISTORY) ? (events - HTTP_STREAM_HISTORY) : 0U;
}

int http_state_events(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    telemetry_view_t view;
    telemetry_look(&server->telemetry, &view);
    const json_hello_t identity = {.boot_id = server->identity.boot_id,
                                   .build_id = server->identity.build_id};
    char hello[160] = "{}";
    cJSON *object = json_hello(&identity);
    (void)cJSON_PrintPreallocated(object, hello, (int)sizeof hello, 0);
    cJSON_Delete(object);
    return http_stream_serve(&server->stream, connection, hello,
                             first_event(connection, view.snapshot.events));
}

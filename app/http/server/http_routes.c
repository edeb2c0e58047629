/* SPDX-License-Identifier: Apache-2.0 */
#include "http/server/http_routes.h"

#include "http/server/asset.h"
#include "http/call/http_act.h"
#include "http/call/http_call.h"
#include "http/call/http_login_gate.h"
#include "http/call/http_reply.h"
#include "http/call/http_transaction.h"
#include "interface/app/handlers.h"
#include "request/request_headers.h"

#include <string.h>

#define FIRST_REFUSAL 400

static int answer_asset(struct mg_connection *connection, const asset_t *asset)
{
    const bool is_packed = (asset->packed_size > 0U) &&
                           request_headers_take_gzip(mg_get_header(connection, "Accept-Encoding"));
    char etag[ASSET_ETAG_SIZE];
    asset_write_etag(asset, is_packed, etag);
    const bool is_known = request_headers_know(mg_get_header(connection, "If-None-Match"), etag);
    const http_reply_t reply = {.status = is_known ? 304 : 200,
                                .type = is_known ? NULL : asset->type,
                                .cache = asset->cache,
                                .etag = etag,
                                .encoding = (is_packed && !is_known) ? "gzip" : NULL,
                                .is_chosen = asset->packed_size > 0U,
                                .body = is_packed ? asset->packed : asset->bytes,
                                .size = is_packed ? asset->packed_size : asset->size};
    return http_reply_send(connection, &reply);
}

/* The document for clients is a file of the console. */
int http_routes_document(http_server_t *server, const http_call_t *call)
{
    (void)server;
    return answer_asset(call->connection, asset_find(call->route->path));
}

static int refuse_method(struct mg_connection *connection, const char *allowed)
{
    const http_problem_t problem = http_problem_of(PROBLEM_METHOD_NOT_ALLOWED);
    return http_reply_problem(connection, &problem, allowed);
}

/* A path that is no route may be a file of the console. */
static int answer_other(struct mg_connection *connection, const char *allowed)
{
    const struct mg_request_info *request = mg_get_request_info(connection);
    const asset_t *asset =
        (request->local_uri_raw != NULL) ? asset_find(request->local_uri_raw) : NULL;
    if (allowed != NULL) {
        return refuse_method(connection, allowed);
    }
    if (asset == NULL) {
        return http_reply_refuse(connection, PROBLEM_NOT_FOUND);
    }
    const bool is_got =
        (strcmp(request->request_method, "GET") == 0) || http_reply_is_head_asked(connection);
    if (!is_got) {
        return refuse_method(connection, "GET, HEAD");
    }
    return (request->content_length > 0) ? http_reply_refuse(connection, PROBLEM_BODY_TOO_LONG)
                                         : answer_asset(connection, asset);
}

static int dispatch(http_server_t *server, http_call_t *call, const char *allowed)
{
    struct mg_connection *connection = call->connection;
    int status = http_call_judge(connection, http_login_gate_is_tls(server, connection)
                                                 ? &server->front_guard
                                                 : &server->guard);
    if (status != 0) {
        return status;
    }
    if (call->route == NULL) {
        return answer_other(connection, allowed);
    }
    status = http_login_gate_judge(server, call);
    if (status == 0) {
        status = http_act_judge(server, call);
    }
    if (status == 0) {
        status = http_call_read(call, exchange_robot(server->exchange));
    }
    return (status != 0) ? status : http_handlers[call->route->id](server, call);
}

/* A page that is not logged in, or asks for what is not there, asks again and again. */
static bool is_idle(bool is_read, int status)
{
    const bool is_of_reads = (status == 401) || (status == 404) || (status == 503);
    return (is_read && is_of_reads) || (status == 429);
}

static bool is_noted(const http_call_t *call, int status)
{
    const char *method = mg_get_request_info(call->connection)->request_method;
    const bool is_read = (strcmp(method, "GET") == 0) || http_reply_is_head_asked(call->connection);
    const route_noted_t noted = (call->route != NULL) ? call->route->noted : ROUTE_NOTED_REFUSED;
    const bool is_refused = (status >= FIRST_REFUSAL) && !is_idle(is_read, status);
    return (noted == ROUTE_NOTED_ALWAYS) || ((noted == ROUTE_NOTED_REFUSED) && is_refused);
}

static void note(http_server_t *server, const http_call_t *call, int status,
                 const http_transaction_t *transaction)
{
    const struct mg_request_info *request = mg_get_request_info(call->connection);
    session_t session;
    const bool has_session = http_login_gate_find(server, call->connection, &session);
    const http_record_entry_t entry = {
        .who = has_session ? session.account.name : NULL,
        .method = request->request_method,
        .path = (request->local_uri_raw != NULL) ? request->local_uri_raw : "",
        .request = transaction->request,
        .status = status,
        .answer = transaction->answer};
    http_record_write(&server->record, &entry, telemetry_now_ms());
}

int http_routes_answer(http_server_t *server, struct mg_connection *connection)
{
    const char *allowed = NULL;
    http_transaction_t transaction;
    http_call_t call = {.connection = connection};
    http_transaction_begin(&transaction, connection);
    call.route = http_call_find(connection, &allowed);
    const int sent = dispatch(server, &call, allowed);
    const int status = (sent != 0) ? sent : 499;
    http_transaction_end(connection);
    if (is_noted(&call, status)) {
        note(server, &call, status, &transaction);
    }
    return status;
}

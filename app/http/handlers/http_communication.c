/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes that show the connected clients, and order something of a connection of
 * OpenIGTLink. Each returns the status sent. */
#include "interface/app/handlers.h"

#include "common/clock.h"
#include "http/call/http_reply.h"
#include "http/gate/answer_timeout.h"
#include "interface/app/messages.h"

#include <pthread.h>

#define US_PER_S 1000000.0

static bool has_authority(const telemetry_view_t *view, command_source_t source, uint32_t number)
{
    return (view->snapshot.holder == (uint32_t)source) && (view->snapshot.holder_peer == number);
}

/* Another process has looked at the same clock a moment ago. */
static double seconds_since(uint64_t then_us)
{
    const uint64_t now_us = clock_monotonic_us();
    return (now_us > then_us) ? ((double)(now_us - then_us) / US_PER_S) : 0.0;
}

static cJSON *new_connection(const telemetry_view_t *view, const exchange_peer_t *peer)
{
    const bool was_heard = peer->heard_us != 0U;
    const json_connection_t also = {
        .number = peer->number,
        .address = peer->name,
        .port = peer->port,
        .dialect = telemetry_json_dialect(peer->dialect),
        .has_authority = has_authority(view, COMMAND_SOURCE_IGTL, peer->number),
        .is_waiting = peer->is_waiting != 0U,
        .keep_alive = peer->is_kept_alive != 0U,
        .age_s = seconds_since(peer->since_us),
        .messages_in = peer->messages_in,
        .messages_out = peer->messages_out,
        .bytes_in = peer->bytes_in,
        .bytes_out = peer->bytes_out,
        .errors = peer->errors,
        .last_message = was_heard ? peer->message : NULL,
        .status = (peer->status[0] != '\0') ? peer->status : NULL,
        .silent_s = seconds_since(was_heard ? peer->heard_us : peer->since_us)};
    return json_connection(&also);
}

static cJSON *new_page(const telemetry_view_t *view, const exchange_peer_t *peer)
{
    const json_page_t also = {.number = peer->number,
                              .account = peer->name,
                              .has_authority =
                                  has_authority(view, COMMAND_SOURCE_HTTP, peer->number),
                              .age_s = seconds_since(peer->since_us)};
    return json_page(&also);
}

static cJSON *new_rows(const exchange_t *exchange, const telemetry_view_t *view,
                       command_source_t source)
{
    exchange_peers_t peers;
    cJSON *rows = cJSON_CreateArray();
    if (!exchange_read_peers(exchange, source, &peers)) {
        peers.count = 0U;
    }
    for (uint32_t i = 0U; i < peers.count; i++) {
        (void)cJSON_AddItemToArray(rows, (source == COMMAND_SOURCE_IGTL)
                                             ? new_connection(view, &peers.peers[i])
                                             : new_page(view, &peers.peers[i]));
    }
    return rows;
}

/** @satisfies SWR-IGTL-059 */
int http_communication_show(http_server_t *server, const http_call_t *call)
{
    telemetry_view_t view;
    telemetry_look(&server->telemetry, &view);
    if (!view.has_snapshot) {
        return http_reply_refuse(call->connection, PROBLEM_NO_DATA);
    }
    const json_communication_t also = {
        .connections = view.is_running[EXCHANGE_IGTL]
                           ? new_rows(server->exchange, &view, COMMAND_SOURCE_IGTL)
                           : cJSON_CreateArray(),
        .pages = new_rows(server->exchange, &view, COMMAND_SOURCE_HTTP),
        .ports = telemetry_json_ports(&view)};
    return http_reply_object(call->connection, 200, json_communication(&also));
}

/* Orders go one by one. */
static status_t have_done(http_server_t *server, const exchange_order_t *order)
{
    const uint32_t looks = answer_timeout_looks(server->exchange);
    status_t status = STATUS_NO_ANSWER;
    bool is_answered = false;
    (void)pthread_mutex_lock(&server->orders);
    const uint32_t id = exchange_give_order(server->exchange, order);
    for (uint32_t i = 0U; (i < looks) && !is_answered; i++) {
        answer_timeout_wait();
        is_answered = exchange_read_order_answer(server->exchange, id, &status);
    }
    (void)pthread_mutex_unlock(&server->orders);
    return is_answered ? status : STATUS_NO_ANSWER;
}

static int answer(http_server_t *server, const http_call_t *call, const exchange_order_t *order)
{
    switch ((int)have_done(server, order)) {
    case STATUS_OK:
        return http_communication_show(server, call);
    case STATUS_HOLDS_AUTHORITY:
        return http_reply_refuse(call->connection, PROBLEM_HOLDS_AUTHORITY);
    case STATUS_UNKNOWN_COMMAND:
        return http_reply_refuse(call->connection, PROBLEM_NOT_THERE);
    default:
        return http_reply_refuse(call->connection, PROBLEM_NO_ANSWER);
    }
}

/** @satisfies SWR-IGTL-060 */
int http_communication_disconnect(http_server_t *server, const http_call_t *call)
{
    const exchange_order_t order = {.kind = (uint32_t)EXCHANGE_ORDER_DISCONNECT,
                                    .number = call->path.number};
    return answer(server, call, &order);
}

/** @satisfies SWR-IGTL-061 */
int http_communication_keep_alive(http_server_t *server, const http_call_t *call)
{
    const exchange_order_t order = {.kind = (uint32_t)EXCHANGE_ORDER_KEEP_ALIVE,
                                    .number = call->path.number,
                                    .is_on = call->body.keep_alive.on ? 1U : 0U};
    return answer(server, call, &order);
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The server at its port: http_server_start(). */
#include "http/server/asset.h"
#include "http/gate/http_handover.h"
#include "http/gate/http_connections.h"
#include "http/call/http_reply.h"
#include "http/server/http_routes.h"
#include "http/server/http_server.h"
#include "http/stop/stop_port.h"

#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <sys/resource.h>

/* A worker needs little; the default of 8 MB each would only be address space to fill. */
#define WORKER_STACK_BYTES (256U * 1024U)

/* A client that does not finish its request holds a worker until the timeout; stops need none
 * (stop_port.c). The library uses the same timeout for a blocked write; a stream tries
 * again (http_stream.c). */
#define REQUEST_TIMEOUT_MS "500"
/* Bytes of a head that the library reads; it refuses a longer one as unreadable. */
#define LIBRARY_HEAD_BYTES 65536U

#define WORKER_NICENESS 10

/* An instance that TLS leads to has its stops come by that as well. */
static void guard_stops(const http_server_t *self, uint32_t port)
{
    const stop_port_gate_t gates[] = {STOP_PORT_OWN, STOP_PORT_OWN_TLS};
    for (size_t i = 0U; i < (sizeof gates / sizeof gates[0]); i++) {
        http_guard_t *guard = &stop_port_gate(gates[i])->guard;
        *guard = self->guard;
        guard->port = port;
        guard->front = self->front;
        guard->front_port = (self->front != NULL) ? self->front->stop : 0U;
    }
}

/* Without it, stops pass by the console's port alone. */
static void open_stop_port(const http_server_t *self)
{
    const uint32_t port = stop_port_open(self->exchange, self->guard.address);
    guard_stops(self, port);
    if (port != 0U) {
        http_head_allow_stops(self->guard.address, port, self->front);
        asset_report_stop_ports(port, (self->front != NULL) ? self->front->stop : 0U);
    }
}

static int open_console(stop_port_gate_t which, const http_guard_t *guard)
{
    gate_t *gate = stop_port_gate(which);
    gate->is_console = true;
    gate->guard = *guard;
    return gate_open(gate, guard->address, guard->port);
}

static http_server_result_t open_gates(const http_server_t *self)
{
    const int error = open_console(STOP_PORT_CONSOLE, &self->guard);
    if (error != 0) {
        return (error == EADDRINUSE) ? HTTP_SERVER_PORT_IN_USE : HTTP_SERVER_BAD_ADDRESS;
    }
    if (self->front != NULL) {
        if (open_console(STOP_PORT_CONSOLE_TLS, &self->front_guard) != 0) {
            return HTTP_SERVER_FRONT_IN_USE;
        }
        if (gate_open(stop_port_gate(STOP_PORT_OWN_TLS), "127.0.0.1", self->front->stop_from) !=
            0) {
            return HTTP_SERVER_FRONT_STOP_IN_USE;
        }
    }
    open_stop_port(self);
    return HTTP_SERVER_STARTED;
}

/* This thread and those that it makes, which the thread of the stops is not among: where the
 * processor is short, so many workers would leave little of it to recorder and OpenIGTLink. */
static void stand_back(void)
{
    (void)setpriority(PRIO_PROCESS, 0U, WORKER_NICENESS);
}

static int begin_request(struct mg_connection *connection)
{
    http_connections_note(connection, HTTP_LINE_ASKS);
    return http_routes_answer(mg_get_user_data(mg_get_context(connection)), connection);
}

static int begin_connection(const struct mg_connection *connection, void **own)
{
    (void)own;
    http_connections_enter(connection);
    return 0;
}

static void end_connection(const struct mg_connection *connection)
{
    http_connections_leave(connection);
}

/* Requests that the library itself refuses, before there is a path to look at. */
static int refuse(struct mg_connection *connection, int status, const char *message)
{
    (void)message;
    http_problem_t problem = http_problem_of(PROBLEM_BAD_REQUEST);
    problem.http = status;
    if (http_connections_is_leaving(connection)) {
        problem = http_problem_of(PROBLEM_GAVE_WAY);
    } else if (http_connections_received(connection) >= LIBRARY_HEAD_BYTES) {
        problem = http_problem_of(PROBLEM_TOO_MANY_HEADERS);
    } else {
        /* It says itself what it has read. */
    }
    (void)http_reply_problem(connection, &problem, NULL);
    return 0;
}

static int keep_quiet(const struct mg_connection *connection, const char *message)
{
    (void)connection;
    (void)message;
    return 1;
}

static struct mg_context *start_library(http_server_t *self)
{
    static const struct mg_callbacks callbacks = {.init_context = http_handover_begin,
                                                  .begin_request = begin_request,
                                                  .init_connection = begin_connection,
                                                  .connection_close = end_connection,
                                                  .http_error = refuse,
                                                  .log_message = keep_quiet};
    char workers[16];
    char head_bytes[16];
    (void)snprintf(workers, sizeof workers, "%u", HTTP_CONNECTIONS_WORKERS);
    (void)snprintf(head_bytes, sizeof head_bytes, "%u", LIBRARY_HEAD_BYTES);
    /* clang-format off */
    const char *options[] = {
        "listening_ports", HTTP_HANDOVER_ADDRESS,
        "num_threads", workers,
        "request_timeout_ms", REQUEST_TIMEOUT_MS,
        "enable_keep_alive", "no",
        "tcp_nodelay", "1", /* Or a body waits until the client has acknowledged the head. */
        "max_request_size", head_bytes,
        "enable_directory_listing", "no",
        "enable_auth_domain_check", "no",
        "access_control_allow_origin", "",
        "access_control_allow_methods", "",
        "access_control_allow_headers", "",
        "cgi_pattern", "",
        "ssi_pattern", "",
        "decode_url", "no", /* Or a path would end at its %00, and have two spellings. */
        NULL};
    /* clang-format on */
    return mg_start(&callbacks, self, options);
}

http_server_result_t http_server_start(http_server_t *self)
{
    const http_server_result_t result = open_gates(self);
    if (result != HTTP_SERVER_STARTED) {
        return result;
    }
    pthread_attr_t attributes;
    (void)pthread_attr_init(&attributes);
    (void)pthread_attr_setstacksize(&attributes, WORKER_STACK_BYTES);
    (void)pthread_setattr_default_np(&attributes);
    (void)mg_init_library(MG_FEATURES_DEFAULT);
    if (!http_handover_open()) {
        return HTTP_SERVER_TOO_FEW_FILES;
    }
    if (!stop_port_begin(self->exchange)) {
        return HTTP_SERVER_FAILED;
    }
    stand_back();
    return (start_library(self) != NULL) ? HTTP_SERVER_STARTED : HTTP_SERVER_FAILED;
}

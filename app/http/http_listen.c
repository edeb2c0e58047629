/* SPDX-License-Identifier: Apache-2.0 */
/** @file The server at its port: http_server_start(). */
#include "http/asset.h"
#include "http/http_lines.h"
#include "http/http_reply.h"
#include "http/http_routes.h"
#include "http/http_server.h"
#include "http/stop_port.h"
#include "limits/requirement_limits.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <pthread.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

/* A worker needs little; the default of 8 MB each would only be address space to fill. */
#define WORKER_STACK_BYTES (256U * 1024U)

/* A client that does not finish its request holds a worker until the timeout; stops have a port
 * of their own (stop_port.c). The library uses the same timeout for a blocked write; a stream tries
 * again (http_stream.c). */
#define REQUEST_TIMEOUT_MS "500"
/* A connection on which nothing is asked for so long is closed; sooner when workers run short. */
#define IDLE_MS "30000"
/* Of a head the library reads no more, and calls it unreadable. */
#define LIBRARY_HEAD_BYTES 65536U

#define WORKER_NICENESS 10
#define UNREAD_BYTES 16384
#define DESCRIPTORS 64 /* So early few are open. */

/* The library does not say why it could not listen. */
static int try_to_listen(const char *its_address, uint32_t port)
{
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    (void)inet_pton(AF_INET, its_address, &address.sin_addr);
    int yes = 1;
    int probe = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    (void)setsockopt(probe, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    int error = 0;
    if ((bind(probe, (const struct sockaddr *)&address, sizeof address) != 0) ||
        (listen(probe, 1) != 0)) {
        error = errno;
    }
    (void)close(probe);
    return error;
}

/* What a client has not read waits in the kernel, by default megabytes of it: half a minute in
 * which its place in the stream is lost. The library does not hand out its listening socket, from
 * which every connection inherits the size; it is found among the descriptors. */
static void bound_unread_bytes(void)
{
    const int bytes = UNREAD_BYTES;
    for (int descriptor = 0; descriptor < DESCRIPTORS; descriptor++) {
        int is_listening = 0;
        socklen_t size = sizeof is_listening;
        if ((getsockopt(descriptor, SOL_SOCKET, SO_ACCEPTCONN, &is_listening, &size) == 0) &&
            (is_listening != 0)) {
            (void)setsockopt(descriptor, SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
        }
    }
}

/* Without it, stops pass by the console's port alone. */
static void open_stop_port(http_server_t *self)
{
    const uint32_t port = stop_port_start(self->exchange, &self->guard, self->front);
    if (port != 0U) {
        http_reply_allow_stops(self->guard.address, port, self->front);
        asset_tell_stop_ports(port, (self->front != NULL) ? self->front->stop : 0U);
    }
}

/* This thread and those that it makes, which the thread of the stops is not among: where the
 * processor is short, so many workers would leave little of it to recorder and OpenIGTLink. */
static void stand_back(void)
{
    (void)setpriority(PRIO_PROCESS, 0U, WORKER_NICENESS);
}

static int begin_request(struct mg_connection *connection)
{
    http_lines_note(connection, HTTP_LINE_ASKS);
    return http_routes_answer(mg_get_user_data(mg_get_context(connection)), connection);
}

static int begin_connection(const struct mg_connection *connection, void **own)
{
    (void)own;
    http_lines_enter(connection);
    return 0;
}

static void end_connection(const struct mg_connection *connection)
{
    http_lines_leave(connection);
}

static void end_request(const struct mg_connection *connection, int status)
{
    (void)status;
    http_lines_note(connection, HTTP_LINE_ANSWERED);
}

/* Requests that the library itself refuses, before there is a path to look at. */
static int refuse(struct mg_connection *connection, int status, const char *message)
{
    (void)message;
    http_problem_t problem = http_problem_of(PROBLEM_BAD_REQUEST);
    problem.http = status;
    if (http_lines_is_leaving(connection)) {
        problem = http_problem_of(PROBLEM_GAVE_WAY);
    } else if (http_lines_received(connection) >= LIBRARY_HEAD_BYTES) {
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

static struct mg_context *start_library(http_server_t *self, const char *address)
{
    static const struct mg_callbacks callbacks = {.begin_request = begin_request,
                                                  .end_request = end_request,
                                                  .init_connection = begin_connection,
                                                  .connection_close = end_connection,
                                                  .http_error = refuse,
                                                  .log_message = keep_quiet};
    char workers[16];
    char waiting[16];
    char head_bytes[16];
    (void)snprintf(workers, sizeof workers, "%u", HTTP_LINES_WORKERS);
    (void)snprintf(waiting, sizeof waiting, "%u", LIMIT_WAITING_CLIENTS);
    (void)snprintf(head_bytes, sizeof head_bytes, "%u", LIBRARY_HEAD_BYTES);
    /* clang-format off */
    const char *options[] = {
        "listening_ports", address,
        "num_threads", workers,
        "listen_backlog", waiting, /* Whom the kernel has no room for comes again seconds later. */
        "request_timeout_ms", REQUEST_TIMEOUT_MS,
        "enable_keep_alive", "yes",
        "keep_alive_timeout_ms", IDLE_MS,
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
    int error = try_to_listen(self->guard.address, self->guard.port);
    if (error == EADDRINUSE) {
        return HTTP_SERVER_PORT_IN_USE;
    }
    if (error != 0) {
        return HTTP_SERVER_BAD_ADDRESS;
    }
    if ((self->front != NULL) && (try_to_listen("127.0.0.1", self->front->console_from) != 0)) {
        return HTTP_SERVER_FRONT_IN_USE;
    }
    if ((self->front != NULL) && (try_to_listen("127.0.0.1", self->front->stop_from) != 0)) {
        return HTTP_SERVER_FRONT_STOP_IN_USE;
    }
    pthread_attr_t attributes;
    (void)pthread_attr_init(&attributes);
    (void)pthread_attr_setstacksize(&attributes, WORKER_STACK_BYTES);
    (void)pthread_setattr_default_np(&attributes);
    char address[HTTP_GUARD_ADDRESS_SIZE + 40U];
    const int size =
        snprintf(address, sizeof address, "%s:%u", self->guard.address, (unsigned)self->guard.port);
    if (self->front != NULL) {
        (void)snprintf(&address[size], sizeof address - (size_t)size, ",127.0.0.1:%u",
                       (unsigned)self->front->console_from);
    }
    (void)mg_init_library(MG_FEATURES_DEFAULT);
    open_stop_port(self);
    stand_back();
    if (start_library(self, address) == NULL) {
        return HTTP_SERVER_FAILED;
    }
    bound_unread_bytes();
    return HTTP_SERVER_STARTED;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_server.h"

#include "common/build_id.h"
#include "http/asset.h"
#include "http/http_door.h"
#include "http/http_lines.h"
#include "http/http_positions.h"
#include "http/http_reply.h"
#include "http/http_routes.h"
#include "http/stop_port.h"
#include "limits/requirement_limits.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>
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

static void make_boot_id(char *text, size_t size)
{
    uint64_t number = 0U;
    if (getrandom(&number, sizeof number, 0U) != (ssize_t)sizeof number) {
        number = telemetry_now_ms();
    }
    (void)snprintf(text, size, "%016llx", (unsigned long long)number);
}

void http_server_init(http_server_t *self, const http_server_config_t *config)
{
    self->exchange = config->exchange;
    self->guard = config->guard;
    self->instance = config->instance;
    self->front = config->front;
    self->archive.directory = config->recordings;
    (void)pthread_mutex_init(&self->archive.lock, NULL);
    if (config->front != NULL) {
        const http_guard_t front = {.address = "127.0.0.1",
                                    .port = config->front->console_from,
                                    .page_port = config->front->console_from,
                                    .front = config->front,
                                    .front_port = config->front->console,
                                    .is_front_only = true};
        self->front_guard = front;
    }
    act_desk_init(&self->acts, config->exchange);
    (void)pthread_mutex_init(&self->orders, NULL);
    http_notes_init(&self->notes, config->exchange, &self->acts);
    session_desk_init(&self->desk, config->accounts, http_notes_write, &self->notes);
    http_positions_begin(self, config->box_key);
    make_boot_id(self->identity.boot_id, sizeof self->identity.boot_id);
    self->identity.version = BUILD_VERSION;
    self->identity.build_id = BUILD_ID;
    self->identity.box = config->box;
    telemetry_init(&self->telemetry, config->exchange);
    http_stream_init(&self->stream, config->exchange);
}

bool http_server_prepare_logins(http_server_t *self, char *error, size_t error_size)
{
    static const char none[] = "There is no account, and this board drives a real robot; make one "
                               "with boresight-passwd and name its file with --accounts.";
    accounts_t accounts;
    accounts.count = 0U;
    if ((self->desk.accounts_file != NULL) &&
        !accounts_read(&accounts, self->desk.accounts_file, error, error_size)) {
        return false;
    }
    if ((self->identity.box == NULL) && (accounts.count == 0U)) {
        (void)snprintf(error, error_size, "%s", none);
        return false;
    }
    if (self->desk.accounts_file == NULL) {
        if (!session_desk_make_code(&self->desk)) {
            (void)snprintf(error, error_size, "The system has no random numbers.");
            return false;
        }
        (void)fprintf(stderr, "Login:       %s (once, at the console on this machine)\n",
                      self->desk.code);
    }
    return true;
}

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

void http_server_tick(http_server_t *self)
{
    telemetry_view_t view;
    session_desk_tick(&self->desk, telemetry_now_ms());
    http_notes_tell_replaced(&self->notes);
    http_notes_tick(&self->notes);
    act_desk_tick(&self->acts, &self->desk, telemetry_now_ms());
    telemetry_look(&self->telemetry, &view);
    if (!view.has_snapshot || !http_stream_is_watched(&self->stream)) {
        return;
    }
    cJSON *state = telemetry_json_state(&self->identity, &view);
    char *json = cJSON_PrintUnformatted(state);
    if (json != NULL) {
        (void)http_stream_publish(&self->stream, json);
    }
    cJSON_free(json);
    cJSON_Delete(state);
}

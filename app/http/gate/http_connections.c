/* SPDX-License-Identifier: Apache-2.0 */
#include "http/gate/http_connections.h"

#include "http/gate/http_handover.h"
#include "limits/requirement_limits.h"

#include <arpa/inet.h>
#include <linux/tcp.h>
#include <netinet/in.h>
#include <pthread.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/socket.h>

#define FEW                                                                                        \
    (HTTP_CONNECTIONS_WORKERS - LIMIT_SPARE_WORKERS) /* Connections from which workers run short.  \
                                                      */

typedef struct {
    const struct mg_connection *connection; /* NULL: this place is free. */
    int socket;                             /* -1: not known yet. */
    bool is_waiting;                        /* For a request, or for the rest of one. */
    bool is_leaving;                        /* It is shut down; its worker is on the way. */
    uint64_t since;                         /* In the order of coming. */
} line_t;

static struct {
    pthread_mutex_t lock;
    uint64_t turns; /* Number of all connections that were ever accepted. */
    unsigned count; /* Without those that are leaving. */
    line_t lines[HTTP_CONNECTIONS_WORKERS];
} all = {.lock = PTHREAD_MUTEX_INITIALIZER};

static line_t *find(const struct mg_connection *connection)
{
    for (size_t i = 0U; i < HTTP_CONNECTIONS_WORKERS; i++) {
        if (all.lines[i].connection == connection) {
            return &all.lines[i];
        }
    }
    return NULL;
}

static bool is_at(const struct sockaddr_in *place, int result, int port)
{
    return (result == 0) && (place->sin_family == AF_INET) && (ntohs(place->sin_port) == port);
}

/* The library does not hand out its sockets; this one is found by its two ends. */
static int find_socket(const struct mg_request_info *ends)
{
    struct in_addr client = {.s_addr = 0U};
    (void)inet_pton(AF_INET, ends->remote_addr, &client);
    for (int descriptor = 0; descriptor < (int)HTTP_HANDOVER_DESCRIPTORS; descriptor++) {
        struct sockaddr_in here = {.sin_port = 0U};
        struct sockaddr_in there = {.sin_port = 0U};
        socklen_t size = sizeof there;
        const int their_end = getpeername(descriptor, (struct sockaddr *)&there, &size);
        if (!is_at(&there, their_end, ends->remote_port) ||
            (there.sin_addr.s_addr != client.s_addr)) {
            continue;
        }
        size = sizeof here;
        const int our_end = getsockname(descriptor, (struct sockaddr *)&here, &size);
        if (is_at(&here, our_end, ends->server_port)) {
            return descriptor;
        }
    }
    return -1;
}

static uint64_t received_of(int socket)
{
    struct tcp_info info = {.tcpi_bytes_received = 0U};
    socklen_t size = sizeof info;
    const int result = getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &size);
    return (result == 0) ? info.tcpi_bytes_received : 0U;
}

/* The library gives no ends of a connection before its worker has begun to read. */
static void know_socket(line_t *line)
{
    const struct mg_request_info *ends =
        (line->socket < 0) ? mg_get_request_info(line->connection) : NULL;
    if (ends != NULL) {
        line->socket = find_socket(ends);
    }
}

/* Its worker then reads what has come, and the end behind it: a client that has sent all is
 * answered. */
static void dismiss_oldest(void)
{
    line_t *oldest = NULL;
    for (size_t i = 0U; i < HTTP_CONNECTIONS_WORKERS; i++) {
        line_t *line = &all.lines[i];
        const bool is_candidate = (line->connection != NULL) && line->is_waiting &&
                                  (mg_get_request_info(line->connection) != NULL);
        if (is_candidate && ((oldest == NULL) || (line->since < oldest->since))) {
            oldest = line;
        }
    }
    if (oldest != NULL) {
        know_socket(oldest);
    }
    if ((oldest != NULL) && (oldest->socket >= 0)) {
        (void)shutdown(oldest->socket, SHUT_RD);
        oldest->is_waiting = false;
        oldest->is_leaving = true;
        all.count--;
    }
}

void http_connections_enter(const struct mg_connection *connection)
{
    (void)pthread_mutex_lock(&all.lock);
    line_t *line = find(NULL);
    if (line != NULL) {
        const line_t new_line = {
            .connection = connection, .socket = -1, .is_waiting = true, .since = all.turns};
        *line = new_line;
        all.turns++;
        all.count++;
    }
    if (all.count > FEW) {
        dismiss_oldest();
    }
    (void)pthread_mutex_unlock(&all.lock);
}

void http_connections_note(const struct mg_connection *connection, http_line_t state)
{
    (void)pthread_mutex_lock(&all.lock);
    line_t *line = find(connection);
    if (line != NULL) {
        line->is_waiting = (state == HTTP_LINE_READS) && !line->is_leaving;
    }
    (void)pthread_mutex_unlock(&all.lock);
}

uint64_t http_connections_received(const struct mg_connection *connection)
{
    uint64_t received = 0U;
    (void)pthread_mutex_lock(&all.lock);
    line_t *line = find(connection);
    if (line != NULL) {
        know_socket(line);
        received = received_of(line->socket);
    }
    (void)pthread_mutex_unlock(&all.lock);
    return received;
}

void http_connections_leave(const struct mg_connection *connection)
{
    (void)pthread_mutex_lock(&all.lock);
    line_t *line = find(connection);
    if (line != NULL) {
        line->connection = NULL;
        all.count -= line->is_leaving ? 0U : 1U;
    }
    (void)pthread_mutex_unlock(&all.lock);
}

bool http_connections_is_leaving(const struct mg_connection *connection)
{
    (void)pthread_mutex_lock(&all.lock);
    const line_t *line = find(connection);
    const bool is_leaving = (line != NULL) && line->is_leaving;
    (void)pthread_mutex_unlock(&all.lock);
    return is_leaving;
}

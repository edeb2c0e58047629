/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_lines.h"

#include "limits/requirement_limits.h"

#include <arpa/inet.h>
#include <linux/tcp.h>
#include <netinet/in.h>
#include <pthread.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/socket.h>

#define DESCRIPTORS 1024
#define FEW                                                                                        \
    (HTTP_LINES_WORKERS - LIMIT_SPARE_WORKERS) /* Connections from which workers run short. */

typedef struct {
    const struct mg_connection *connection; /* NULL: this place is free. */
    int socket;                             /* -1: not known before its first answer. */
    bool is_idle;
    bool is_leaving;   /* It was told to; its worker is on the way. */
    uint64_t since;    /* In the order of becoming idle. */
    uint64_t received; /* Bytes, at that time. */
} line_t;

static struct {
    pthread_mutex_t lock;
    unsigned port;
    unsigned front_port;
    uint64_t turns;
    unsigned count; /* Without those that are leaving. */
    line_t lines[HTTP_LINES_WORKERS];
} all = {.lock = PTHREAD_MUTEX_INITIALIZER};

void http_lines_init(unsigned port, unsigned front_port)
{
    all.port = port;
    all.front_port = front_port;
}

static line_t *find(const struct mg_connection *connection)
{
    for (size_t i = 0U; i < HTTP_LINES_WORKERS; i++) {
        if (all.lines[i].connection == connection) {
            return &all.lines[i];
        }
    }
    return NULL;
}

static bool has_port(const struct sockaddr_in *address, int result, unsigned port)
{
    return (result == 0) && (address->sin_family == AF_INET) && (ntohs(address->sin_port) == port);
}

/* The library does not hand out its sockets; this one is found by its two ends. */
static int find_socket(unsigned their_port)
{
    for (int descriptor = 0; descriptor < DESCRIPTORS; descriptor++) {
        struct sockaddr_in here = {.sin_port = 0U};
        struct sockaddr_in there = {.sin_port = 0U};
        socklen_t size = sizeof there;
        const int their_end = getpeername(descriptor, (struct sockaddr *)&there, &size);
        if (!has_port(&there, their_end, their_port)) {
            continue;
        }
        size = sizeof here;
        const int our_end = getsockname(descriptor, (struct sockaddr *)&here, &size);
        if (has_port(&here, our_end, all.port) ||
            ((all.front_port != 0U) && has_port(&here, our_end, all.front_port))) {
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

/* Its worker then reads the end, and closes it; an answer that is on its way still leaves. */
static void close_oldest(void)
{
    line_t *oldest = NULL;
    for (size_t i = 0U; i < HTTP_LINES_WORKERS; i++) {
        line_t *line = &all.lines[i];
        const bool is_candidate =
            (line->connection != NULL) && line->is_idle && (line->socket >= 0);
        if (is_candidate && ((oldest == NULL) || (line->since < oldest->since))) {
            oldest = line;
        }
    }
    if (oldest != NULL) {
        (void)shutdown(oldest->socket, SHUT_RD);
        oldest->is_idle = false;
        oldest->is_leaving = true;
        all.count--;
    }
}

void http_lines_enter(const struct mg_connection *connection)
{
    (void)pthread_mutex_lock(&all.lock);
    line_t *line = find(NULL);
    if (line != NULL) {
        const line_t new_line = {.connection = connection, .socket = -1};
        *line = new_line;
        all.count++;
    }
    if (all.count > FEW) {
        close_oldest();
    }
    (void)pthread_mutex_unlock(&all.lock);
}

static void know_socket(line_t *line)
{
    if (line->socket < 0) {
        line->socket = find_socket((unsigned)mg_get_request_info(line->connection)->remote_port);
    }
}

void http_lines_note(const struct mg_connection *connection, bool is_idle)
{
    (void)pthread_mutex_lock(&all.lock);
    line_t *line = find(connection);
    if (line != NULL) {
        if (is_idle) { /* Its answer has left: nobody waits for the search. */
            know_socket(line);
        }
        line->is_idle = is_idle && !line->is_leaving;
        line->received = is_idle ? received_of(line->socket) : line->received;
        line->since = all.turns;
        all.turns++;
    }
    (void)pthread_mutex_unlock(&all.lock);
}

uint64_t http_lines_received(const struct mg_connection *connection)
{
    uint64_t received = 0U;
    (void)pthread_mutex_lock(&all.lock);
    line_t *line = find(connection);
    if (line != NULL) {
        know_socket(line);
        received = received_of(line->socket) - line->received;
    }
    (void)pthread_mutex_unlock(&all.lock);
    return received;
}

void http_lines_leave(const struct mg_connection *connection)
{
    (void)pthread_mutex_lock(&all.lock);
    line_t *line = find(connection);
    if (line != NULL) {
        line->connection = NULL;
        all.count -= line->is_leaving ? 0U : 1U;
    }
    (void)pthread_mutex_unlock(&all.lock);
}

bool http_lines_has_room(void)
{
    (void)pthread_mutex_lock(&all.lock);
    const bool has_room = all.count <= FEW;
    (void)pthread_mutex_unlock(&all.lock);
    return has_room;
}

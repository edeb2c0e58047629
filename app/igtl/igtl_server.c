/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/igtl_server.h"

#include <arpa/inet.h>
#include <errno.h>
#include <inttypes.h>
#include <netinet/in.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#define BACKLOG 16
#define MESSAGES_PER_TURN 16U
#define ACCEPTS_PER_TURN 16U
#define LOG_INTERVAL_US UINT64_C(1000000)

/* One line per kind and second at most; it says how many there were since the last. */
static void log_trouble(igtl_server_t *self, igtl_trouble_t kind, const char *reason,
                        uint64_t now_us)
{
    static const char *const texts[IGTL_TROUBLES] = {
        "refused a connection: all are taken",
        "dropped a connection",
        "dropped a connection",
        "dropped a connection: it does not read",
        "refused a message",
        "dropped a connection: it was silent and its place is wanted"};
    igtl_trouble_count_t *trouble = &self->troubles[kind];

    trouble->count++;
    if (now_us < trouble->next_log_us) {
        return;
    }
    (void)fprintf(stderr, "boresight-igtl: port %u %s%s%s (%" PRIu64 " more, %" PRIu64 " in all)\n",
                  (unsigned)self->port, texts[kind], (reason[0] == '\0') ? "" : ": ", reason,
                  trouble->count - trouble->said - 1U, trouble->count);
    trouble->said = trouble->count;
    trouble->next_log_us = now_us + LOG_INTERVAL_US;
}

static bool listen_on(igtl_server_t *self, const char *address, char *error, size_t error_size)
{
    struct sockaddr_in place = {.sin_family = AF_INET, .sin_port = htons(self->port)};
    const int on = 1;
    int reason;

    if (inet_pton(AF_INET, address, &place.sin_addr) != 1) {
        (void)snprintf(error, error_size, "%s is not an IPv4 address; give one with --bind",
                       address);
        return false;
    }
    self->listener = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (self->listener < 0) {
        (void)snprintf(error, error_size, "no socket can be opened: %s", strerror(errno));
        return false;
    }
    /* A port of a process that has just ended can be opened again. */
    (void)setsockopt(self->listener, SOL_SOCKET, SO_REUSEADDR, &on, (socklen_t)sizeof on);
    if ((bind(self->listener, (const struct sockaddr *)&place, (socklen_t)sizeof place) == 0) &&
        (listen(self->listener, BACKLOG) == 0)) {
        return true;
    }
    reason = errno;
    (void)snprintf(error, error_size, "port %u cannot be opened on %s: %s", (unsigned)self->port,
                   address, strerror(reason));
    errno = reason;
    return false;
}

bool igtl_server_open(igtl_server_t *self, const char *address, uint16_t port, char *error,
                      size_t error_size)
{
    self->port = port;
    self->listener = -1;
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        igtl_connection_init(&self->connections[i]);
    }
    (void)memset(self->troubles, 0, sizeof self->troubles);
    return listen_on(self, address, error, error_size);
}

void igtl_server_close(igtl_server_t *self)
{
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if (self->connections[i].descriptor >= 0) {
            igtl_connection_close(&self->connections[i]);
        }
    }
    if (self->listener >= 0) {
        (void)close(self->listener);
        self->listener = -1;
    }
}

uint32_t igtl_server_polls(const igtl_server_t *self, struct pollfd *polls)
{
    uint32_t count = 1U;

    polls[0] = (struct pollfd){.fd = self->listener, .events = POLLIN};
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if (self->connections[i].descriptor >= 0) {
            const int waiting =
                (self->connections[i].outbox.count > 0U) ? (POLLIN | POLLOUT) : POLLIN;

            polls[count] =
                (struct pollfd){.fd = self->connections[i].descriptor, .events = (short)waiting};
            count++;
        }
    }
    return count;
}

bool igtl_server_has_peers(const igtl_server_t *self)
{
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if (self->connections[i].descriptor >= 0) {
            return true;
        }
    }
    return false;
}

static void drop(igtl_server_t *self, uint32_t peer)
{
    igtl_connection_close(&self->connections[peer]);
    self->calls->disconnected(self->dialect, self->first_place + peer);
}

/* Makes room by dropping who has been silent for longest. */
static void evict_silent(igtl_server_t *self, uint64_t now_us)
{
    uint64_t longest_us = IGTL_SILENT_US;
    uint32_t silent = IGTL_PEERS;

    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        const uint64_t silent_us = now_us - self->connections[i].heard_us;
        const bool is_in_control =
            (self->calls->is_controlled_by != NULL) &&
            self->calls->is_controlled_by(self->dialect, self->first_place + i);

        if ((silent_us > longest_us) && !is_in_control) {
            longest_us = silent_us;
            silent = i;
        }
    }
    if (silent < IGTL_PEERS) {
        log_trouble(self, IGTL_TROUBLE_SILENT, "", now_us);
        drop(self, silent);
    }
}

static bool is_full(const igtl_server_t *self)
{
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if (self->connections[i].descriptor < 0) {
            return false;
        }
    }
    return true;
}

/* The log of events names a connection by its number only. */
static void greet(igtl_server_t *self, uint32_t number, const struct sockaddr_in *place,
                  uint64_t now_us)
{
    char address[INET_ADDRSTRLEN] = "?";

    if (now_us < self->next_greeting_us) {
        return;
    }
    self->next_greeting_us = now_us + LOG_INTERVAL_US;
    (void)inet_ntop(AF_INET, &place->sin_addr, address, (socklen_t)sizeof address);
    (void)fprintf(stderr, "boresight-igtl: port %u: peer %u is %s:%u\n", (unsigned)self->port,
                  (unsigned)number, address, (unsigned)ntohs(place->sin_port));
}

static bool seat(igtl_server_t *self, int descriptor, const struct sockaddr_in *place,
                 uint64_t now_us)
{
    if (is_full(self)) {
        evict_silent(self, now_us);
    }
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if (self->connections[i].descriptor < 0) {
            igtl_connection_open(&self->connections[i], descriptor, now_us);
            greet(self, self->next_number, place, now_us);
            const igtl_introduction_t introduction = {self->next_number, self->language, "ENTRY_",
                                                      &self->connections[i].outbox};
            self->calls->connected(self->dialect, self->first_place + i, &introduction);
            self->next_number += IGTL_NUMBER_STEP;
            return true;
        }
    }
    return false;
}

static void accept_peers(igtl_server_t *self, uint64_t now_us)
{
    for (uint32_t i = 0U; i < ACCEPTS_PER_TURN; i++) {
        struct sockaddr_in place = {.sin_family = AF_INET};
        socklen_t size = (socklen_t)sizeof place;
        const int descriptor =
            accept4(self->listener, (struct sockaddr *)&place, &size, SOCK_NONBLOCK | SOCK_CLOEXEC);

        if (descriptor < 0) {
            return;
        }
        if (!seat(self, descriptor, &place, now_us)) {
            (void)close(descriptor);
            log_trouble(self, IGTL_TROUBLE_FULL, "", now_us);
        }
    }
}

static void tell_trouble(igtl_server_t *self, uint32_t peer, igtl_result_t reason, const char *name,
                         const igtl_moment_t *moment)
{
    const igtl_status_t status = {igtl_result_code(reason), "REFUSED", igtl_result_text(reason)};

    igtl_tell_status(&self->connections[peer].outbox, name, &status, moment);
}

/* Tells why, as far as the peer listens, and closes. */
static void drop_with(igtl_server_t *self, uint32_t peer, igtl_trouble_t kind, igtl_result_t reason,
                      const igtl_moment_t *moment)
{
    tell_trouble(self, peer, reason, "CONNECTION", moment);
    (void)igtl_connection_flush(&self->connections[peer]);
    log_trouble(self, kind, igtl_result_text(reason), moment->now_us);
    drop(self, peer);
}

/* False when the connection has ended. */
static bool handle(igtl_server_t *self, uint32_t peer, igtl_inbox_event_t event,
                   const igtl_moment_t *moment)
{
    const igtl_inbox_t *inbox = &self->connections[peer].inbox;

    switch (event) {
    case IGTL_INBOX_MESSAGE:
        self->calls->receive(self->dialect, self->first_place + peer, &inbox->message, moment);
        return true;
    case IGTL_INBOX_REFUSED:
        tell_trouble(self, peer, inbox->reason, inbox->header.name, moment);
        log_trouble(self, IGTL_TROUBLE_MESSAGE, igtl_result_text(inbox->reason), moment->now_us);
        return true;
    case IGTL_INBOX_BROKEN:
        drop_with(self, peer, IGTL_TROUBLE_BROKEN, inbox->reason, moment);
        return false;
    case IGTL_INBOX_WAITING:
    case IGTL_INBOX_SKIPPED:
    default:
        return true;
    }
}

static void receive_from(igtl_server_t *self, uint32_t peer, const igtl_moment_t *moment)
{
    igtl_connection_t *connection = &self->connections[peer];
    uint32_t bytes_left = IGTL_BYTES_PER_TURN;

    for (uint32_t i = 0U; i < MESSAGES_PER_TURN; i++) {
        igtl_inbox_event_t event = IGTL_INBOX_WAITING;
        const igtl_received_t received =
            igtl_connection_receive(connection, moment->now_us, &bytes_left, &event);

        if (received == IGTL_RECEIVED_END) {
            drop(self, peer);
            return;
        }
        if ((received == IGTL_RECEIVED_NOTHING) || !handle(self, peer, event, moment)) {
            break;
        }
    }
    if ((connection->descriptor >= 0) && igtl_inbox_is_late(&connection->inbox, moment->now_us)) {
        drop_with(self, peer, IGTL_TROUBLE_LATE, IGTL_INCOMPLETE, moment);
    }
}

void igtl_server_receive(igtl_server_t *self, const igtl_moment_t *moment)
{
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if (self->connections[i].descriptor >= 0) {
            receive_from(self, i, moment);
        }
    }
    accept_peers(self, moment->now_us); /* Last: who has gone makes room. */
}

void igtl_server_send(igtl_server_t *self, const igtl_moment_t *moment)
{
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if ((self->connections[i].descriptor >= 0) &&
            !igtl_connection_flush(&self->connections[i])) {
            if (self->connections[i].outbox.has_overflowed) {
                log_trouble(self, IGTL_TROUBLE_SLOW, "", moment->now_us);
            }
            drop(self, i);
        }
    }
}

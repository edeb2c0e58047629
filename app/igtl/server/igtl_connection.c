/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_connection.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#define KEEPALIVE_IDLE_S 5
#define KEEPALIVE_INTERVAL_S 2
#define KEEPALIVE_COUNT 3
#define UNACKNOWLEDGED_MS 10000

void igtl_connection_init(igtl_connection_t *self)
{
    self->descriptor = -1;
    self->number = 0U;
    self->place = IGTL_NO_PLACE;
    self->address = 0U;
    self->port = 0U;
    self->is_kept_alive = false;
    self->since_us = 0U;
    self->heard_us = 0U;
    self->was_heard = false;
    self->heard[0] = '\0';
    self->status[0] = '\0';
    self->statuses = 0U;
    self->refusal[0] = '\0';
    self->refusals = 0U;
    self->messages_in = 0U;
    self->messages_out = 0U;
    self->received = 0U;
    self->errors = 0U;
    self->sent = 0U;
    self->acknowledged = 0U;
    self->moved_us = 0U;
    igtl_inbox_init(&self->inbox);
    igtl_inbox_lend(&self->inbox, self->large);
    igtl_outbox_init(&self->outbox);
}

static void set_option(int descriptor, int level, int option, int value)
{
    (void)setsockopt(descriptor, level, option, &value, (socklen_t)sizeof value);
}

void igtl_connection_keep_alive(igtl_connection_t *self, bool is_on)
{
    set_option(self->descriptor, SOL_SOCKET, SO_KEEPALIVE, is_on ? 1 : 0);
    self->is_kept_alive = is_on;
}

void igtl_connection_open(igtl_connection_t *self, int descriptor, uint64_t now_us)
{
    igtl_connection_init(self);
    self->descriptor = descriptor;
    self->since_us = now_us;
    self->heard_us = now_us;
    (void)fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
    set_option(descriptor, IPPROTO_TCP, TCP_NODELAY, 1);
    igtl_connection_keep_alive(self, true);
    set_option(descriptor, IPPROTO_TCP, TCP_KEEPIDLE, KEEPALIVE_IDLE_S);
    set_option(descriptor, IPPROTO_TCP, TCP_KEEPINTVL, KEEPALIVE_INTERVAL_S);
    set_option(descriptor, IPPROTO_TCP, TCP_KEEPCNT, KEEPALIVE_COUNT);
    set_option(descriptor, IPPROTO_TCP, TCP_USER_TIMEOUT, UNACKNOWLEDGED_MS);
}

void igtl_connection_close(igtl_connection_t *self)
{
    (void)close(self->descriptor);
    self->descriptor = -1;
}

static bool is_only_waiting(void)
{
    return (errno == EAGAIN) || (errno == EWOULDBLOCK) || (errno == EINTR);
}

static void count(igtl_connection_t *self, igtl_inbox_event_t event, uint64_t now_us)
{
    if ((event == IGTL_INBOX_MESSAGE) || (event == IGTL_INBOX_SKIPPED)) {
        self->heard_us = now_us;
        self->was_heard = true;
        self->messages_in++;
        (void)memcpy(self->heard, self->inbox.header.name, sizeof self->heard);
    } else if (event == IGTL_INBOX_REFUSED) {
        self->errors++;
    } else {
        /* It is not whole, or no message. */
    }
}

igtl_received_t igtl_connection_receive(igtl_connection_t *self, uint64_t now_us,
                                        uint32_t *bytes_left, igtl_inbox_event_t *event)
{
    while (*bytes_left > 0U) {
        uint8_t *where;
        const uint32_t room = igtl_inbox_room(&self->inbox, &where);
        const uint32_t most = (room < *bytes_left) ? room : *bytes_left;
        const ssize_t bytes = recv(self->descriptor, where, most, 0);

        if (bytes == 0) {
            return IGTL_RECEIVED_END;
        }
        if (bytes < 0) {
            return is_only_waiting() ? IGTL_RECEIVED_NOTHING : IGTL_RECEIVED_END;
        }
        *bytes_left -= (uint32_t)bytes;
        self->received += (uint64_t)bytes;
        *event = igtl_inbox_advance(&self->inbox, (uint32_t)bytes, now_us);
        count(self, *event, now_us);
        if (*event != IGTL_INBOX_WAITING) {
            igtl_outbox_hear(&self->outbox, self->inbox.header.version);
            return IGTL_RECEIVED_EVENT;
        }
    }
    return IGTL_RECEIVED_NOTHING;
}

bool igtl_connection_flush(igtl_connection_t *self)
{
    uint32_t length;
    const uint8_t *bytes = igtl_outbox_next(&self->outbox, &length);

    while (bytes != NULL) {
        const uint32_t waiting = self->outbox.count;
        const ssize_t written = send(self->descriptor, bytes, length, MSG_NOSIGNAL);

        if (written < 0) {
            return is_only_waiting() && !self->outbox.has_overflowed;
        }
        self->sent += (uint64_t)written;
        igtl_outbox_advance(&self->outbox, (uint32_t)written);
        self->messages_out += waiting - self->outbox.count;
        bytes = igtl_outbox_next(&self->outbox, &length);
    }
    return !self->outbox.has_overflowed;
}

uint64_t igtl_connection_unread_us(igtl_connection_t *self, uint64_t now_us)
{
    int queued = 0;
    uint64_t acknowledged;

    (void)ioctl(self->descriptor, SIOCOUTQ, &queued);
    acknowledged = self->sent - (uint64_t)queued;
    if ((self->moved_us == 0U) || (acknowledged != self->acknowledged) ||
        ((queued == 0) && (self->outbox.count == 0U))) {
        self->acknowledged = acknowledged;
        self->moved_us = now_us;
    }
    return now_us - self->moved_us;
}

static bool is_printable(uint8_t byte)
{
    return (byte >= 0x20U) && (byte <= 0x7EU);
}

/* Up to its first NUL, behind a space. */
static void add_field(char text[EXCHANGE_PEER_STATUS_SIZE], const uint8_t *field, uint32_t bytes)
{
    size_t used = strlen(text);

    for (uint32_t i = 0U; (i < bytes) && (field[i] != 0U); i++) {
        if ((i == 0U) && (used < (EXCHANGE_PEER_STATUS_SIZE - 1U))) {
            text[used] = ' ';
            used++;
        }
        if (used < (EXCHANGE_PEER_STATUS_SIZE - 1U)) {
            text[used] = is_printable(field[i]) ? (char)field[i] : '?';
            used++;
        }
    }
    text[used] = '\0';
}

void igtl_connection_keep_status(igtl_connection_t *self, const igtl_message_t *message)
{
    char text[EXCHANGE_PEER_STATUS_SIZE];

    (void)snprintf(text, sizeof text, "%s %u", message->name, (unsigned)message->code);
    add_field(text, &message->content[IGTL_STATUS_NAME_OFFSET], IGTL_STATUS_NAME_BYTES);
    add_field(text, &message->content[IGTL_STATUS_BYTES],
              message->content_bytes - IGTL_STATUS_BYTES);
    if (strcmp(text, self->status) != 0) {
        (void)memcpy(self->status, text, sizeof self->status);
        self->statuses++;
    }
}

void igtl_connection_keep_refusal(igtl_connection_t *self)
{
    const char *const refusal = self->outbox.refusal;

    char text[IGTL_OUTBOX_REFUSAL] = "";
    for (uint32_t i = 0U; refusal[i] != '\0'; i++) {
        text[i] = is_printable((uint8_t)refusal[i]) ? refusal[i] : '?';
    }
    if ((text[0] != '\0') && (strcmp(text, self->refusal) != 0)) {
        (void)memcpy(self->refusal, text, sizeof self->refusal);
        self->refusals++;
    }
}

void igtl_connection_unwatch(igtl_connection_t *self)
{
    self->moved_us = 0U;
}

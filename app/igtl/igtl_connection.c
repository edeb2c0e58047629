/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/igtl_connection.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stddef.h>
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
    self->heard_us = 0U;
    self->was_heard = false;
    self->sent = 0U;
    self->acknowledged = 0U;
    self->moved_us = 0U;
    igtl_inbox_init(&self->inbox);
    igtl_outbox_init(&self->outbox);
}

static void set_option(int descriptor, int level, int option, int value)
{
    (void)setsockopt(descriptor, level, option, &value, (socklen_t)sizeof value);
}

void igtl_connection_open(igtl_connection_t *self, int descriptor, uint64_t now_us)
{
    igtl_connection_init(self);
    self->descriptor = descriptor;
    self->heard_us = now_us;
    (void)fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
    set_option(descriptor, IPPROTO_TCP, TCP_NODELAY, 1);
    set_option(descriptor, SOL_SOCKET, SO_KEEPALIVE, 1);
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

igtl_received_t igtl_connection_receive(igtl_connection_t *self, uint64_t now_us,
                                        uint32_t *bytes_left, igtl_inbox_event_t *event)
{
    while (*bytes_left > 0U) {
        uint8_t *where;
        const uint32_t room = igtl_inbox_room(&self->inbox, &where);
        const uint32_t most = (room < *bytes_left) ? room : *bytes_left;
        const ssize_t count = recv(self->descriptor, where, most, 0);

        if (count == 0) {
            return IGTL_RECEIVED_END;
        }
        if (count < 0) {
            return is_only_waiting() ? IGTL_RECEIVED_NOTHING : IGTL_RECEIVED_END;
        }
        *bytes_left -= (uint32_t)count;
        *event = igtl_inbox_advance(&self->inbox, (uint32_t)count, now_us);
        if ((*event == IGTL_INBOX_MESSAGE) || (*event == IGTL_INBOX_SKIPPED)) {
            self->heard_us = now_us;
            self->was_heard = true;
        }
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
        const ssize_t count = send(self->descriptor, bytes, length, MSG_NOSIGNAL);

        if (count < 0) {
            return is_only_waiting() && !self->outbox.has_overflowed;
        }
        self->sent += (uint64_t)count;
        igtl_outbox_advance(&self->outbox, (uint32_t)count);
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

void igtl_connection_unwatch(igtl_connection_t *self)
{
    self->moved_us = 0U;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_caller.h"

#include "limits/requirement_limits.h"

#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <stddef.h>
#include <sys/socket.h>
#include <unistd.h>

void igtl_caller_init(igtl_caller_t *self, uint32_t address, uint16_t number)
{
    *self = (igtl_caller_t){.address = address,
                            .number = number,
                            .descriptor = -1,
                            .pause_us = LIMIT_IGTL_CALL_LEAST_US};
}

void igtl_caller_close(igtl_caller_t *self)
{
    if (self->descriptor >= 0) {
        (void)close(self->descriptor);
        self->descriptor = -1;
    }
}

static void pause_longer(igtl_caller_t *self, uint64_t now_us)
{
    self->next_us = now_us + self->pause_us;
    self->pause_us *= 2U;
    if (self->pause_us > LIMIT_IGTL_CALL_MOST_US) {
        self->pause_us = LIMIT_IGTL_CALL_MOST_US;
    }
}

static igtl_call_t fail(igtl_caller_t *self, int error, uint64_t now_us)
{
    igtl_caller_close(self);
    self->error = error;
    pause_longer(self, now_us);
    return IGTL_CALL_FAILED;
}

static igtl_call_t begin(igtl_caller_t *self, uint64_t now_us)
{
    const struct sockaddr_in place = {.sin_family = AF_INET,
                                      .sin_port = htons(self->number),
                                      .sin_addr.s_addr = htonl(self->address)};

    self->since_us = now_us;
    self->descriptor = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (self->descriptor < 0) {
        return fail(self, errno, now_us);
    }
    if ((connect(self->descriptor, (const struct sockaddr *)&place, (socklen_t)sizeof place) !=
         0) &&
        (errno != EINPROGRESS)) {
        return fail(self, errno, now_us);
    }
    return IGTL_CALL_NOTHING;
}

/* A call to a port of this machine without a listener can meet itself. */
static bool is_own_echo(const igtl_caller_t *self)
{
    struct sockaddr_in own = {.sin_family = AF_INET};
    socklen_t size = (socklen_t)sizeof own;

    (void)getsockname(self->descriptor, (struct sockaddr *)&own, &size);
    return (ntohs(own.sin_port) == self->number) && (ntohl(own.sin_addr.s_addr) == self->address);
}

static igtl_call_t look(igtl_caller_t *self, uint64_t now_us, int *descriptor)
{
    struct pollfd end = {.fd = self->descriptor, .events = POLLOUT};
    int error = 0;
    socklen_t size = (socklen_t)sizeof error;

    if (poll(&end, 1U, 0) != 1) {
        return ((now_us - self->since_us) < IGTL_CALL_TIMEOUT_US) ? IGTL_CALL_NOTHING
                                                                  : fail(self, ETIMEDOUT, now_us);
    }
    (void)getsockopt(self->descriptor, SOL_SOCKET, SO_ERROR, &error, &size);
    if (error != 0) {
        return fail(self, error, now_us);
    }
    if (is_own_echo(self)) {
        return fail(self, ECONNREFUSED, now_us);
    }
    *descriptor = self->descriptor;
    self->descriptor = -1;
    self->error = 0;
    self->since_us = now_us;
    self->is_connected = true;
    return IGTL_CALL_ANSWERED;
}

igtl_call_t igtl_caller_step(igtl_caller_t *self, uint64_t now_us, int *descriptor)
{
    if (self->descriptor >= 0) {
        return look(self, now_us, descriptor);
    }
    return (self->is_connected || (now_us < self->next_us)) ? IGTL_CALL_NOTHING
                                                            : begin(self, now_us);
}

void igtl_caller_lost(igtl_caller_t *self, bool was_heard, uint64_t now_us)
{
    self->is_connected = false;
    if (was_heard || ((now_us - self->since_us) > self->pause_us)) {
        self->pause_us = LIMIT_IGTL_CALL_LEAST_US;
    }
    pause_longer(self, now_us);
}

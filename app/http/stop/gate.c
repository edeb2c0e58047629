/* SPDX-License-Identifier: Apache-2.0 */
#include "http/stop/gate.h"

#include "limits/requirement_limits.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#define SILENCE_S 1
#define UNREAD_BYTES 16384

static void set(int socket, int level, int option, int value)
{
    (void)setsockopt(socket, level, option, &value, sizeof value);
}

/* Every connection inherits these. Bytes that a client has not read wait in the kernel, by default
 * megabytes of them: half a minute in which its place in the stream is lost. */
static int listen_on(int socket, const struct sockaddr_in *place)
{
    /* A client that the kernel has no room for comes again seconds later. */
    set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
    set(socket, SOL_SOCKET, SO_SNDBUF, UNREAD_BYTES);
    set(socket, IPPROTO_TCP, TCP_DEFER_ACCEPT, SILENCE_S);
    const bool is_listening = (bind(socket, (const struct sockaddr *)place, sizeof *place) == 0) &&
                              (listen(socket, (int)LIMIT_WAITING_CLIENTS) == 0);
    return is_listening ? 0 : errno;
}

int gate_open(gate_t *self, const char *address, uint32_t port)
{
    struct sockaddr_in place = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    (void)inet_pton(AF_INET, address, &place.sin_addr);
    self->socket = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int error = (self->socket >= 0) ? listen_on(self->socket, &place) : errno;
    if ((error != 0) && (self->socket >= 0)) {
        (void)close(self->socket);
        self->socket = -1;
    }
    return error;
}

uint32_t gate_port(const gate_t *self)
{
    struct sockaddr_in place = {.sin_port = 0U};
    socklen_t size = sizeof place;
    (void)getsockname(self->socket, (struct sockaddr *)&place, &size);
    return ntohs(place.sin_port);
}

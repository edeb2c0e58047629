/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_listener.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#define BACKLOG 16

int igtl_listener_open(uint32_t address, uint16_t number, char *error, size_t error_size)
{
    const struct sockaddr_in place = {
        .sin_family = AF_INET, .sin_port = htons(number), .sin_addr.s_addr = htonl(address)};
    const int listener = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int on = 1;
    char dotted[INET_ADDRSTRLEN] = "?";
    int reason;

    if (listener < 0) {
        (void)snprintf(error, error_size, "no socket can be opened: %s", strerror(errno));
        return -1;
    }
    /* A port of a process that has just ended can be opened again. */
    (void)setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, (socklen_t)sizeof on);
    if ((bind(listener, (const struct sockaddr *)&place, (socklen_t)sizeof place) == 0) &&
        (listen(listener, BACKLOG) == 0)) {
        return listener;
    }
    reason = errno;
    (void)close(listener);
    (void)inet_ntop(AF_INET, &place.sin_addr, dotted, (socklen_t)sizeof dotted);
    (void)snprintf(error, error_size, "port %u cannot be opened on %s: %s", (unsigned)number,
                   dotted, strerror(reason));
    errno = reason;
    return -1;
}

int igtl_listener_accept(int listener, uint32_t *address, uint16_t *number)
{
    struct sockaddr_in place = {.sin_family = AF_INET};
    socklen_t size = (socklen_t)sizeof place;
    const int descriptor =
        accept4(listener, (struct sockaddr *)&place, &size, SOCK_NONBLOCK | SOCK_CLOEXEC);

    *address = ntohl(place.sin_addr.s_addr);
    *number = ntohs(place.sin_port);
    return descriptor;
}

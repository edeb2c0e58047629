/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_handover.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#define DESCRIPTORS 64      /* So early few are open. */
#define WAITING_CLIENTS 320 /* The descriptors of all clients stay below 1,024. */

static int way[2]; /* A pipe of descriptors. */

/* What the library finds under the name of accept(): this program's own comes before the C
 * library's. */
int hand_over(int listener, struct sockaddr *address, socklen_t *size) __asm__("accept");

int hand_over(int listener, struct sockaddr *address, socklen_t *size)
{
    int socket = -1;
    if (read(listener, &socket, sizeof socket) != (ssize_t)sizeof socket) {
        return -1;
    }
    if (getpeername(socket, address, size) != 0) { /* It has gone. */
        (void)close(socket);
        return -1;
    }
    return socket;
}

bool http_handover_open(void)
{
    return pipe2(way, O_CLOEXEC | O_NONBLOCK) == 0;
}

static bool is_at(int descriptor, int port)
{
    struct sockaddr_in place = {.sin_port = 0U};
    socklen_t size = sizeof place;
    return (getsockname(descriptor, (struct sockaddr *)&place, &size) == 0) &&
           (place.sin_family == AF_INET) && (ntohs(place.sin_port) == port);
}

/* The library does not hand out its listening socket; it is found among the descriptors. */
void http_handover_begin(const struct mg_context *context)
{
    struct mg_server_port listened = {.port = 0};
    (void)mg_get_server_ports(context, 1, &listened);
    for (int descriptor = 0; descriptor < DESCRIPTORS; descriptor++) {
        if (is_at(descriptor, listened.port)) {
            (void)dup3(way[0], descriptor, O_CLOEXEC);
        }
    }
}

bool http_handover_has_room(void)
{
    int bytes = 0;
    (void)ioctl(way[0], FIONREAD, &bytes);
    return bytes < (WAITING_CLIENTS * (int)sizeof(int));
}

void http_handover_give(int socket)
{
    if (write(way[1], &socket, sizeof socket) != (ssize_t)sizeof socket) {
        (void)close(socket);
    }
}

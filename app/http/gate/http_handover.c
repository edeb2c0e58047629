/* SPDX-License-Identifier: Apache-2.0 */
#include "http/gate/http_handover.h"

#include "limits/requirement_limits.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#define OTHERS 704U /* Descriptors for files and for clients that do not wait for the library. */

static int way[2];    /* A pipe of descriptors. */
static rlim_t places; /* In it. */

/* The library's accept(): the linker takes the function of this program before that of the C
 * library. */
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

/* A client that finds no place waits in the kernel, also one with a stop. */
static bool make_places(void)
{
    struct rlimit descriptors = {.rlim_cur = 0U};
    (void)getrlimit(RLIMIT_NOFILE, &descriptors);
    descriptors.rlim_cur = (descriptors.rlim_max < HTTP_HANDOVER_DESCRIPTORS)
                               ? descriptors.rlim_max
                               : HTTP_HANDOVER_DESCRIPTORS;
    (void)setrlimit(RLIMIT_NOFILE, &descriptors);
    if (descriptors.rlim_cur < HTTP_HANDOVER_LEAST) {
        return false;
    }
    places = descriptors.rlim_cur - OTHERS;
    places = (places < LIMIT_WAITING_CLIENTS) ? places : LIMIT_WAITING_CLIENTS;
    return true;
}

bool http_handover_open(void)
{
    return make_places() && (pipe2(way, O_CLOEXEC | O_NONBLOCK) == 0);
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
    for (int descriptor = 0; descriptor < (int)HTTP_HANDOVER_DESCRIPTORS; descriptor++) {
        if (is_at(descriptor, listened.port)) {
            (void)dup3(way[0], descriptor, O_CLOEXEC);
        }
    }
}

bool http_handover_has_room(void)
{
    int bytes = 0;
    (void)ioctl(way[0], FIONREAD, &bytes);
    return ((rlim_t)bytes / sizeof(int)) < places;
}

void http_handover_give(int socket)
{
    if (write(way[1], &socket, sizeof socket) != (ssize_t)sizeof socket) {
        (void)close(socket);
    }
}

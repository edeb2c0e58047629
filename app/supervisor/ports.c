/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/ports.h"

#include <arpa/inet.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

typedef struct {
    const char *port;
    const char *service;
    const char *option;
    const char *variable;
} use_t;

/* 0, or the errno of binding. */
static int try_bind(uint32_t address, unsigned long port)
{
    const int is_reused = 1;
    struct sockaddr_in place = {.sin_family = AF_INET,
                                .sin_port = htons((uint16_t)port),
                                .sin_addr.s_addr = htonl(address)};
    const int end = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    int result = 0;

    if (end < 0) {
        return errno;
    }
    (void)setsockopt(end, SOL_SOCKET, SO_REUSEADDR, &is_reused, sizeof is_reused);
    if ((bind(end, (const struct sockaddr *)&place, sizeof place) != 0) || (listen(end, 1) != 0)) {
        result = errno;
    }
    (void)close(end);
    return result;
}

static void explain(const use_t *use, const char *address, int reason, char *error,
                    uint32_t error_size)
{
    switch (reason) {
    case EADDRINUSE:
        (void)snprintf(error, error_size,
                       "Port %s for %s is in use; stop the program that has it, or choose another "
                       "with %s or %s.",
                       use->port, use->service, use->option, use->variable);
        break;
    case EACCES:
        (void)snprintf(
            error, error_size,
            "Port %s for %s needs a right this user lacks; choose one above 1023 with %s or %s.",
            use->port, use->service, use->option, use->variable);
        break;
    case EADDRNOTAVAIL:
        (void)snprintf(error, error_size,
                       "%s is no address of this machine; give --bind one that is.", address);
        break;
    default:
        (void)snprintf(error, error_size,
                       "Port %s for %s cannot be used (%s); choose another with %s or %s.",
                       use->port, use->service, strerror(reason), use->option, use->variable);
        break;
    }
}

static bool check_file(const options_t *options, char *error, uint32_t error_size)
{
    for (uint32_t i = 0U; i < options->ports.count; i++) {
        const igtl_port_t *port = &options->ports.ports[i];
        const int reason = port->is_calling ? 0 : try_bind(port->address, port->number);
        char place[IGTL_PLACE_SIZE];

        if (reason != 0) {
            igtl_port_place(port->address, port->number, place);
            (void)snprintf(error, error_size,
                           "[%s] cannot listen on %s (%s); stop the program that has it, or change "
                           "%s.",
                           port->name, place, strerror(reason), options->igtl_file);
            return false;
        }
    }
    return true;
}

bool ports_check(const options_t *options, char *error, uint32_t error_size)
{
    const use_t uses[] = {
        {options->http_port, "the console", "--http-port", "HTTP_PORT"},
        {options->brp_port, "the OpenIGTLink workphases", "--brp-port", "BRP_PORT"},
        {options->igtl_port, "the OpenIGTLink transforms", "--igtl-port", "IGTL_PORT"}};
    const size_t count = (options->igtl_file == NULL) ? (sizeof uses / sizeof uses[0]) : 1U;
    struct in_addr address = {.s_addr = htonl(INADDR_LOOPBACK)};

    (void)inet_pton(AF_INET, options->bind, &address);
    for (size_t i = 0U; i < count; i++) {
        const int reason = try_bind(ntohl(address.s_addr), strtoul(uses[i].port, NULL, 10));
        if (reason != 0) {
            explain(&uses[i], options->bind, reason, error, error_size);
            return false;
        }
    }
    return check_file(options, error, error_size);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/igtl_options.h"

#include <errno.h>
#include <getopt.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define DEFAULT_BRP_PORT 18936U
#define DEFAULT_IGTL_PORT 18944U

typedef struct {
    const char *address;
    uint16_t brp_port;
    uint16_t igtl_port;
} given_t;

static bool read_port(const char *text, uint16_t *port)
{
    char *end;
    unsigned long value;

    errno = 0;
    value = strtoul(text, &end, 10);
    if ((errno != 0) || (end == text) || (*end != '\0') || (value == 0U) || (value > UINT16_MAX)) {
        return false;
    }
    *port = (uint16_t)value;
    return true;
}

const char igtl_options_usage[] = "usage: boresight-igtl --exchange NAME [--igtl-file FILE | "
                                  "[--brp-port PORT] [--igtl-port PORT] [--bind ADDRESS]]";

static bool take(igtl_options_t *self, given_t *given, int option, const char *value)
{
    switch (option) {
    case 'e':
        self->exchange = value;
        return true;
    case 'f':
        self->file = value;
        return true;
    case 'w':
        return read_port(value, &given->brp_port);
    case 't':
        return read_port(value, &given->igtl_port);
    case 'b':
        given->address = value;
        return true;
    default:
        return false;
    }
}

bool igtl_options_read(igtl_options_t *self, int count, char **arguments, char *error,
                       size_t error_size)
{
    static const struct option names[] = {
        {"exchange", required_argument, NULL, 'e'}, {"igtl-file", required_argument, NULL, 'f'},
        {"brp-port", required_argument, NULL, 'w'}, {"igtl-port", required_argument, NULL, 't'},
        {"bind", required_argument, NULL, 'b'},     {NULL, 0, NULL, 0}};
    given_t given = {"127.0.0.1", DEFAULT_BRP_PORT, DEFAULT_IGTL_PORT};
    bool is_good = true;
    int option = getopt_long(count, arguments, "", names, NULL);

    while (option != -1) {
        is_good = take(self, &given, option, optarg) && is_good;
        option = getopt_long(count, arguments, "", names, NULL);
    }
    if (!is_good || (self->exchange == NULL) || (optind != count)) {
        (void)snprintf(error, error_size, "%s", igtl_options_usage);
        return false;
    }
    if (self->file != NULL) {
        return igtl_ports_read(&self->ports, self->file, error, error_size);
    }
    if (!igtl_ports_set(&self->ports, given.address, given.brp_port, given.igtl_port)) {
        (void)snprintf(error, error_size, "%s is not an IPv4 address; give one with --bind",
                       given.address);
        return false;
    }
    return true;
}

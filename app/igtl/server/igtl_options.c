/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_options.h"

#include "common/command_line.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define ERROR_SIZE 400U
#define DEFAULT_ADDRESS "127.0.0.1"
#define DEFAULT_BRP_PORT 18936U
#define DEFAULT_IGTL_PORT 18944U

enum { INSTANCE = 0, IGTL_FILE, BRP_PORT, IGTL_PORT, BIND, OPTIONS };

static const command_option_t known[OPTIONS] = {
    [INSTANCE] = {"instance", "NAME", .says = "instance of Boresight that it belongs to",
                  .is_needed = true},
    [IGTL_FILE] = {"igtl-file", "FILE", .says = "of all ports, in place of the two"},
    [BRP_PORT] = {"brp-port", "PORT", .says = "workphases; default 18936", .least = 1U,
                  .most = UINT16_MAX},
    [IGTL_PORT] = {"igtl-port", "PORT", .says = "transforms; default 18944", .least = 1U,
                   .most = UINT16_MAX},
    [BIND] = {"bind", "ADDRESS", .says = "IPv4 address to listen on; default 127.0.0.1"},
};
static const command_line_t command_line = {.program = "boresight-igtl",
                                            .says = "Serves OpenIGTLink; boresight starts it.",
                                            .usage = "OPTION...",
                                            .options = known,
                                            .count = OPTIONS};

static uint16_t port_of(const char *value, uint16_t otherwise)
{
    return (value != NULL) ? (uint16_t)strtoul(value, NULL, 10) : otherwise;
}

static int read_file(igtl_options_t *self)
{
    char error[ERROR_SIZE];

    if (!igtl_ports_read(&self->ports, self->file, error, sizeof error)) {
        (void)fprintf(stderr, "boresight-igtl: %s\n", error);
        return COMMAND_LINE_WRONG;
    }
    return COMMAND_LINE_GO_ON;
}

int igtl_options_read(igtl_options_t *self, int count, char *const arguments[])
{
    const char *values[OPTIONS];
    const int code = command_line_read(&command_line, count, arguments, values, NULL);

    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    self->instance = values[INSTANCE];
    self->file = values[IGTL_FILE];
    if (self->file != NULL) {
        return read_file(self);
    }
    const char *const address = (values[BIND] != NULL) ? values[BIND] : DEFAULT_ADDRESS;
    return igtl_ports_set(&self->ports, address, port_of(values[BRP_PORT], DEFAULT_BRP_PORT),
                          port_of(values[IGTL_PORT], DEFAULT_IGTL_PORT))
               ? COMMAND_LINE_GO_ON
               : command_line_refuse(&command_line,
                                     "\"%s\" is no IPv4 address; give --bind one of this machine.",
                                     address);
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Any text as a file of ports: it is understood whole, or refused with its line and a
 * reason. */
#include "fuzz/sentence.h"
#include "igtl/server/igtl_ports.h"

#include <stdlib.h>
#include <string.h>

#define ERROR_SIZE 200U

static void check_port(const igtl_port_t *port)
{
    SENTENCE((port->name[0] != '\0') && (memchr(port->name, 0, sizeof port->name) != NULL),
             "a port has a name");
    SENTENCE(memchr(port->entry_prefix, 0, sizeof port->entry_prefix) != NULL, "a prefix ends");
    SENTENCE(port->number != 0U, "a port has a number");
    SENTENCE((port->language == IGTL_LANGUAGE_BRP_2013) ||
                 (port->language == IGTL_LANGUAGE_BRP_2021) ||
                 (port->language == IGTL_LANGUAGE_CRTK),
             "a port speaks a dialect");
    SENTENCE(port->allowed_count <= IGTL_ALLOWED, "the networks fit");
    SENTENCE(port->is_calling || ((port->address >> 24U) == 127U) || (port->allowed_count > 0U),
             "who may connect from elsewhere is named");
}

static void check_ports(const igtl_ports_t *ports)
{
    SENTENCE((ports->count >= 1U) && (ports->count <= IGTL_PORTS), "there are ports, and they fit");
    for (uint32_t i = 0U; i < ports->count; i++) {
        check_port(&ports->ports[i]);
        for (uint32_t k = 0U; k < i; k++) {
            SENTENCE(strcmp(ports->ports[i].name, ports->ports[k].name) != 0, "no name is doubled");
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static igtl_ports_t ports;
    char error[ERROR_SIZE];
    char *text = malloc(size);

    if ((size > 0U) && (text != NULL)) {
        (void)memcpy(text, data, size);
    }
    (void)memset(&ports, 0xA5, sizeof ports);
    (void)memset(error, 'x', sizeof error);
    if (igtl_ports_parse(&ports, "FILE", text, size, error, sizeof error)) {
        check_ports(&ports);
    } else {
        SENTENCE(memchr(error, 0, sizeof error) != NULL, "a reason ends");
        SENTENCE(strncmp(error, "FILE", 4U) == 0, "a reason names the file");
    }
    free(text);
    return 0;
}

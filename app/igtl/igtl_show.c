/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/igtl_show.h"

#include <stdio.h>
#include <string.h>

#if EXCHANGE_PORTS != IGTL_PORTS
#error "Each port has a row."
#endif

static exchange_port_state_t state_of(const igtl_server_t *server)
{
    if (!server->port->is_calling) {
        return EXCHANGE_PORT_LISTENING;
    }
    if (server->caller.is_connected) {
        return EXCHANGE_PORT_CONNECTED;
    }
    return (server->caller.descriptor >= 0) ? EXCHANGE_PORT_CALLING : EXCHANGE_PORT_WAITING;
}

static void count_peers(const igtl_server_t *server, exchange_port_t *row)
{
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        const igtl_connection_t *connection = &server->connections[i];

        if (connection->descriptor < 0) {
            continue;
        }
        if (connection->place == IGTL_NO_PLACE) {
            row->waiting++;
            continue;
        }
        row->peers++;
        if ((server->calls->is_controlled_by != NULL) &&
            server->calls->is_controlled_by(server->dialect,
                                            igtl_server_peer(server, connection))) {
            row->commander = connection->number;
        }
    }
}

void igtl_show_port(const igtl_server_t *server, uint64_t now_us, exchange_port_t *row)
{
    const igtl_port_t *port = server->port;

    (void)memset(row, 0, sizeof *row);
    (void)snprintf(row->name, sizeof row->name, "%s", port->name);
    row->dialect = (uint32_t)port->language;
    row->address = port->address;
    row->number = port->number;
    row->state = (uint32_t)state_of(server);
    if ((row->state == (uint32_t)EXCHANGE_PORT_WAITING) && (server->caller.next_us > now_us)) {
        row->again_ms = (uint32_t)((server->caller.next_us - now_us) / 1000U);
    }
    count_peers(server, row);
    row->troubles = (uint32_t)server->troubles.count;
    (void)snprintf(row->trouble, sizeof row->trouble, "%s", server->troubles.last);
}

void igtl_show_ports(exchange_t *exchange, const igtl_server_t *servers, uint32_t count,
                     uint64_t now_us)
{
    exchange_ports_t ports = {.count = count};

    for (uint32_t i = 0U; i < count; i++) {
        igtl_show_port(&servers[i], now_us, &ports.ports[i]);
    }
    exchange_publish_ports(exchange, &ports);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_show.h"

#include <stdio.h>
#include <string.h>

#if EXCHANGE_PORTS != IGTL_PORTS
#error "Each port has a row."
#endif
/* igtl_server.h: IGTL_CONNECTIONS of each port. */
#if EXCHANGE_PEERS < (IGTL_PORTS * IGTL_CONNECTIONS)
#error "Each connection has a row."
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

void igtl_show_peer(const igtl_server_t *server, const igtl_connection_t *connection,
                    exchange_peer_t *row)
{
    (void)memset(row, 0, sizeof *row);
    row->number = connection->number;
    row->dialect = (uint32_t)server->port->language;
    row->since_us = connection->since_us;
    row->heard_us = connection->was_heard ? connection->heard_us : 0U;
    row->messages_in = connection->messages_in;
    row->messages_out = connection->messages_out;
    row->bytes_in = connection->received;
    row->bytes_out = connection->sent;
    row->errors = connection->errors;
    row->is_waiting = (connection->place == IGTL_NO_PLACE) ? 1U : 0U;
    row->is_kept_alive = connection->is_kept_alive ? 1U : 0U;
    igtl_port_place(connection->address, connection->port, row->name);
    (void)snprintf(row->port, sizeof row->port, "%s", server->port->name);
    (void)snprintf(row->message, sizeof row->message, "%s", connection->heard);
    (void)snprintf(row->status, sizeof row->status, "%s", connection->status);
    row->statuses = connection->statuses;
    (void)snprintf(row->refusal, sizeof row->refusal, "%s", connection->refusal);
    row->refusals = connection->refusals;
}

void igtl_show_peers(exchange_t *exchange, const igtl_server_t *servers, uint32_t count)
{
    static exchange_peers_t peers;

    peers.count = 0U;
    for (uint32_t i = 0U; i < (count * IGTL_CONNECTIONS); i++) {
        const igtl_server_t *server = &servers[i / IGTL_CONNECTIONS];
        const igtl_connection_t *connection = &server->connections[i % IGTL_CONNECTIONS];

        if (connection->descriptor >= 0) {
            igtl_show_peer(server, connection, &peers.peers[peers.count]);
            peers.count++;
        }
    }
    exchange_publish_peers(exchange, COMMAND_SOURCE_IGTL, &peers);
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

/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange_peers.h"

#include "exchange/exchange_lock.h"
#include "exchange/exchange_segment.h"

#include <stdio.h>

void exchange_publish_ports(exchange_t *self, const exchange_ports_t *ports)
{
    segment_others_t *others = &self->segment->others;

    exchange_write_locked(&others->ports_sequence, &others->ports, ports, sizeof *ports);
}

/* igtl may have died in the middle of anything. */
static bool are_ports_whole(exchange_ports_t *ports)
{
    bool are_whole = ports->count <= EXCHANGE_PORTS;

    for (uint32_t i = 0U; i < EXCHANGE_PORTS; i++) {
        exchange_port_t *port = &ports->ports[i];

        are_whole = are_whole && (port->dialect < EXCHANGE_DIALECTS) &&
                    (port->state < EXCHANGE_PORT_STATES);
        port->name[EXCHANGE_PORT_NAME_SIZE - 1U] = '\0';
        port->trouble[EXCHANGE_PORT_TROUBLE_SIZE - 1U] = '\0';
    }
    return are_whole;
}

bool exchange_read_ports(const exchange_t *self, exchange_ports_t *ports)
{
    const segment_others_t *others = &self->segment->others;

    for (uint32_t tries = 0U; tries < EXCHANGE_READ_TRIES; tries++) {
        if (exchange_read_locked(&others->ports_sequence, ports, &others->ports, sizeof *ports)) {
            return are_ports_whole(ports);
        }
    }
    return false;
}

void exchange_publish_peers(exchange_t *self, command_source_t source,
                            const exchange_peers_t *peers)
{
    segment_peers_t *table = &self->segment->others.peers[source];

    exchange_write_locked(&table->sequence, &table->peers, peers, sizeof *peers);
}

/* Its process may have died in the middle of anything. */
static bool are_peers_whole(exchange_peers_t *peers)
{
    bool are_whole = peers->count <= EXCHANGE_PEERS;

    for (uint32_t i = 0U; i < EXCHANGE_PEERS; i++) {
        exchange_peer_t *peer = &peers->peers[i];

        are_whole = are_whole && (peer->dialect < EXCHANGE_DIALECTS) && (peer->is_waiting <= 1U) &&
                    (peer->is_kept_alive <= 1U);
        peer->port[EXCHANGE_PORT_NAME_SIZE - 1U] = '\0';
        peer->name[EXCHANGE_PEER_NAME_SIZE - 1U] = '\0';
        peer->message[EXCHANGE_PEER_MESSAGE_SIZE - 1U] = '\0';
    }
    return are_whole;
}

bool exchange_read_peers(const exchange_t *self, command_source_t source, exchange_peers_t *peers)
{
    const segment_peers_t *table = &self->segment->others.peers[source];

    for (uint32_t tries = 0U; tries < EXCHANGE_READ_TRIES; tries++) {
        if (exchange_read_locked(&table->sequence, peers, &table->peers, sizeof *peers)) {
            return are_peers_whole(peers);
        }
    }
    return false;
}

static const exchange_peer_t *find(const exchange_peers_t *peers, uint32_t number)
{
    for (uint32_t i = 0U; i < peers->count; i++) {
        if (peers->peers[i].number == number) {
            return &peers->peers[i];
        }
    }
    return NULL;
}

void exchange_title(const exchange_t *self, command_source_t source, uint32_t number,
                    char title[EXCHANGE_TITLE_SIZE])
{
    const bool is_page = source == COMMAND_SOURCE_HTTP;
    exchange_peers_t peers;
    const exchange_peer_t *peer =
        exchange_read_peers(self, source, &peers) ? find(&peers, number) : NULL;

    if (peer == NULL) {
        (void)snprintf(title, EXCHANGE_TITLE_SIZE, "%s %u", is_page ? "page" : "connection",
                       (unsigned)number);
    } else {
        (void)snprintf(title, EXCHANGE_TITLE_SIZE, "%s %s", is_page ? "page of" : peer->port,
                       peer->name);
    }
}

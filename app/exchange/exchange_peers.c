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

uint32_t exchange_give_order(exchange_t *self, const exchange_order_t *order)
{
    segment_order_t *place = &self->segment->others.order;
    exchange_order_t numbered = *order;

    numbered.id = place->order.id + 1U;
    exchange_write_locked(&place->sequence, &place->order, &numbered, sizeof numbered);
    return numbered.id;
}

bool exchange_read_order_answer(const exchange_t *self, uint32_t id, status_t *status)
{
    const segment_order_answer_t *place = &self->segment->others.order_answer;
    segment_answered_t answer;

    if (!exchange_read_locked(&place->sequence, &answer, &place->answer, sizeof answer)) {
        return false;
    }
    *status = (status_t)answer.status;
    return answer.id == id;
}

bool exchange_take_order(const exchange_t *self, exchange_order_t *order)
{
    const segment_order_t *place = &self->segment->others.order;

    return exchange_read_locked(&place->sequence, order, &place->order, sizeof *order) &&
           (order->id != self->segment->others.order_answer.answer.id) &&
           (order->kind <= (uint32_t)EXCHANGE_ORDER_KEEP_ALIVE) && (order->is_on <= 1U);
}

void exchange_answer_order(exchange_t *self, const exchange_order_t *order, status_t status)
{
    segment_order_answer_t *place = &self->segment->others.order_answer;
    const segment_answered_t answer = {.id = order->id, .status = (uint32_t)status};

    exchange_write_locked(&place->sequence, &place->answer, &answer, sizeof answer);
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

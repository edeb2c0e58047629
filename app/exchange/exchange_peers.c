/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange_peers.h"

#include "exchange/exchange_lock.h"
#include "exchange/exchange_segment.h"

#include <stdio.h>

void exchange_publish_ports(exchange_t *self, const exchange_ports_t *ports)
{
    segment_others_t *others = &self->segment->others;

    exchange_write_sealed(&others->ports_seal, &others->ports, ports, sizeof *ports);
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
        if (exchange_read_sealed(&others->ports_seal, ports, &others->ports, sizeof *ports)) {
            return are_ports_whole(ports);
        }
    }
    return false;
}

void exchange_publish_peers(exchange_t *self, command_source_t source,
                            const exchange_peers_t *peers)
{
    segment_peers_t *table = &self->segment->others.peers[source];

    exchange_write_sealed(&table->seal, &table->peers, peers, sizeof *peers);
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
        peer->status[EXCHANGE_PEER_STATUS_SIZE - 1U] = '\0';
        peer->refusal[EXCHANGE_PEER_STATUS_SIZE - 1U] = '\0';
    }
    return are_whole;
}

bool exchange_read_peers(const exchange_t *self, command_source_t source, exchange_peers_t *peers)
{
    const segment_peers_t *table = &self->segment->others.peers[source];

    for (uint32_t tries = 0U; tries < EXCHANGE_READ_TRIES; tries++) {
        if (exchange_read_sealed(&table->seal, peers, &table->peers, sizeof *peers)) {
            return are_peers_whole(peers);
        }
    }
    return false;
}

static bool read_order(const exchange_t *self, exchange_order_t *order)
{
    const segment_order_t *place = &self->segment->others.order;

    return exchange_read_sealed(&place->seal, order, &place->order, sizeof *order);
}

static bool read_answer(const exchange_t *self, segment_answered_t *answer)
{
    const segment_order_answer_t *place = &self->segment->others.order_answer;

    return exchange_read_sealed(&place->seal, answer, &place->answer, sizeof *answer);
}

/* Where the order of the server before was damaged, no newer one has the id of its answer. */
static uint32_t last_order(const exchange_t *self)
{
    exchange_order_t order;
    segment_answered_t answer;
    uint32_t last = self->order_given;

    if ((last == 0U) && read_order(self, &order)) {
        last = order.id;
    } else if ((last == 0U) && read_answer(self, &answer)) {
        last = answer.id;
    } else {
        /* It has given some, or none exists. */
    }
    return last;
}

uint32_t exchange_give_order(exchange_t *self, const exchange_order_t *order)
{
    segment_order_t *place = &self->segment->others.order;
    const uint32_t last = last_order(self);
    exchange_order_t numbered = *order;

    self->order_given = (last != UINT32_MAX) ? (last + 1U) : 1U;
    numbered.id = self->order_given;
    exchange_write_sealed(&place->seal, &place->order, &numbered, sizeof numbered);
    return numbered.id;
}

bool exchange_read_order_answer(const exchange_t *self, uint32_t id, status_t *status)
{
    segment_answered_t answer;

    if (!read_answer(self, &answer)) {
        return false;
    }
    *status = (status_t)answer.status;
    return answer.id == id;
}

bool exchange_take_order(exchange_t *self, exchange_order_t *order)
{
    return read_order(self, order) && (order->id != self->order_answered) &&
           (order->kind <= (uint32_t)EXCHANGE_ORDER_KEEP_ALIVE) && (order->is_on <= 1U);
}

void exchange_answer_order(exchange_t *self, const exchange_order_t *order, status_t status)
{
    segment_order_answer_t *place = &self->segment->others.order_answer;
    const segment_answered_t answer = {.id = order->id, .status = (uint32_t)status};

    self->order_answered = order->id;
    exchange_write_sealed(&place->seal, &place->answer, &answer, sizeof answer);
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

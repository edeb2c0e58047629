/* SPDX-License-Identifier: Apache-2.0 */
#include "http/stop/stop_port.h"

#include "common/clock.h"
#include "http/gate/http_handover.h"
#include "http/gate/answer_timeout.h"
#include "http/stop/stop_client.h"

#include <poll.h>
#include <pthread.h>
#include <stddef.h>
#include <sys/socket.h>

#define TURN_MS 100
#define WELCOMED 64U /* At one gate in one turn. */

static struct {
    exchange_t *exchange;
    gate_t gates[STOP_PORT_GATES];
    uint64_t welcomed;
    uint64_t looked_us;
    stop_client_t clients[STOP_PORT_CLIENTS];
} stop_port = {.gates = {{.socket = -1}, {.socket = -1}, {.socket = -1}, {.socket = -1}}};

gate_t *stop_port_gate(stop_port_gate_t gate)
{
    return &stop_port.gates[gate];
}

/* A client that waits goes last: its stop is on its way, but it would get no answer. */
static bool is_dearer(const stop_client_t *client, const stop_client_t *other)
{
    const bool is_waiting = client->state == STOP_CLIENT_WAITS;
    return (is_waiting != (other->state == STOP_CLIENT_WAITS)) ? is_waiting
                                                               : (client->number > other->number);
}

/* A free place, or else the oldest client's. */
static stop_client_t *find_place(void)
{
    stop_client_t *place = &stop_port.clients[0];
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        stop_client_t *client = &stop_port.clients[i];
        if (client->socket < 0) {
            return client;
        }
        place = is_dearer(place, client) ? client : place;
    }
    stop_client_give_way(place);
    return place;
}

/* Where the library is behind, clients of the console wait in the kernel. */
static bool is_open(const gate_t *gate)
{
    return (gate->socket >= 0) && (!gate->is_console || http_handover_has_room());
}

static void welcome(const gate_t *gate)
{
    for (size_t i = 0U; (i < WELCOMED) && is_open(gate); i++) {
        const int socket = accept4(gate->socket, NULL, NULL, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (socket < 0) {
            return;
        }
        stop_client_t *client = find_place();
        client->number = stop_port.welcomed;
        stop_port.welcomed++;
        stop_client_enter(client, stop_port.exchange, gate, socket);
    }
}

static void attend(stop_client_t *client, bool is_heard, bool is_look_due)
{
    if (is_heard && (client->state != STOP_CLIENT_WAITS)) {
        stop_client_hear(client, stop_port.exchange);
    }
    if ((client->socket >= 0) && (client->state == STOP_CLIENT_WAITS) && is_look_due) {
        stop_client_look(client, stop_port.exchange);
    }
    if ((client->socket >= 0) && (client->state != STOP_CLIENT_WAITS)) {
        stop_client_judge_timeout(client);
    }
}

/* A client waits for control, or a gate for the library. */
static bool is_anybody_waiting(void)
{
    bool is_waiting = !http_handover_has_room();
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        is_waiting = is_waiting || ((stop_port.clients[i].socket >= 0) &&
                                    (stop_port.clients[i].state == STOP_CLIENT_WAITS));
    }
    return is_waiting;
}

/* poll() passes over negative descriptors. A client that waits is not heard: nothing more is due
 * from it. */
static void wait_for_events(struct pollfd events[STOP_PORT_CLIENTS + STOP_PORT_GATES])
{
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        const stop_client_t *client = &stop_port.clients[i];
        events[i].fd = (client->state == STOP_CLIENT_WAITS) ? -1 : client->socket;
        events[i].events = POLLIN;
        events[i].revents = 0;
    }
    for (size_t i = 0U; i < STOP_PORT_GATES; i++) {
        const gate_t *gate = &stop_port.gates[i];
        events[STOP_PORT_CLIENTS + i].fd = is_open(gate) ? gate->socket : -1;
        events[STOP_PORT_CLIENTS + i].events = POLLIN;
        events[STOP_PORT_CLIENTS + i].revents = 0;
    }
    (void)poll(events, STOP_PORT_CLIENTS + STOP_PORT_GATES,
               is_anybody_waiting() ? (int)ANSWER_POLL_MS : TURN_MS);
}

static void take_turn(void)
{
    struct pollfd events[STOP_PORT_CLIENTS + STOP_PORT_GATES];
    wait_for_events(events);
    const uint64_t now_us = clock_monotonic_us();
    const bool is_look_due = (now_us - stop_port.looked_us) >= (ANSWER_POLL_MS * 1000U);
    stop_port.looked_us = is_look_due ? now_us : stop_port.looked_us;
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        if (stop_port.clients[i].socket >= 0) {
            attend(&stop_port.clients[i], events[i].revents != 0, is_look_due);
        }
    }
    for (size_t i = 0U; i < STOP_PORT_GATES; i++) {
        if (events[STOP_PORT_CLIENTS + i].revents != 0) {
            welcome(&stop_port.gates[i]);
        }
    }
}

static void *serve(void *unused)
{
    (void)unused;
    const uint32_t port = gate_port(&stop_port.gates[STOP_PORT_OWN]);
    for (;;) {
        exchange_note_stop_port(stop_port.exchange, port); /* It may be damaged. */
        take_turn();
    }
    return NULL;
}

uint32_t stop_port_open(exchange_t *exchange, const char *address)
{
    gate_t *gate = stop_port_gate(STOP_PORT_OWN);
    if (gate_open(gate, address, exchange_stop_port(exchange)) != 0) {
        (void)gate_open(gate, address, 0U);
    }
    const uint32_t port = (gate->socket >= 0) ? gate_port(gate) : 0U;
    exchange_note_stop_port(exchange, port);
    return port;
}

bool stop_port_begin(exchange_t *exchange)
{
    pthread_t thread;
    stop_port.exchange = exchange;
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        stop_port.clients[i].socket = -1;
    }
    return pthread_create(&thread, NULL, serve, NULL) == 0;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_server.h"

#include "igtl/server/igtl_listener.h"
#include "igtl/server/igtl_slots.h"
#include "limits/requirement_limits.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define MESSAGES_PER_TURN 16U
#define ACCEPTS_PER_TURN 16U
#define GREETING_INTERVAL_US UINT64_C(1000000)

static void note(igtl_server_t *self, igtl_trouble_t kind, const char *reason, uint64_t now_us)
{
    igtl_troubles_note(&self->troubles, self->port->number, kind, reason, now_us);
}

bool igtl_server_open(igtl_server_t *self, const igtl_port_t *port, char *error, size_t error_size)
{
    self->port = port;
    self->listener = -1;
    self->next_greeting_us = 0U;
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        igtl_connection_init(&self->connections[i]);
    }
    (void)memset(&self->troubles, 0, sizeof self->troubles);
    igtl_caller_init(&self->caller, port->address, port->number);
    if (!port->is_calling) {
        self->listener = igtl_listener_open(port->address, port->number, error, error_size);
    }
    return port->is_calling || (self->listener >= 0);
}

void igtl_server_close(igtl_server_t *self)
{
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        if (self->connections[i].descriptor >= 0) {
            igtl_connection_close(&self->connections[i]);
        }
    }
    igtl_caller_close(&self->caller);
    if (self->listener >= 0) {
        (void)close(self->listener);
        self->listener = -1;
    }
}

uint32_t igtl_server_polls(const igtl_server_t *self, struct pollfd *polls)
{
    uint32_t count = 1U;

    /* poll() passes over what is -1. */
    polls[0] = self->port->is_calling
                   ? (struct pollfd){.fd = self->caller.descriptor, .events = POLLOUT}
                   : (struct pollfd){.fd = self->listener, .events = POLLIN};
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        if (self->connections[i].descriptor >= 0) {
            const int waiting =
                (self->connections[i].outbox.count > 0U) ? (POLLIN | POLLOUT) : POLLIN;

            polls[count] =
                (struct pollfd){.fd = self->connections[i].descriptor, .events = (short)waiting};
            count++;
        }
    }
    return count;
}

bool igtl_server_has_peers(const igtl_server_t *self)
{
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        if (self->connections[i].descriptor >= 0) {
            return true;
        }
    }
    return false;
}

/* The log of events names a connection by its number only. */
static void greet(igtl_server_t *self, uint32_t address, uint16_t number, uint64_t now_us)
{
    char place[IGTL_PLACE_SIZE];

    if (now_us < self->next_greeting_us) {
        return;
    }
    self->next_greeting_us = now_us + GREETING_INTERVAL_US;
    igtl_port_place(address, number, place);
    (void)fprintf(stderr, "boresight-igtl: port %u: peer %u is %s\n", (unsigned)self->port->number,
                  (unsigned)self->next_number, place);
}

static void accept_peers(igtl_server_t *self, uint64_t now_us)
{
    for (uint32_t i = 0U; i < ACCEPTS_PER_TURN; i++) {
        uint32_t address;
        uint16_t number;
        const int descriptor = igtl_listener_accept(self->listener, &address, &number);

        if (descriptor < 0) {
            return;
        }
        if (igtl_port_allows(self->port, address)) {
            greet(self, address, number, now_us);
            igtl_slots_enter(self, descriptor, address, number, now_us);
        } else {
            char place[IGTL_PLACE_SIZE];

            (void)close(descriptor);
            igtl_port_place(address, number, place);
            note(self, IGTL_TROUBLE_STRANGER, place, now_us);
        }
    }
}

static void call_peer(igtl_server_t *self, uint64_t now_us)
{
    int descriptor = -1;

    switch (igtl_caller_step(&self->caller, now_us, &descriptor)) {
    case IGTL_CALL_ANSWERED:
        greet(self, self->port->address, self->port->number, now_us);
        igtl_slots_enter(self, descriptor, self->port->address, self->port->number, now_us);
        break;
    case IGTL_CALL_FAILED:
        note(self, IGTL_TROUBLE_CALL, strerror(self->caller.error), now_us);
        break;
    case IGTL_CALL_NOTHING:
    default:
        break;
    }
}

static void send_trouble(igtl_connection_t *connection, igtl_result_t reason, const char *name,
                         const igtl_moment_t *moment)
{
    const igtl_status_t status = {igtl_result_code(reason), "REFUSED", igtl_result_text(reason)};

    igtl_send_refused(&connection->outbox, name, &status, moment);
}

/* Sends the reason, as far as the peer listens, and closes. */
static void drop_with(igtl_server_t *self, igtl_connection_t *connection, igtl_trouble_t kind,
                      igtl_result_t reason, const igtl_moment_t *moment)
{
    send_trouble(connection, reason, "CONNECTION", moment);
    (void)igtl_connection_flush(connection);
    note(self, kind, igtl_result_text(reason), moment->now_us);
    igtl_seats_drop(self, connection, moment->now_us);
}

/* False when the connection has ended. */
static bool handle(igtl_server_t *self, igtl_connection_t *connection, igtl_inbox_event_t event,
                   const igtl_moment_t *moment)
{
    const igtl_inbox_t *inbox = &connection->inbox;

    connection->outbox.refusal[0] = '\0'; /* A refusal without a question, of a stream. */
    switch (event) {
    case IGTL_INBOX_MESSAGE:
        if (inbox->message.kind == IGTL_KIND_STATUS) {
            igtl_connection_keep_status(connection, &inbox->message);
        }
        if ((connection->place != IGTL_NO_PLACE) ||
            igtl_slots_admit(self, connection, &inbox->message, moment)) {
            self->calls->receive(self->dialect, igtl_seats_peer(self, connection), &inbox->message,
                                 moment);
            igtl_connection_keep_refusal(connection);
        }
        return true;
    case IGTL_INBOX_REFUSED:
        send_trouble(connection, inbox->reason, inbox->header.name, moment);
        igtl_connection_keep_refusal(connection);
        note(self, IGTL_TROUBLE_MESSAGE, igtl_result_text(inbox->reason), moment->now_us);
        return true;
    case IGTL_INBOX_BROKEN:
        drop_with(self, connection, IGTL_TROUBLE_BROKEN, inbox->reason, moment);
        return false;
    case IGTL_INBOX_WAITING:
    case IGTL_INBOX_SKIPPED:
    default:
        return true;
    }
}

static void receive_from(igtl_server_t *self, igtl_connection_t *connection,
                         const igtl_moment_t *moment)
{
    uint32_t bytes_left = IGTL_BYTES_PER_TURN;

    for (uint32_t i = 0U; i < MESSAGES_PER_TURN; i++) {
        igtl_inbox_event_t event = IGTL_INBOX_WAITING;
        const igtl_received_t received =
            igtl_connection_receive(connection, moment->now_us, &bytes_left, &event);

        if (received == IGTL_RECEIVED_END) {
            igtl_seats_drop(self, connection, moment->now_us);
            return;
        }
        if ((received == IGTL_RECEIVED_NOTHING) || !handle(self, connection, event, moment)) {
            break;
        }
    }
    if ((connection->descriptor >= 0) && igtl_inbox_is_late(&connection->inbox, moment->now_us)) {
        drop_with(self, connection, IGTL_TROUBLE_LATE, IGTL_INCOMPLETE, moment);
    }
}

void igtl_server_receive(igtl_server_t *self, const igtl_moment_t *moment)
{
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        if (self->connections[i].descriptor >= 0) {
            receive_from(self, &self->connections[i], moment);
        }
    }
    igtl_slots_fill(self); /* A peer that has gone makes room, first for those that wait. */
    if (self->port->is_calling) {
        call_peer(self, moment->now_us);
    } else {
        accept_peers(self, moment->now_us);
    }
}

status_t igtl_server_obey(igtl_server_t *self, const exchange_order_t *order, uint64_t now_us)
{
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        igtl_connection_t *connection = &self->connections[i];

        if ((connection->descriptor < 0) || (connection->number != order->number)) {
            continue;
        }
        if (order->kind == (uint32_t)EXCHANGE_ORDER_KEEP_ALIVE) {
            igtl_connection_keep_alive(connection, order->is_on != 0U);
            return STATUS_OK;
        }
        if (igtl_seats_commands(self, connection)) {
            return STATUS_HOLDS_AUTHORITY;
        }
        igtl_seats_drop(self, connection, now_us);
        return STATUS_OK;
    }
    return STATUS_UNKNOWN_COMMAND;
}

/* In the time of answers from control: in a pause of the machine no peer could have read. */
static bool has_hung(igtl_server_t *self, igtl_connection_t *connection,
                     const igtl_moment_t *moment)
{
    if ((self->calls->has_order == NULL) || (connection->place == IGTL_NO_PLACE) ||
        !self->calls->has_order(self->dialect, igtl_seats_peer(self, connection))) {
        igtl_connection_unwatch(connection);
        return false;
    }
    return igtl_connection_unread_us(connection, moment->answer_clock_us) >= LIMIT_IGTL_UNREAD_US;
}

void igtl_server_send(igtl_server_t *self, const igtl_moment_t *moment)
{
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        igtl_connection_t *connection = &self->connections[i];

        if (connection->descriptor < 0) {
            continue;
        }
        if (!igtl_connection_flush(connection)) {
            if (connection->outbox.has_overflowed) {
                note(self, IGTL_TROUBLE_SLOW, "", moment->now_us);
            }
            igtl_seats_drop(self, connection, moment->now_us);
        } else if (has_hung(self, connection, moment)) {
            note(self, IGTL_TROUBLE_HUNG, "", moment->now_us);
            igtl_seats_drop(self, connection, moment->now_us);
        } else {
            /* It is served. */
        }
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_slots.h"

#include "limits/requirement_limits.h"

#include <stddef.h>

static igtl_connection_t *at_place(igtl_server_t *self, uint32_t place)
{
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        igtl_connection_t *connection = &self->connections[i];

        if ((connection->descriptor >= 0) && (connection->place == place)) {
            return connection;
        }
    }
    return NULL;
}

/* IGTL_NO_PLACE when all are taken. */
static uint32_t free_place(igtl_server_t *self)
{
    for (uint32_t place = 0U; place < IGTL_PEERS; place++) {
        if (at_place(self, place) == NULL) {
            return place;
        }
    }
    return IGTL_NO_PLACE;
}

/* The lowest number came first. NULL when none waits. */
static igtl_connection_t *longest_waiting(igtl_server_t *self, uint32_t *count)
{
    igtl_connection_t *longest = NULL;

    *count = 0U;
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        igtl_connection_t *connection = &self->connections[i];

        if ((connection->descriptor >= 0) && (connection->place == IGTL_NO_PLACE)) {
            (*count)++;
            if ((longest == NULL) || (connection->number < longest->number)) {
                longest = connection;
            }
        }
    }
    return longest;
}

static void seat(igtl_server_t *self, igtl_connection_t *connection, uint32_t place)
{
    const igtl_introduction_t introduction = {connection->number, self->port->language,
                                              self->port->entry_prefix, &connection->outbox};

    connection->place = place;
    self->calls->connected(self->dialect, igtl_seats_peer(self, connection), &introduction);
}

void igtl_slots_fill(igtl_server_t *self)
{
    uint32_t count;
    igtl_connection_t *waiting = longest_waiting(self, &count);
    uint32_t place = free_place(self);

    while ((waiting != NULL) && (place != IGTL_NO_PLACE)) {
        seat(self, waiting, place);
        waiting = longest_waiting(self, &count);
        place = free_place(self);
    }
}

void igtl_slots_enter(igtl_server_t *self, int descriptor, uint32_t address, uint16_t port,
                      uint64_t now_us)
{
    uint32_t count;
    igtl_connection_t *oldest = longest_waiting(self, &count);

    if (free_place(self) == IGTL_NO_PLACE) {
        igtl_troubles_note(&self->troubles, self->port->number, IGTL_TROUBLE_FULL, "", now_us);
        if (count == IGTL_WAITING) {
            igtl_seats_drop(self, oldest, now_us);
        }
    }
    for (uint32_t i = 0U; i < IGTL_CONNECTIONS; i++) {
        igtl_connection_t *connection = &self->connections[i];

        if (connection->descriptor < 0) {
            igtl_connection_open(connection, descriptor, now_us);
            connection->address = address;
            connection->port = port;
            connection->number = self->next_number;
            self->next_number += IGTL_NUMBER_STEP;
            igtl_slots_fill(self);
            return;
        }
    }
}

static bool is_needed(const igtl_server_t *self, const igtl_connection_t *connection)
{
    const igtl_dialect_calls_t *calls = self->calls;
    const uint32_t peer = igtl_seats_peer(self, connection);

    return igtl_seats_commands(self, connection) ||
           ((calls->has_order != NULL) && calls->has_order(self->dialect, peer));
}

/* Makes room by dropping the peer that has been silent for longest, if for more than `least_us`. */
static void evict_silent(igtl_server_t *self, uint64_t least_us, uint64_t now_us)
{
    uint64_t longest_us = least_us;
    igtl_connection_t *silent = NULL;

    for (uint32_t place = 0U; place < IGTL_PEERS; place++) {
        igtl_connection_t *connection = at_place(self, place);

        if ((connection != NULL) && ((now_us - connection->heard_us) >= longest_us) &&
            !is_needed(self, connection)) {
            longest_us = now_us - connection->heard_us;
            silent = connection;
        }
    }
    if (silent != NULL) {
        igtl_troubles_note(&self->troubles, self->port->number, IGTL_TROUBLE_SILENT, "", now_us);
        igtl_seats_drop(self, silent, now_us);
    }
}

bool igtl_slots_admit(igtl_server_t *self, igtl_connection_t *connection,
                      const igtl_message_t *message, const igtl_moment_t *moment)
{
    static const igtl_status_t taken = {IGTL_STATUS_BUSY, "BUSY",
                                        "BUSY: All connections are taken; this one waits."};

    if (message->kind == IGTL_KIND_STATUS) {
        return false;
    }
    if (free_place(self) == IGTL_NO_PLACE) {
        const bool is_stop = (self->calls->is_stop != NULL) && self->calls->is_stop(message);

        evict_silent(self, is_stop ? 0U : (LIMIT_IGTL_SILENT_US + 1U), moment->now_us);
    }
    const uint32_t place = free_place(self);
    if (place == IGTL_NO_PLACE) {
        igtl_send_status(&connection->outbox, message->name, &taken, moment);
        return false;
    }
    seat(self, connection, place);
    return true;
}

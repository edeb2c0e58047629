/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_seats.h"

#include <stddef.h>

uint32_t igtl_seats_peer(const igtl_server_t *self, const igtl_connection_t *connection)
{
    return self->first_place + connection->place;
}

bool igtl_seats_commands(const igtl_server_t *self, const igtl_connection_t *connection)
{
    return (connection->place != IGTL_NO_PLACE) && (self->calls->is_controlled_by != NULL) &&
           self->calls->is_controlled_by(self->dialect, igtl_seats_peer(self, connection));
}

void igtl_seats_drop(igtl_server_t *self, igtl_connection_t *connection, uint64_t now_us)
{
    igtl_connection_close(connection);
    if (connection->place != IGTL_NO_PLACE) {
        self->calls->disconnected(self->dialect, igtl_seats_peer(self, connection));
    }
    if (self->port->is_calling) {
        igtl_caller_lost(&self->caller, connection->was_heard, now_us);
    }
}

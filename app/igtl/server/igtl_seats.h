/* SPDX-License-Identifier: Apache-2.0 */
/** @file The state of a server: its port, its dialect and the connections that have a place or wait
 * for one. */
#ifndef BORESIGHT_IGTL_SEATS_H
#define BORESIGHT_IGTL_SEATS_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/server/igtl_caller.h"
#include "igtl/server/igtl_connection.h"
#include "igtl/server/igtl_port.h"
#include "igtl/server/igtl_troubles.h"

#include <stdbool.h>
#include <stdint.h>

#define IGTL_WAITING 4U                              /**< Connections that wait for a place. */
#define IGTL_CONNECTIONS (IGTL_PEERS + IGTL_WAITING) /**< Connections of a port. */

#define IGTL_NUMBER_STEP 10U /**< The last digit of a connection's number is its port. */

/** The calls of a server to a dialect; `dialect` is its own state, `peer` a place. */
typedef struct {
    void (*connected)(void *dialect, uint32_t peer, const igtl_introduction_t *introduction);
    void (*disconnected)(void *dialect, uint32_t peer);
    void (*receive)(void *dialect, uint32_t peer, const igtl_message_t *message,
                    const igtl_moment_t *moment);
    bool (*is_controlled_by)(const void *dialect, uint32_t peer); /**< NULL: by none. */
    bool (*has_order)(const void *dialect, uint32_t peer);        /**< NULL: none has one. */
    bool (*is_stop)(const igtl_message_t *message);               /**< NULL: none is. */
} igtl_dialect_calls_t;

typedef struct {
    const igtl_dialect_calls_t *calls;
    void *dialect;
    uint32_t first_place;    /**< In the dialect: its connections are peers from here on. */
    const igtl_port_t *port; /**< Lives as long. */
    int listener;            /**< -1: it calls. */
    igtl_caller_t caller;
    uint32_t next_number;      /**< Number of the next connection. */
    uint64_t next_greeting_us; /**< Not before this time its number is in the log. */
    igtl_connection_t connections[IGTL_CONNECTIONS];
    igtl_troubles_t troubles;
} igtl_server_t;

/** The dialect's peer of a connection that has a place. */
uint32_t igtl_seats_peer(const igtl_server_t *self, const igtl_connection_t *connection);

/** `connection` has authority, as far as the dialect knows. */
bool igtl_seats_commands(const igtl_server_t *self, const igtl_connection_t *connection);

/** Closes `connection`, and informs the dialect when it had a place. */
void igtl_seats_drop(igtl_server_t *self, igtl_connection_t *connection, uint64_t now_us);

#endif

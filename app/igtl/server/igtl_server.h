/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * One port and its connections: those that came to it, or the one that it called. Reads and writes
 * without waiting, hands whole messages to its dialect, drops who breaks the protocol and leaves
 * everyone else alone.
 */
#ifndef BORESIGHT_IGTL_SERVER_H
#define BORESIGHT_IGTL_SERVER_H

#include "igtl/server/igtl_ports.h"
#include "igtl/server/igtl_seats.h"
#include "igtl/dialect/igtl_dialect.h"
#include "exchange/exchange_peers.h"

#include <poll.h>
#include <stdbool.h>
#include <stdint.h>

#define IGTL_SERVER_POLLS (IGTL_CONNECTIONS + 1U) /**< And what it listens or calls with. */
#define IGTL_BYTES_PER_TURN 65536U                /**< Read of one connection per turn. */

/**
 * Opens `port`, which lives as long. `calls`, `dialect`, `first_place` and `next_number` (not 0)
 * are set before. A new connection is a line on stderr with its number and address, at most one in
 * a second.
 *
 * @return false with one sentence in `error` and the cause in errno
 */
bool igtl_server_open(igtl_server_t *self, const igtl_port_t *port, char *error, size_t error_size);

/** Closes the port and all connections. */
void igtl_server_close(igtl_server_t *self);

/** Descriptors to wait for. `polls` has room for IGTL_SERVER_POLLS; returns the number filled. */
uint32_t igtl_server_polls(const igtl_server_t *self, struct pollfd *polls);

/** Anyone connected. */
bool igtl_server_has_peers(const igtl_server_t *self);

/**
 * Accepts or calls, reads, and drops connections that stay in the middle of a message. At most a
 * few messages per connection and at most IGTL_BYTES_PER_TURN, so that no peer is kept waiting by
 * another. Places are given by igtl_slots.h.
 *
 * @satisfies SWR-IGTL-011
 * @satisfies SWR-IGTL-048
 */
void igtl_server_receive(igtl_server_t *self, const igtl_moment_t *moment);

/** Sends what the dialect has put into the outboxes, and drops who takes nothing while its order
 * runs. */
void igtl_server_send(igtl_server_t *self, const igtl_moment_t *moment);

/**
 * Carries out the request about a connection. One that has authority is not disconnected.
 *
 * @return STATUS_OK, STATUS_HOLDS_AUTHORITY, STATUS_UNKNOWN_COMMAND when this port has none of that
 * number
 *
 * @satisfies SWR-IGTL-057
 * @satisfies SWR-IGTL-058
 */
status_t igtl_server_obey(igtl_server_t *self, const exchange_order_t *order, uint64_t now_us);

#endif

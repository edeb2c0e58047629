/* SPDX-License-Identifier: Apache-2.0 */
/** @file State of the ports and their connections, for the processes that show it. */
#ifndef BORESIGHT_IGTL_SHOW_H
#define BORESIGHT_IGTL_SHOW_H

#include "exchange/exchange_peers.h"
#include "igtl/server/igtl_server.h"

#include <stdint.h>

/**
 * The row of one port.
 *
 * @satisfies SWR-IGTL-028
 */
void igtl_show_port(const igtl_server_t *server, uint64_t now_us, exchange_port_t *row);

/**
 * The row of one connection.
 *
 * @satisfies SWR-IGTL-056
 */
void igtl_show_peer(const igtl_server_t *server, const igtl_connection_t *connection,
                    exchange_peer_t *row);

/** Publishes the rows of all connections of `count` ports. */
void igtl_show_peers(exchange_t *exchange, const igtl_server_t *servers, uint32_t count);

/** Publishes the rows of `count` ports. */
void igtl_show_ports(exchange_t *exchange, const igtl_server_t *servers, uint32_t count,
                     uint64_t now_us);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A port of its own for one request, stop, served by one thread from a table of clients. Clients
 * that keep the console's port busy do not matter here; of those that keep this one busy the oldest
 * gives its place to the newest, so that nobody has to wait for a slow one.
 */
#ifndef BORESIGHT_STOP_PORT_H
#define BORESIGHT_STOP_PORT_H

#include "exchange/exchange.h"
#include "http/http_guard.h"

#include <stdint.h>

#define STOP_PORT_CLIENTS 256U

/**
 * Listens on the address of `console` and serves from a thread of its own until the process ends.
 * The port is the one noted in the exchange, so that pages go on after a restart, or else a free
 * one; it is noted in each turn, as a neighbour may have damaged it. Only the page of `console` may
 * ask, or who is no page. TLS leads to a second port (`front`, NULL: none). To be called once.
 *
 * @return the port; 0 when there is none, and stops pass by the console's port alone
 *
 * @satisfies SWR-HTTP-007
 * @satisfies SWR-LOAD-003
 */
uint32_t stop_port_start(exchange_t *exchange, const http_guard_t *console,
                         const tls_front_t *front);

#endif

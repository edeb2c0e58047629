/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The ports of the server: the console's port, and one of its own for a single request, stop. One
 * thread reads the first request of each client. It answers stops itself, so that none waits for a
 * worker of the library, and gives the library all others of the console's port. The oldest client
 * that has not finished its request is replaced by the newest, so that no client has to wait for a
 * slow one.
 */
#ifndef BORESIGHT_STOP_PORT_H
#define BORESIGHT_STOP_PORT_H

#include "exchange/exchange.h"
#include "http/stop/gate.h"

#include <stdbool.h>
#include <stdint.h>

#define STOP_PORT_CLIENTS 512U

/** All gates. */
typedef enum {
    STOP_PORT_OWN = 0,
    STOP_PORT_OWN_TLS = 1, /**< Fed by TLS. */
    STOP_PORT_CONSOLE = 2,
    STOP_PORT_CONSOLE_TLS = 3 /**< The same. */
} stop_port_gate_t;

#define STOP_PORT_GATES 4U

/** The gate, whose guard and port are to be set before stop_port_begin(). */
gate_t *stop_port_gate(stop_port_gate_t gate);

/**
 * Opens the port for stops on `address`: the one noted in the exchange, so that pages go on after a
 * restart, or else a free one; it is noted then and in each turn, as a neighbour may damage it.
 *
 * @return the port; 0 when none exists, and stops pass by the console's port alone
 *
 * @satisfies SWR-HTTP-007
 */
uint32_t stop_port_open(exchange_t *exchange, const char *address);

/**
 * Serves from a thread of its own until the process ends. To be called once.
 *
 * @return false when there is no thread for it
 *
 * @satisfies SWR-LOAD-003
 * @satisfies SWR-LOAD-010
 * @satisfies SWR-LOAD-011
 */
bool stop_port_begin(exchange_t *exchange);

#endif

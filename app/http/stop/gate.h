/* SPDX-License-Identifier: Apache-2.0 */
/** @file A port at which clients come: the console's or that of the stops, each with or without TLS
 * before it. */
#ifndef BORESIGHT_GATE_H
#define BORESIGHT_GATE_H

#include "http/gate/http_guard.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    int socket;         /**< -1: it does not listen. */
    bool is_console;    /**< The library answers what is no stop. */
    http_guard_t guard; /**< Judge of the clients that may ask here. */
} gate_t;

/**
 * Listens on `port` of `address`, 0 meaning any. A client that sends nothing waits in the kernel
 * for a second before it comes.
 *
 * @return 0, or why not (errno)
 *
 * @satisfies SWR-LOAD-006
 */
int gate_open(gate_t *self, const char *address, uint32_t port);

/** The port listened on; 0: none. */
uint32_t gate_port(const gate_t *self);

#endif

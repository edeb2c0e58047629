/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The HTTP server: the console's files, the state as JSON and as a stream, STOP, what pages with
 * authority command, and what the recorder has left. Nothing else is served, no other file is read,
 * no name is looked up.
 */
#ifndef BORESIGHT_HTTP_SERVER_H
#define BORESIGHT_HTTP_SERVER_H

#include "exchange/exchange.h"
#include "http/gate/http_guard.h"
#include "http/call/http_context.h"
#include "http/call/http_stream.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum {
    HTTP_SERVER_STARTED = 0,
    HTTP_SERVER_PORT_IN_USE = 1,
    HTTP_SERVER_BAD_ADDRESS = 2, /**< This machine does not have the address. */
    HTTP_SERVER_FAILED = 3,
    HTTP_SERVER_FRONT_IN_USE = 4,      /**< The console's port that TLS shall feed. */
    HTTP_SERVER_FRONT_STOP_IN_USE = 5, /**< The same of the stop's. */
    HTTP_SERVER_TOO_FEW_FILES = 6      /**< That this user may have open. */
} http_server_result_t;

/** The parts that the server is started with. All of them outlive the server. */
typedef struct {
    exchange_t *exchange;
    http_guard_t guard;
    const char *instance;     /**< Its name. */
    const char *box;          /**< Name of the simulated box; NULL: real cards. */
    const char *accounts;     /**< File of the accounts; NULL: none. */
    const char *recordings;   /**< Folder of the recorder. */
    const char *box_key;      /**< File of the key of the box; NULL: none. */
    const tls_front_t *front; /**< How TLS leads here; NULL: it does not. */
} http_server_config_t;

/** Prepares `self`. */
void http_server_init(http_server_t *self, const http_server_config_t *config);

/**
 * Decides how one logs in: by the accounts; without any, by a code that is printed here.
 *
 * @return false with a sentence in `error`, when there must be an account and is none
 *
 * @satisfies SWR-SESS-005
 * @satisfies SWR-SESS-006
 */
bool http_server_prepare_logins(http_server_t *self, char *error, size_t error_size);

/**
 * Listens on the guard's address, which is the loopback address unless the operator gave another,
 * and serves from threads of its own. They end with the process: a client can delay an orderly
 * stop, and there is nothing to save.
 *
 * @satisfies SWR-HTTP-005
 * @satisfies SWR-LOAD-004
 * @satisfies SWR-LOAD-006
 * @satisfies SWR-LOAD-007
 * @satisfies SWR-SESS-019
 * @satisfies SWR-SESS-023
 * @satisfies SWR-SESS-025
 */
http_server_result_t http_server_start(http_server_t *self);

/**
 * Sends the present state to the streams, ends what belongs to sessions that have ended, and writes
 * again what a neighbour may have damaged in the exchange; called at 20 Hz.
 *
 * @satisfies SWR-EXCH-023
 */
void http_server_tick(http_server_t *self);

#endif

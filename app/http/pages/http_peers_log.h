/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Connections of OpenIGTLink in the log: a note for each STATUS of a client, and for each message
 * that igtl refused by itself, when it differs from the last one of its connection. Changes that
 * come too fast are counted.
 */
#ifndef BORESIGHT_HTTP_PEERS_LOG_H
#define BORESIGHT_HTTP_PEERS_LOG_H

#include "exchange/exchange_peers.h"
#include "http/pages/http_notes.h"

#include <stdint.h>

/** The notes of each row: its last STATUS, and its last refusal. */
typedef enum { HTTP_PEERS_LOG_STATUS = 0, HTTP_PEERS_LOG_REFUSAL = 1 } http_peers_log_kind_t;

#define HTTP_PEERS_LOG_KINDS 2U

/** Number of its changes that are in the log. */
typedef struct {
    uint64_t since_us; /**< Begin of the connection: numbers begin anew with each run of igtl. */
    uint32_t number;
    uint32_t logged[HTTP_PEERS_LOG_KINDS];
} http_peers_log_row_t;

typedef struct {
    http_notes_t *notes;
    uint64_t logged_ms; /**< The last one; 0: never. */
    uint32_t next;      /**< Row to begin with, so that none waits for ever. */
    http_peers_log_row_t rows[EXCHANGE_PEERS]; /**< As the table of connections had them. */
} http_peers_log_t;

/** Starts with nothing logged. `notes` outlives `self`. */
void http_peers_log_init(http_peers_log_t *self, http_notes_t *notes);

/**
 * Notes one that has changed, LIMIT_STATUS_LOG_PAUSE_MS after the one before at the earliest;
 * called by one thread at 20 Hz.
 *
 * @satisfies SWR-EVENT-022
 * @satisfies SWR-EVENT-023
 */
void http_peers_log_tick(http_peers_log_t *self, uint64_t now_ms);

#endif

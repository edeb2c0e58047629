/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What clients of OpenIGTLink say of themselves, in the log: a note for each STATUS that is another
 * one than the last of its connection. What changes too fast is counted.
 */
#ifndef BORESIGHT_HTTP_STATUSES_H
#define BORESIGHT_HTTP_STATUSES_H

#include "exchange/exchange_peers.h"
#include "http/http_notes.h"

#include <stdint.h>

/** How many of its statuses are in the log. */
typedef struct {
    uint64_t since_us; /**< Of the connection: numbers begin anew with each run of igtl. */
    uint32_t number;
    uint32_t logged;
} http_statuses_row_t;

typedef struct {
    http_notes_t *notes;
    uint64_t logged_ms; /**< The last one; 0: never. */
    uint32_t next;      /**< Row to begin with, so that none waits for ever. */
    http_statuses_row_t rows[EXCHANGE_PEERS]; /**< As the table of connections had them. */
} http_statuses_t;

/** Starts with nothing logged. `notes` outlives `self`. */
void http_statuses_init(http_statuses_t *self, http_notes_t *notes);

/**
 * Notes one that has changed, LIMIT_STATUS_LOG_PAUSE_MS after the one before at the earliest;
 * called by one thread at 20 Hz.
 *
 * @satisfies SWR-EVENT-022
 */
void http_statuses_tick(http_statuses_t *self, uint64_t now_ms);

#endif

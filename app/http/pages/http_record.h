/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The record of requests in the log: of the commands of users who are logged in, and of refused
 * requests, each with a pace of its own, so that a client that is refused cannot fill the log.
 * Requests that come faster are counted.
 */
#ifndef BORESIGHT_HTTP_RECORD_H
#define BORESIGHT_HTTP_RECORD_H

#include "http/pages/http_notes.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** How fast requests of a kind are written. */
typedef struct {
    uint64_t credit_ms;
    uint64_t at_ms; /**< When credit was given last. */
    uint32_t left_out;
} http_record_pace_t;

typedef struct {
    http_notes_t *notes;
    pthread_mutex_t lock;
    http_record_pace_t commanded;
    http_record_pace_t refused; /**< And those of clients that are not logged in. */
} http_record_t;

/** A request that was answered. */
typedef struct {
    const char *who; /**< Name of the account; NULL: a stranger. */
    const char *method;
    const char *path;
    const char *request; /**< Its body; "": none was read. */
    int status;          /**< 0: the client did not take the answer. */
    const char *answer;
} http_record_entry_t;

/** Starts with nothing left out. `notes` outlives `self`. */
void http_record_init(http_record_t *self, http_notes_t *notes, uint64_t now_ms);

/**
 * Notes a request, or counts it. Any thread.
 *
 * @satisfies SWR-EVENT-018
 * @satisfies SWR-EVENT-019
 */
void http_record_write(http_record_t *self, const http_record_entry_t *entry, uint64_t now_ms);

/** Notes the number of requests that were left out, once there is room again; called at 20 Hz. */
void http_record_tick(http_record_t *self, uint64_t now_ms);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Notes of the server in the log of events: the words are kept in the exchange, and control is
 * asked for an event of each. One is asked for at a time, and again until it stands in the log: a
 * stop may have refused it.
 */
#ifndef BORESIGHT_HTTP_NOTES_H
#define BORESIGHT_HTTP_NOTES_H

#include "exchange/exchange_notes.h"
#include "http/pages/command_client.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** The last note about a damaged command lane. */
typedef struct {
    uint32_t count;
    uint32_t note;        /**< Its number; 0: it is known to have been kept. */
    uint64_t reported_ms; /**< 0: never. */
} http_notes_damage_t;

typedef struct {
    exchange_t *exchange;
    command_client_t *client;
    pthread_mutex_t lock;
    uint32_t written;    /**< Number of the newest note. */
    uint32_t logged;     /**< Number of the last one that stands in the log. */
    uint32_t asked;      /**< Number of the last one that was asked for. */
    uint32_t ticks_left; /**< Ticks until it is asked for again. */
    uint32_t next_event; /**< Number of the event of the log to look at next. */
    uint64_t kept_ms;    /**< When a note of a client was kept last. */
    uint32_t seen;       /**< Value of `logged` at the last tick, for all threads. */
    http_notes_damage_t damages[COMMAND_SOURCE_COUNT]; /**< Damages of their command lanes. */
} http_notes_t;

/** Starts with nothing to log. `exchange` and `client`, which asks control, outlive `self`. */
void http_notes_init(http_notes_t *self, exchange_t *exchange, command_client_t *client);

/** Keeps a note; http_notes_tick() has it logged. Any thread. `owner` is an http_notes_t. */
void http_notes_write(void *owner, note_kind_t kind, const char *who, const char *text);

/**
 * Keeps the note of a client; the caller has it logged. Any thread.
 *
 * @return its number; 0 within LIMIT_NOTE_PAUSE_MS of the one before
 */
uint32_t http_notes_keep(http_notes_t *self, const char *who, const char *text, uint64_t now_ms);

/** Whether so many notes wait to be logged that more would be lost. Any thread. */
bool http_notes_are_behind(http_notes_t *self);

/**
 * Notes which programs the supervisor has replaced.
 *
 * @satisfies SWR-LIFE-002
 */
void http_notes_report_replaced(http_notes_t *self);

/**
 * Notes of each command lane how often it was found damaged, where that has grown or the note of it
 * was damaged itself: at once, and again LIMIT_DAMAGE_PAUSE_MS later at the earliest.
 *
 * @satisfies SWR-EXCH-024
 */
void http_notes_report_damage(http_notes_t *self, uint64_t now_ms);

/**
 * Has the next note logged that no other caller has logged; called by one thread at 20 Hz, so that
 * at most as many are logged in a second. A note that is overwritten before is never logged.
 *
 * @satisfies SWR-SESS-020
 */
void http_notes_tick(http_notes_t *self);

#endif

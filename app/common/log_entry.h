/* SPDX-License-Identifier: Apache-2.0 */
/** @file An event in the log: with its time and its sentence, and as a line of a log's file. */
#ifndef BORESIGHT_LOG_ENTRY_H
#define BORESIGHT_LOG_ENTRY_H

#include "common/event_text.h"
#include "exchange/exchange.h"

#include <stdbool.h>
#include <stdint.h>

#define LOG_ENTRY_LINE_SIZE 1024U /**< Room for a line with its ends. */

typedef struct {
    event_t event;
    uint64_t utc_us;            /**< When control published it. */
    char text[EVENT_TEXT_SIZE]; /**< Its sentence. */
} log_entry_t;

/**
 * Makes one, in the words of the note that it refers to or else with the names of the robot and of
 * the page's account.
 *
 * @satisfies SWR-SESS-026
 */
void log_entry_make(log_entry_t *self, const exchange_t *exchange, const exchange_event_t *event);

/**
 * Writes a line: time, number, cycle, severity, name, subject, value, cause, peer, sentence.
 *
 * @satisfies SWR-EVENT-013
 */
void log_entry_write(const log_entry_t *self, char line[LOG_ENTRY_LINE_SIZE]);

/** Reads such a line, with or without its end. False: it is none. */
bool log_entry_read(log_entry_t *self, const char *line);

#endif

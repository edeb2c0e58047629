/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The event log: one readable line per event (common/log_entry.h), put on the disk each second.
 * Each run has a file of its own, and another one when that is full; the oldest are removed.
 */
#ifndef BORESIGHT_EVENT_LOG_H
#define BORESIGHT_EVENT_LOG_H

#include "common/file_series.h"
#include "exchange/exchange.h"
#include "exchange/exchange_files.h"

#include <stdbool.h>

typedef struct {
    const char *directory; /**< Lives as long as the log. */
    exchange_t *exchange;  /**< The same. */
    int file;              /**< -1: not open; tried again at the next sync. */
    uint64_t size;         /**< Size of the file, in bytes. */
    uint32_t severity;     /**< Those and above are written; the file says so. */
    uint32_t number;       /**< Number of its file, and of the one before; 0: none exists. */
    uint32_t number_before;
    uint32_t next; /**< Number of the next event. */
    bool is_dirty;
    bool is_failing; /**< It could not be written, which was said; its events wait. */
    char path[FILE_SERIES_PATH_SIZE];
} event_log_t;

/**
 * Goes on with the file of this run in `directory`, or begins one; a failure is said once, in one
 * sentence, on stderr.
 *
 * @satisfies SWR-EVENT-014
 * @satisfies SWR-REC-011
 */
void event_log_open(event_log_t *self, const char *directory, exchange_t *exchange);

/**
 * Writes the events that the exchange has gained; those that it has overwritten are counted in a
 * line. An event that cannot be written stays in the exchange until the next call. Notes there how
 * far it is and in which files, again each time: a neighbour may have damaged it.
 *
 * @satisfies SWR-EVENT-008
 * @satisfies SWR-EVENT-015
 * @satisfies SWR-EVENT-017
 * @satisfies SWR-EXCH-023
 * @satisfies SWR-REC-010
 */
void event_log_drain(event_log_t *self);

/**
 * Puts what was written on the disk; begins anew when the file was removed or moved. Called each
 * second.
 *
 * @satisfies SWR-REC-014
 */
void event_log_sync(event_log_t *self);

/**
 * Writes that the last `cycles` cycles of the run are in no recording.
 *
 * @satisfies SWR-REC-040
 */
void event_log_note_unrecorded(event_log_t *self, uint32_t cycles);

/** Writes what is no event: a name, `value=` and a number, a sentence. */
void event_log_remark(event_log_t *self, const char *remark);

void event_log_close(event_log_t *self);

#endif

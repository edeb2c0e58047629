/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The events of this run that fit a filter: the newest of them, or the first ones after one. Those
 * that are still in the exchange come from there, earlier ones from the present log and the one
 * before it.
 */
#ifndef BORESIGHT_LOG_SEARCH_H
#define BORESIGHT_LOG_SEARCH_H

#include "common/log_entry.h"
#include "exchange/exchange.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    bool has_after;
    uint32_t after;    /**< Number of an event: the first ones after it. Without: the newest. */
    uint32_t limit;    /**< At most so many; not 0. */
    uint32_t severity; /**< event_severity_t: these and those above it. */
    const char *text;  /**< In the sentence or the name, in any case; NULL: any. */
    uint64_t from_us;  /**< UTC since 1970, inclusive. */
    uint64_t to_us;    /**< The same. */
} log_filter_t;

typedef struct {
    uint32_t count;   /**< Entries found. */
    uint32_t next;    /**< Number of the event after the last one that was looked at. */
    uint32_t lost;    /**< Events after `after` that were looked for and are nowhere. */
    bool wants_files; /**< Files were not read and might have more. */
    const log_filter_t *filter;
    log_entry_t *entries; /**< Used in a circle; see log_search_entry(). */
    uint32_t oldest;      /**< Its place. */
} log_search_t;

/**
 * Searches among the `events` that there have been in this run.
 *
 * @param directory  of the recorder; NULL: only what is still in the exchange
 * @return false without memory; else log_search_end() is to follow
 *
 * @satisfies SWR-EVENT-016
 */
bool log_search(log_search_t *self, const log_filter_t *filter, const exchange_t *exchange,
                uint32_t events, const char *directory);

/** The entry at `place`, below count, the oldest first. */
const log_entry_t *log_search_entry(const log_search_t *self, uint32_t place);

void log_search_end(log_search_t *self);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the recorder writes, so that others read the right files, and what it shall write. */
#ifndef BORESIGHT_EXCHANGE_FILES_H
#define BORESIGHT_EXCHANGE_FILES_H

#include "exchange/exchange.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * For the recorder: which file it writes, by the number in its name, noted for those who read it
 * and for its own next run; 0: none.
 *
 * @satisfies SWR-EXCH-020
 */
void exchange_note_file(exchange_t *self, exchange_file_t file, uint32_t number);
uint32_t exchange_file(const exchange_t *self, exchange_file_t file);

/** For the HTTP server, one thread at a time. Kept as long as control runs. */
void exchange_set_log_level(exchange_t *self, const exchange_log_level_t *level);

/**
 * Copies it. Never above CRITICAL, and nothing but plain characters in the name.
 *
 * @return false when it was never set, or when the writer kept interfering
 */
bool exchange_read_log_level(const exchange_t *self, exchange_log_level_t *level);

#endif

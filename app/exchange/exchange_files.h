/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the recorder writes, so that others read the right files. */
#ifndef BORESIGHT_EXCHANGE_FILES_H
#define BORESIGHT_EXCHANGE_FILES_H

#include "exchange/exchange.h"

#include <stdint.h>

typedef enum {
    EXCHANGE_FILE_RECORDING = 0,
    EXCHANGE_FILE_LOG = 1,
    EXCHANGE_FILE_LOG_BEFORE = 2 /**< Of the same run. */
} exchange_file_t;

#define EXCHANGE_FILES 3U

/**
 * For the recorder: which file it writes, by the number in its name, noted for those who read it
 * and for its own next run; 0: none.
 *
 * @satisfies SWR-EXCH-020
 */
void exchange_note_file(exchange_t *self, exchange_file_t file, uint32_t number);
uint32_t exchange_file(const exchange_t *self, exchange_file_t file);

#endif

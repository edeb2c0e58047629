/* SPDX-License-Identifier: Apache-2.0 */
/** @file Why peers of a port were not served: counted, in the log within bounds, and the last one
 * kept to be shown. */
#ifndef BORESIGHT_IGTL_TROUBLES_H
#define BORESIGHT_IGTL_TROUBLES_H

#include <stdint.h>

typedef enum {
    IGTL_TROUBLE_FULL = 0,     /**< A connection had to wait, or go: all places are taken. */
    IGTL_TROUBLE_BROKEN = 1,   /**< Dropped: it does not speak the protocol. */
    IGTL_TROUBLE_LATE = 2,     /**< Dropped: a message stayed incomplete. */
    IGTL_TROUBLE_SLOW = 3,     /**< Dropped: it does not read what it is sent. */
    IGTL_TROUBLE_MESSAGE = 4,  /**< A message was refused. */
    IGTL_TROUBLE_SILENT = 5,   /**< Dropped: it was silent, and another wanted its place. */
    IGTL_TROUBLE_STRANGER = 6, /**< Refused: its address is not allowed. */
    IGTL_TROUBLE_HUNG = 7,     /**< Dropped: its order ran, and it did not acknowledge what it was
                                  sent. */
    IGTL_TROUBLE_CALL = 8      /**< A call was in vain. */
} igtl_trouble_t;

#define IGTL_TROUBLES 9U
#define IGTL_TROUBLE_TEXT 96U

typedef struct {
    uint64_t count;
    uint64_t said;        /**< Number of these in the log. */
    uint64_t next_log_us; /**< Not before this time again. */
} igtl_trouble_count_t;

typedef struct {
    igtl_trouble_count_t counts[IGTL_TROUBLES];
    uint64_t count;               /**< Number of all kinds. */
    char last[IGTL_TROUBLE_TEXT]; /**< In words, "" before the first. */
} igtl_troubles_t;

/** One more; a line on stderr, at most one per kind and second. `reason` may be "". */
void igtl_troubles_note(igtl_troubles_t *self, uint16_t port, igtl_trouble_t kind,
                        const char *reason, uint64_t now_us);

#endif

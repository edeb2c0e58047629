/* SPDX-License-Identifier: Apache-2.0 */
/** @file The parts of the status line and how they become one. */
#ifndef BORESIGHT_STATUS_PARTS_H
#define BORESIGHT_STATUS_PARTS_H

#include "interface/snapshot.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define STATUS_PARTS 32U
#define STATUS_PART_SIZE 96U

/** How a part is coloured. Its words say the same. */
typedef enum {
    STATUS_PLAIN = 0,
    STATUS_GOOD = 1,
    STATUS_NOTE = 2, /**< The operator has to look. */
    STATUS_BAD = 3
} status_tone_t;

typedef struct {
    char text[STATUS_PART_SIZE];
    status_tone_t tone;
} status_part_t;

typedef struct {
    status_part_t parts[STATUS_PARTS];
    uint32_t count;
} status_parts_t;

/** How a log repeats the line; at first all zero. */
typedef struct {
    uint64_t shown_us; /**< When it was last written. */
    uint32_t bad;      /**< Parts that were bad at the last look. */
} status_repeat_t;

/** Adds a part behind the others; one too many is left out, a long one is cut. */
void status_parts_add(status_parts_t *self, status_tone_t tone, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/**
 * Adds in which time the disk of the recordings is full; 0 minutes: no end is foreseen, and nothing
 * is added.
 *
 * @satisfies SWR-REC-037
 */
void status_parts_add_room(status_parts_t *self, uint32_t minutes);

/**
 * Adds what has stopped a loop that was late too often; nothing while it is not stopped.
 *
 * @satisfies SWR-CTRL-030
 */
void status_parts_add_lateness(status_parts_t *self, const snapshot_t *shown);

/**
 * Whether a log is to have the line now: every five seconds, and at once where one more part is bad
 * than at the last look.
 *
 * @satisfies SWR-SUP-014
 */
bool status_repeat_is_due(status_repeat_t *self, const status_parts_t *parts, uint64_t now_us);

/**
 * Writes the parts that fit into `columns`, each whole and in their order, and "..." for those that
 * do not: the first one always, then first what is bad, what has to be looked at, and what is good.
 * 0 columns: there is no bound. Colours take no column.
 *
 * @satisfies SWR-SUP-011
 */
void status_parts_write(const status_parts_t *self, uint32_t columns, bool is_coloured, char *text,
                        size_t size);

#endif

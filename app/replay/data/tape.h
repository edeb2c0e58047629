/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A JSON value as it changes, in rows of which each says only what the reader cannot know: a JSON
 * array of the cycles since the row before, then of pairs, a place and the value there now. Places
 * are counted through the value as it was before the row, from 0, the whole, depth first, what is
 * inside after what it is in; a place is told as its distance from the one before. The first row
 * has all of it at place 0.
 *
 * Numbers are told in some rows only; in the others, whose cycles are negative, they stand. A
 * number that is not told where numbers are goes on as it did: by so much for each cycle since
 * numbers were told before as its last told change was for each of its own, if that is a whole
 * number, else it stands. After an object or array was told they all stand.
 */
#ifndef BORESIGHT_TAPE_H
#define BORESIGHT_TAPE_H

#include "replay/data/bytes.h"

#include <cjson/cJSON.h>
#include <stdbool.h>
#include <stdint.h>

/** All zero is before the first row. */
typedef struct {
    cJSON *shown;  /**< What the reader has. */
    double *rates; /**< Of each place for each cycle. */
    uint32_t places;
    uint32_t cycle;   /**< Of the last row. */
    uint32_t counted; /**< Of the last one with numbers. */
} tape_t;

/**
 * Puts the row of `cycle`, later than the one before, in which the value is `now`. The first is
 * `with_numbers`. False, and nothing put: without numbers there is nothing to tell.
 */
bool tape_take(tape_t *self, uint32_t cycle, bool with_numbers, const cJSON *now, bytes_t *row);

void tape_free(tape_t *self);

#endif

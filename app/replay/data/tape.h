/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A JSON value as it changes, in rows of which each says only what the reader cannot know: a JSON
 * array of the cycles since the row before, then of pairs, a place and the value there now. Places
 * are counted through the value as it was before the row, from 0, the whole, depth first, a value
 * after the one that holds it; a place is given as its distance from the one before. The first row
 * has all of it at place 0.
 *
 * Numbers are given in some rows only; in the others, whose cycles are negative, they stand. A
 * number that is not given in a row with numbers continues as before: by so much for each cycle
 * since the last row with numbers as its last given change was for each of its own, if that is a
 * whole number, else it stands. After an object or array was given they all stand.
 */
#ifndef BORESIGHT_TAPE_H
#define BORESIGHT_TAPE_H

#include "replay/data/bytes.h"

#include <cjson/cJSON.h>
#include <stdbool.h>
#include <stdint.h>

/** All zero is before the first row. */
typedef struct {
    cJSON *shown;  /**< The value that the reader has. */
    double *rates; /**< Change of each place for each cycle. */
    uint32_t places;
    uint32_t cycle;   /**< Cycle of the last row. */
    uint32_t counted; /**< Cycle of the last one with numbers. */
} tape_t;

/**
 * Puts the row of `cycle`, later than the one before, in which the value is `now`. The first is
 * `with_numbers`. False, and nothing put: without numbers there is nothing to give.
 */
bool tape_take(tape_t *self, uint32_t cycle, bool with_numbers, const cJSON *now, bytes_t *row);

void tape_free(tape_t *self);

#endif

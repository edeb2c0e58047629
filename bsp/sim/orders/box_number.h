/* SPDX-License-Identifier: Apache-2.0 */
/** @file Numbers that orders to the simulated box end with, and their ranges. Stateless. */
#ifndef BORESIGHT_BOX_NUMBER_H
#define BORESIGHT_BOX_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

/** A whole number, the last word of an order. */
typedef struct {
    const char *order; /**< First word of the order. */
    const char *act;   /**< Second word; NULL: the number is the second word. */
    int64_t least;
    int64_t most;
    const char *unit; /**< " mm", or "". */
} box_number_t;

/** The number that an order of `count` words takes, by its first two; NULL: it takes none. */
const box_number_t *box_number_find(const char *order, const char *act, uint32_t count);

/** False when `word` is no number of the range of `self`; `number` is set otherwise. */
bool box_number_read(const box_number_t *self, const char *word, int64_t *number);

#endif

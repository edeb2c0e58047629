/* SPDX-License-Identifier: Apache-2.0 */
/** @file The words of one order to the simulated box. Stateless. */
#ifndef BORESIGHT_BOX_WORDS_H
#define BORESIGHT_BOX_WORDS_H

#include "sim/orders/box_number.h"

#include <stdbool.h>
#include <stdint.h>

#define BOX_WORD_COUNT 3U
#define BOX_WORD_SIZE 16U

/** Words that an order does not have are empty. */
typedef struct {
    char words[BOX_WORD_COUNT][BOX_WORD_SIZE];
    uint32_t count;
} box_words_t;

/** Splits `line` at its blanks. False: it has more words than any order, or a longer one. */
bool box_words_split(const char *line, box_words_t *words);

/** The word `index` is this one. */
bool box_words_is(const box_words_t *self, uint32_t index, const char *word);

/** Number of `word` among `known`, which ends with NULL; -1: it is not there. */
int box_words_find(const char *const known[], const char *word);

/** The number that this order takes; NULL: none. */
const box_number_t *box_words_number(const box_words_t *self);

/** Reads it. False: the order takes none, or has none of its range. */
bool box_words_take_number(const box_words_t *self, int64_t *number);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The words of a text, one after the other, and the numbers and axes that they are. */
#ifndef BORESIGHT_WORKPHASE_TEXT_H
#define BORESIGHT_WORKPHASE_TEXT_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The next word of `*text`, which ends at a space; `*text` goes on behind it. NULL: none is left.
 * It is a part of the text, which is changed. */
char *workphase_text_next(char **text);

/** Whether `word` is `expected`; false of no word at all. */
bool workphase_text_is(const char *word, const char *expected);

/** Reads `word` as a decimal number within +-`most`. False when it is none, or no word at all. */
bool workphase_text_number(const char *word, double most, double *number);

/** Reads `word` as a whole number. False when it is none, too large, or no word at all. */
bool workphase_text_whole(const char *word, int32_t *number);

/** The same of digits alone. */
bool workphase_text_natural(const char *word, uint32_t *number);

/** Reads `word` as ticks of `axis`, or ticks/s: it is in mm or degrees, or these in a second. False
 * as above, and when no int32_t is so far away. */
bool workphase_text_ticks(const char *word, const axis_config_t *axis, int32_t *ticks);

#endif

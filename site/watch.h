/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Questions of a page beside a robot in a closed loop: the possible inputs, the state and events of
 * the last cycle, and the differences from another run. Words come out by one text.
 */
#ifndef BORESIGHT_WATCH_H
#define BORESIGHT_WATCH_H

#include "controller/controller.h"
#include "site/closed_loop.h"
#include "site/export.h"

#include <stdbool.h>
#include <stdint.h>

#define WATCH_WORDS_SIZE 32768U

/** The robot that is watched; of the module. */
const closed_loop_t *watch_loop(void);

/** Where the words are; a line that has no room is left out. */
EXPORT(words) const char *watch_words(void);

/**
 * Which inputs there are, a line each: `order` and an order of the box as it lists
 * it; `command KIND CODE`; `field NAME OFFSET WORDS` of a command, without its kind; `word FIELD
 * WORD NUMBER` where a word stands for the number of a field.
 */
EXPORT(vocabulary) void watch_vocabulary(void);

/** The events and answers of the last cycle, a line each: `event NAME SUBJECT`, the subject being
 * its number; `answer ID KIND STATUS`. Needs a robot that was started (contract 320).
 *
 * @satisfies SWR-SITE-020
 */
EXPORT(happened) void watch_happened(void);

/** Bit n: axis n was driven in the last cycle. */
EXPORT(driven) uint32_t watch_driven(void);

/**
 * Puts what `TOPIC FIELD` in the words is after the last cycle there, such as `RELEASED` of `state
 * pedal`. Needs a robot (320).
 *
 * @return false: there is none such
 */
EXPORT(look) bool watch_look(void);

/** Outputs of the last cycle. */
EXPORT(outputs) const controller_outputs_t *watch_outputs(void);
EXPORT(outputsSize) uint32_t watch_outputs_size(void);

/** Where the outputs of another run are to be written. */
EXPORT(other) controller_outputs_t *watch_other(void);

/** Begins to compare. Needs a robot (320). */
EXPORT(compareBegin) void watch_compare_begin(void);

/**
 * Lists what in the last cycle is for the first time other than in the other run; no words
 * when nothing is. Needs a comparison that was begun (321).
 *
 * @satisfies SWR-SITE-018
 */
EXPORT(compare) void watch_compare(void);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Texts of the board's table, with what its {names} stand for. */
#ifndef BORESIGHT_BOARD_TEXT_H
#define BORESIGHT_BOARD_TEXT_H

#include "supervisor/options_values.h"

#include <stdbool.h>
#include <stddef.h>

/**
 * Writes `pattern`. {instance}, {robot}, {programs} and {recordings} are those of `options`; the
 * name of an option of the board is its value, and that of one that takes nothing is itself if it
 * was given and nothing if not.
 *
 * @return false when it is longer than `size`; `text` then holds its beginning
 */
bool board_text_write(char *text, size_t size, const char *pattern, const options_t *options);

#endif

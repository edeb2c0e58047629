/* SPDX-License-Identifier: Apache-2.0 */
/** @file A text that people have written, line by line. */
#ifndef BORESIGHT_TEXT_LINES_H
#define BORESIGHT_TEXT_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/** `text` and `length` are put in, all else is zero at first. */
typedef struct {
    const char *text;
    size_t length;
    size_t place;      /**< Where the next line begins. */
    unsigned number;   /**< Number of the present line, from 1. */
    const char *fault; /**< Fault of the present line; NULL: none. */
} text_lines_t;

/**
 * Copies the next line into `size` bytes of `line`, which is empty if it has a fault.
 *
 * @return false after the last line
 */
static inline bool text_lines_next(text_lines_t *self, char *line, size_t size)
{
    if (self->place >= self->length) {
        return false;
    }
    const char *start = &self->text[self->place];
    const size_t left = self->length - self->place;
    const char *end = memchr(start, '\n', left);
    const size_t count = (end != NULL) ? (size_t)(end - start) : left;
    const bool is_good = (count < size) && (memchr(start, '\0', count) == NULL);

    self->number++;
    self->place += count + 1U;
    self->fault = is_good ? NULL : "the line is too long, or holds a NUL.";
    (void)memcpy(line, start, is_good ? count : 0U);
    line[is_good ? count : 0U] = '\0';
    return true;
}

#endif

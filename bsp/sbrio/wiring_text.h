/* SPDX-License-Identifier: Apache-2.0 */
/** @file The words of a wiring's text: parts, numbers and paths, and the error for a wrong one.
 */
#ifndef BORESIGHT_WIRING_TEXT_H
#define BORESIGHT_WIRING_TEXT_H

#include <stdbool.h>
#include <stdint.h>

#define WIRING_PATH_SIZE 64U
#define WIRING_TEXT_SIZE 4096U

/** Place of a reader in a text. */
typedef struct {
    char *rest;    /**< Rest that is not read yet; NULL at the end. */
    uint32_t line; /**< From 1 on. */
    char *error;
    uint32_t error_size;
} wiring_reader_t;

/** Says that `what` is wrong, and why, as the end of a sentence. @return false */
bool wiring_refuse(const wiring_reader_t *reader, const char *what, const char *why);

/** Cuts the first part off `*rest`, up to one of `ends`, without the blanks around it; `*rest` is
 * NULL after the last one. */
char *wiring_cut(char **rest, const char *ends);

/** @return false if `text` is no number from `least` to `most` */
bool wiring_number(const char *text, uint32_t least, uint32_t most, uint32_t *number);

/** Takes an absolute path, or refuses it. */
bool wiring_path(const wiring_reader_t *reader, const char *text, char path[WIRING_PATH_SIZE]);

/** Reads a regular file whole, without waiting; without it `error` is a sentence.
 *
 * @satisfies SWR-NI-020
 */
bool wiring_load(const char *path, char text[WIRING_TEXT_SIZE], char *error, uint32_t error_size);

#endif

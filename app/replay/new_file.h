/* SPDX-License-Identifier: Apache-2.0 */
/** @file A file that is written for others. */
#ifndef BORESIGHT_NEW_FILE_H
#define BORESIGHT_NEW_FILE_H

#include <stdbool.h>
#include <stdio.h>

/**
 * Opens `path`, which must not exist yet: nothing is written over, least of all the recording. `-`
 * is the standard output. NULL after a sentence on the standard error.
 *
 * @satisfies SWR-REPLAY-012
 */
FILE *new_file_open(const char *path);

/** Closes it; `is_written`: so far all of it was. False, after a sentence: it is not whole. */
bool new_file_close(FILE *file, const char *path, bool is_written);

#endif

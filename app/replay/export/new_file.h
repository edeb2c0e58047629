/* SPDX-License-Identifier: Apache-2.0 */
/** @file A file that is written for others. */
#ifndef BORESIGHT_NEW_FILE_H
#define BORESIGHT_NEW_FILE_H

#include <stdbool.h>
#include <stdio.h>

/**
 * Opens `path`, which must not exist yet: nothing is written over, least of all the recording. `-`
 * is the standard output. It gets its name when it is whole. NULL after a sentence on the standard
 * error.
 *
 * @satisfies SWR-REPLAY-012
 */
FILE *new_file_open(const char *path);

/**
 * Closes it; `is_made`: there was room for what belongs into it. False, after a sentence that says
 * why: it is not whole, and unless it is the standard output it was removed.
 *
 * @satisfies SWR-REPLAY-022
 */
bool new_file_close(FILE *opened, const char *path, bool is_made);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Replayed motion into a new file, for others: each writes one, and returns the exit code.
 */
#ifndef BORESIGHT_FILE_OUTPUT_H
#define BORESIGHT_FILE_OUTPUT_H

#include "replay/verify/walk.h"

int file_output_csv(walk_t *walk, const char *path);
int file_output_mcap(walk_t *walk, const char *path);

/** @satisfies SWR-REPLAY-017 */
int file_output_html(walk_t *walk, const char *path);

#endif

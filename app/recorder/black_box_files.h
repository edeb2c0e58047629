/* SPDX-License-Identifier: Apache-2.0 */
/** @file Names and removal of the black box' files. */
#ifndef BORESIGHT_BLACK_BOX_FILES_H
#define BORESIGHT_BLACK_BOX_FILES_H

#include <stddef.h>
#include <stdint.h>

/** Writes "DIRECTORY/blackbox-<UTC>-<number>.bsr"; names sort by age. */
void black_box_name(char *path, size_t size, const char *directory, uint64_t utc_us,
                    uint32_t number);

/** Removes the oldest recordings until at most `files`, with fewer than `bytes` together, are left.
 * `present` stays even when the clock was set back and its name is the oldest. */
void black_box_remove_oldest(const char *directory, const char *present, uint32_t files,
                             uint64_t bytes);

#endif

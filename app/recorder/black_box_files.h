/* SPDX-License-Identifier: Apache-2.0 */
/** @file Names and removal of the black box' files. */
#ifndef BORESIGHT_BLACK_BOX_FILES_H
#define BORESIGHT_BLACK_BOX_FILES_H

#include <stddef.h>
#include <stdint.h>

/** Writes "DIRECTORY/blackbox-<number>-<UTC>.bsr". The number tells the age, the clock may be set
 * back. */
void black_box_name(char *path, size_t size, const char *directory, uint32_t number,
                    uint64_t utc_us);

/** The number of the newest recording; 0 when there is none. */
uint32_t black_box_newest(const char *directory);

/**
 * Removes the oldest recordings until at most `files`, with fewer than `bytes` together, are left;
 * those without a number are the oldest. `present` stays in any case.
 *
 * @satisfies SWR-REC-007
 */
void black_box_remove_oldest(const char *directory, const char *present, uint32_t files,
                             uint64_t bytes);

#endif

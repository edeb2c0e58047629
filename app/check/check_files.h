/* SPDX-License-Identifier: Apache-2.0 */
/** @file The kernel's small files, and the lists and masks of cores in them. */
#ifndef BORESIGHT_CHECK_FILES_H
#define BORESIGHT_CHECK_FILES_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#define CHECK_FILE_SIZE 1024U

/** Opens the file `path`, which begins with a slash, below `root`; NULL when it cannot. */
FILE *check_open(const char *root, const char *path);

/**
 * Reads the first line of a file, without its end; "" when none exists.
 *
 * @return false when the file cannot be read
 */
bool check_read(const char *root, const char *path, char text[CHECK_FILE_SIZE]);

/** Whether a list of cores ("0-2,5") has `core`. */
bool check_list_has(const char *list, uint32_t core);

/** Whether a mask of cores ("3", "ff,ffffffff") has `core`. */
bool check_mask_has(const char *mask, uint32_t core);

#endif

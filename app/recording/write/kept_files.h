/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The recordings that a black box has written, and whether they are still there as it left them.
 */
#ifndef BORESIGHT_KEPT_FILES_H
#define BORESIGHT_KEPT_FILES_H

#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

/** A file that was begun, as it is found as long as no other program touches it. */
typedef struct {
    uint64_t started_us; /**< In its name, as its number. */
    uint32_t number;
    uint32_t first_cycle;
    uint32_t end_cycle;   /**< The cycle after its last one. */
    uint32_t kept_before; /**< The cycle after the last one that the file before it has. */
    uint64_t size;        /**< Bytes that were written. */
    ino_t inode;
    dev_t device;
} kept_file_t;

typedef struct {
    kept_file_t files[LIMIT_RECORDINGS]; /**< Those that have a block, the oldest first. */
    uint32_t count;
} kept_files_t;

/** Takes the identity of the open file `descriptor`. */
void kept_file_identify(kept_file_t *self, int descriptor);

/** `path` leads to this file. `size` receives the bytes that it has now. */
bool kept_file_is_at(const kept_file_t *self, const char *path, off_t *size);

/** Removed, or not in its folder any more, where the series is looked for, or shorter than it was
 * left, as by a shell that empties it. */
bool kept_file_is_gone(const kept_file_t *self, const char *directory);

/** Adds the newest file; without room the oldest is forgotten. */
void kept_files_add(kept_files_t *self, const kept_file_t *file);

/**
 * Forgets those that are gone from `directory`. `kept_until`, the cycle after the last one that is
 * kept, goes back with them; NULL where it stays.
 *
 * @return the cycles of those that are gone
 */
uint32_t kept_files_forget_gone(kept_files_t *self, const char *directory, uint32_t *kept_until);

#endif

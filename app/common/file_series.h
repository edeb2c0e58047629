/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Files that are written one after the other, the oldest of which are removed:
 * PREFIX<number>-<UTC>SUFFIX. The number gives the order of age, as the clock may be set back.
 */
#ifndef BORESIGHT_FILE_SERIES_H
#define BORESIGHT_FILE_SERIES_H

#include <dirent.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define FILE_SERIES_PATH_SIZE 512U
#define FILE_SERIES_NAME_SIZE 65U /**< Size of a name, with its end. */

typedef struct {
    const char *prefix; /**< Ends with its only hyphen. */
    const char *suffix;
    uint32_t files; /**< How many are kept. */
    uint64_t bytes; /**< They are fewer than these together. */
} file_series_t;

/** Series of the recordings of all cycles: blackbox-000001-20261122T175000Z.bsr. */
extern const file_series_t file_series_recordings;

/** Series of the logs of events: events-000001-20261122T175000Z.log. */
extern const file_series_t file_series_logs;

/** Whether a file of this name is one of the series. Such a name is short and has nothing but
 * letters, digits, hyphens and points. */
bool file_series_has(const file_series_t *self, const char *name);

/** The number in a name of any series; 0: it has none, or none that a next one may follow. */
uint32_t file_series_number(const char *name);

/** The same, however large it is; the largest of all for one that does not fit. */
uint64_t file_series_any_number(const char *name);

/** Writes the path of a new one. */
void file_series_path(const file_series_t *self, const char *directory, uint32_t number,
                      uint64_t utc_us, char path[FILE_SERIES_PATH_SIZE]);

/** Finds the one with `number`. False: none exists. */
bool file_series_find(const file_series_t *self, const char *directory, uint32_t number,
                      char path[FILE_SERIES_PATH_SIZE]);

/**
 * The names in `directory`, the oldest first, those without a number before all others.
 *
 * @param entries  set to the list, to be given back by file_series_forget()
 * @return their number; 0 when there is no such directory
 */
uint32_t file_series_list(const file_series_t *self, const char *directory,
                          struct dirent ***entries);
void file_series_forget(struct dirent **entries, uint32_t count);

/** The number of the newest; 0 when none exists. */
uint32_t file_series_newest(const file_series_t *self, const char *directory);

/**
 * Removes the oldest until few enough are left; those without a number are the oldest. `present`, a
 * path, stays in any case.
 *
 * @return the bytes of those that are left
 *
 * @satisfies SWR-REC-007
 * @satisfies SWR-EVENT-008
 */
uint64_t file_series_remove_oldest(const file_series_t *self, const char *directory,
                                   const char *present);

#endif

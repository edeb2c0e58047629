/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Files that the recorder has left in its folder, for reading. A name that a client sends is looked
 * for among them and opens nothing by itself; links, pipes and folders are not among them.
 */
#ifndef BORESIGHT_ARCHIVE_FOLDER_H
#define BORESIGHT_ARCHIVE_FOLDER_H

#include "common/file_series.h"
#include "common/log_entry.h"
#include "common/utc_text.h"
#include "recording/format/recording.h"

#include <stdbool.h>
#include <stdint.h>

/** A file to be sent. */
typedef struct {
    int file; /**< -1: none exists. */
    char name[FILE_SERIES_NAME_SIZE];
    uint64_t bytes;       /**< Its whole bytes, from its beginning. */
    uint64_t modified_ns; /**< UTC since 1970. */
} archive_file_t;

typedef struct {
    char name[FILE_SERIES_NAME_SIZE];
    uint64_t bytes;      /**< Those that are whole. */
    bool is_known;       /**< It begins as a recording of this format: */
    uint64_t started_us; /**< UTC since 1970. */
    char robot[16];      /**< As it stands there: any bytes. */
    bool is_present;     /**< It is being written. */
} archive_recording_t;

typedef struct {
    char name[FILE_SERIES_NAME_SIZE];
    uint64_t bytes;
    bool has_lines;
    uint64_t first_us; /**< UTC of its first line. */
    uint64_t last_us;  /**< The same of its last one. */
    bool is_present;   /**< It is being written. */
} archive_log_t;

/**
 * Opens the file of `series` that is called `name`, for reading.
 *
 * @param present  number of the one that is being written, 0: none; of that recording only whole
 *                 blocks are there
 * @return false: none exists, `self->file` is -1
 *
 * @satisfies SWR-HTTP-047
 * @satisfies SWR-REC-015
 * @satisfies SWR-REC-016
 */
bool archive_open(archive_file_t *self, const char *directory, const file_series_t *series,
                  const char *name, uint32_t present);

/** The same of the one with this number. */
bool archive_open_number(archive_file_t *self, const char *directory, const file_series_t *series,
                         uint32_t number);

void archive_close(archive_file_t *self);

/**
 * Lists the newest recordings first, at most `most`.
 *
 * @param present  number of the one that is being written; 0: none
 * @return their number
 *
 * @satisfies SWR-REC-017
 */
uint32_t archive_list_recordings(const char *directory, uint32_t present,
                                 archive_recording_t *recordings, uint32_t most);

/** The same of the logs. */
uint32_t archive_list_logs(const char *directory, uint32_t present, archive_log_t *logs,
                           uint32_t most);

#endif

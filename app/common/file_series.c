/* SPDX-License-Identifier: Apache-2.0 */
#include "common/file_series.h"

#include "limits/requirement_limits.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define MEGABYTE UINT64_C(1000000)
#define LETTERS                                                                                    \
    "0123456789"                                                                                   \
    "abcdefghijklmnopqrstuvwxyz"                                                                   \
    "ABCDEFGHIJKLMNOPQRSTUVWXYZ"                                                                   \
    "-."

const file_series_t file_series_recordings = {.prefix = "blackbox-",
                                              .suffix = ".bsr",
                                              .files = LIMIT_RECORDINGS,
                                              .bytes = LIMIT_RECORDINGS_MB * MEGABYTE};
const file_series_t file_series_logs = {.prefix = "events-",
                                        .suffix = ".log",
                                        .files = LIMIT_EVENT_LOGS,
                                        .bytes = LIMIT_EVENT_LOGS_MB * MEGABYTE};

bool file_series_has(const file_series_t *self, const char *name)
{
    const size_t length = strlen(name);
    const size_t before = strlen(self->prefix);
    const size_t after = strlen(self->suffix);

    return (length > (before + after)) && (length < FILE_SERIES_NAME_SIZE) &&
           (strncmp(name, self->prefix, before) == 0) &&
           (strcmp(&name[length - after], self->suffix) == 0) && (strspn(name, LETTERS) == length);
}

/* One of an older build has none: its name begins with its date. */
uint64_t file_series_any_number(const char *name)
{
    const char *hyphen = strchr(name, '-');
    char *end = NULL;
    const unsigned long long number = (hyphen != NULL) ? strtoull(&hyphen[1], &end, 10) : 0U;

    return ((hyphen != NULL) && (*end == '-')) ? (uint64_t)number : 0U;
}

uint32_t file_series_number(const char *name)
{
    const uint64_t number = file_series_any_number(name);

    return (number < UINT32_MAX) ? (uint32_t)number : 0U;
}

void file_series_path(const file_series_t *self, const char *directory, uint32_t number,
                      uint64_t utc_us, char path[FILE_SERIES_PATH_SIZE])
{
    const time_t seconds = (time_t)(utc_us / UINT64_C(1000000));
    struct tm utc;
    char stamp[32];

    (void)gmtime_r(&seconds, &utc);
    (void)strftime(stamp, sizeof stamp, "%Y%m%dT%H%M%SZ", &utc);
    (void)snprintf(path, FILE_SERIES_PATH_SIZE, "%s/%s%06u-%s%s", directory, self->prefix,
                   (unsigned)number, stamp, self->suffix);
}

static int by_age(const struct dirent **one, const struct dirent **other)
{
    const uint32_t first = file_series_number((*one)->d_name);
    const uint32_t second = file_series_number((*other)->d_name);

    if (first != second) {
        return (first < second) ? -1 : 1;
    }
    return strcmp((*one)->d_name, (*other)->d_name);
}

uint32_t file_series_list(const file_series_t *self, const char *directory,
                          struct dirent ***entries)
{
    uint32_t kept = 0U;

    *entries = NULL;
    const int count = scandir(directory, entries, NULL, by_age);
    for (int i = 0; i < count; i++) {
        if (file_series_has(self, (*entries)[i]->d_name)) {
            (*entries)[kept] = (*entries)[i];
            kept++;
        } else {
            free((*entries)[i]);
        }
    }
    return kept;
}

void file_series_forget(struct dirent **entries, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        free(entries[i]);
    }
    free(entries);
}

bool file_series_find(const file_series_t *self, const char *directory, uint32_t number,
                      char path[FILE_SERIES_PATH_SIZE])
{
    struct dirent **entries;
    const uint32_t count = file_series_list(self, directory, &entries);
    bool is_found = false;

    for (uint32_t i = 0U; (i < count) && !is_found; i++) {
        is_found = file_series_number(entries[i]->d_name) == number;
        (void)snprintf(path, FILE_SERIES_PATH_SIZE, "%s/%s", directory, entries[i]->d_name);
    }
    file_series_forget(entries, count);
    return is_found;
}

uint32_t file_series_newest(const file_series_t *self, const char *directory)
{
    struct dirent **entries;
    const uint32_t count = file_series_list(self, directory, &entries);
    const uint32_t newest = (count > 0U) ? file_series_number(entries[count - 1U]->d_name) : 0U;

    file_series_forget(entries, count);
    return newest;
}

static uint64_t size_of(const char *path)
{
    struct stat status;

    return (stat(path, &status) == 0) ? (uint64_t)status.st_size : 0U;
}

uint64_t file_series_remove_oldest(const file_series_t *self, const char *directory,
                                   const char *present)
{
    struct dirent **entries;
    const uint32_t count = file_series_list(self, directory, &entries);
    uint64_t used = 0U;
    uint64_t left = 0U;
    uint32_t kept = 0U;

    for (uint32_t i = count; i > 0U; i--) { /* The newest first. */
        char path[FILE_SERIES_PATH_SIZE];
        (void)snprintf(path, sizeof path, "%s/%s", directory, entries[i - 1U]->d_name);
        const uint64_t size = size_of(path);
        used += size;
        kept++;
        if (((kept > self->files) || (used >= self->bytes)) && (strcmp(path, present) != 0)) {
            (void)unlink(path);
        } else {
            left += size;
        }
    }
    file_series_forget(entries, count);
    return left;
}

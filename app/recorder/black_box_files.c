/* SPDX-License-Identifier: Apache-2.0 */
#include "recorder/black_box_files.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define PATH_SIZE 512U
#define PREFIX "blackbox-"
#define PREFIX_LENGTH (sizeof PREFIX - 1U)

void black_box_name(char *path, size_t size, const char *directory, uint32_t number,
                    uint64_t utc_us)
{
    const time_t seconds = (time_t)(utc_us / UINT64_C(1000000));
    struct tm utc;
    char stamp[32];

    (void)gmtime_r(&seconds, &utc);
    (void)strftime(stamp, sizeof stamp, "%Y%m%dT%H%M%SZ", &utc);
    (void)snprintf(path, size, "%s/blackbox-%06u-%s.bsr", directory, (unsigned)number, stamp);
}

static int is_recording(const struct dirent *entry)
{
    const size_t length = strlen(entry->d_name);

    return ((strncmp(entry->d_name, PREFIX, PREFIX_LENGTH) == 0) && (length > 4U) &&
            (strcmp(&entry->d_name[length - 4U], ".bsr") == 0))
               ? 1
               : 0;
}

/* 0: it has none, such as one of an older build, whose name begins with its date, or one that no
 * number follows. */
static uint32_t number_of(const char *name)
{
    char *end = NULL;
    const unsigned long number = strtoul(&name[PREFIX_LENGTH], &end, 10);

    return ((number < UINT32_MAX) && (*end == '-')) ? (uint32_t)number : 0U;
}

static int by_age(const struct dirent **one, const struct dirent **other)
{
    const uint32_t first = number_of((*one)->d_name);
    const uint32_t second = number_of((*other)->d_name);

    if (first != second) {
        return (first < second) ? -1 : 1;
    }
    return strcmp((*one)->d_name, (*other)->d_name);
}

uint32_t black_box_newest(const char *directory)
{
    struct dirent **entries = NULL;
    const int count = scandir(directory, &entries, is_recording, by_age);
    const uint32_t newest = (count > 0) ? number_of(entries[count - 1]->d_name) : 0U;

    for (int i = 0; i < count; i++) {
        free(entries[i]);
    }
    free(entries);
    return newest;
}

static uint64_t size_of(const char *directory, const char *name)
{
    char path[PATH_SIZE];
    struct stat status;

    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    return (stat(path, &status) == 0) ? (uint64_t)status.st_size : 0U;
}

void black_box_remove_oldest(const char *directory, const char *present, uint32_t files,
                             uint64_t bytes)
{
    struct dirent **entries = NULL;
    const int count = scandir(directory, &entries, is_recording, by_age);
    uint64_t used = 0U;
    uint32_t kept = 0U;

    for (int i = count - 1; i >= 0; i--) { /* The newest first. */
        used += size_of(directory, entries[i]->d_name);
        kept++;
        char path[PATH_SIZE];
        (void)snprintf(path, sizeof path, "%s/%s", directory, entries[i]->d_name);
        if (((kept > files) || (used >= bytes)) && (strcmp(path, present) != 0)) {
            (void)unlink(path);
        }
        free(entries[i]);
    }
    free(entries);
}

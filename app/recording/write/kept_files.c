/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/kept_files.h"

#include "common/file_series.h"

#include <errno.h>
#include <stddef.h>
#include <string.h>
#include <sys/stat.h>

void kept_file_identify(kept_file_t *self, int descriptor)
{
    struct stat status;

    (void)memset(&status, 0, sizeof status);
    (void)fstat(descriptor, &status);
    self->inode = status.st_ino;
    self->device = status.st_dev;
}

static bool is_same(const kept_file_t *self, const struct stat *found)
{
    return (found->st_ino == self->inode) && (found->st_dev == self->device);
}

bool kept_file_is_at(const kept_file_t *self, const char *path, off_t *size)
{
    struct stat found;

    if ((stat(path, &found) != 0) || !is_same(self, &found)) {
        return false;
    }
    *size = found.st_size;
    return true;
}

bool kept_file_is_gone(const kept_file_t *self, const char *directory)
{
    char path[FILE_SERIES_PATH_SIZE];
    struct stat found;

    file_series_path(&file_series_recordings, directory, self->number, self->started_us, path);
    if (stat(path, &found) != 0) {
        return (errno == ENOENT) || (errno == ENOTDIR);
    }
    return !is_same(self, &found) || ((uint64_t)found.st_size < self->size);
}

static void forget(kept_files_t *self, uint32_t i)
{
    self->count--;
    (void)memmove(&self->files[i], &self->files[i + 1U], (self->count - i) * sizeof self->files[0]);
}

/* There is room, unless old recordings could not be removed. */
void kept_files_add(kept_files_t *self, const kept_file_t *file)
{
    if (self->count == LIMIT_RECORDINGS) {
        forget(self, 0U);
    }
    self->files[self->count] = *file;
    self->count++;
}

/* The next file says what it lacks since the last one that is still there, so the newest comes
 * first. */
uint32_t kept_files_forget_gone(kept_files_t *self, const char *directory, uint32_t *kept_until)
{
    uint32_t cycles = 0U;

    for (uint32_t i = self->count; i > 0U; i--) {
        const kept_file_t *file = &self->files[i - 1U];
        if (kept_file_is_gone(file, directory)) {
            cycles += file->end_cycle - file->first_cycle;
            if ((kept_until != NULL) && (*kept_until == file->end_cycle)) {
                *kept_until = file->kept_before;
            }
            forget(self, i - 1U);
        }
    }
    return cycles;
}

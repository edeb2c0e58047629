/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/run.h"

#include "common/file_series.h"
#include "recording/format/recording.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define NAME_SIZE (4U * (NAME_MAX + 1U))

/* The beginning of a file. */
typedef struct {
    uint8_t header[RECORDING_HEADER_SIZE];
    uint8_t fields[RECORDING_FIELDS_SIZE];
} head_t;

static int is_recording(const struct dirent *entry)
{
    const size_t length = strlen(entry->d_name);
    const size_t end = strlen(file_series_recordings.suffix);

    return (length > end) &&
           (strcmp(&entry->d_name[length - end], file_series_recordings.suffix) == 0);
}

static void leave_out(const char *name, const char *why, FILE *notes)
{
    char escaped[NAME_SIZE];

    recording_escape(name, escaped, sizeof escaped);
    (void)fprintf(notes, "%s is left out: %s.\n", escaped, why);
}

/* Number of bytes of its beginning that exist; -1: it cannot be read. */
static ssize_t read_head(const char *path, head_t *head)
{
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    struct stat status;
    ssize_t size = -1;

    if (file < 0) {
        return -1;
    }
    if (fstat(file, &status) == 0) {
        errno = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
        size = S_ISREG(status.st_mode) ? pread(file, head, sizeof *head, 0) : -1;
    }
    const int reason = errno;
    (void)close(file);
    errno = reason;
    return size;
}

/* Fields that are damaged stand first, so that it is opened, and its damage said. */
static bool take_fields(run_file_t *self, const head_t *head)
{
    recording_fields_t fields;
    const bool are_right = recording_decode_fields(head->fields, &fields);

    self->first = are_right ? fields.cycle : 0U;
    return !are_right || (fields.magic == RECORDING_BLOCK_MAGIC);
}

/* False after saying why it is of no run. */
static bool take_file(run_file_t *self, const char *name, FILE *notes)
{
    head_t head;
    recording_header_t header;
    const ssize_t size = read_head(self->path, &head);

    self->number = file_series_any_number(name);
    if (size < 0) {
        leave_out(name, strerror(errno), notes);
        return false;
    }
    const uint32_t version =
        ((size_t)size >= sizeof head.header) ? recording_decode_header(head.header, &header) : 0U;
    self->run = (version == RECORDING_VERSION) ? header.run : 0U;
    if (version == 0U) {
        leave_out(name, "it is no recording, or its header was changed or damaged", notes);
    } else if (version != RECORDING_VERSION) {
        leave_out(name, "it is of another version of the format", notes);
    } else if (((size_t)size < sizeof head) || !take_fields(self, &head)) {
        leave_out(name, "it holds no cycle", notes);
    } else {
        return true;
    }
    return false;
}

static char *new_path(const char *folder, const char *name)
{
    const size_t size = strlen(folder) + strlen(name) + sizeof "/";
    char *const path = malloc(size);

    if (path == NULL) {
        abort();
    }
    (void)snprintf(path, size, "%s/%s", folder, name);
    return path;
}

static run_file_t *new_files(size_t most)
{
    run_file_t *const files = calloc(most, sizeof *files);

    if (files == NULL) {
        abort();
    }
    return files;
}

static int by_place(const void *one, const void *other)
{
    const run_file_t *const a = one;
    const run_file_t *const b = other;

    if (a->run != b->run) {
        return (a->run < b->run) ? -1 : 1;
    }
    if (a->first != b->first) {
        return (a->first < b->first) ? -1 : 1;
    }
    return strcmp(a->path, b->path);
}

/* All recordings there, run by run. */
static bool list(run_t *self, const char *folder, FILE *notes)
{
    struct dirent **entries = NULL;
    const int count = scandir(folder, &entries, is_recording, alphasort);

    if (count < 0) {
        (void)fprintf(stderr, "%s cannot be read (%s).\n", folder, strerror(errno));
        return false;
    }
    self->files = new_files((size_t)count + 1U);
    self->left_out = new_files((size_t)count + 1U);
    for (int i = 0; i < count; i++) {
        run_file_t file = {.path = new_path(folder, entries[i]->d_name)};
        if (take_file(&file, entries[i]->d_name, notes)) {
            self->files[self->count] = file;
            self->count++;
        } else {
            self->left_out[self->left_out_count] = file;
            self->left_out_count++;
        }
        free(entries[i]);
    }
    free(entries);
    qsort(self->files, self->count, sizeof self->files[0], by_place);
    return true;
}

static bool has_name(const run_file_t *file, const char *name)
{
    char own[RECORDING_RUN_SIZE];

    recording_run_name(file->run, own);
    return (name == NULL) || (strncmp(own, name, strlen(name)) == 0);
}

/* The newest of these files; NULL: none exists. */
static const run_file_t *find_newest(const run_t *self, const char *name)
{
    const run_file_t *newest = NULL;

    for (uint32_t i = 0U; i < self->count; i++) {
        const run_file_t *const file = &self->files[i];
        if (has_name(file, name) && ((newest == NULL) || (file->number >= newest->number))) {
            newest = file;
        }
    }
    return newest;
}

/* False after naming what was left out and may be of a newer run. */
static bool is_newest_known(const run_t *self, const run_file_t *newest, const char *folder)
{
    bool is_known = true;

    for (uint32_t i = 0U; i < self->left_out_count; i++) {
        const run_file_t *const file = &self->left_out[i];
        if ((file->number >= newest->number) && (file->run != newest->run)) {
            char escaped[NAME_SIZE];
            recording_escape(&file->path[strlen(folder) + 1U], escaped, sizeof escaped);
            (void)fprintf(stderr,
                          "%s is newer than all recordings that can be read; name the run with "
                          "--run NAME.\n",
                          escaped);
            is_known = false;
        }
    }
    return is_known;
}

/* Names all runs but one. */
static void name_runs(const run_t *self, const run_file_t *but, const char *before, FILE *notes)
{
    bool is_first = true;
    char name[RECORDING_RUN_SIZE];

    for (uint32_t i = 0U; i < self->count; i++) {
        const uint64_t run = self->files[i].run;
        const bool is_next = (i == 0U) || (run != self->files[i - 1U].run);
        if (is_next && ((but == NULL) || (run != but->run))) {
            recording_run_name(run, name);
            (void)fprintf(notes, "%s%s", is_first ? before : ", ", name);
            is_first = false;
        }
    }
    (void)fprintf(notes, "%s", is_first ? "" : ".\n");
}

/* Keeps only those of the run. */
static void keep(run_t *self, uint64_t run)
{
    uint32_t kept = 0U;

    for (uint32_t i = 0U; i < self->count; i++) {
        if (self->files[i].run == run) {
            self->files[kept] = self->files[i];
            kept++;
        } else {
            free(self->files[i].path);
        }
    }
    self->count = kept;
}

bool run_find(run_t *self, const char *folder, const char *name, FILE *notes)
{
    if (!list(self, folder, notes)) {
        return false;
    }
    const run_file_t *const newest = find_newest(self, name);
    if ((newest != NULL) && (name == NULL) && !is_newest_known(self, newest, folder)) {
        name_runs(self, NULL, "The runs there: ", stderr);
        return false;
    }
    if (newest != NULL) {
        name_runs(self, newest, "Other runs there, which --run NAME replays: ", notes);
        keep(self, newest->run);
        return true;
    }
    (void)fprintf(stderr, "%s holds no recording%s%s.\n", folder, (name != NULL) ? " of run " : "",
                  (name != NULL) ? name : "");
    name_runs(self, NULL, "The runs there: ", stderr);
    return false;
}

void run_free(run_t *self)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        free(self->files[i].path);
    }
    for (uint32_t i = 0U; i < self->left_out_count; i++) {
        free(self->left_out[i].path);
    }
    free(self->files);
    free(self->left_out);
    (void)memset(self, 0, sizeof *self);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/archive/archive_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define TAIL_BYTES (2U * LOG_ENTRY_LINE_SIZE) /* Tail of a log; its last line is in it. */

static bool read_at(int file, uint64_t offset, void *bytes, size_t size)
{
    return pread(file, bytes, size, (off_t)offset) == (ssize_t)size;
}

/* Up to where the recording has whole blocks: the next one may just be written. */
static uint64_t whole_bytes(int file, uint64_t size)
{
    uint8_t bytes[RECORDING_FIELDS_SIZE];
    recording_fields_t fields;
    uint64_t end = RECORDING_HEADER_SIZE;

    if (size < RECORDING_HEADER_SIZE) {
        return 0U;
    }
    while (read_at(file, end, bytes, sizeof bytes) && recording_decode_fields(bytes, &fields)) {
        const uint64_t next = end + RECORDING_PREFIX_SIZE +
                              recording_checksums_size(fields.compressed_size) +
                              fields.compressed_size;
        if (next > size) {
            break;
        }
        end = next;
    }
    return end;
}

/* Takes the file over; closes it if it is none to be read. */
static bool take(archive_file_t *self, int file, const char *name, bool is_present_recording)
{
    struct stat status;

    self->file = file;
    if ((file < 0) || (fstat(file, &status) != 0) || !S_ISREG(status.st_mode)) {
        archive_close(self);
        return false;
    }
    (void)snprintf(self->name, sizeof self->name, "%.*s", (int)sizeof self->name - 1, name);
    self->bytes = (uint64_t)status.st_size;
    if (is_present_recording) {
        self->bytes = whole_bytes(file, self->bytes);
    }
    self->modified_ns =
        ((uint64_t)status.st_mtim.tv_sec * UINT64_C(1000000000)) + (uint64_t)status.st_mtim.tv_nsec;
    return true;
}

/* The files of a series, the newest first. */
typedef struct {
    const file_series_t *series;
    uint32_t present;
    int folder;
    struct dirent **entries;
    uint32_t count;
    uint32_t left;
} walk_t;

static void begin_walk(walk_t *walk, const char *directory, const file_series_t *series,
                       uint32_t present)
{
    walk->series = series;
    walk->present = present;
    walk->folder = open(directory, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    walk->count = file_series_list(series, directory, &walk->entries);
    walk->left = walk->count;
}

static const struct dirent *next_of(walk_t *walk)
{
    walk->left--;
    return walk->entries[walk->left];
}

static void end_walk(walk_t *walk)
{
    file_series_forget(walk->entries, walk->count);
    if (walk->folder >= 0) {
        (void)close(walk->folder);
    }
}

static bool is_present(const walk_t *walk, const char *name)
{
    return (walk->present != 0U) && (file_series_number(name) == walk->present);
}

static bool open_entry(archive_file_t *self, const walk_t *walk, const struct dirent *entry)
{
    const int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;

    return take(self, openat(walk->folder, entry->d_name, flags), entry->d_name,
                (walk->series == &file_series_recordings) && is_present(walk, entry->d_name));
}

bool archive_open(archive_file_t *self, const char *directory, const file_series_t *series,
                  const char *name, uint32_t present)
{
    walk_t walk;
    bool is_open = false;

    self->file = -1;
    begin_walk(&walk, directory, series, present);
    while ((walk.left > 0U) && !is_open) {
        const struct dirent *entry = next_of(&walk);
        is_open = (strcmp(entry->d_name, name) == 0) && open_entry(self, &walk, entry);
    }
    end_walk(&walk);
    return is_open;
}

bool archive_open_number(archive_file_t *self, const char *directory, const file_series_t *series,
                         uint32_t number)
{
    walk_t walk;
    bool is_open = false;

    self->file = -1;
    begin_walk(&walk, directory, series, 0U);
    while ((walk.left > 0U) && !is_open) {
        const struct dirent *entry = next_of(&walk);
        is_open = (file_series_number(entry->d_name) == number) && open_entry(self, &walk, entry);
    }
    end_walk(&walk);
    return is_open;
}

void archive_close(archive_file_t *self)
{
    if (self->file >= 0) {
        (void)close(self->file);
    }
    self->file = -1;
}

static void describe_recording(const archive_file_t *opened, archive_recording_t *recording)
{
    uint8_t bytes[RECORDING_HEADER_SIZE];
    recording_header_t header = {.started_us = 0U};

    (void)memset(recording, 0, sizeof *recording);
    (void)memcpy(recording->name, opened->name, sizeof recording->name);
    recording->bytes = opened->bytes;
    recording->is_known = read_at(opened->file, 0U, bytes, sizeof bytes) &&
                          (recording_decode_header(bytes, &header) == RECORDING_VERSION);
    recording->started_us = header.started_us;
    (void)memcpy(recording->robot, header.robot, sizeof recording->robot);
}

uint32_t archive_list_recordings(const char *directory, uint32_t present,
                                 archive_recording_t *recordings, uint32_t most)
{
    walk_t walk;
    archive_file_t opened;
    uint32_t listed = 0U;

    begin_walk(&walk, directory, &file_series_recordings, present);
    while ((walk.left > 0U) && (listed < most)) {
        if (open_entry(&opened, &walk, next_of(&walk))) {
            describe_recording(&opened, &recordings[listed]);
            recordings[listed].is_present = is_present(&walk, opened.name);
            archive_close(&opened);
            listed++;
        }
    }
    end_walk(&walk);
    return listed;
}

/* The time with which a line begins. */
static bool read_time(const char *line, uint64_t *utc_us)
{
    char when[UTC_TEXT_SIZE];

    (void)snprintf(when, sizeof when, "%s", line);
    return utc_text_read(when, utc_us);
}

/* The last line may just be written, or be cut off. */
static bool read_last_time(const archive_file_t *opened, uint64_t *utc_us)
{
    char tail[TAIL_BYTES + 1U];
    const size_t size = (opened->bytes < TAIL_BYTES) ? (size_t)opened->bytes : TAIL_BYTES;
    bool is_found = false;

    if (!read_at(opened->file, opened->bytes - size, tail, size)) {
        return false;
    }
    tail[size] = '\0';
    const char *line = (size == opened->bytes) ? tail : strchr(tail, '\n');
    while (line != NULL) {
        line = &line[(*line == '\n') ? 1U : 0U];
        is_found = read_time(line, utc_us) || is_found;
        line = strchr(line, '\n');
    }
    return is_found;
}

static void describe_log(const archive_file_t *opened, archive_log_t *log)
{
    char head[UTC_TEXT_SIZE] = "";

    (void)memset(log, 0, sizeof *log);
    (void)memcpy(log->name, opened->name, sizeof log->name);
    log->bytes = opened->bytes;
    log->has_lines = read_at(opened->file, 0U, head, sizeof head - 1U) &&
                     read_time(head, &log->first_us) && read_last_time(opened, &log->last_us);
}

uint32_t archive_list_logs(const char *directory, uint32_t present, archive_log_t *logs,
                           uint32_t most)
{
    walk_t walk;
    archive_file_t opened;
    uint32_t listed = 0U;

    begin_walk(&walk, directory, &file_series_logs, present);
    while ((walk.left > 0U) && (listed < most)) {
        if (open_entry(&opened, &walk, next_of(&walk))) {
            describe_log(&opened, &logs[listed]);
            logs[listed].is_present = is_present(&walk, opened.name);
            archive_close(&opened);
            listed++;
        }
    }
    end_walk(&walk);
    return listed;
}

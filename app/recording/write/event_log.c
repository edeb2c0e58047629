/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/event_log.h"

#include "common/clock.h"
#include "common/directory.h"
#include "common/file_series.h"
#include "common/log_entry.h"
#include "common/utc_text.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define BATCH 64U
#define FILE_MODE 0640
#define FULL (LIMIT_EVENT_LOG_MB * UINT64_C(1000000))

/* A number is used only if its file is made here. */
static int make_file(const char *directory, uint32_t *number, char path[FILE_SERIES_PATH_SIZE])
{
    int file;

    (void)directory_make(directory);
    *number = file_series_newest(&file_series_logs, directory);
    do {
        (*number)++;
        file_series_path(&file_series_logs, directory, *number, clock_utc_us(), path);
        file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, FILE_MODE);
    } while ((file < 0) && (errno == EEXIST));
    return file;
}

static void note_place(const event_log_t *self)
{
    exchange_note_file(self->exchange, EXCHANGE_FILE_LOG, self->number);
    exchange_note_file(self->exchange, EXCHANGE_FILE_LOG_BEFORE, self->number_before);
    exchange_note_logged(self->exchange, self->next);
}

/* Events that are not in the log wait in the exchange. */
static void fail(event_log_t *self)
{
    if (!self->is_failing) {
        (void)fprintf(stderr,
                      "recorder: the event log in %s cannot be written (%s); free space there, or "
                      "make it a folder that can be written. The last %u events wait in memory.\n",
                      self->directory, strerror(errno), EXCHANGE_EVENTS);
    }
    self->is_failing = true;
}

static void recover(event_log_t *self)
{
    if (self->is_failing) {
        (void)fprintf(stderr, "recorder: the event log goes on in %s.\n", self->path);
        self->is_failing = false;
    }
}

/* Old logs make room only for one that exists. */
static bool begin(event_log_t *self)
{
    char path[FILE_SERIES_PATH_SIZE];
    uint32_t number;
    const int file = make_file(self->directory, &number, path);

    if (file < 0) {
        return false;
    }
    self->file = file;
    (void)memcpy(self->path, path, sizeof self->path);
    self->size = 0U;
    self->severity = (uint32_t)EVENT_SEVERITY_INFORMATION;
    self->number_before = self->number;
    self->number = number;
    note_place(self);
    (void)file_series_remove_oldest(&file_series_logs, self->directory, path);
    return true;
}

/* The recorder before may have died before it took back half a line. */
static uint64_t whole_lines(int file, uint64_t size)
{
    char end[LOG_ENTRY_LINE_SIZE];
    const uint64_t from = (size > sizeof end) ? (size - sizeof end) : 0U;
    const ssize_t count = pread(file, end, sizeof end, (off_t)from);

    for (ssize_t i = count; i > 0; i--) {
        if (end[i - 1] == '\n') {
            return from + (uint64_t)i;
        }
    }
    return (from > 0U) ? size : 0U;
}

/* Continues the file that the recorder before has begun in this run. */
static bool go_on(event_log_t *self)
{
    char *const path = self->path;
    struct stat status;

    if ((self->number == 0U) ||
        !file_series_find(&file_series_logs, self->directory, self->number, path)) {
        return false;
    }
    const int file = open(path, O_RDWR | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if ((file < 0) || (fstat(file, &status) != 0) || !S_ISREG(status.st_mode)) {
        (void)close(file);
        return false;
    }
    self->file = file;
    self->size = whole_lines(file, (uint64_t)status.st_size);
    if (self->size < (uint64_t)status.st_size) {
        (void)!ftruncate(file, (off_t)self->size);
    }
    return true;
}

/* Twice in the log is better than not at all. */
static void find_next(event_log_t *self)
{
    self->next = exchange_logged(self->exchange);
    if ((self->next == 0U) && (self->size > 0U)) {
        self->next = exchange_oldest_event(self->exchange);
        (void)fprintf(stderr,
                      "recorder: the number of the last event in the log is not known; events from "
                      "%u on may be there twice.\n",
                      (unsigned)self->next);
    }
}

/* Without a place for another its events are worth more than the bound. */
static void change_file(event_log_t *self)
{
    const int full = self->file;

    if (begin(self)) {
        (void)fdatasync(full);
        (void)close(full);
    }
}

void event_log_open(event_log_t *self, const char *directory, exchange_t *exchange)
{
    (void)memset(self, 0, sizeof *self);
    self->directory = directory;
    self->exchange = exchange;
    self->file = -1;
    self->number = exchange_file(exchange, EXCHANGE_FILE_LOG);
    self->number_before = exchange_file(exchange, EXCHANGE_FILE_LOG_BEFORE);
    self->next = exchange_logged(exchange);
    if (!go_on(self) && !begin(self)) {
        fail(self);
    }
    find_next(self);
}

/* A write that ends early has found no more room; half a line is taken back. */
static bool append(event_log_t *self, const char *line, size_t size)
{
    const ssize_t count = write(self->file, line, size);
    const int reason = (count < 0) ? errno : ENOSPC;

    if (count == (ssize_t)size) {
        self->is_dirty = true;
        self->size += size;
        return true;
    }
    if (count > 0) {
        (void)!ftruncate(self->file, (off_t)self->size);
    }
    errno = reason;
    return false;
}

static bool write_line(event_log_t *self, const char *line)
{
    const size_t size = strlen(line);

    if (self->file < 0) {
        return false;
    }
    if ((self->size + size) > FULL) {
        change_file(self);
    }
    if (!append(self, line, size)) {
        fail(self);
        return false;
    }
    recover(self);
    return true;
}

static bool write_event(event_log_t *self, const exchange_event_t *event)
{
    log_entry_t entry;
    char line[LOG_ENTRY_LINE_SIZE];

    if (event->event.severity < self->severity) {
        return true;
    }
    log_entry_make(&entry, self->exchange, event);
    log_entry_write(&entry, line);
    return write_line(self, line);
}

/* A line that is no event: with the number of the next one. */
static bool write_remark(event_log_t *self, const char *remark)
{
    char when[UTC_TEXT_SIZE];
    char line[LOG_ENTRY_LINE_SIZE];

    utc_text_write(clock_utc_us(), when);
    (void)snprintf(line, sizeof line, "%s %u %s\n", when, (unsigned)self->next, remark);
    return write_line(self, line);
}

/* It is in the log, or below its level. */
static void advance(event_log_t *self, uint32_t next)
{
    self->next = next;
    exchange_note_logged(self->exchange, next);
}

/* Those before `next` have no place in the exchange any more. */
static bool write_loss(event_log_t *self, uint32_t next)
{
    const uint32_t lost = next - self->next;
    char remark[64];

    if (lost == 0U) {
        return true;
    }
    (void)snprintf(remark, sizeof remark, "EVENTS_LOST value=%u", (unsigned)lost);
    if (!write_remark(self, remark)) {
        return false;
    }
    (void)fprintf(stderr, "recorder: %u events are missing in the event log, from number %u on.\n",
                  (unsigned)lost, (unsigned)self->next);
    advance(self, next);
    return true;
}

/* A file that lacks some says so. */
static bool look_at_level(event_log_t *self)
{
    exchange_log_level_t level;
    char remark[160];

    if (!exchange_read_log_level(self->exchange, &level) || (level.severity == self->severity)) {
        return true;
    }
    (void)snprintf(remark, sizeof remark,
                   "LOG_LEVEL value=%u From here on events from %s on are written, %s%s.",
                   (unsigned)level.severity, event_severity_name((int32_t)level.severity),
                   (level.by[0] != '\0') ? "set by " : "as the level was damaged", level.by);
    if (!write_remark(self, remark)) {
        return false;
    }
    self->severity = level.severity;
    return true;
}

/* Each is noted when it is written: a recorder that dies here writes at most one again. */
static bool write_next(event_log_t *self, const exchange_event_t *event)
{
    /* The level after the loss: another file may have begun. */
    const bool is_written =
        write_loss(self, event->event.number) && look_at_level(self) && write_event(self, event);

    if (is_written) {
        advance(self, event->event.number + 1U);
    }
    return is_written;
}

/* False: there are no more, or they wait in the exchange. */
static bool drain_batch(event_log_t *self)
{
    static exchange_event_t events[BATCH];
    uint32_t lost = 0U; /* Counted by the numbers: some of them may wait with those around. */
    uint32_t next = self->next;
    const uint32_t count = exchange_read_events(self->exchange, &next, events, BATCH, &lost);

    for (uint32_t i = 0U; i < count; i++) {
        if (!write_next(self, &events[i])) {
            return false;
        }
    }
    return write_loss(self, next) && (count == BATCH);
}

void event_log_drain(event_log_t *self)
{
    bool is_more = look_at_level(self);

    while (is_more) {
        is_more = drain_batch(self);
    }
    note_place(self);
}

/* Removed, or not in its folder any more, where readers look for it. */
static bool is_gone(const event_log_t *self)
{
    struct stat ours;
    struct stat found;

    if (fstat(self->file, &ours) != 0) {
        return false;
    }
    if (stat(self->path, &found) != 0) {
        return (errno == ENOENT) || (errno == ENOTDIR);
    }
    return (found.st_ino != ours.st_ino) || (found.st_dev != ours.st_dev);
}

/* Lines that are written into a removed file are lost. */
static void look_for_file(event_log_t *self)
{
    if ((self->file >= 0) && is_gone(self)) {
        (void)fprintf(stderr, "recorder: %s was removed or moved; a new event log is begun.\n",
                      self->path);
        (void)close(self->file);
        self->file = -1;
    }
}

void event_log_sync(event_log_t *self)
{
    look_for_file(self);
    if ((self->file < 0) && !begin(self)) {
        fail(self);
    } else if (self->is_dirty) {
        (void)fdatasync(self->file);
        self->is_dirty = false;
    } else {
        /* Nothing new. */
    }
}

void event_log_note_unrecorded(event_log_t *self, uint32_t cycles)
{
    char remark[96];

    (void)snprintf(remark, sizeof remark,
                   "CYCLES_UNRECORDED value=%u The last cycles of the run are in no recording.",
                   (unsigned)cycles);
    (void)write_remark(self, remark);
}

void event_log_remark(event_log_t *self, const char *remark)
{
    (void)write_remark(self, remark);
}

void event_log_close(event_log_t *self)
{
    event_log_sync(self);
    if (self->is_failing) {
        (void)fprintf(stderr, "recorder: events from number %u on are not in the event log.\n",
                      (unsigned)self->next);
    }
    if (self->file >= 0) {
        (void)close(self->file);
    }
    self->file = -1;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "recorder/event_log.h"

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

/* Whatever the number is: its file is made here, or it is not used. */
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
    self->size = 0U;
    self->severity = (uint32_t)EVENT_SEVERITY_INFORMATION;
    self->number_before = self->number;
    self->number = number;
    note_place(self);
    file_series_remove_oldest(&file_series_logs, self->directory, path);
    return true;
}

/* What the recorder before has begun in this run. */
static bool go_on(event_log_t *self)
{
    char path[FILE_SERIES_PATH_SIZE];
    struct stat status;

    if ((self->number == 0U) ||
        !file_series_find(&file_series_logs, self->directory, self->number, path)) {
        return false;
    }
    const int file = open(path, O_WRONLY | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if ((file < 0) || (fstat(file, &status) != 0) || !S_ISREG(status.st_mode)) {
        (void)close(file);
        return false;
    }
    self->file = file;
    self->size = (uint64_t)status.st_size;
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
        (void)fprintf(
            stderr,
            "recorder: the event log in %s cannot be opened (%s); events are counted only.\n",
            directory, strerror(errno));
    }
    find_next(self);
}

static void write_line(event_log_t *self, const char *line)
{
    const size_t size = strlen(line);

    if ((self->file >= 0) && ((self->size + size) > FULL)) {
        change_file(self);
    }
    if ((self->file >= 0) && (write(self->file, line, size) == (ssize_t)size)) {
        self->is_dirty = true;
        self->size += size;
        if (self->unwritten > 0U) {
            (void)fprintf(stderr, "recorder: the event log goes on; %u events are missing.\n",
                          (unsigned)self->unwritten);
            self->unwritten = 0U;
        }
    } else {
        if ((self->unwritten == 0U) && (self->file >= 0)) {
            (void)fprintf(
                stderr,
                "recorder: the event log in %s cannot be written (%s); free some space there.\n",
                self->directory, strerror(errno));
        }
        (void)!ftruncate(self->file, (off_t)self->size); /* No half a line. */
        self->unwritten++;
    }
}

static void write_event(event_log_t *self, const exchange_event_t *event)
{
    log_entry_t entry;
    char line[LOG_ENTRY_LINE_SIZE];

    if (event->event.severity < self->severity) {
        return;
    }
    log_entry_make(&entry, self->exchange, event);
    log_entry_write(&entry, line);
    write_line(self, line);
}

/* What is no event: with the number of the next one. */
static void write_remark(event_log_t *self, uint32_t next, const char *remark)
{
    char when[UTC_TEXT_SIZE];
    char line[LOG_ENTRY_LINE_SIZE];

    utc_text_write(clock_utc_us(), when);
    (void)snprintf(line, sizeof line, "%s %u %s\n", when, (unsigned)next, remark);
    write_line(self, line);
}

static void write_loss(event_log_t *self, uint32_t first, uint32_t lost)
{
    char remark[64];

    (void)snprintf(remark, sizeof remark, "EVENTS_LOST value=%u", (unsigned)lost);
    write_remark(self, first, remark);
}

/* A file that lacks some says so. */
static void look_at_level(event_log_t *self)
{
    exchange_log_level_t level;
    char remark[160];

    if (!exchange_read_log_level(self->exchange, &level) || (level.severity == self->severity)) {
        return;
    }
    (void)snprintf(remark, sizeof remark,
                   "LOG_LEVEL value=%u From here on events from %s on are written, %s%s.",
                   (unsigned)level.severity, event_severity_name((int32_t)level.severity),
                   (level.by[0] != '\0') ? "set by " : "as the level was damaged", level.by);
    write_remark(self, self->next, remark);
    self->severity = level.severity;
}

/* Each is noted when it is written: a recorder that dies here writes at most one again. */
void event_log_drain(event_log_t *self)
{
    static exchange_event_t events[BATCH];
    exchange_t *exchange = self->exchange;
    uint32_t count;

    look_at_level(self);
    do {
        uint32_t lost = 0U;
        const uint32_t first = self->next;
        uint32_t next = first;
        count = exchange_read_events(exchange, &next, events, BATCH, &lost);
        if (lost > 0U) {
            write_loss(self, first, lost);
        }
        for (uint32_t i = 0U; i < count; i++) {
            look_at_level(self); /* Another file may have begun. */
            write_event(self, &events[i]);
            self->next = events[i].event.number + 1U;
            exchange_note_logged(exchange, self->next);
        }
        self->next = next;
        note_place(self);
    } while (count == BATCH);
}

/* What is written into a removed file is nowhere. */
static void look_for_file(event_log_t *self)
{
    struct stat status;

    if ((self->file >= 0) && (fstat(self->file, &status) == 0) && (status.st_nlink == 0U)) {
        (void)fprintf(stderr, "recorder: the event log in %s was removed; a new one is begun.\n",
                      self->directory);
        (void)close(self->file);
        self->file = -1;
    }
}

void event_log_sync(event_log_t *self)
{
    look_for_file(self);
    if (self->file < 0) {
        (void)begin(self);
    } else if (self->is_dirty) {
        (void)fdatasync(self->file);
        self->is_dirty = false;
    } else {
        /* Nothing new. */
    }
}

void event_log_close(event_log_t *self)
{
    event_log_sync(self);
    if (self->file >= 0) {
        (void)close(self->file);
    }
    self->file = -1;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "recorder/event_log.h"

#include "common/directory.h"
#include "common/clock.h"
#include "common/log_entry.h"
#include "common/utc_text.h"
#include "limits/requirement_limits.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define BATCH 64U
#define FILE_MODE 0640
#define PATH_SIZE 512U
#define FULL (LIMIT_EVENT_LOG_MB * UINT64_C(1000000))

static bool reopen(event_log_t *self)
{
    char path[PATH_SIZE];
    struct stat status;

    (void)snprintf(path, sizeof path, "%s/events.log", self->directory);
    (void)directory_make(self->directory);
    self->file = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, FILE_MODE);
    self->size =
        ((self->file >= 0) && (fstat(self->file, &status) == 0)) ? (uint64_t)status.st_size : 0U;
    return self->file >= 0;
}

/* Not when it was removed, or another recorder with the same folder has put it aside. */
static bool is_still_there(const event_log_t *self, const char *path)
{
    struct stat own;
    struct stat there;

    return (fstat(self->file, &own) == 0) && (stat(path, &there) == 0) &&
           (own.st_dev == there.st_dev) && (own.st_ino == there.st_ino);
}

/* Without a place for the full one its events are worth more than the bound. */
static void rotate(event_log_t *self)
{
    char path[PATH_SIZE];
    char older[PATH_SIZE];

    (void)snprintf(path, sizeof path, "%s/events.log", self->directory);
    (void)snprintf(older, sizeof older, "%s/events.1.log", self->directory);
    if (!is_still_there(self, path) || (rename(path, older) == 0)) {
        (void)fdatasync(self->file);
        (void)close(self->file);
        (void)reopen(self);
    }
}

void event_log_open(event_log_t *self, const char *directory)
{
    (void)memset(self, 0, sizeof *self);
    self->directory = directory;
    if (!reopen(self)) {
        (void)fprintf(
            stderr,
            "recorder: the event log in %s cannot be opened (%s); events are counted only.\n",
            directory, strerror(errno));
    }
}

static void write_line(event_log_t *self, const char *line)
{
    const size_t size = strlen(line);

    if ((self->file >= 0) && ((self->size + size) > FULL)) {
        rotate(self);
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
        self->unwritten++;
    }
}

static void write_event(event_log_t *self, const exchange_t *exchange,
                        const exchange_event_t *event)
{
    log_entry_t entry;
    char line[LOG_ENTRY_LINE_SIZE];

    log_entry_make(&entry, exchange, event);
    log_entry_write(&entry, line);
    write_line(self, line);
}

static void write_loss(event_log_t *self, uint32_t first, uint32_t lost)
{
    char when[UTC_TEXT_SIZE];
    char line[LOG_ENTRY_LINE_SIZE];

    utc_text_write(clock_utc_us(), when);
    (void)snprintf(line, sizeof line, "%s %u EVENTS_LOST value=%u\n", when, (unsigned)first,
                   (unsigned)lost);
    write_line(self, line);
}

/* Each is noted when it is written: a recorder that dies here writes at most one again. */
void event_log_drain(event_log_t *self, exchange_t *exchange)
{
    static exchange_event_t events[BATCH];
    uint32_t next = exchange_logged(exchange);
    uint32_t count;

    do {
        uint32_t lost = 0U;
        const uint32_t first = next;
        count = exchange_read_events(exchange, &next, events, BATCH, &lost);
        if (lost > 0U) {
            write_loss(self, first, lost);
        }
        for (uint32_t i = 0U; i < count; i++) {
            write_event(self, exchange, &events[i]);
            exchange_note_logged(exchange, events[i].event.number + 1U);
        }
        exchange_note_logged(exchange, next);
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
        (void)reopen(self);
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

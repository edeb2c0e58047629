/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/archive/log_search.h"

#include "recording/archive/archive_folder.h"
#include "exchange/exchange_files.h"
#include "interface/app/names.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool is_full(const log_search_t *self)
{
    return self->filter->has_after && (self->count == self->filter->limit);
}

static bool fits(const log_filter_t *filter, const log_entry_t *entry)
{
    const bool has_text =
        (filter->text == NULL) || (strcasestr(entry->text, filter->text) != NULL) ||
        (strcasestr(event_id_name((int32_t)entry->event.id), filter->text) != NULL);

    return has_text && (entry->event.severity >= filter->severity) &&
           (entry->utc_us >= filter->from_us) && (entry->utc_us <= filter->to_us);
}

/* In a search for the newest, one more takes the place of the oldest. */
static void keep(log_search_t *self, const log_entry_t *entry)
{
    const uint32_t limit = self->filter->limit;

    if (self->count < limit) {
        self->entries[self->count] = *entry;
        self->count++;
    } else {
        self->entries[self->oldest] = *entry;
        self->oldest = (self->oldest + 1U) % limit;
    }
}

/* In the order of their numbers; what comes a second time is left out. */
static void look_at(log_search_t *self, const log_entry_t *entry)
{
    const uint32_t number = entry->event.number;

    if ((number < self->next) || is_full(self)) {
        return;
    }
    self->lost += self->filter->has_after ? (number - self->next) : 0U;
    self->next = number + 1U;
    if (fits(self->filter, entry)) {
        keep(self, entry);
    }
}

/* Those before the number `until`. */
static void read_file(log_search_t *self, const char *directory, uint32_t log, uint32_t until)
{
    archive_file_t opened;
    char line[LOG_ENTRY_LINE_SIZE];
    log_entry_t entry;

    if ((log == 0U) || !archive_open_number(&opened, directory, &file_series_logs, log)) {
        return;
    }
    FILE *const file = fdopen(opened.file, "r");
    if (file == NULL) {
        archive_close(&opened);
        return;
    }
    while (!is_full(self) && (fgets(line, sizeof line, file) != NULL)) {
        if (log_entry_read(&entry, line) && (entry.event.number < until)) {
            look_at(self, &entry);
        }
    }
    (void)fclose(file);
}

static void read_files(log_search_t *self, const exchange_t *exchange, const char *directory,
                       uint32_t until)
{
    const uint32_t log = exchange_file(exchange, EXCHANGE_FILE_LOG);

    read_file(self, directory, exchange_file(exchange, EXCHANGE_FILE_LOG_BEFORE), until);
    read_file(self, directory, log, until);
}

static void read_ring(log_search_t *self, const exchange_t *exchange, const exchange_event_t *ring,
                      uint32_t count)
{
    log_entry_t entry;

    for (uint32_t i = 0U; (i < count) && !is_full(self); i++) {
        log_entry_make(&entry, exchange, &ring[i]);
        look_at(self, &entry);
    }
}

bool log_search(log_search_t *self, const log_filter_t *filter, const exchange_t *exchange,
                uint32_t events, const char *directory)
{
    const uint32_t following = filter->after + ((filter->after == UINT32_MAX) ? 0U : 1U);
    const uint32_t start = filter->has_after ? following : 0U;
    uint32_t next = (events > EXCHANGE_EVENTS) ? (events - EXCHANGE_EVENTS) : 0U;
    uint32_t overwritten = 0U;

    (void)memset(self, 0, sizeof *self);
    self->filter = filter;
    self->next = start;
    self->entries = malloc(filter->limit * sizeof *self->entries);
    exchange_event_t *ring = malloc(EXCHANGE_EVENTS * sizeof *ring);
    if ((self->entries == NULL) || (ring == NULL)) {
        free(ring);
        log_search_end(self);
        return false;
    }
    /* First what may be overwritten meanwhile. */
    const uint32_t count =
        exchange_read_events(exchange, &next, ring, EXCHANGE_EVENTS, &overwritten);
    const uint32_t first = (count > 0U) ? ring[0].event.number : events;
    if (directory != NULL) {
        read_files(self, exchange, directory, first);
    }
    read_ring(self, exchange, ring, count);
    self->wants_files = (directory == NULL) && (start < first) &&
                        (filter->has_after || (self->count < filter->limit));
    free(ring);
    return true;
}

const log_entry_t *log_search_entry(const log_search_t *self, uint32_t place)
{
    return &self->entries[(self->oldest + place) % self->filter->limit];
}

void log_search_end(log_search_t *self)
{
    free(self->entries);
    self->entries = NULL;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/pages/http_record.h"

#include "limits/requirement_limits.h"
#include "http/login/passed.h"

#include <stdio.h>
#include <string.h>

#define FIRST_REFUSAL 400
#define LEFT_OUT_SIZE 48U
#define PATH_MOST 64

/* Requests that are written at once, and the ms after which one more is. */
typedef struct {
    uint64_t most_ms;
    uint64_t each_ms;
} terms_t;

static const terms_t terms_of_commands = {.most_ms = (uint64_t)LIMIT_TRANSACTIONS_AT_ONCE *
                                                     LIMIT_TRANSACTION_PAUSE_MS,
                                          .each_ms = LIMIT_TRANSACTION_PAUSE_MS};
static const terms_t terms_of_refusals = {.most_ms = (uint64_t)LIMIT_REFUSALS_AT_ONCE *
                                                     LIMIT_REFUSAL_PAUSE_MS,
                                          .each_ms = LIMIT_REFUSAL_PAUSE_MS};

void http_record_init(http_record_t *self, http_notes_t *notes, uint64_t now_ms)
{
    (void)memset(self, 0, sizeof *self);
    self->notes = notes;
    (void)pthread_mutex_init(&self->lock, NULL);
    self->commanded = (http_record_pace_t){.credit_ms = terms_of_commands.most_ms, .at_ms = now_ms};
    self->refused = (http_record_pace_t){.credit_ms = terms_of_refusals.most_ms, .at_ms = now_ms};
}

/* Notes that are behind would be pushed out by more. */
static bool may_write(http_record_t *self, http_record_pace_t *pace, const terms_t *terms,
                      uint64_t now_ms)
{
    const uint64_t credit_ms = pace->credit_ms + passed_ms(pace->at_ms, now_ms);
    pace->credit_ms = (credit_ms < terms->most_ms) ? credit_ms : terms->most_ms;
    pace->at_ms = (now_ms > pace->at_ms) ? now_ms : pace->at_ms;
    const bool is_time = (pace->credit_ms >= terms->each_ms) && !http_notes_are_behind(self->notes);
    pace->credit_ms -= is_time ? terms->each_ms : 0U;
    return is_time;
}

/* A byte that is no ASCII could change how a line reads. */
static void make_plain(char *text)
{
    for (char *byte = text; *byte != '\0'; byte++) {
        *byte = ((*byte < ' ') || (*byte > '~')) ? '?' : *byte;
    }
}

static void report(http_record_t *self, const http_record_entry_t *entry, uint32_t left_out)
{
    char before[LEFT_OUT_SIZE] = "";
    char text[EXCHANGE_NOTE_TEXT_SIZE];
    if (left_out > 0U) {
        (void)snprintf(before, sizeof before, "(%u before it are not logged) ", (unsigned)left_out);
    }
    (void)snprintf(text, sizeof text, "%s%s %.*s%s%s answered %d%s%s", before, entry->method,
                   PATH_MOST, entry->path, (entry->request[0] != '\0') ? " " : "", entry->request,
                   entry->status, (entry->answer[0] != '\0') ? " " : "", entry->answer);
    make_plain(text);
    http_notes_write(self->notes, NOTE_TRANSACTION, (entry->who != NULL) ? entry->who : "?", text);
}

void http_record_write(http_record_t *self, const http_record_entry_t *entry, uint64_t now_ms)
{
    const bool is_command = (entry->who != NULL) && (entry->status < FIRST_REFUSAL);
    http_record_pace_t *pace = is_command ? &self->commanded : &self->refused;
    const terms_t *terms = is_command ? &terms_of_commands : &terms_of_refusals;
    uint32_t left_out = 0U;
    (void)pthread_mutex_lock(&self->lock);
    const bool is_time = may_write(self, pace, terms, now_ms);
    if (is_time) {
        left_out = pace->left_out;
        pace->left_out = 0U;
    } else {
        pace->left_out++;
    }
    (void)pthread_mutex_unlock(&self->lock);
    if (is_time) {
        report(self, entry, left_out);
    }
}

static void report_left_out(http_record_t *self, http_record_pace_t *pace, const terms_t *terms,
                            uint64_t now_ms)
{
    char text[EXCHANGE_NOTE_TEXT_SIZE];
    (void)pthread_mutex_lock(&self->lock);
    const bool is_time = (pace->left_out > 0U) && may_write(self, pace, terms, now_ms);
    const uint32_t left_out = is_time ? pace->left_out : 0U;
    pace->left_out -= left_out;
    (void)pthread_mutex_unlock(&self->lock);
    if (left_out > 0U) {
        (void)snprintf(text, sizeof text, "%u request%s, %s, came too fast to be logged.",
                       (unsigned)left_out, (left_out > 1U) ? "s" : "",
                       (pace == &self->commanded) ? "not refused" : "refused or a stranger's");
        http_notes_write(self->notes, NOTE_TRANSACTION, "http", text);
    }
}

void http_record_tick(http_record_t *self, uint64_t now_ms)
{
    report_left_out(self, &self->commanded, &terms_of_commands, now_ms);
    report_left_out(self, &self->refused, &terms_of_refusals, now_ms);
}

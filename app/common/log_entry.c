/* SPDX-License-Identifier: Apache-2.0 */
#include "common/log_entry.h"

#include "common/utc_text.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_peers.h"
#include "interface/app/names.h"

#include <stdio.h>
#include <string.h>

#define WORD_SIZE 48
#define CODES_MOST 256 /* Codes of any enumeration here. */

void log_entry_make(log_entry_t *self, const exchange_t *exchange, const exchange_event_t *event)
{
    self->event = event->event;
    self->utc_us = event->utc_us;
    if (!exchange_send_note(exchange, &event->event, self->text, sizeof self->text)) {
        char page[EXCHANGE_TITLE_SIZE];
        exchange_title(exchange, COMMAND_SOURCE_HTTP, event->event.peer, page);
        event_text_sentence(exchange_robot(exchange), &event->event, page, self->text,
                            sizeof self->text);
    }
}

void log_entry_write(const log_entry_t *self, char line[LOG_ENTRY_LINE_SIZE])
{
    const event_t *event = &self->event;
    char when[UTC_TEXT_SIZE];

    utc_text_write(self->utc_us, when);
    (void)snprintf(line, LOG_ENTRY_LINE_SIZE,
                   "%s %u cycle=%u %s %s subject=%u value=%d cause=%s peer=%u %s\n", when,
                   (unsigned)event->number, (unsigned)event->cycle,
                   event_severity_name((int32_t)event->severity), event_id_name((int32_t)event->id),
                   (unsigned)event->subject, (int)event->value,
                   event_cause_name((int32_t)event->cause), (unsigned)event->peer, self->text);
}

static bool find(const char *(*name_of)(int32_t), const char *word, uint32_t *code)
{
    for (int32_t i = 0; i < CODES_MOST; i++) {
        if (strcmp(name_of(i), word) == 0) {
            *code = (uint32_t)i;
            return true;
        }
    }
    return false;
}

bool log_entry_read(log_entry_t *self, const char *line)
{
    event_t *event = &self->event;
    char when[WORD_SIZE];
    char severity[WORD_SIZE];
    char id[WORD_SIZE];
    char cause[WORD_SIZE];
    int length = 0;

    (void)sscanf(line, "%47s %u cycle=%u %47s %47s subject=%u value=%d cause=%47s peer=%u%n", when,
                 &event->number, &event->cycle, severity, id, &event->subject, &event->value, cause,
                 &event->peer, &length);
    if ((length == 0) || (line[length] != ' ')) {
        return false;
    }
    const char *text = &line[length + 1];
    (void)snprintf(self->text, sizeof self->text, "%.*s", (int)strcspn(text, "\n"), text);
    return utc_text_read(when, &self->utc_us) &&
           find(event_severity_name, severity, &event->severity) &&
           find(event_id_name, id, &event->id) && find(event_cause_name, cause, &event->cause);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/pages/http_notes.h"

#include "interface/event.h"
#include "limits/requirement_limits.h"
#include "http/login/passed.h"

#include <stdio.h>
#include <string.h>

#define EVENTS_AT_ONCE 32U
#define ASK_AGAIN_TICKS 10U /* Half a second. */

void http_notes_init(http_notes_t *self, exchange_t *exchange, command_client_t *client)
{
    (void)memset(self, 0, sizeof *self);
    self->exchange = exchange;
    self->client = client;
    (void)pthread_mutex_init(&self->lock, NULL);
    self->written = exchange_newest_note(exchange);
    self->logged = self->written;
    self->seen = self->written;
    self->asked = self->written;
}

static uint32_t write_note(http_notes_t *self, note_kind_t kind, const char *who, const char *text)
{
    (void)pthread_mutex_lock(&self->lock);
    const uint32_t number = exchange_write_note(self->exchange, kind, who, text);
    self->written = number;
    (void)pthread_mutex_unlock(&self->lock);
    return number;
}

void http_notes_write(void *owner, note_kind_t kind, const char *who, const char *text)
{
    (void)write_note(owner, kind, who, text);
}

uint32_t http_notes_keep(http_notes_t *self, const char *who, const char *text, uint64_t now_ms)
{
    uint32_t number = 0U;
    (void)pthread_mutex_lock(&self->lock);
    if (passed_ms(self->kept_ms, now_ms) >= LIMIT_NOTE_PAUSE_MS) {
        number = exchange_write_note(self->exchange, NOTE_OPERATOR, who, text);
        self->written = number;
        self->kept_ms = now_ms;
    }
    (void)pthread_mutex_unlock(&self->lock);
    return number;
}

void http_notes_report_replaced(http_notes_t *self)
{
    static const struct {
        exchange_process_t process;
        const char *name;
    } programs[] = {
        {EXCHANGE_RECORDER, "recorder"}, {EXCHANGE_IGTL, "igtl"}, {EXCHANGE_HTTP, "http"}};
    char text[80];

    for (size_t i = 0U; i < (sizeof programs / sizeof programs[0]); i++) {
        const uint32_t count = exchange_take_replaced(self->exchange, programs[i].process);
        if (count > 0U) {
            (void)snprintf(text, sizeof text,
                           "gave no sign of life for %u s and was replaced, %u time%s.",
                           LIMIT_HANG_US / 1000000U, (unsigned)count, (count > 1U) ? "s" : "");
            http_notes_write(self, NOTE_REPLACED, programs[i].name, text);
        }
    }
}

static void report_damage(http_notes_t *self, command_source_t source, uint64_t now_ms)
{
    static const char *const names[COMMAND_SOURCE_COUNT] = {
        [COMMAND_SOURCE_IGTL] = "igtl", [COMMAND_SOURCE_HTTP] = "http"};
    http_notes_damage_t *reported = &self->damages[source];
    const uint32_t count = exchange_lane_damages(self->exchange, source);
    exchange_note_t note;
    char text[120];

    if ((reported->note != 0U) && exchange_read_note(self->exchange, reported->note, &note)) {
        reported->note = 0U;
    }
    if ((count != reported->count) || (reported->note != 0U)) {
        (void)snprintf(text, sizeof text,
                       "command lane damaged %u time%s since the start; commands in it were "
                       "dropped.",
                       (unsigned)count, (count > 1U) ? "s" : "");
        reported->note = write_note(self, NOTE_DAMAGED, names[source], text);
        reported->count = count;
        reported->reported_ms = now_ms;
    }
}

void http_notes_report_damage(http_notes_t *self, uint64_t now_ms)
{
    for (uint32_t i = 0U; i < COMMAND_SOURCE_COUNT; i++) {
        const uint64_t reported_ms = self->damages[i].reported_ms;
        if ((reported_ms == 0U) || (passed_ms(reported_ms, now_ms) >= LIMIT_DAMAGE_PAUSE_MS)) {
            report_damage(self, (command_source_t)i, now_ms);
        }
    }
}

bool http_notes_are_behind(http_notes_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    const uint32_t since = self->written - self->seen;
    (void)pthread_mutex_unlock(&self->lock);
    return since > (LIMIT_NOTES_KEPT / 2U);
}

static uint32_t newest(http_notes_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    const uint32_t written = self->written;
    self->seen = self->logged;
    (void)pthread_mutex_unlock(&self->lock);
    return written;
}

static void look_into_log(http_notes_t *self)
{
    exchange_event_t events[EVENTS_AT_ONCE];
    uint32_t lost = 0U;
    uint32_t count;
    do {
        count =
            exchange_read_events(self->exchange, &self->next_event, events, EVENTS_AT_ONCE, &lost);
        for (uint32_t i = 0U; i < count; i++) {
            const event_t *event = &events[i].event;
            const bool is_note =
                (event->id == (uint32_t)EVENT_NOTE) || (event->id == (uint32_t)EVENT_LOGIN_REFUSED);
            const bool is_asked = is_note && ((uint32_t)event->value == self->asked);
            self->logged = is_asked ? self->asked : self->logged;
        }
    } while (count == EVENTS_AT_ONCE);
}

static void ask(http_notes_t *self, const exchange_note_t *note)
{
    const command_t command = {.kind = (uint32_t)COMMAND_NOTE,
                               .as.note = {.note = note->kind, .number = (int32_t)note->number}};
    (void)command_client_send(self->client, 0U, &command);
    self->asked = note->number;
    self->ticks_left = ASK_AGAIN_TICKS;
}

void http_notes_tick(http_notes_t *self)
{
    exchange_note_t note;
    look_into_log(self);
    if (self->logged != self->asked) {
        self->ticks_left--;
    }
    const uint32_t next = self->logged + 1U;
    const bool is_free = (self->logged == self->asked) || (self->ticks_left == 0U);
    if ((self->logged == newest(self)) || !is_free) {
        return;
    }
    if (exchange_read_note(self->exchange, next, &note) && (note.kind != (uint32_t)NOTE_OPERATOR)) {
        ask(self, &note);
    } else {
        self->logged = next;
        self->asked = next;
    }
}

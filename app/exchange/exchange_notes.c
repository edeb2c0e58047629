/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange_notes.h"

#include "exchange/exchange_lock.h"
#include "exchange/exchange_segment.h"

#include <stdio.h>

uint32_t exchange_write_note(exchange_t *self, note_kind_t kind, const char *who, const char *text)
{
    segment_others_t *others = &self->segment->others;
    exchange_note_t note = {.number = exchange_newest_note(self) + 1U, .kind = (uint32_t)kind};
    segment_note_t *slot = &others->notes[note.number % EXCHANGE_NOTES];

    (void)snprintf(note.who, sizeof note.who, "%s", who);
    (void)snprintf(note.text, sizeof note.text, "%s", text);
    exchange_write_sealed(&slot->seal, &slot->note, &note, sizeof note);
    self->newest_note = note.number;
    return note.number;
}

static bool read_place(const exchange_t *self, uint32_t place, exchange_note_t *note)
{
    const segment_note_t *slot = &self->segment->others.notes[place];

    return exchange_read_sealed(&slot->seal, note, &slot->note, sizeof *note);
}

uint32_t exchange_newest_note(exchange_t *self)
{
    exchange_note_t note;
    uint32_t newest = self->newest_note;

    for (uint32_t i = 0U; (i < EXCHANGE_NOTES) && (self->newest_note == 0U); i++) {
        if (read_place(self, i, &note) && (note.number > newest)) {
            newest = note.number;
        }
    }
    self->newest_note = newest;
    return newest;
}

/* The log has a line for each event, with any text of http. */
static void clean(char *text, size_t size)
{
    text[size - 1U] = '\0';
    for (char *byte = text; *byte != '\0'; byte++) {
        *byte = (((unsigned char)*byte < 0x20U) || (*byte == '\x7F')) ? ' ' : *byte;
    }
}

bool exchange_read_note(const exchange_t *self, uint32_t number, exchange_note_t *note)
{
    const bool is_whole = read_place(self, number % EXCHANGE_NOTES, note) &&
                          (note->number == number) && (note->kind < NOTE_KIND_COUNT);

    if (is_whole) {
        clean(note->who, sizeof note->who);
        clean(note->text, sizeof note->text);
    }
    return is_whole;
}

/* An operator's words do not read as ours. */
bool exchange_send_note(const exchange_t *self, const event_t *event, char *text, size_t size)
{
    const bool is_note =
        (event->id == (uint32_t)EVENT_NOTE) || (event->id == (uint32_t)EVENT_LOGIN_REFUSED);
    exchange_note_t note;

    if (!is_note || !exchange_read_note(self, (uint32_t)event->value, &note) ||
        (note.kind != event->subject)) {
        return false;
    }
    (void)snprintf(text, size, "%s%s: %s", (note.kind == (uint32_t)NOTE_OPERATOR) ? "Note of " : "",
                   note.who, note.text);
    return true;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/data/bytes.h"

#include "common/little_endian.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_ROOM 1024U

void bytes_clear(bytes_t *self)
{
    self->used = 0U;
}

void bytes_free(bytes_t *self)
{
    free(self->at);
    (void)memset(self, 0, sizeof *self);
}

static void make_room(bytes_t *self, size_t more)
{
    size_t room = (self->room > 0U) ? self->room : FIRST_ROOM;

    while ((room - self->used) < more) {
        room *= 2U;
    }
    if (room > self->room) {
        self->at = realloc(self->at, room);
        self->room = room;
    }
    if (self->at == NULL) {
        abort();
    }
}

void bytes_put(bytes_t *self, const void *from, size_t size)
{
    make_room(self, size);
    (void)memcpy(&self->at[self->used], from, size);
    self->used += size;
}

void bytes_put8(bytes_t *self, uint8_t value)
{
    bytes_put(self, &value, sizeof value);
}

void bytes_put16(bytes_t *self, uint16_t value)
{
    bytes_put8(self, (uint8_t)value);
    bytes_put8(self, (uint8_t)(value >> 8));
}

void bytes_put32(bytes_t *self, uint32_t value)
{
    uint8_t bytes[sizeof value];

    put32(bytes, value);
    bytes_put(self, bytes, sizeof bytes);
}

void bytes_put64(bytes_t *self, uint64_t value)
{
    uint8_t bytes[sizeof value];

    put64(bytes, value);
    bytes_put(self, bytes, sizeof bytes);
}

/* The second attempt has room for all of it. */
void bytes_print(bytes_t *self, const char *format, ...)
{
    int size = 0;

    for (size_t room = 64U; room > 0U; room = (room <= (size_t)size) ? ((size_t)size + 1U) : 0U) {
        va_list arguments;
        make_room(self, room);
        va_start(arguments, format);
        size = vsnprintf((char *)&self->at[self->used], room, format, arguments);
        va_end(arguments);
        if (size < 0) {
            abort();
        }
    }
    self->used += (size_t)size;
}

void bytes_quote(bytes_t *self, const char *text)
{
    bytes_put8(self, (uint8_t)'"');
    for (const char *letter = text; *letter != '\0'; letter++) {
        if ((*letter == '"') || (*letter == '\\')) {
            bytes_put8(self, (uint8_t)'\\');
        }
        if ((uint8_t)*letter < (uint8_t)' ') {
            bytes_print(self, "\\u%04x", (unsigned)(uint8_t)*letter);
        } else {
            bytes_put8(self, (uint8_t)*letter);
        }
    }
    bytes_put8(self, (uint8_t)'"');
}

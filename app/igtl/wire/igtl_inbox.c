/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/wire/igtl_inbox.h"

#include "igtl/wire/igtl_crc64.h"

#include <string.h>

void igtl_inbox_init(igtl_inbox_t *self)
{
    (void)memset(self, 0, sizeof *self);
}

void igtl_inbox_lend(igtl_inbox_t *self, uint8_t large[LIMIT_IGTL_ARRAY_MAX])
{
    self->large = large;
}

static bool is_large(const igtl_inbox_t *self)
{
    return self->header.body_bytes > LIMIT_IGTL_BODY_MAX;
}

static uint8_t *body_of(igtl_inbox_t *self)
{
    return is_large(self) ? self->large : &self->buffer[IGTL_HEADER_BYTES];
}

uint32_t igtl_inbox_room(igtl_inbox_t *self, uint8_t **where)
{
    uint64_t missing;

    if (self->filled < IGTL_HEADER_BYTES) {
        *where = &self->buffer[self->filled];
        return IGTL_HEADER_BYTES - self->filled;
    }
    if (self->is_skipping) {
        missing = self->header.body_bytes - self->passed;
        *where = &self->buffer[IGTL_HEADER_BYTES];
        return (missing < LIMIT_IGTL_BODY_MAX) ? (uint32_t)missing : LIMIT_IGTL_BODY_MAX;
    }
    *where = &body_of(self)[self->filled - IGTL_HEADER_BYTES];
    return (IGTL_HEADER_BYTES + (uint32_t)self->header.body_bytes) - self->filled;
}

static igtl_inbox_event_t finish(igtl_inbox_t *self, igtl_inbox_event_t event)
{
    self->filled = 0U;
    self->passed = 0U;
    self->passed_crc = 0U;
    self->is_skipping = false;
    self->is_begun = false;
    return event;
}

static igtl_inbox_event_t skip(igtl_inbox_t *self, uint32_t count)
{
    self->passed += count;
    self->passed_crc = igtl_crc64(self->passed_crc, &self->buffer[IGTL_HEADER_BYTES], count);
    if (self->passed < self->header.body_bytes) {
        return IGTL_INBOX_WAITING;
    }
    if ((self->reason == IGTL_OK) && (self->passed_crc != self->header.crc)) {
        self->reason = IGTL_BAD_CRC;
    }
    return finish(self, (self->reason == IGTL_OK) ? IGTL_INBOX_SKIPPED : IGTL_INBOX_REFUSED);
}

static igtl_inbox_event_t complete(igtl_inbox_t *self)
{
    if (self->filled < (IGTL_HEADER_BYTES + (uint32_t)self->header.body_bytes)) {
        return IGTL_INBOX_WAITING;
    }
    self->reason = igtl_decode_body(&self->header, body_of(self), &self->message);
    return finish(self, (self->reason == IGTL_OK) ? IGTL_INBOX_MESSAGE : IGTL_INBOX_REFUSED);
}

static igtl_inbox_event_t take(igtl_inbox_t *self, uint32_t count)
{
    if (self->is_skipping) {
        return skip(self, count);
    }
    self->filled += count;
    if (self->filled < IGTL_HEADER_BYTES) {
        return IGTL_INBOX_WAITING;
    }
    if (self->filled == IGTL_HEADER_BYTES) {
        self->reason = igtl_decode_header(self->buffer, &self->header);
        if (igtl_header_is_lost(&self->header)) {
            return IGTL_INBOX_BROKEN;
        }
        if ((self->reason == IGTL_OK) && (self->header.kind == IGTL_KIND_ARRAY) && is_large(self) &&
            (self->large == NULL)) {
            self->reason = IGTL_TOO_LONG;
        }
        self->is_skipping = (self->reason != IGTL_OK) || (self->header.kind == IGTL_KIND_OTHER);
    }
    return self->is_skipping ? skip(self, 0U) : complete(self);
}

igtl_inbox_event_t igtl_inbox_advance(igtl_inbox_t *self, uint32_t count, uint64_t now_us)
{
    if (!self->is_begun) {
        self->is_begun = true;
        self->begun_us = now_us;
    }
    self->heard_us = now_us;
    return take(self, count);
}

bool igtl_inbox_is_late(const igtl_inbox_t *self, uint64_t now_us)
{
    const uint64_t taken_us = now_us - self->begun_us;
    const uint64_t silent_us = now_us - self->heard_us;

    if (!self->is_begun) {
        return false;
    }
    return self->is_skipping ? ((taken_us >= LIMIT_IGTL_SKIP_TIMEOUT_US) ||
                                (silent_us >= LIMIT_IGTL_PARTIAL_TIMEOUT_US))
                             : (taken_us >= LIMIT_IGTL_PARTIAL_TIMEOUT_US);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/wire/igtl_outbox.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define LABEL_OFFSET 2U /* Type and device name in the header. */
#define LABEL_BYTES 32U

void igtl_outbox_init(igtl_outbox_t *self)
{
    (void)memset(self, 0, sizeof *self);
    self->version = 1U;
}

void igtl_outbox_hear(igtl_outbox_t *self, uint32_t version)
{
    if (version == 2U) {
        self->version = 2U;
    }
}

static void put(igtl_outbox_t *self, uint32_t at, const igtl_packet_t *packet)
{
    igtl_packet_t *place = &self->packets[at];

    if (self->version == 2U) {
        igtl_packet_extend(place, packet);
    } else {
        place->length = packet->length;
        (void)memcpy(place->bytes, packet->bytes, packet->length);
    }
}

static void append(igtl_outbox_t *self, const igtl_packet_t *packet, bool is_state)
{
    const uint32_t last = (self->first + self->count) % IGTL_OUTBOX_PACKETS;

    if (self->count == IGTL_OUTBOX_PACKETS) {
        self->has_overflowed = true;
        return;
    }
    put(self, last, packet);
    self->is_state[last] = is_state;
    self->count++;
}

void igtl_outbox_add(igtl_outbox_t *self, const igtl_packet_t *packet)
{
    append(self, packet, false);
}

void igtl_outbox_note_refusal(igtl_outbox_t *self, const char *name, const char *reason)
{
    (void)snprintf(self->refusal, sizeof self->refusal, "%s %s", name, reason);
}

void igtl_outbox_add_state(igtl_outbox_t *self, const igtl_packet_t *packet)
{
    const uint32_t begun = (self->sent > 0U) ? 1U : 0U;

    for (uint32_t i = begun; i < self->count; i++) {
        const uint32_t at = (self->first + i) % IGTL_OUTBOX_PACKETS;

        if (self->is_state[at] && (memcmp(&self->packets[at].bytes[LABEL_OFFSET],
                                          &packet->bytes[LABEL_OFFSET], LABEL_BYTES) == 0)) {
            put(self, at, packet);
            return;
        }
    }
    append(self, packet, true);
}

const uint8_t *igtl_outbox_next(const igtl_outbox_t *self, uint32_t *length)
{
    const igtl_packet_t *packet = &self->packets[self->first];

    if (self->count == 0U) {
        *length = 0U;
        return NULL;
    }
    *length = packet->length - self->sent;
    return &packet->bytes[self->sent];
}

void igtl_outbox_advance(igtl_outbox_t *self, uint32_t length)
{
    self->sent += length;
    if (self->sent >= self->packets[self->first].length) {
        self->sent = 0U;
        self->first = (self->first + 1U) % IGTL_OUTBOX_PACKETS;
        self->count--;
    }
}

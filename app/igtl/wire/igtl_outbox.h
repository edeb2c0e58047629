/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The output queue of one connection: whole messages, first in, first out. A state message
 * replaces the one of the same type and name that has not left yet, so that a slow peer sees the
 * newest state and costs no memory. Messages get the header version of the peer here; their writers
 * do not know it.
 */
#ifndef BORESIGHT_IGTL_OUTBOX_H
#define BORESIGHT_IGTL_OUTBOX_H

#include "igtl/wire/igtl_packet.h"

#include <stdbool.h>
#include <stdint.h>

#define IGTL_OUTBOX_PACKETS 64U
#define IGTL_OUTBOX_REFUSAL 128U /**< Longer refusals are cut. */

typedef struct {
    uint32_t version; /**< Version of headers: 2 once the peer has sent it, before 1. */
    igtl_packet_t packets[IGTL_OUTBOX_PACKETS];
    bool is_state[IGTL_OUTBOX_PACKETS];
    uint32_t first;
    uint32_t count;
    uint32_t sent;       /**< Bytes of the first packet that have left. */
    bool has_overflowed; /**< A message found no room: the peer is too slow, drop it. */
    char refusal[IGTL_OUTBOX_REFUSAL]; /**< The last one that was noted, in words; "": none. */
} igtl_outbox_t;

void igtl_outbox_init(igtl_outbox_t *self);

/**
 * The peer has sent a message with header `version`; anything but 1 and 2 says nothing.
 *
 * @satisfies SWR-IGTL-005
 */
void igtl_outbox_hear(igtl_outbox_t *self, uint32_t version);

/** Adds an answer or a report: every one is sent. */
void igtl_outbox_add(igtl_outbox_t *self, const igtl_packet_t *packet);

/** Keeps in words that the message `name` was refused, and why. */
void igtl_outbox_note_refusal(igtl_outbox_t *self, const char *name, const char *reason);

/** Adds a state, of which only the newest matters. */
void igtl_outbox_add_state(igtl_outbox_t *self, const igtl_packet_t *packet);

/** The bytes to send next, NULL when there are none: one message, or the rest of one. */
const uint8_t *igtl_outbox_next(const igtl_outbox_t *self, uint32_t *length);

/** `length` of them have left. */
void igtl_outbox_advance(igtl_outbox_t *self, uint32_t length);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/origins.h"

#include <stddef.h>

#define EVENTS_AT_ONCE 16U

static origin_t *find(origins_t *self, uint32_t event)
{
    switch (event) {
    case (uint32_t)EVENT_REGISTERED:
        return &self->registration;
    case (uint32_t)EVENT_TARGET_ACCEPTED:
        return &self->target;
    case (uint32_t)EVENT_ENTRY_TAKEN:
        return &self->entry;
    default:
        return NULL;
    }
}

static void note(origin_t *origin, const exchange_t *exchange, const event_t *event)
{
    const bool is_page = event->cause == (uint32_t)EVENT_CAUSE_CONSOLE;
    origin->is_known = is_page || (event->cause == (uint32_t)EVENT_CAUSE_IGTL);
    origin->source = is_page ? (uint32_t)COMMAND_SOURCE_HTTP : (uint32_t)COMMAND_SOURCE_IGTL;
    origin->peer = event->peer;
    origin->cycle = event->cycle;
    exchange_title(exchange, (command_source_t)origin->source, event->peer, origin->title);
}

void origins_look(origins_t *self, const exchange_t *exchange)
{
    exchange_event_t events[EVENTS_AT_ONCE];
    uint32_t lost = 0U;
    uint32_t count;
    do {
        count = exchange_read_events(exchange, &self->next_event, events, EVENTS_AT_ONCE, &lost);
        for (uint32_t i = 0U; i < count; i++) {
            origin_t *origin = find(self, events[i].event.id);
            if (origin != NULL) {
                note(origin, exchange, &events[i].event);
            }
        }
    } while (count == EVENTS_AT_ONCE);
}

void origins_take_registration(origins_t *self, const exchange_t *exchange,
                               const snapshot_t *snapshot)
{
    origin_t *origin = &self->registration;
    const bool is_told = origin->is_known && (origin->cycle == snapshot->registered_cycle) &&
                         (origin->source == snapshot->registered_source) &&
                         (origin->peer == snapshot->registered_peer);
    if ((snapshot->is_registered != 0U) && !is_told) {
        origin->is_known = true;
        origin->source = snapshot->registered_source;
        origin->peer = snapshot->registered_peer;
        origin->cycle = snapshot->registered_cycle;
        exchange_title(exchange, (command_source_t)origin->source, origin->peer, origin->title);
    }
}

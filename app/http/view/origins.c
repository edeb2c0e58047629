/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/origins.h"

#include <stddef.h>

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

void origins_take(origins_t *self, const exchange_t *exchange, const event_t *event)
{
    origin_t *const origin = find(self, event->id);

    if (origin != NULL) {
        note(origin, exchange, event);
    }
}

static void take(origin_t *origin, const exchange_t *exchange, const origin_t *shown)
{
    const bool is_reported = origin->is_known && (origin->cycle == shown->cycle) &&
                             (origin->source == shown->source) && (origin->peer == shown->peer);
    if (shown->is_known && !is_reported) {
        *origin = *shown;
        exchange_title(exchange, (command_source_t)origin->source, origin->peer, origin->title);
    }
}

/* Only OpenIGTLink proposes. */
static void take_proposal(origin_t *origin, const exchange_t *exchange, uint32_t is_there,
                          uint32_t peer, uint32_t cycle)
{
    const origin_t shown = {.is_known = is_there != 0U,
                            .source = (uint32_t)COMMAND_SOURCE_IGTL,
                            .peer = peer,
                            .cycle = cycle};
    take(origin, exchange, &shown);
}

void origins_take_shown(origins_t *self, const exchange_t *exchange, const snapshot_t *snapshot)
{
    const origin_t registration = {.is_known = snapshot->is_registered != 0U,
                                   .source = snapshot->registered_source,
                                   .peer = snapshot->registered_peer,
                                   .cycle = snapshot->registered_cycle};
    take(&self->registration, exchange, &registration);
    take_proposal(&self->proposed_registration, exchange, snapshot->has_proposed_registration,
                  snapshot->registration_proposer_peer, snapshot->registration_proposed_cycle);
    take_proposal(&self->proposed_entry, exchange, snapshot->has_proposed_entry,
                  snapshot->entry_proposer_peer, snapshot->entry_proposed_cycle);
    take_proposal(&self->proposed_target, exchange, snapshot->has_proposed_target,
                  snapshot->target_proposer_peer, snapshot->target_proposed_cycle);
}

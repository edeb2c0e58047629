/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/authority.h"

#include "limits/requirement_limits.h"

#include <string.h>

static bool is_same(const authority_party_t *one, const authority_party_t *other)
{
    return (one->source == other->source) && (one->peer == other->peer);
}

static bool is_granted(const authority_t *self)
{
    return self->sealed.request == (uint32_t)AUTHORITY_REQUEST_GRANTED;
}

static void hold(authority_t *self, const authority_party_t *party, authority_time_t now)
{
    self->sealed.holder = *party;
    self->sealed.since_cycle = now.cycle;
    self->sealed.since_us = now.time_us;
}

void authority_init(authority_t *self)
{
    (void)memset(self, 0, sizeof *self);
    authority_chart_init(&self->chart);
}

bool authority_check(authority_t *self)
{
    const bool was_damaged = authority_chart_check(&self->chart) != 0U;
    if (was_damaged) {
        self->sealed.holder.peer = 0U;
        authority_forget_request(self);
    }
    return was_damaged;
}

bool authority_is_of(const authority_t *self, const authority_party_t *party)
{
    return authority_is_held(self) && is_same(&self->sealed.holder, party);
}

bool authority_take(authority_t *self, const authority_party_t *party, authority_time_t now)
{
    if ((party->peer == 0U) || !authority_is_free(self)) {
        return false;
    }
    (void)authority_chart_dispatch(&self->chart, AUTHORITY_EVENT_TAKE);
    hold(self, party, now);
    return true;
}

uint32_t authority_lose(authority_t *self, uint32_t time_us)
{
    if (!authority_is_held(self)) {
        return 0U;
    }
    self->sealed.holder.peer = 0U;
    self->sealed.since_us = time_us;
    return authority_chart_dispatch(&self->chart, AUTHORITY_EVENT_LOSE);
}

bool authority_is_unrenewed(const authority_t *self, uint32_t time_us)
{
    return authority_is_held(self) &&
           (self->sealed.holder.source == (uint32_t)COMMAND_SOURCE_HTTP) &&
           ((time_us - self->sealed.since_us) >= LIMIT_AUTHORITY_RENEW_US);
}

/* The party that was granted authority has it as soon as it is free. */
static bool succeed(authority_t *self, authority_time_t now)
{
    const authority_party_t party = self->sealed.requester;
    const bool has_taken = is_granted(self) && authority_take(self, &party, now);
    if (has_taken) {
        authority_forget_request(self);
    }
    return has_taken;
}

bool authority_step(authority_t *self, bool is_at_rest, uint32_t elapsed_us, authority_time_t now)
{
    (void)authority_chart_advance(&self->chart, elapsed_us);
    if (authority_is_ending(self) &&
        (is_at_rest || ((now.time_us - self->sealed.since_us) >= LIMIT_AUTHORITY_END_US))) {
        (void)authority_chart_dispatch(&self->chart, AUTHORITY_EVENT_RESTED);
    }
    return succeed(self, now);
}

bool authority_is_asked(const authority_t *self, authority_request_t request, uint32_t axis,
                        const authority_party_t *party)
{
    return (self->sealed.request == (uint32_t)request) && (self->sealed.request_axis == axis) &&
           is_same(&self->sealed.requester, party);
}

bool authority_ask(authority_t *self, authority_request_t request, uint32_t axis,
                   const authority_party_t *party, uint32_t time_us)
{
    const bool is_anothers =
        (self->sealed.requester.peer != 0U) && !is_same(&self->sealed.requester, party);
    if (is_anothers) {
        return false;
    }
    self->sealed.request = (uint32_t)request;
    self->sealed.request_axis = axis;
    self->sealed.requester = *party;
    self->sealed.requested_us = time_us;
    return true;
}

uint32_t authority_request_left_us(const authority_t *self, uint32_t time_us)
{
    const uint32_t passed_us = time_us - self->sealed.requested_us;
    const bool is_waiting = (self->sealed.requester.peer != 0U) && !is_granted(self);
    if (!is_waiting || (passed_us >= LIMIT_AUTHORITY_ASK_US)) {
        return 0U;
    }
    return LIMIT_AUTHORITY_ASK_US - passed_us;
}

void authority_forget_request(authority_t *self)
{
    self->sealed.request = (uint32_t)AUTHORITY_REQUEST_NONE;
    self->sealed.requester.peer = 0U;
}

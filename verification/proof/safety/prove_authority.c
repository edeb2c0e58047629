/* SPDX-License-Identifier: Apache-2.0 */
/* Authority over any calls, from any sound state: what holds after each holds always. */
#include "prove.h"

#include "limits/requirement_limits.h"
#include "safety/authority.h"

static authority_t self;

/* What every call leaves: who has it has a name, and nobody else is held for the holder. */
static bool is_sound(void)
{
    return authority_chart_is_sound(&self.chart) &&
           SAME(authority_is_held(&self), self.sealed.holder.peer != 0U);
}

static void begin(void)
{
    authority_t any;
    self = any;
    assume(is_sound());
}

void prove_SWR_AUTH_001_it_is_given_only_while_it_is_free(void)
{
    authority_party_t party;
    authority_time_t now;
    begin();
    const bool was_free = authority_is_free(&self);
    const authority_party_t before = self.sealed.holder;

    const bool has_taken = authority_take(&self, &party, now);

    PROVE(IMPLIES(has_taken, was_free && (party.peer != 0U)),
          "SWR-AUTH-001: only what is free is given, and only to a name");
    PROVE(IMPLIES(has_taken, authority_is_of(&self, &party)), "SWR-AUTH-001: who takes it has it");
    PROVE(IMPLIES(!has_taken, (self.sealed.holder.peer == before.peer) &&
                                  (self.sealed.holder.source == before.source)),
          "SWR-AUTH-001: who has it keeps it");
    PROVE(is_sound(), "SWR-AUTH-001: the next call may rely on it");
    POSSIBLE(has_taken, "taken");
}

void prove_SWR_AUTH_006_authority_is_not_free_before_all_axes_rest(void)
{
    authority_time_t now;
    uint32_t elapsed_us;
    uint32_t lost_us;
    bool is_at_rest;
    begin();
    const bool was_held = authority_is_held(&self);
    (void)authority_lose(&self, lost_us);
    PROVE(!authority_is_held(&self), "SWR-AUTH-005: what was lost is not held");
    PROVE(IMPLIES(was_held, authority_is_ending(&self)), "SWR-AUTH-006: and not free");
    PROVE(is_sound(), "SWR-AUTH-001: the next call may rely on it");
    const bool was_ending = authority_is_ending(&self);
    const uint32_t since_us = self.sealed.since_us;

    const bool has_taken = authority_step(&self, is_at_rest, elapsed_us, now);

    PROVE(IMPLIES(was_ending && !is_at_rest && ((now.time_us - since_us) < LIMIT_AUTHORITY_END_US),
                  authority_is_ending(&self)),
          "SWR-AUTH-006: before all is at rest, or the time is over, nobody has it");
    PROVE(IMPLIES(has_taken, authority_is_held(&self)), "SWR-AUTH-008: who was granted it has it");
    PROVE(is_sound(), "SWR-AUTH-001: the next cycle may rely on it");
    POSSIBLE(was_held && authority_is_free(&self), "free again");
    POSSIBLE(has_taken, "given to who was granted it");
}

void prove_SWR_AUTH_012_a_request_of_another_one_stands(void)
{
    authority_party_t party;
    authority_request_t request;
    uint32_t axis;
    uint32_t time_us;
    begin();
    const authority_party_t before = self.sealed.requester;
    const authority_party_t holder = self.sealed.holder;
    const bool is_anothers =
        (before.peer != 0U) && ((before.peer != party.peer) || (before.source != party.source));

    const bool is_asked = authority_ask(&self, request, axis, &party, time_us);

    PROVE(SAME(is_asked, !is_anothers), "SWR-AUTH-012: refused while another one's stands");
    PROVE(IMPLIES(is_anothers, (self.sealed.requester.peer == before.peer) &&
                                   (self.sealed.requester.source == before.source)),
          "SWR-AUTH-012: another one's stays");
    PROVE((self.sealed.holder.peer == holder.peer) && (self.sealed.holder.source == holder.source),
          "SWR-AUTH-001: asking gives nothing");
    PROVE(is_sound(), "SWR-AUTH-001: the next call may rely on it");
    POSSIBLE(is_asked, "asked");
}

/* SPDX-License-Identifier: Apache-2.0 */
/* One cycle of the link to a card, from any sound state and with any frame of 256 bytes or none;
 * and any number of silent cycles, by induction. */
#include "prove.h"

#include "card/link.h"

#include <stddef.h>

static link_t self;
static card_samples_t samples;

static void begin(void)
{
    link_t any;
    card_samples_t any_samples;
    self = any;
    samples = any_samples;
    assume(card_link_chart_is_sound(&self.chart));
}

void prove_SWR_LINK_007_of_a_card_in_use_only_the_next_ten_reports_count(void)
{
    uint8_t bytes[CARD_FRAME_BYTES];
    uint32_t slot;
    uint32_t elapsed_us;
    begin();
    assume(slot < CARD_SLOT_COUNT);
    const bool was_usable = link_is_usable(&self);
    const bool was_lost = self.chart.state == CARD_LINK_STATE_LOST;
    const bool had_report = self.sealed.has_report != 0U;
    const uint32_t heartbeat = self.report.heartbeat;

    link_step(&self, slot, bytes, &samples, elapsed_us);

    const uint32_t step = self.report.heartbeat - heartbeat;
    const bool is_fresh = self.is_fresh != 0U;
    PROVE(IMPLIES(was_usable && had_report && is_fresh,
                  (step >= 1U) && (step <= LIMIT_SEQUENCE_WINDOW)),
          "SWR-LINK-007: a report that counts is 1 to 10 after the last one");
    PROVE(IMPLIES(!is_fresh, self.report.heartbeat == heartbeat),
          "SWR-LINK-002: the last valid report stays");
    PROVE(IMPLIES(was_lost, self.chart.state == CARD_LINK_STATE_LOST),
          "SWR-LINK-003: what is lost stays lost until it is reset");
    PROVE(IMPLIES(was_usable && is_fresh && ((self.report.status & CARD_STATUS_FAULTS) != 0U),
                  self.chart.state == CARD_LINK_STATE_LOST),
          "SWR-LINK-006: a fault loses the card in its cycle");
    PROVE(IMPLIES(was_usable && is_fresh && !link_is_right_card(&self), !link_is_usable(&self)),
          "SWR-LINK-008: another card is lost");
    PROVE(IMPLIES(was_usable && !is_fresh && (self.sealed.age_cycles >= LIMIT_LINK_AGE_CYCLES),
                  self.chart.state == CARD_LINK_STATE_LOST),
          "SWR-LINK-001: five cycles without a valid frame lose the card");
    PROVE(card_link_chart_is_sound(&self.chart), "SWR-CORE-004: the chart stays sound");
    POSSIBLE(is_fresh && link_is_usable(&self), "a report that counts");
}

void prove_SWR_LINK_001_five_silent_cycles_lose_a_card(void)
{
    uint32_t slot;
    begin();
    assume((slot < CARD_SLOT_COUNT) && link_is_usable(&self));
    for (uint32_t i = 0U; i < LIMIT_LINK_AGE_CYCLES; i++) {
        uint32_t elapsed_us;
        link_step(&self, slot, NULL, &samples, elapsed_us);
    }
    PROVE(self.chart.state == CARD_LINK_STATE_LOST, "SWR-LINK-001: lost after five silent cycles");
    POSSIBLE(self.sealed.cause == (uint16_t)LINK_CAUSE_AGE, "lost by age");
}

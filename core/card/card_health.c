/* SPDX-License-Identifier: Apache-2.0 */
#include "card/card_health.h"

#include "limits/requirement_limits.h"

/* A counter that has gone back belongs to a card that was started anew. */
#define LARGEST_GROWTH 0x7FFFFFFFU

static inline bool stands(const card_health_t *self, card_trouble_t trouble)
{
    return (self->troubles & card_health_bit(trouble)) != 0U;
}

static inline void set(card_health_t *self, card_trouble_t trouble, bool is_so)
{
    const uint32_t bit = card_health_bit(trouble);
    self->troubles = is_so ? (self->troubles | bit) : (self->troubles & ~bit);
}

static void judge_supply(card_health_t *self, uint32_t supply_mv)
{
    const uint32_t least_mv =
        LIMIT_CARD_SUPPLY_LEAST_MV +
        (stands(self, CARD_TROUBLE_SUPPLY_LOW) ? LIMIT_CARD_SUPPLY_BACK_MV : 0U);
    const uint32_t most_mv =
        LIMIT_CARD_SUPPLY_MOST_MV -
        (stands(self, CARD_TROUBLE_SUPPLY_HIGH) ? LIMIT_CARD_SUPPLY_BACK_MV : 0U);
    const bool is_low = supply_mv < least_mv;
    const bool is_high = supply_mv > most_mv;
    if (!is_low && !is_high) {
        self->odd_looks = 0U;
    } else if (self->odd_looks < LIMIT_CARD_SUPPLY_LOOKS) {
        self->odd_looks++;
    } else {
        /* It has been so for long. */
    }
    const bool is_lasting = self->odd_looks >= LIMIT_CARD_SUPPLY_LOOKS;
    set(self, CARD_TROUBLE_SUPPLY_LOW, is_low && is_lasting);
    set(self, CARD_TROUBLE_SUPPLY_HIGH, is_high && is_lasting);
}

static inline bool is_hotter(const card_health_t *self, card_trouble_t trouble, int32_t heat_dc,
                             int32_t limit_dc)
{
    return heat_dc >
           (stands(self, trouble) ? (limit_dc - (int32_t)LIMIT_CARD_DRIVER_BACK_DC) : limit_dc);
}

static inline bool has_grown(const card_health_t *self, uint32_t before, uint32_t now)
{
    return (self->has_looked != 0U) && ((now - before - 1U) < LARGEST_GROWTH);
}

/* Stands from the first growth until none has come for a while. */
static void judge_count(card_health_t *self, card_trouble_t trouble, bool is_growing,
                        uint32_t *calm_looks)
{
    if (is_growing) {
        *calm_looks = 0U;
        set(self, trouble, true);
    } else if (stands(self, trouble)) {
        *calm_looks += 1U;
        set(self, trouble, *calm_looks < LIMIT_CARD_CALM_LOOKS);
    } else {
        /* It does not stand. */
    }
}

uint32_t card_health_look(card_health_t *self, const card_report_t *report, bool has_supply)
{
    const uint32_t before = self->troubles;
    const uint32_t refused = report->rx_crc_errors + report->sequence_gaps;
    const int32_t heat_dc = report->driver_temperature_dc;
    if (has_supply) {
        judge_supply(self, report->supply_mv);
    } else {
        self->odd_looks = 0U;
    }
    set(self, CARD_TROUBLE_DRIVER_WARM,
        is_hotter(self, CARD_TROUBLE_DRIVER_WARM, heat_dc, (int32_t)LIMIT_CARD_DRIVER_WARM_DC));
    set(self, CARD_TROUBLE_DRIVER_HOT,
        is_hotter(self, CARD_TROUBLE_DRIVER_HOT, heat_dc, (int32_t)LIMIT_CARD_DRIVER_HOT_DC));
    judge_count(self, CARD_TROUBLE_COMMANDS_REFUSED, has_grown(self, self->refused, refused),
                &self->calm_refused);
    judge_count(self, CARD_TROUBLE_WATCHDOG_TRIPPED,
                has_grown(self, self->trips, report->watchdog_trips), &self->calm_trips);
    self->refused = refused;
    self->trips = report->watchdog_trips;
    self->has_looked = 1U;
    return before ^ self->troubles;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "control/cycle_lane.h"

#include "bsp.h"
#include "check/realtime.h"
#include "exchange/exchange_cycles.h"
#include "limits/requirement_limits.h"

#define PATIENCE_NS (UINT64_C(1000) * LIMIT_RECORDER_PATIENCE_US)
#define NAP_NS UINT64_C(2000000)

static bool has_room(const cycle_lane_t *self, exchange_t *exchange)
{
    const uint32_t wanted =
        self->is_gap ? (exchange_cycle_capacity(exchange) / 2U) : EXCHANGE_CYCLE_ENTRIES;

    return exchange_cycle_room(exchange) >= wanted;
}

/* False when the recorder has given no sign of life for too long. */
static bool is_patient(cycle_lane_t *self, const exchange_t *exchange, uint64_t *heard_ns)
{
    const uint32_t beats = exchange_beats(exchange, EXCHANGE_RECORDER);
    const uint64_t now_ns = realtime_now_ns();

    if (beats != self->heard) {
        self->heard = beats;
        *heard_ns = now_ns;
    }
    return (now_ns - *heard_ns) < PATIENCE_NS;
}

void cycle_lane_wait(cycle_lane_t *self, exchange_t *exchange, const volatile sig_atomic_t *stop)
{
    const bool is_heard = exchange_beats(exchange, EXCHANGE_RECORDER) != self->heard;
    bool is_full = !has_room(self, exchange);

    if (!is_full || (self->has_waited && !is_heard)) {
        return;
    }
    uint64_t heard_ns = realtime_now_ns();
    while (is_full && (*stop == 0) && is_patient(self, exchange, &heard_ns)) {
        bsp_stand_still_ns(NAP_NS);
        exchange_beat(exchange, EXCHANGE_CONTROL);
        is_full = !has_room(self, exchange);
    }
    self->has_waited = is_full;
}

bool cycle_lane_look(cycle_lane_t *self, exchange_t *exchange)
{
    const bool was_gap = self->is_gap;

    self->is_gap = !has_room(self, exchange);
    self->lost += self->is_gap ? 1U : 0U;
    return was_gap && !self->is_gap;
}

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

void cycle_lane_wait(cycle_lane_t *self, exchange_t *exchange, const volatile sig_atomic_t *stop)
{
    const bool has_read = exchange_cycles_released(exchange) != self->released;
    bool is_full = !has_room(self, exchange);

    if (!is_full || (self->has_waited && !has_read)) {
        return;
    }
    const uint64_t end_ns = realtime_now_ns() + PATIENCE_NS;
    while (is_full && (*stop == 0) && (realtime_now_ns() < end_ns)) {
        bsp_stand_still_ns(NAP_NS);
        exchange_beat(exchange, EXCHANGE_CONTROL);
        is_full = !has_room(self, exchange);
    }
    self->has_waited = is_full;
    self->released = exchange_cycles_released(exchange);
}

bool cycle_lane_look(cycle_lane_t *self, exchange_t *exchange)
{
    const bool was_gap = self->is_gap;

    self->is_gap = !has_room(self, exchange);
    self->lost += self->is_gap ? 1U : 0U;
    return was_gap && !self->is_gap;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "control/cycle_lane.h"

#include "bsp.h"
#include "check/realtime.h"
#include "exchange/exchange_cycles.h"
#include "limits/requirement_limits.h"

#define TIMEOUT_NS (UINT64_C(1000) * LIMIT_RECORDER_ANSWER_CLOCK_US)
#define NAP_NS UINT64_C(2000000)
#define SILENT_NS (UINT64_C(1000) * LIMIT_RECORDER_SILENT_US)
#define PROOF_NS (UINT64_C(1000) * LIMIT_RECORDER_PROOF_US)

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
    return (now_ns - *heard_ns) < TIMEOUT_NS;
}

/* False while the recorder is not to be waited for. */
static bool is_full(const cycle_lane_t *self, exchange_t *exchange)
{
    return !exchange_is_recorder_failing(exchange) && !has_room(self, exchange);
}

void cycle_lane_wait(cycle_lane_t *self, exchange_t *exchange, const volatile sig_atomic_t *stop)
{
    const bool is_heard = exchange_beats(exchange, EXCHANGE_RECORDER) != self->heard;
    bool is_held = is_full(self, exchange);

    if (!is_held || (self->has_waited && !is_heard)) {
        return;
    }
    uint64_t heard_ns = realtime_now_ns();
    while (is_held && (*stop == 0) && is_patient(self, exchange, &heard_ns)) {
        bsp_stand_still_ns(NAP_NS);
        exchange_beat(exchange, EXCHANGE_CONTROL);
        is_held = is_full(self, exchange);
    }
    self->has_waited = is_held;
}

/* A count that comes from damage goes back, or far. */
static uint32_t newly_removed(cycle_lane_t *self, const exchange_t *exchange)
{
    const uint32_t reported = exchange_cycles_removed(exchange);
    const uint32_t more = reported - self->removed;

    if (more > (uint32_t)INT32_MAX) {
        return 0U;
    }
    self->removed = reported;
    return more;
}

bool cycle_lane_look(cycle_lane_t *self, exchange_t *exchange)
{
    const bool was_gap = self->is_gap;

    const uint32_t removed = newly_removed(self, exchange);
    const bool is_stopped = exchange_is_recorder_failing(exchange);
    self->is_failing = is_stopped || (removed != 0U);
    self->is_gap = is_stopped || !has_room(self, exchange);
    self->lost += removed + (self->is_gap ? 1U : 0U);
    return was_gap && !self->is_gap;
}

bool cycle_lane_lacks_recorder(cycle_lane_t *self, const exchange_t *exchange)
{
    const uint32_t beats = exchange_beats(exchange, EXCHANGE_RECORDER);
    const uint64_t now_ns = realtime_now_ns();

    if ((beats != self->beats) || (self->beaten_ns == 0U)) {
        self->beats = beats;
        self->beaten_ns = now_ns;
    }
    if (self->is_gap) {
        self->gap_ns = now_ns;
    }
    return ((self->gap_ns != 0U) && ((now_ns - self->gap_ns) < PROOF_NS)) ||
           ((now_ns - self->beaten_ns) >= SILENT_NS);
}

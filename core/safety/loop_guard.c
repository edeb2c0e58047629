/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/loop_guard.h"

#include "limits/requirement_limits.h"

void loop_guard_init(loop_guard_t *self)
{
    loop_guard_chart_init(&self->chart);
    self->sealed.overruns = 0U;
    self->sealed.lateness = (loop_lateness_t){.count = 0U};
}

static uint32_t add(uint32_t one, uint32_t other)
{
    uint32_t sum = UINT32_MAX;
    if (one <= (UINT32_MAX - other)) {
        sum = one + other;
    }
    return sum;
}

/* While the loop is stopped, what has stopped it stands. */
static void keep(loop_guard_t *self, uint32_t elapsed_us, uint32_t stage, bool is_late)
{
    loop_lateness_t *const lateness = &self->sealed.lateness;
    if (self->chart.state == LOOP_GUARD_STATE_STOPPED) {
        return;
    }
    if (self->chart.state == LOOP_GUARD_STATE_ON_TIME) {
        *lateness = (loop_lateness_t){.count = 0U};
    }
    lateness->span_us = add(lateness->span_us, elapsed_us);
    if (is_late) {
        lateness->count = add(lateness->count, 1U);
        if (elapsed_us > lateness->longest_us) {
            lateness->longest_us = elapsed_us;
            lateness->longest_stage = stage;
        }
    }
}

void loop_guard_step(loop_guard_t *self, uint32_t elapsed_us, uint32_t stage)
{
    const bool is_late = elapsed_us > LIMIT_OVERRUN_US;
    (void)loop_guard_chart_advance(&self->chart, elapsed_us);
    if (is_late || (self->chart.state != LOOP_GUARD_STATE_ON_TIME)) {
        keep(self, elapsed_us, stage, is_late);
    }
    /* A cycle that counts as many late ones is counted once. */
    const uint32_t times =
        (elapsed_us > LIMIT_LOOP_SILENT_US) ? LIMIT_OVERRUNS_IN_A_ROW : (uint32_t)1U;
    const loop_guard_event_t event = is_late ? LOOP_GUARD_EVENT_LATE : LOOP_GUARD_EVENT_PUNCTUAL;
    uint32_t actions = 0U;
    for (uint32_t i = 0U; i < times; i++) {
        actions = loop_guard_chart_dispatch(&self->chart, event);
    }
    if (((actions & LOOP_GUARD_ACTION_COUNT_OVERRUN) != 0U) &&
        (self->sealed.overruns < UINT32_MAX)) {
        self->sealed.overruns++;
    }
}

void loop_guard_reset(loop_guard_t *self)
{
    (void)loop_guard_chart_dispatch(&self->chart, LOOP_GUARD_EVENT_RESET);
}

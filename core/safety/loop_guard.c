/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/loop_guard.h"

#include "limits/requirement_limits.h"

void loop_guard_init(loop_guard_t *self)
{
    loop_guard_chart_init(&self->chart);
    self->overruns = 0U;
}

void loop_guard_step(loop_guard_t *self, uint32_t elapsed_us)
{
    (void)loop_guard_chart_advance(&self->chart, elapsed_us);
    const loop_guard_event_t event =
        (elapsed_us > LIMIT_OVERRUN_US) ? LOOP_GUARD_EVENT_LATE : LOOP_GUARD_EVENT_PUNCTUAL;
    const uint32_t actions = loop_guard_chart_dispatch(&self->chart, event);
    if (((actions & LOOP_GUARD_ACTION_COUNT_OVERRUN) != 0U) && (self->overruns < UINT32_MAX)) {
        self->overruns++;
    }
}

void loop_guard_reset(loop_guard_t *self)
{
    (void)loop_guard_chart_dispatch(&self->chart, LOOP_GUARD_EVENT_RESET);
}

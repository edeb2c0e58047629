/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/edge_pace.h"

#include "limits/requirement_limits.h"

#define DUE_SHIFT 15U

void edge_pace_settle(edge_pace_t *self)
{
    self->uneven = 0U;
}

void edge_pace_rest(edge_pace_t *self)
{
    self->speed_ticks_per_s_q8 = 0U;
}

static bool is_much_more(uint64_t one, uint64_t other)
{
    return (one * 100U) > (other * LIMIT_PACE_CHANGE_PERCENT);
}

/* Way by time of the two, crosswise, without a quotient. */
static void compare(edge_pace_t *self, uint32_t ticks, uint32_t due)
{
    const uint64_t one = (uint64_t)due * self->ticks;
    const uint64_t other = (uint64_t)self->due * ticks;
    if (is_much_more(one, other) || is_much_more(other, one)) {
        self->uneven += LIMIT_UNEVEN_WEIGHT;
    } else {
        self->uneven -= (self->uneven > 0U) ? 1U : 0U;
    }
}

bool edge_pace_step(edge_pace_t *self, uint32_t ticks, uint32_t edge_us,
                    uint32_t speed_ticks_per_s_q8)
{
    const uint32_t time_us = edge_us - self->edge_us;
    const uint32_t before_q8 = self->speed_ticks_per_s_q8;
    self->edge_us = edge_us;
    self->speed_ticks_per_s_q8 = speed_ticks_per_s_q8;
    if ((before_q8 == 0U) || (time_us >= LIMIT_SPEED_TIMEOUT_US)) {
        return false;
    }
    const uint64_t speeds_q8 = (uint64_t)before_q8 + speed_ticks_per_s_q8;
    const uint32_t due = (uint32_t)((speeds_q8 * time_us) >> DUE_SHIFT);
    if (self->ticks != 0U) {
        compare(self, ticks, due);
    }
    self->ticks = ticks;
    self->due = due;
    return self->uneven >= LIMIT_UNEVEN_MOST;
}

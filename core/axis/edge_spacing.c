/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/edge_spacing.h"

#include "limits/requirement_limits.h"

#include <string.h>

#define UNKNOWN UINT32_MAX

void edge_spacing_init(edge_spacing_t *self)
{
    (void)memset(self, 0, sizeof *self);
    self->since_q16 = UNKNOWN;
}

void edge_spacing_settle(edge_spacing_t *self)
{
    self->uneven = 0U;
}

void edge_spacing_begin(edge_spacing_t *self)
{
    self->since_q16 = UNKNOWN;
    self->ended_q16 = 0U;
}

static bool is_much_more(uint64_t one, uint64_t other)
{
    return (one * 100U) > (other * LIMIT_PACE_CHANGE_PERCENT);
}

/* Way by counts of the two, crosswise. */
static void compare(edge_spacing_t *self, uint32_t ticks, uint32_t due_q16)
{
    const uint64_t one = (uint64_t)due_q16 * self->ticks;
    const uint64_t other = (uint64_t)self->due_q16 * ticks;
    if (is_much_more(one, other) || is_much_more(other, one)) {
        self->uneven += LIMIT_UNEVEN_WEIGHT;
    } else {
        self->uneven -= (self->uneven > 0U) ? 1U : 0U;
    }
}

bool edge_spacing_step(edge_spacing_t *self, const edge_spacing_view_t *view)
{
    const bool is_known = self->since_q16 != UNKNOWN;
    const uint32_t after_q16 = (view->after_q16 < view->way_q16) ? view->after_q16 : view->way_q16;
    self->ended_q16 = 0U;
    if (view->ticks == 0U) {
        self->since_q16 += is_known ? view->way_q16 : 0U;
        return false;
    }
    const uint32_t due_q16 = self->since_q16 + (view->way_q16 - after_q16);
    self->since_q16 = after_q16;
    if (!is_known) {
        return false;
    }
    if (self->ticks != 0U) {
        compare(self, view->ticks, due_q16);
    }
    self->ticks = view->ticks;
    self->due_q16 = due_q16;
    self->ended_q16 = due_q16;
    return self->uneven >= LIMIT_UNEVEN_MOST;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/hand_guard.h"

#include "limits/requirement_limits.h"
#include "safety/permit.h"

void hand_guard_step(hand_guard_t *self, const hand_law_t *law, const hand_t *hand,
                     uint32_t elapsed_us)
{
    const bool is_push = hand->is_trusted && ((int64_t)hand->force_mn > (int64_t)law->dead_zone_mn);
    if (is_push) {
        self->left_us = LIMIT_HAND_OFF_US;
    } else {
        self->left_us -= (elapsed_us < self->left_us) ? elapsed_us : self->left_us;
    }
}

uint32_t hand_guard_reasons(const hand_guard_t *self, const hand_t *hand, int64_t left_ticks)
{
    return permit_reason(!hand->is_trusted, PERMIT_REASON_FORCE_DOUBTFUL) |
           permit_reason(self->left_us == 0U, PERMIT_REASON_HAND_OFF) |
           permit_reason(left_ticks <= 0, PERMIT_REASON_AT_DEPTH);
}

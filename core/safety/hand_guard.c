/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/hand_guard.h"

#include "limits/requirement_limits.h"
#include "safety/permit.h"

static uint32_t less(uint32_t left_us, uint32_t elapsed_us)
{
    return left_us - ((elapsed_us < left_us) ? elapsed_us : left_us);
}

/* A zero that is wrong or drifts, or a sensor that is stuck, looks like a hand that never lets go:
 * no proof lasts longer than one push may. */
static void prove(hand_guard_t *self, bool is_quiet, bool is_moving, uint32_t elapsed_us)
{
    const uint32_t room_us = LIMIT_HAND_PROOF_US - self->quiet_us;
    self->quiet_us =
        is_quiet ? (self->quiet_us + ((elapsed_us < room_us) ? elapsed_us : room_us)) : 0U;
    if (self->quiet_us >= LIMIT_HAND_PROOF_US) {
        self->proven_us = LIMIT_HAND_PUSH_US;
    } else if (!is_moving) {
        self->proven_us = 0U;
    } else {
        self->proven_us = less(self->proven_us, elapsed_us);
    }
}

int32_t hand_guard_step(hand_guard_t *self, const hand_law_t *law, const hand_t *hand,
                        bool is_moving, uint32_t elapsed_us)
{
    const int64_t force_mn = (int64_t)hand->force_mn;
    const int64_t dead_mn = (int64_t)law->dead_zone_mn;
    prove(self, hand->is_trusted && (force_mn <= dead_mn) && (force_mn >= -dead_mn), is_moving,
          elapsed_us);
    if (hand->is_trusted && (force_mn > dead_mn) && (self->proven_us != 0U)) {
        self->left_us = LIMIT_HAND_OFF_US;
    } else {
        self->left_us = less(self->left_us, elapsed_us);
    }
    return (self->proven_us != 0U) ? hand->force_mn : 0;
}

uint32_t hand_guard_reasons(const hand_guard_t *self, const hand_t *hand, int64_t left_ticks)
{
    return permit_reason(!hand->is_trusted, PERMIT_REASON_FORCE_DOUBTFUL) |
           permit_reason(self->proven_us == 0U, PERMIT_REASON_HAND_UNPROVEN) |
           permit_reason(self->left_us == 0U, PERMIT_REASON_HAND_OFF) |
           permit_reason(left_ticks <= 0, PERMIT_REASON_AT_DEPTH);
}

/* SPDX-License-Identifier: Apache-2.0 */
/* A hand that moves the needle, from any state of its guard, for every force, law and time. */
#include "prove.h"

#include "limits/requirement_limits.h"
#include "safety/hand_guard.h"
#include "safety/permit.h"

static bool has(uint32_t reasons, permit_reason_t name)
{
    return ((reasons >> (uint32_t)name) & 1U) != 0U;
}

void prove_SWR_COOP_008_no_drive_without_a_trusted_push_of_just_now_nor_beyond_the_depth(void)
{
    hand_guard_t guard;
    hand_law_t law;
    hand_t hand;
    uint32_t elapsed_us;
    int64_t left_ticks;
    const uint32_t left_us = guard.left_us;
    const bool is_push = hand.is_trusted && ((int64_t)hand.force_mn > (int64_t)law.dead_zone_mn);
    assume(left_us <= LIMIT_HAND_OFF_US);

    hand_guard_step(&guard, &law, &hand, elapsed_us);
    const uint32_t reasons = hand_guard_reasons(&guard, &hand, left_ticks);

    PROVE(guard.left_us <= LIMIT_HAND_OFF_US, "SWR-COOP-008: the next cycle may rely on it");
    PROVE(SAME(has(reasons, PERMIT_REASON_FORCE_DOUBTFUL), !hand.is_trusted),
          "SWR-COOP-008: a force that is not trusted bars every drive");
    PROVE(SAME(has(reasons, PERMIT_REASON_HAND_OFF), !is_push && (elapsed_us >= left_us)),
          "SWR-COOP-008: no drive once the last push is over for its time");
    PROVE(SAME(has(reasons, PERMIT_REASON_AT_DEPTH), (left_ticks <= 0)),
          "SWR-COOP-008: no drive at the depth or beyond");
    POSSIBLE(reasons == 0U, "a drive");
}

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
    bool is_moving;
    const hand_guard_t before = guard;
    const int64_t force_mn = (int64_t)hand.force_mn;
    const int64_t dead_mn = (int64_t)law.dead_zone_mn;
    const bool is_quiet = hand.is_trusted && (force_mn <= dead_mn) && (force_mn >= -dead_mn);
    assume((before.left_us <= LIMIT_HAND_OFF_US) && (before.quiet_us <= LIMIT_HAND_PROOF_US) &&
           (before.proven_us <= LIMIT_HAND_PUSH_US));

    const int32_t felt_mn = hand_guard_step(&guard, &law, &hand, is_moving, elapsed_us);
    const bool is_push = hand.is_trusted && (force_mn > dead_mn) && (guard.proven_us != 0U);
    const uint32_t reasons = hand_guard_reasons(&guard, &hand, left_ticks);

    PROVE((guard.left_us <= LIMIT_HAND_OFF_US) && (guard.quiet_us <= LIMIT_HAND_PROOF_US) &&
              (guard.proven_us <= LIMIT_HAND_PUSH_US),
          "SWR-COOP-008: the next cycle may rely on it");
    PROVE(IMPLIES((guard.proven_us != 0U) && (before.proven_us == 0U),
                  is_quiet && (guard.quiet_us == LIMIT_HAND_PROOF_US)),
          "SWR-COOP-012: a hand is proven by having been off for its time");
    PROVE(IMPLIES(!is_quiet && (before.proven_us <= elapsed_us), guard.proven_us == 0U),
          "SWR-COOP-013: no push goes on for longer than its time");
    PROVE(IMPLIES(!is_quiet && (before.proven_us > elapsed_us),
                  guard.proven_us <= (before.proven_us - elapsed_us)),
          "SWR-COOP-013: all of the time that it lasts is counted");
    PROVE(IMPLIES(!is_moving && !is_quiet, guard.proven_us == 0U),
          "SWR-COOP-012: without the pedal a hand that pushes is not proven");
    PROVE(felt_mn == ((guard.proven_us != 0U) ? hand.force_mn : 0),
          "SWR-COOP-012: a hand that was not seen off moves nothing");
    PROVE(SAME(has(reasons, PERMIT_REASON_HAND_UNPROVEN), guard.proven_us == 0U),
          "SWR-COOP-012: nor does the permit let it");
    PROVE(SAME(has(reasons, PERMIT_REASON_FORCE_DOUBTFUL), !hand.is_trusted),
          "SWR-COOP-008: a force that is not trusted bars every drive");
    PROVE(SAME(has(reasons, PERMIT_REASON_HAND_OFF), !is_push && (elapsed_us >= before.left_us)),
          "SWR-COOP-008: no drive once the last push is over for its time");
    PROVE(SAME(has(reasons, PERMIT_REASON_AT_DEPTH), (left_ticks <= 0)),
          "SWR-COOP-008: no drive at the depth or beyond");
    POSSIBLE(reasons == 0U, "a drive");
}

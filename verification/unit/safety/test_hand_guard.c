/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: while a hand moves the needle, nothing is driven without a trusted force,
 * without a push of just now, or beyond the depth.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "safety/hand_guard.h"
#include "safety/permit.h"

#define CYCLE_US LIMIT_CYCLE_US
#define DEAD_ZONE_MN 300
#define LEFT_TICKS 100

static const hand_law_t law = {.dead_zone_mn = (uint32_t)DEAD_ZONE_MN};
static const hand_t push = {.force_mn = DEAD_ZONE_MN + 1, .is_trusted = true};
static const hand_t open_hand = {.force_mn = DEAD_ZONE_MN, .is_trusted = true};
static const hand_t doubtful_push = {.force_mn = 5000, .is_trusted = false};

static hand_guard_t guard;

static int32_t feel(const hand_t *hand)
{
    return hand_guard_step(&guard, &law, hand, true, CYCLE_US);
}

/* A hand that was seen off, with the pedal pressed. */
void setUp(void)
{
    guard = (hand_guard_t){0};
    for (uint32_t us = 0U; us < LIMIT_HAND_PROOF_US; us += CYCLE_US) {
        (void)feel(&open_hand);
    }
}

void tearDown(void)
{
}

static bool has(const hand_t *hand, int64_t left_ticks, permit_reason_t reason)
{
    const uint32_t reasons = hand_guard_reasons(&guard, hand, left_ticks);
    return (reasons & permit_reason(true, reason)) != 0U;
}

static bool is_off(const hand_t *hand)
{
    return has(hand, LEFT_TICKS, PERMIT_REASON_HAND_OFF);
}

void test_SWR_COOP_008_at_first_no_hand_pushes(void)
{
    TEST_ASSERT_TRUE(is_off(&open_hand));
}

void test_SWR_COOP_008_a_push_lets_the_needle_go_for_a_short_time(void)
{
    (void)feel(&push);
    TEST_ASSERT_EQUAL_HEX32(0U, hand_guard_reasons(&guard, &push, LEFT_TICKS));
    for (uint32_t us = CYCLE_US; us < LIMIT_HAND_OFF_US; us += CYCLE_US) {
        (void)feel(&open_hand);
        TEST_ASSERT_FALSE(is_off(&open_hand));
    }
    (void)feel(&open_hand);
    TEST_ASSERT_TRUE(is_off(&open_hand));
    (void)feel(&open_hand);
    TEST_ASSERT_TRUE(is_off(&open_hand));
}

void test_SWR_COOP_008_a_late_cycle_counts_for_all_of_its_time(void)
{
    (void)feel(&push);
    (void)hand_guard_step(&guard, &law, &open_hand, true, LIMIT_HAND_OFF_US + 1U);
    TEST_ASSERT_TRUE(is_off(&open_hand));
}

void test_SWR_COOP_008_a_doubtful_force_is_no_push_and_a_reason_of_its_own(void)
{
    (void)feel(&doubtful_push);
    TEST_ASSERT_TRUE(is_off(&doubtful_push));
    (void)feel(&push);
    TEST_ASSERT_EQUAL_HEX32(permit_reason(true, PERMIT_REASON_FORCE_DOUBTFUL),
                            hand_guard_reasons(&guard, &doubtful_push, LEFT_TICKS));
}

void test_SWR_COOP_008_no_way_is_left_at_the_depth_or_beyond(void)
{
    (void)feel(&push);
    TEST_ASSERT_FALSE(has(&push, 1, PERMIT_REASON_AT_DEPTH));
    TEST_ASSERT_TRUE(has(&push, 0, PERMIT_REASON_AT_DEPTH));
    TEST_ASSERT_TRUE(has(&push, -1, PERMIT_REASON_AT_DEPTH));
}

void test_SWR_COOP_012_a_hand_that_never_lets_go_moves_nothing(void)
{
    guard = (hand_guard_t){0};
    for (uint32_t i = 0U; i < 1000U; i++) {
        TEST_ASSERT_EQUAL_INT32(0, feel(&push));
        TEST_ASSERT_TRUE(has(&push, LEFT_TICKS, PERMIT_REASON_HAND_UNPROVEN));
        TEST_ASSERT_TRUE(is_off(&push));
    }
}

void test_SWR_COOP_012_it_was_off_for_all_of_the_time_without_a_pull(void)
{
    static const hand_t pull = {.force_mn = -DEAD_ZONE_MN - 1, .is_trusted = true};
    guard = (hand_guard_t){0};
    for (uint32_t us = CYCLE_US; us < LIMIT_HAND_PROOF_US; us += CYCLE_US) {
        (void)feel(&open_hand);
    }
    (void)feel(&pull);
    for (uint32_t us = CYCLE_US; us < LIMIT_HAND_PROOF_US; us += CYCLE_US) {
        (void)feel(&open_hand);
        TEST_ASSERT_TRUE(has(&open_hand, LEFT_TICKS, PERMIT_REASON_HAND_UNPROVEN));
    }
    (void)feel(&open_hand);
    TEST_ASSERT_FALSE(has(&open_hand, LEFT_TICKS, PERMIT_REASON_HAND_UNPROVEN));
    TEST_ASSERT_EQUAL_INT32(push.force_mn, feel(&push));
}

/* It goes on pushing while the foot leaves the pedal. */
void test_SWR_COOP_012_without_the_pedal_a_push_has_to_be_proven_anew(void)
{
    TEST_ASSERT_EQUAL_INT32(push.force_mn, feel(&push));
    TEST_ASSERT_EQUAL_INT32(0, hand_guard_step(&guard, &law, &push, false, CYCLE_US));
    TEST_ASSERT_EQUAL_INT32(0, feel(&push));
    TEST_ASSERT_TRUE(has(&push, LEFT_TICKS, PERMIT_REASON_HAND_UNPROVEN));
}

/* A drift is no sudden thing: without an end to each push it would move the needle for good. */
void test_SWR_COOP_013_a_push_ends_after_its_time_until_the_hand_was_seen_off(void)
{
    for (uint32_t us = CYCLE_US; us < LIMIT_HAND_PUSH_US; us += CYCLE_US) {
        TEST_ASSERT_EQUAL_INT32(push.force_mn, feel(&push));
        TEST_ASSERT_FALSE(has(&push, LEFT_TICKS, PERMIT_REASON_HAND_UNPROVEN));
    }
    for (uint32_t i = 0U; i < 1000U; i++) {
        TEST_ASSERT_EQUAL_INT32(0, feel(&push));
        TEST_ASSERT_TRUE(has(&push, LEFT_TICKS, PERMIT_REASON_HAND_UNPROVEN));
    }
    for (uint32_t us = 0U; us < LIMIT_HAND_PROOF_US; us += CYCLE_US) {
        (void)feel(&open_hand);
    }
    TEST_ASSERT_EQUAL_INT32(push.force_mn, feel(&push));
}

void test_SWR_COOP_013_pushes_in_short_turns_count_as_one(void)
{
    uint32_t us = 0U;
    for (; us < (LIMIT_HAND_PUSH_US + (2U * CYCLE_US)); us += CYCLE_US) {
        (void)feel(((us % LIMIT_HAND_PROOF_US) == 0U) ? &push : &open_hand);
    }
    TEST_ASSERT_EQUAL_INT32(0, feel(&push));
}

void test_SWR_COOP_013_a_late_cycle_counts_for_all_of_its_time(void)
{
    TEST_ASSERT_EQUAL_INT32(0, hand_guard_step(&guard, &law, &push, true, LIMIT_HAND_PUSH_US));
}

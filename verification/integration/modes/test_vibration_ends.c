/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the vibration that answers a puncture ends with the pedal, the hand or a doubt,
 * is in the log, and leads the needle nowhere afterwards.
 */
#include "integration/support/by_hand.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "limits/requirement_limits.h"

#include <math.h>

#include "integration/support/vibration_world.inc"

#define STILL_TICKS 3.0     /* Way that a motor runs on after it was switched off. */
#define FILTERED_CYCLES 30U /* From a hand that lets go to a force below the dead zone. */

void setUp(void)
{
    by_hand_start(&rig, ENTRY_Z_NM, TARGET_Z_NM);
    witness = (witness_t){0};
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static bool is_driven(void)
{
    return rig.outputs.snapshot.axes[BY_HAND_NEEDLE].drive_mode != (uint32_t)CARD_DRIVE_OFF;
}

/* In each part of the vibration. */
void test_SWR_VIB_704_without_the_pedal_it_stops_in_the_same_cycle_and_is_not_resumed(void)
{
    for (uint32_t after = 0U; after < 400U; after += 23U) {
        setUp();
        begin_vibration();
        for (uint32_t i = 0U; i < after; i++) {
            cycle(GRIP_MN);
        }
        rig_box(&rig, "pedal release");
        const uint32_t pressed = rig.outputs.snapshot.pedal;
        while (rig.outputs.snapshot.pedal == pressed) {
            rig_cycle(&rig);
        }
        TEST_ASSERT_FALSE(is_driven());
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(is_vibrating());
        const double there = needle_ticks();
        rig_cycles(&rig, 300U);
        TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, needle_ticks());
        rig_box(&rig, "hand release");
        rig_cycles(&rig, BY_HAND_OFF_CYCLES);
        rig_press(&rig);
        rig_cycles(&rig, 300U);
        TEST_ASSERT_FALSE(is_vibrating());
        TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, needle_ticks());
    }
}

void test_SWR_VIB_704_without_the_hand_it_stops_soon(void)
{
    begin_vibration();
    rig_box(&rig, "hand release");
    rig_cycles(&rig, FILTERED_CYCLES);
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_FALSE(is_vibrating());
    const double there = needle_ticks();
    rig_cycles(&rig, 500U);
    TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, needle_ticks());
}

/* Each end of the insertion ends the vibration, in the cycle that notices. */
void test_SWR_VIB_704_scanner_emergency_stop_and_doubt_end_it(void)
{
    static const char *const ends[] = {"scanner on", "estop pull", "force hand broken"};
    for (uint32_t i = 0U; i < (sizeof ends / sizeof ends[0]); i++) {
        setUp();
        begin_vibration();
        rig_box(&rig, ends[i]);
        uint32_t cycles = 0U;
        while (is_vibrating() && (cycles < 20U)) {
            rig_cycle(&rig);
            cycles++;
        }
        TEST_ASSERT_FALSE(is_driven());
        TEST_ASSERT_FALSE(is_vibrating());
        const double there = needle_ticks();
        rig_cycles(&rig, 500U);
        TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, needle_ticks());
    }
}

/* Where the last event of the kind says that it was. */
static int32_t last_um(event_id_t id)
{
    int32_t depth_um = INT32_MIN;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        depth_um = (rig.events[i].id == (uint32_t)id) ? (rig.events[i].value / 1000) : depth_um;
    }
    return depth_um;
}

static uint32_t cuts(void)
{
    return rig_count(&rig, EVENT_VIBRATION_CUT);
}

void test_SWR_VIB_753_each_that_begins_is_in_the_log(void)
{
    insert();
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_VIBRATION_BEGUN));
    TEST_ASSERT_EQUAL_UINT32(0U, cuts());
}

void test_SWR_VIB_753_one_that_is_ended_is_in_the_log_whatever_ends_it(void)
{
    static const char *const ends[] = {"hand release", "pedal release", "scanner on",
                                       "force hand broken"};
    for (uint32_t i = 0U; i < (sizeof ends / sizeof ends[0]); i++) {
        setUp();
        begin_vibration();
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_VIBRATION_BEGUN));
        TEST_ASSERT_EQUAL_UINT32(0U, cuts());
        const int32_t there_um = rig.outputs.snapshot.membranes.depth_um;
        rig_box(&rig, ends[i]);
        rig_cycles(&rig, 2U * FILTERED_CYCLES);
        TEST_ASSERT_EQUAL_UINT32(1U, cuts());
        TEST_ASSERT_INT32_WITHIN((int32_t)LIMIT_VIBRATION_MOST_UM, there_um,
                                 last_um(EVENT_VIBRATION_CUT));
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(there_um, last_um(EVENT_VIBRATION_BEGUN));
    }
}

/* It pushes hardest just behind the membrane, as it has braced itself against a needle that stood.
 */
void test_SWR_VIB_703_a_hand_that_never_lets_go_leads_it_nowhere_afterwards(void)
{
    begin_vibration();
    by_hand_push(&rig, 2 * GRIP_MN);
    while (is_vibrating()) {
        rig_cycle(&rig);
        look();
    }
    const double there = needle_ticks();
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_TRUE(fabs(needle_ticks() - there) <= TICKS_PER_UM);
    TEST_ASSERT_NOT_EQUAL_HEX32(0U, rig.outputs.snapshot.axes[BY_HAND_NEEDLE].permit_reasons &
                                        permit_reason(true, PERMIT_REASON_HAND_UNPROVEN));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_LET_GO, rig.outputs.snapshot.next_step);
    rig_box(&rig, "hand release");
    rig_cycles(&rig, BY_HAND_OFF_CYCLES);
    by_hand_push(&rig, GRIP_MN);
    rig_cycles(&rig, BY_HAND_OFF_CYCLES);
    TEST_ASSERT_TRUE(is_driven());
}

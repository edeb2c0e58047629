/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: while a hand inserts the needle, membranes are found, named and counted, the
 * controller says when it can find none, and moves nothing otherwise by them.
 */
#include "integration/support/by_hand.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "base/seal.h"
#include "controller/controller.h"
#include "limits/requirement_limits.h"

#include <stddef.h>
#include <string.h>

#include "integration/support/membranes_world.inc"

#define NOWHERE_UM 40000
#define NEAR_UM 1000
#define LATE_UM 400        /* From a puncture to its report. */
#define AFTER_CYCLES 2000U /* Behind the end of an insertion nothing is driven. */

void setUp(void)
{
    by_hand_start(&rig, ENTRY_Z_NM, TARGET_Z_NM);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void insert_to(int32_t depth_um)
{
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (shown()->depth_um < depth_um); i++) {
        cycle();
    }
    TEST_ASSERT_GREATER_OR_EQUAL_INT32(depth_um, shown()->depth_um);
}

static void insert(void)
{
    begin();
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, finish());
    rig_cycle(&rig);
}

/* Where the box has ruptured membrane `number`, below the entry point. */
static int32_t truth_um(uint32_t number)
{
    const double home_mm =
        box_depth_mm(&rig.box) - ((double)rig_position(&rig, BY_HAND_NEEDLE) / 1666.67);
    const double target_mm =
        home_mm + ((double)rig.controller.plan.target_ticks[BY_HAND_NEEDLE] / 1666.67);
    const double left_mm = target_mm - rig.box.force.tissue.popped_at_mm[number];
    return ((TARGET_Z_NM - ENTRY_Z_NM) / 1000) - (int32_t)(left_mm * 1000.0);
}

void test_SWR_PUNCT_610_expected_membranes_are_found_where_they_are_punctured(void)
{
    const int32_t depths_um[] = {FIRST_UM, SECOND_UM};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(2U, depths_um));
    insert();
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_MEMBRANE_FOUND));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED));
    for (uint32_t i = 0U; i < 2U; i++) {
        const event_t *const found = event_of(EVENT_MEMBRANE_FOUND, i);
        TEST_ASSERT_INT32_WITHIN(LATE_UM, truth_um(i), found->value / 1000);
        TEST_ASSERT_GREATER_THAN_UINT32(LIMIT_MEMBRANE_LEAST_MN, found->subject);
        TEST_ASSERT_EQUAL_UINT32(MEMBRANE_FOUND, shown()->membranes[i].state);
        TEST_ASSERT_EQUAL_INT32(found->value / 1000, shown()->membranes[i].found_um);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->left);
}

void test_SWR_PUNCT_610_those_that_are_not_expected_are_named_so(void)
{
    insert();
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANE_FOUND));
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED));
    TEST_ASSERT_EQUAL_UINT32(2U, shown()->unexpected);
    TEST_ASSERT_INT32_WITHIN(LATE_UM, truth_um(1U),
                             event_of(EVENT_MEMBRANE_UNEXPECTED, 1U)->value / 1000);
}

void test_SWR_PUNCT_610_a_needle_that_goes_in_anew_has_all_of_them_ahead(void)
{
    expect_one(FIRST_UM);
    insert();
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->left);
    by_hand_push(&rig, 0);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(
        STATUS_OK, rig_command(&rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT}).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->left);
    rig_release(&rig);
    rig_cycles(&rig, BY_HAND_OFF_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, cooperate).status);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, shown()->left);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->unexpected);
}

/* Two boxes with the same hand go on together, until the insertion has ended and beyond. */
static void expect_same_drives(rig_t *other, bool is_other_blind)
{
    uint32_t after = 0U;
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (after < AFTER_CYCLES); i++) {
        if (is_other_blind) {
            (void)memset(&other->controller.membranes, 0, sizeof other->controller.membranes);
        }
        move_hand(other);
        cycle();
        rig_cycle(other);
        TEST_ASSERT_EQUAL_MEMORY(rig.outputs.frames, other->outputs.frames,
                                 sizeof rig.outputs.frames);
        TEST_ASSERT_EQUAL_UINT32(rig.outputs.snapshot.order, other->outputs.snapshot.order);
        after += (rig.outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE) ? 1U : 0U;
    }
    TEST_ASSERT_EQUAL_UINT32(AFTER_CYCLES, after);
}

/* Two boxes have the same hand and tissue, and the controller of one is blinded in each cycle. No
 * vibration answers a puncture. */
void test_SWR_PUNCT_611_the_same_drives_whatever_was_found(void)
{
    static rig_t blind;
    rig.robot.vibration = (vibration_law_t){0};
    rig.robot.seal = seal_of(SEAL_START, (const uint8_t *)&rig.robot, offsetof(robot_t, seal));
    begin();
    blind = rig;
    expect_same_drives(&blind, true);
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&blind, EVENT_MEMBRANE_UNEXPECTED));
}

/* Both vibrate alike: one has a membrane where it expects it, and misses another. */
void test_SWR_PUNCT_611_the_same_drives_whatever_is_expected(void)
{
    static rig_t other;
    const int32_t depths_um[] = {FIRST_UM, NOWHERE_UM};
    other = rig;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(2U, depths_um));
    rig_cycle(&other);
    begin();
    by_hand_enter(&other);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&other, cooperate).status);
    rig_press(&other);
    by_hand_push(&other, GRIP_MN);
    expect_same_drives(&other, false);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANE_MISSED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&other, EVENT_MEMBRANE_MISSED));
}

void test_SWR_PUNCT_612_a_membrane_that_was_passed_is_missed(void)
{
    expect_one(NOWHERE_UM);
    begin();
    insert_to(NOWHERE_UM + (int32_t)LIMIT_MEMBRANE_WINDOW_UM - NEAR_UM);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANE_MISSED));
    TEST_ASSERT_EQUAL_UINT32(1U, shown()->left);
    insert_to(NOWHERE_UM + (int32_t)LIMIT_MEMBRANE_WINDOW_UM + NEAR_UM);
    TEST_ASSERT_EQUAL_UINT32(1U, event_of(EVENT_MEMBRANE_MISSED, 0U)->subject);
    TEST_ASSERT_EQUAL_INT32(NOWHERE_UM * 1000, event_of(EVENT_MEMBRANE_MISSED, 0U)->value);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_MISSED, shown()->membranes[0].state);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->left);
}

/* They are too near to the target to be passed by far. */
void test_SWR_PUNCT_612_at_the_depth_of_the_target_all_that_is_ahead_is_missed(void)
{
    const int32_t depths_um[] = {SECOND_UM, 59000, 59900};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(3U, depths_um));
    insert();
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANE_FOUND));
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_MEMBRANE_MISSED));
    TEST_ASSERT_EQUAL_UINT32(3U, event_of(EVENT_MEMBRANE_MISSED, 1U)->subject);
}

void test_SWR_PUNCT_612_an_insertion_that_was_stopped_has_missed_nothing(void)
{
    expect_one(NOWHERE_UM);
    begin();
    rig_cycles(&rig, PUSHED);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    rig_cycles(&rig, 10U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANE_MISSED));
    TEST_ASSERT_EQUAL_UINT32(1U, shown()->left);
}

/* Below the entry point, with the target known. */
static int32_t needle_um(void)
{
    const double left_ticks = (double)rig.controller.plan.target_ticks[BY_HAND_NEEDLE] -
                              (double)rig_position(&rig, BY_HAND_NEEDLE);
    return (int32_t)(((double)(TARGET_Z_NM - ENTRY_Z_NM) - (left_ticks * 600.0)) / 1000.0);
}

/* One is behind the needle by more than the window, and the next is still to be punctured. */
void test_SWR_PUNCT_752_a_membrane_that_another_mode_has_passed_is_not_missed(void)
{
    const int32_t depths_um[] = {NOWHERE_UM, SECOND_UM, 59900};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(3U, depths_um));
    by_hand_enter(&rig);
    rig_press(&rig);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (needle_um() < (SECOND_UM - (2 * NEAR_UM))); i++) {
        rig_cycle(&rig);
    }
    rig_release(&rig);
    rig_cycles(&rig, BY_HAND_OFF_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(3U, shown()->left);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, cooperate).status);
    rig_press(&rig);
    pushed = 0U;
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, finish());
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANE_PASSED));
    TEST_ASSERT_EQUAL_UINT32(1U, event_of(EVENT_MEMBRANE_PASSED, 0U)->subject);
    TEST_ASSERT_EQUAL_INT32(NOWHERE_UM * 1000, event_of(EVENT_MEMBRANE_PASSED, 0U)->value);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_PASSED, shown()->membranes[0].state);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_FOUND, shown()->membranes[1].state);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_MISSED, shown()->membranes[2].state);
}

/* Its window ends behind the place of the pause. */
void test_SWR_PUNCT_752_a_pause_of_the_hand_hides_nothing(void)
{
    const int32_t depths_um[] = {NOWHERE_UM};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(1U, depths_um));
    begin();
    insert_to(NOWHERE_UM + ((int32_t)LIMIT_MEMBRANE_WINDOW_UM / 2));
    rig_release(&rig);
    rig_box(&rig, "hand release");
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_TARGETING).status);
    rig_cycles(&rig, 500U);
    begin();
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, finish());
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANE_PASSED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANE_MISSED));
}

void test_SWR_PUNCT_752_nor_is_one_that_was_passed_with_a_doubtful_force(void)
{
    const int32_t depths_um[] = {NOWHERE_UM, 59900};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(2U, depths_um));
    begin();
    insert_to(NOWHERE_UM - NEAR_UM);
    rig_box(&rig, "force needle broken");
    (void)finish();
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_MEMBRANE_PASSED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANE_MISSED));
}

void test_SWR_PUNCT_613_it_is_blind_at_rest_and_says_so(void)
{
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_SIGHT_OFF, shown()->sight);
    begin();
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_SIGHT_PAUSED, shown()->sight);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_SIGHT_LOOKING, shown()->sight);
    by_hand_push(&rig, 0);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_EQUAL_INT32(
        0, rig.outputs.snapshot.axes[BY_HAND_NEEDLE].setpoint_speed_ticks_per_s_q8);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_SIGHT_PAUSED, shown()->sight);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_SIGHT_PAUSED, shown()->sight);
}

/* In front of the second membrane, pressed in, the needle stops for seconds, and goes on. */
void test_SWR_PUNCT_613_relaxation_of_the_tissue_is_no_membrane(void)
{
    begin();
    insert_to(SECOND_UM - (2 * NEAR_UM));
    const int32_t before_mn = rig.outputs.snapshot.forces[FORCE_CHANNEL_NEEDLE].force_mn;
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED));
    by_hand_push(&rig, 0);
    rig_cycles(&rig, 4000U);
    TEST_ASSERT_LESS_THAN_INT32(before_mn - (2 * (int32_t)LIMIT_MEMBRANE_LEAST_MN),
                                rig.outputs.snapshot.forces[FORCE_CHANNEL_NEEDLE].force_mn);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED));
    pushed = 0U;
    (void)finish();
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED));
}

/* It has hardly any noise, so that nothing calls it stuck. */
void test_SWR_PUNCT_613_a_reading_that_stands_still_blinds_it(void)
{
    sim_phantom_file_t phantom = rig.box.force.phantom;
    phantom.cells[SIM_CELL_NEEDLE].noise_n = BY_HAND_QUIET_N;
    box_force_lay(&rig.box.force, &phantom);
    by_hand_zero(&rig);
    begin();
    insert_to(FIRST_UM - (4 * NEAR_UM));
    rig_box(&rig, "force needle 1790");
    rig_cycles(&rig, LIMIT_FORCE_STILL_CYCLES + 2U);
    TEST_ASSERT_EQUAL_HEX32(0U, rig.outputs.snapshot.forces[FORCE_CHANNEL_NEEDLE].doubts);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_SIGHT_DOUBTFUL, shown()->sight);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANES_UNSEEN));
}

void test_SWR_PUNCT_613_a_doubtful_force_blinds_it_and_is_named_once(void)
{
    begin();
    rig_cycles(&rig, PUSHED);
    rig_box(&rig, "force needle broken");
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_SIGHT_DOUBTFUL, shown()->sight);
    (void)finish();
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANES_UNSEEN));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED));
}

/* Its cell trembles five times as much. */
void test_SWR_PUNCT_617_the_least_fall_comes_from_the_noise_of_the_zeroing(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->least_fall_mn);
    begin();
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_MEMBRANE_LEAST_MN, shown()->least_fall_mn);
    setUp();
    sim_phantom_file_t phantom = rig.box.force.phantom;
    phantom.cells[SIM_CELL_NEEDLE].noise_n = 0.1;
    box_force_lay(&rig.box.force, &phantom);
    by_hand_zero(&rig);
    begin();
    rig_cycle(&rig);
    const uint32_t noise_mn = rig.outputs.snapshot.forces[FORCE_CHANNEL_NEEDLE].noise_mn;
    TEST_ASSERT_UINT32_WITHIN(15U, 100U, noise_mn);
    TEST_ASSERT_UINT32_WITHIN(
        2U, (noise_mn * LIMIT_MEMBRANE_FLOOR_SIGMAS * LIMIT_MEMBRANE_WHITE_PERMILLE) / 1000U,
        shown()->least_fall_mn);
}

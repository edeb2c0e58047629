/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: expected membranes belong to their target and entry point; a list that does not
 * fit is refused, and a damaged one is forgotten and named.
 */
#include "integration/support/by_hand.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "limits/requirement_limits.h"

#include <stddef.h>

#include "integration/support/membranes_world.inc"

void setUp(void)
{
    by_hand_start(&rig, ENTRY_Z_NM, TARGET_Z_NM);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_PUNCT_614_expected_membranes_stand_until_the_target_is_another_one(void)
{
    const int32_t depths_um[] = {FIRST_UM, SECOND_UM};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(2U, depths_um));
    TEST_ASSERT_EQUAL_INT32(2, event_of(EVENT_MEMBRANES_TAKEN, 0U)->value);
    TEST_ASSERT_EQUAL_UINT32(2U, event_of(EVENT_MEMBRANE_EXPECTED, 1U)->subject);
    TEST_ASSERT_EQUAL_INT32(SECOND_UM * 1000, event_of(EVENT_MEMBRANE_EXPECTED, 1U)->value);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_EQUAL_UINT32(2U, shown()->count);
    TEST_ASSERT_EQUAL_UINT32(2U, shown()->left);
    TEST_ASSERT_EQUAL_INT32(SECOND_UM, shown()->membranes[1].depth_um);
    by_hand_enter(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_TARGETING).status);
    TEST_ASSERT_EQUAL_UINT32(2U, shown()->count);
    rigid_t pose = rig.controller.plan.scanner_target;
    pose.translation.z_nm -= 1000000;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->count);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANES_FORGOTTEN));
}

void test_SWR_PUNCT_614_and_until_the_entry_point_is(void)
{
    expect_one(FIRST_UM);
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY};
    entry.as.pose.pose = rig.controller.plan.scanner_target;
    entry.as.pose.pose.translation.z_nm = ENTRY_Z_NM - 1000000;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry).status);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->count);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_ENTRY_POINT, expect(1U, &(int32_t){FIRST_UM}));
}

void test_SWR_PUNCT_614_the_same_entry_point_again_forgets_nothing(void)
{
    expect_one(FIRST_UM);
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY};
    entry.as.pose.pose = rig.controller.plan.scanner_target;
    entry.as.pose.pose.translation = rig.controller.plan.entry;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry).status);
    const rigid_t target = rig.controller.plan.scanner_target;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &target).status);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, shown()->count);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANES_FORGOTTEN));
}

/* Both commands come in one cycle, so that no cycle sees the target without an entry point. */
void test_SWR_PUNCT_614_nor_with_another_entry_point_of_the_same_target(void)
{
    expect_one(FIRST_UM);
    rig_forget(&rig);
    const rigid_t target = rig.controller.plan.scanner_target;
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY, .id = rig.next_id + 1U};
    entry.as.pose.pose = target;
    entry.as.pose.pose.translation = rig.controller.plan.entry;
    entry.as.pose.pose.translation.z_nm -= 1000000;
    command_t again = {.kind = (uint32_t)COMMAND_TARGET, .id = rig.next_id + 2U};
    again.as.pose.pose = target;
    rig.commands[0] = entry;
    rig.commands[1] = again;
    rig.command_count = 2U;
    rig.next_id += 2U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.answer_count);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig.outputs.answers[0].status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig.outputs.answers[1].status);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->count);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMBRANES_FORGOTTEN));
}

void test_SWR_PUNCT_614_an_empty_list_expects_none(void)
{
    expect_one(FIRST_UM);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(0U, NULL));
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->count);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMBRANES_FORGOTTEN));
}

void test_SWR_PUNCT_615_a_list_that_does_not_fit_is_refused_and_changes_nothing(void)
{
    const int32_t many_um[LIMIT_MEMBRANES_MOST + 1U] = {1000, 2000, 3000, 4000, 5000,
                                                        6000, 7000, 8000, 9000};
    expect_one(FIRST_UM);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMBRANE_DEPTH, expect(1U, &(int32_t){60100}));
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMBRANE_DEPTH, expect(1U, &(int32_t){0}));
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMBRANE_ORDER, expect(2U, (int32_t[]){5000, 5000}));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OUT_OF_RANGE, expect(LIMIT_MEMBRANES_MOST + 1U, many_um));
    TEST_ASSERT_EQUAL_UINT32(1U, shown()->count);
    TEST_ASSERT_EQUAL_INT32(FIRST_UM, shown()->membranes[0].depth_um);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(LIMIT_MEMBRANES_MOST, many_um));
}

/* Its entry point is farther away than any list may be deep. */
void test_SWR_PUNCT_615_a_membrane_too_deep_for_a_list_is_refused(void)
{
    by_hand_align(&rig, TARGET_Z_NM - 310000000, TARGET_Z_NM);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OUT_OF_RANGE,
                             expect(1U, &(int32_t){(int32_t)LIMIT_MEMBRANE_DEEPEST_UM + 1}));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, expect(1U, &(int32_t){(int32_t)LIMIT_MEMBRANE_DEEPEST_UM}));
}

void test_SWR_PUNCT_615_no_list_while_a_motion_is_armed_or_elsewhere(void)
{
    by_hand_enter(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED, expect(1U, &(int32_t){FIRST_UM}));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, expect(1U, &(int32_t){FIRST_UM}));
}

void test_SWR_PUNCT_615_no_list_without_a_target_or_a_sensor(void)
{
    static rig_t other;
    const int32_t depth_um = FIRST_UM;
    other = rig;
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_FORCE_SENSOR, expect(1U, &depth_um));
    rig = other;
    plan_forget_target(&rig.controller.plan);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET, expect(1U, &depth_um));
}

void test_SWR_PUNCT_616_a_damaged_list_is_forgotten_and_named(void)
{
    expect_one(FIRST_UM);
    rig_forget(&rig);
    rig.controller.membranes.plan.list.membranes[0].depth_um ^= 256;
    rig_cycles(&rig, CARD_SLOT_COUNT);
    TEST_ASSERT_EQUAL_UINT32(EVENT_MEMORY_MEMBRANES, event_of(EVENT_MEMORY_DAMAGED, 0U)->subject);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->count);
}

void test_SWR_PUNCT_616_a_damaged_insertion_begins_anew_in_its_cycle(void)
{
    expect_one(FIRST_UM);
    begin();
    rig_cycles(&rig, PUSHED);
    rig_forget(&rig);
    rig.controller.membranes.run.detector.looked ^= 0x40000000U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_SIGHT_PAUSED, shown()->sight);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, finish());
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED));
}

/* Its flag of running, too, which would begin it anew without a word. */
void test_SWR_PUNCT_616_a_damaged_flag_is_named_in_its_cycle(void)
{
    expect_one(FIRST_UM);
    begin();
    rig_cycles(&rig, PUSHED);
    rig_forget(&rig);
    rig.controller.membranes.run.is_running = 0U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, finish());
}

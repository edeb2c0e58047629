/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: an insertion by hand is refused or ended, by name and without a motion, where
 * its force is doubtful.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "integration/support/cooperate_world.inc"

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* It stands where a move that was armed by entering the workphase would be run by the pedal. */
void test_SWR_COOP_014_a_refused_insertion_by_hand_leaves_no_move_armed(void)
{
    align();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_FALSE(is_over());
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, status_of(cooperate));
    TEST_ASSERT_TRUE(is_over());
    const double there = depth_ticks();
    rig_press(&rig);
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, depth_ticks());
}

void test_SWR_COOP_014_other_refused_commands_leave_it_armed(void)
{
    align();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_NOT_EQUAL_UINT32(
        STATUS_OK, status_of((command_t){.kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = 0U}}));
    TEST_ASSERT_FALSE(is_over());
}

/* Each of the steps that it names is accepted, and the last one ends the reason. */
void test_SWR_COOP_015_after_a_doubt_the_reason_stays_and_the_next_steps_work(void)
{
    start_armed();
    push(1000);
    rig_cycles(&rig, 1000U);
    rig_box(&rig, "force hand broken");
    rig_cycles(&rig, 10U);
    TEST_ASSERT_TRUE(has_reason(PERMIT_REASON_FORCE_DOUBTFUL));
    rig_box(&rig, "force hand normal");
    let_go();
    rig_release(&rig);
    rig_cycles(&rig, 200U);
    TEST_ASSERT_TRUE(has_reason(PERMIT_REASON_FORCE_DOUBTFUL));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_ZERO_FORCE, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of((command_t){.kind = (uint32_t)COMMAND_RETRACT}));
    TEST_ASSERT_FALSE(has_reason(PERMIT_REASON_FORCE_DOUBTFUL));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
    rig_release(&rig);
    rig_cycles(&rig, 200U);
    zero_force();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(cooperate));
}

void test_SWR_COOP_006_a_doubtful_force_drives_nothing_and_ends_the_order(void)
{
    start_armed();
    push(1000);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_TRUE(is_driven());
    rig_forget(&rig);
    rig_box(&rig, "force hand broken");
    while (rig.outputs.snapshot.forces[FORCE_CHANNEL_HAND].doubts == 0U) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, rig.answers[rig.answer_count - 1U].status);
    rig_release(&rig);
    rig_cycles(&rig, 200U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, status_of(cooperate));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of((command_t){.kind = (uint32_t)COMMAND_RETRACT}));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
}

void test_SWR_COOP_006_also_while_the_order_waits_for_the_pedal(void)
{
    start_ready();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(cooperate));
    rig_box(&rig, "force hand broken");
    rig_cycles(&rig, 10U);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

/* A person pulls while the sensor is zeroed, and lets go. */
void test_SWR_COOP_012_a_zero_that_was_taken_under_a_pull_moves_nothing(void)
{
    align();
    push(-800);
    rig_cycles(&rig, 100U);
    zero_force();
    let_go();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(cooperate));
    rig_press(&rig);
    const double there = depth_ticks();
    rig_cycles(&rig, 5000U);
    TEST_ASSERT_GREATER_THAN_INT32(500, rig.outputs.snapshot.forces[FORCE_CHANNEL_HAND].force_mn);
    TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, depth_ticks());
    TEST_ASSERT_TRUE(has_reason(PERMIT_REASON_HAND_UNPROVEN));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_LET_GO, rig.outputs.snapshot.next_step);
}

void test_SWR_COOP_006_a_damaged_table_of_the_sensor_ends_it(void)
{
    start_armed();
    push(1000);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_TRUE(is_driven());
    rig.robot.force.slot ^= 4U;
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

/* The sensor itself is believed until its table has its turn. */
void test_SWR_COOP_006_a_damaged_slope_of_the_sensor_ends_it_in_its_cycle(void)
{
    start_armed();
    push(1000);
    rig_cycles(&rig, 1000U);
    while ((rig.controller.sealed.cycle % CARD_SLOT_COUNT) != (CARD_SLOT_COUNT / 2U)) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_TRUE(is_driven());
    rig.robot.force.channels[FORCE_CHANNEL_HAND].mn_per_count_q16 ^= 4;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_HEX32(0U, rig.outputs.snapshot.forces[FORCE_CHANNEL_HAND].doubts);
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    rig_cycles(&rig, 2U * CARD_SLOT_COUNT);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    rig_release(&rig);
    rig_cycles(&rig, 2U * CARD_SLOT_COUNT);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_MEMORY, rig.outputs.snapshot.next_step);
}

/* The force is that of the report before, as there is none in this cycle. */
void test_SWR_FORCE_576_a_force_that_changes_by_itself_moves_nothing(void)
{
    start_armed();
    rig_cycles(&rig, OFF_CYCLES);
    rig_box(&rig, "card 3 silent");
    rig.controller.force.sealed.force_mn[FORCE_CHANNEL_HAND] = HARD_MN;
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_TRUE(is_over());
    TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, rig.answers[rig.answer_count - 1U].status);
}

void test_SWR_COOP_008_the_permit_says_that_no_hand_pushes(void)
{
    start_armed();
    rig_cycles(&rig, 100U);
    TEST_ASSERT_TRUE(has_reason(PERMIT_REASON_HAND_OFF));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PUSH, rig.outputs.snapshot.next_step);
    push(1000);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_HEX32(0U, rig.outputs.snapshot.axes[NEEDLE].permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_HOLD_PEDAL, rig.outputs.snapshot.next_step);
}

void test_SWR_COOP_009_it_is_not_armed_before_the_sensor_was_zeroed(void)
{
    align();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, status_of(cooperate));
}

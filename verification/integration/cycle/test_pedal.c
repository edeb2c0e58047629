/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The pedal on the simulated box: no motion without it, and only after a fresh press.
 * In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_PEDAL_001_nothing_is_driven_before_the_pedal_is_pressed(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    for (uint32_t i = 0U; i < 2000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PRESS_PEDAL, rig.outputs.snapshot.next_step);
}

void test_SWR_PEDAL_002_release_zeroes_every_drive_word_in_the_same_cycle(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "pedal a open");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.inputs.pedal_a);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_PEDAL_003_a_pedal_held_while_arming_does_not_start_the_move(void)
{
    rig_start_targeted(&rig);
    rig_press(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    for (uint32_t i = 0U; i < 1000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 200U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_PEDAL_005_pressing_again_continues_from_the_actual_position_from_rest(void)
{
    rig_start_moving(&rig);
    rig_release(&rig);
    rig_cycles(&rig, 100U);
    const int32_t held = rig_position(&rig, NEURO_AXIS_HEAD);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_INT32(held, rig_position(&rig, NEURO_AXIS_HEAD));
    rig_box(&rig, "pedal press");
    while (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_MOVING) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_INT32_WITHIN(1, held, rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].setpoint_ticks);
    const int32_t limit_q8 =
        (robot_neuro.axes[NEURO_AXIS_HEAD].acceleration_ticks_per_s2 * 256) / 500;
    TEST_ASSERT_INT32_WITHIN(
        limit_q8, 0, rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].setpoint_speed_ticks_per_s_q8);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
}

/* An armed order waits without the pedal, for a share of `cycles`: the others have passed at once.
 * @return how many these are */
static uint32_t wait_armed(uint32_t cycles)
{
    const uint32_t passed = cycles - SCENES(cycles);
    TEST_ASSERT_EQUAL_HEX32(0U, procedure_step(&rig.controller.procedure, passed * LIMIT_CYCLE_US));
    controller_seal(&rig.controller);
    rig_cycles(&rig, cycles - passed);
    return passed;
}

void test_SWR_PEDAL_006_sixty_seconds_without_the_pedal_discard_the_move(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_forget(&rig);
    (void)wait_armed((LIMIT_ARMED_HOLD_US / LIMIT_CYCLE_US) - 2U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.answer_count);
    const answer_t answer = rig_finish(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_EXPIRED, answer.status);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

/* The cycle of the last event of this kind. */
static uint32_t cycle_of(event_id_t id)
{
    uint32_t cycle = 0U;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if (rig.events[i].id == (uint32_t)id) {
            cycle = rig.events[i].cycle;
        }
    }
    return cycle;
}

void test_SWR_PEDAL_006_the_sixty_seconds_begin_in_the_cycle_in_which_it_was_armed(void)
{
    rig_start_targeted(&rig);
    rig_forget(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    const uint32_t passed = wait_armed((LIMIT_ARMED_HOLD_US / LIMIT_CYCLE_US) - 2U);
    (void)rig_finish(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_ARMED_HOLD_US / LIMIT_CYCLE_US,
                             passed + cycle_of(EVENT_ORDER_EXPIRED) - cycle_of(EVENT_ORDER_ARMED));
}

void test_SWR_PEDAL_004_disagreeing_channels_stop_the_move_and_latch_a_fault(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "pedal b open");
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_finish(&rig, 120U).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PEDAL_FAULT));
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_PEDAL_FAULT,
                          rig.outputs.snapshot.axes[0].permit_reasons);
}

void test_SWR_PEDAL_007_a_pedal_fault_is_cleared_by_start_up_with_the_pedal_released(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "pedal b open");
    rig_cycles(&rig, 200U);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_release(&rig);
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_PEDAL_FAULT,
                          rig.outputs.snapshot.axes[0].permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_BITS_LOW(1UL << PERMIT_REASON_PEDAL_FAULT,
                         rig.outputs.snapshot.axes[0].permit_reasons);
}

void test_SWR_PEDAL_003_after_a_scan_the_pedal_must_be_pressed_anew(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 50U);
    rig_box(&rig, "scanner off");
    for (uint32_t i = 0U; i < 500U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_PEDAL_003_a_channel_that_closes_during_a_scan_needs_a_fresh_release(void)
{
    rig_start_moving(&rig);
    rig_release(&rig);
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 20U);
    rig_box(&rig, "pedal a close");
    rig_cycles(&rig, 20U);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 5U);
    rig_box(&rig, "pedal b close");
    for (uint32_t i = 0U; i < 200U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_ESTOP_004_a_release_of_the_pedal_shorter_than_a_cycle_is_a_release(void)
{
    rig_start_moving(&rig);
    rig_forget(&rig);
    rig_box(&rig, "pedal pulse");
    box_advance(&rig.box, 500U);
    rig_cycles(&rig, 4U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PEDAL_RELEASED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PEDAL_PRESSED));
}

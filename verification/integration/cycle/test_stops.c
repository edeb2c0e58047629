/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Stops of a motion on the simulated box, and the conditions to go on: the e-stop, links, the
 * scanner, late cycles, workphases.
 * In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_ESTOP_001_the_e_stop_zeroes_every_drive_word_in_the_same_cycle(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "estop pull");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.inputs.estop_open);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_ESTOP_002_the_e_stop_stays_latched_until_start_up(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 5U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_ESTOP, rig.outputs.snapshot.next_step);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_ESTOP_LATCHED,
                          rig.outputs.snapshot.axes[0].permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_CLEAR, rig.outputs.snapshot.estop);
}

void test_SWR_ESTOP_003_the_e_stop_disables_the_axes_and_discards_the_move(void)
{
    rig_start_moving(&rig);
    rig_forget(&rig);
    rig_box(&rig, "estop pull");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 3U).kind);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, rig.outputs.snapshot.workphase);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, rig.outputs.snapshot.axes[i].power);
    }
    rig_box(&rig, "estop reset");
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_LINK_001_a_silent_card_stops_every_axis_in_the_fifth_cycle(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES - 1U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_CHECK_CARDS, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
}

void test_SWR_LINK_002_a_corrupt_card_is_refused_and_lost(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "card lateral corrupt");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_LINK_AGE_CYCLES, rig_count(&rig, EVENT_FRAME_REFUSED));
}

void test_SWR_LINK_003_a_lost_card_returns_only_by_start_up_and_is_homed_again(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES);
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_box(&rig, "card lateral normal");
    rig_cycles(&rig, 30U);
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_LINK_LOST,
                          rig.outputs.snapshot.axes[0].permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].reference);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].reference);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
}

void test_SWR_PERMIT_004_the_axes_rest_while_the_scanner_acquires(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "scanner on");
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_SCANNER, rig.outputs.snapshot.next_step);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 300U);
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_SCANNER));
}

void test_SWR_ESTOP_004_an_e_stop_pulse_shorter_than_a_cycle_stops_and_latches(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "estop pulse");
    box_advance(&rig.box, 500U);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, rig.outputs.snapshot.workphase);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, rig.outputs.snapshot.estop);
}

void test_SWR_LOOP_002_three_late_cycles_stop_the_motion(void)
{
    rig_start_moving(&rig);
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, LIMIT_OVERRUNS_IN_A_ROW - 1U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_LOOP_STOPPED));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OVERRUNS_IN_A_ROW, rig.outputs.snapshot.overruns);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_LOOP_STOPPED));
}

void test_SWR_PHASE_004_stop_and_emergency_zero_the_drive_in_the_same_cycle(void)
{
    rig_start_moving(&rig);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_start_moving(&rig);
    (void)rig_workphase(&rig, WORKPHASE_EMERGENCY);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_PHASE_005_every_change_of_workphase_discards_the_armed_move(void)
{
    static const workphase_t others[] = {WORKPHASE_PLANNING, WORKPHASE_TARGETING, WORKPHASE_MANUAL,
                                         WORKPHASE_STOP, WORKPHASE_EMERGENCY};
    for (uint32_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        rig_start_moving(&rig);
        (void)rig_workphase(&rig, others[i]);
        TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.answer_count);
        TEST_ASSERT_EQUAL_UINT32(STATUS_DISCARDED, rig.outputs.answers[0].status);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        rig_release(&rig);
        rig_press(&rig);
        rig_cycles(&rig, 100U);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
}

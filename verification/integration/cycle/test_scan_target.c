/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a position that has drifted by no more than a long scan leaves behind is in
 * doubt, and no reason to plan anew.
 */
#include "integration/support/rig.h"

#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"
#include "unity.h"

#define SCAN_CYCLES SCENES(SCENES(600000U)) /* Ten minutes. */

static rig_t rig;

void setUp(void)
{
    rig_start_targeted(&rig);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* Effect of noise on `axis` in a cycle or more. */
static void drift_to(uint32_t axis, int32_t ticks)
{
    drift_audit_t *const drift = &rig.controller.axes[axis].sealed.drift;
    drift->idle_ticks = ticks;
    controller_seal(&rig.controller);
    rig_cycles(&rig, ROBOT_AXIS_MAX);
}

static void expect_in_doubt(uint32_t axis, uint32_t has_target)
{
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, rig.outputs.snapshot.axes[axis].reference);
    TEST_ASSERT_EQUAL_UINT32(has_target, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32((has_target != 0U) ? STATUS_NOT_HOMED : STATUS_NO_TARGET,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
}

static void press_button(void)
{
    rig_box(&rig, "button press");
    rig_cycles(&rig, (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 10U);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 10U);
}

void test_SWR_AXIS_045_after_ten_minutes_of_a_scan_the_button_lets_the_move_go(void)
{
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, SCAN_CYCLES);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 100U);
    if (ARE_SCENES_WHOLE) {
        TEST_ASSERT_GREATER_THAN_UINT32(1U, rig_count(&rig, EVENT_AXIS_DRIFTED));
        TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
        TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_HOMED,
                                 rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
        TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_CONFIRM, rig.outputs.snapshot.next_step);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    press_button();
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
}

void test_SWR_AXIS_045_the_bound_is_that_of_the_row(void)
{
    for (int32_t sign = -1; sign <= 1; sign += 2) {
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            const int32_t bound = (int32_t)robot_neuro.axes[i].drift_ticks;
            rig_start_targeted(&rig);
            drift_to(i, sign * bound);
            if (rig.outputs.snapshot.axes[i].reference == (uint32_t)AXIS_REFERENCE_UNVERIFIED) {
                expect_in_doubt(i, 1U);
                rig_cycles(&rig, 500U); /* It comes to rest. */
                TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_CONFIRM, rig.outputs.snapshot.next_step);
            } else {
                TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
            }
        }
    }
}

void test_SWR_AXIS_022_beyond_the_bound_there_is_no_target_any_more(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig_start_targeted(&rig);
        drift_to(i, 400);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_DRIFTED));
        expect_in_doubt(i, 0U);
    }
}

void test_SWR_AXIS_046_a_doubt_that_grows_beyond_the_bound_forgets_the_target_and_says_so(void)
{
    const int32_t bound = (int32_t)robot_neuro.axes[NEURO_AXIS_HEAD].drift_ticks;
    drift_to(NEURO_AXIS_HEAD, bound);
    expect_in_doubt(NEURO_AXIS_HEAD, 1U);
    rig_forget(&rig);
    drift_to(NEURO_AXIS_HEAD, bound + 1);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_DRIFTED));
    expect_in_doubt(NEURO_AXIS_HEAD, 0U);
    rig_cycles(&rig, 10U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_DRIFTED));
}

void test_SWR_REF_010_any_other_doubt_forgets_the_target_of_one_that_has_drifted(void)
{
    drift_to(NEURO_AXIS_HEAD, (int32_t)robot_neuro.axes[NEURO_AXIS_HEAD].drift_ticks);
    expect_in_doubt(NEURO_AXIS_HEAD, 1U);
    rig_box(&rig, "card pitch silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES + 1U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
}

void test_SWR_AXIS_045_homing_that_is_given_up_after_a_drift_forgets_the_target(void)
{
    drift_to(NEURO_AXIS_HEAD, (int32_t)robot_neuro.axes[NEURO_AXIS_HEAD].drift_ticks);
    expect_in_doubt(NEURO_AXIS_HEAD, 1U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    rig_press(&rig);
    rig_cycles(&rig, 200U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST,
                             rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].reference);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
}

/* So much more than before. */
static void drift_by(uint32_t axis, int32_t ticks)
{
    drift_to(axis, rig.controller.axes[axis].sealed.drift.idle_ticks + ticks);
}

static void confirm_drift(uint32_t axis, int32_t ticks)
{
    drift_by(axis, ticks);
    rig_cycles(&rig, 500U); /* It comes to rest. */
    press_button();
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    rig_forget(&rig);
}

void test_SWR_AXIS_054_what_was_confirmed_of_a_drift_counts_until_the_next_reference(void)
{
    for (int32_t sign = -1; sign <= 1; sign += 2) {
        rig_start_targeted(&rig);
        confirm_drift(NEURO_AXIS_HEAD, sign * 17);
        drift_by(NEURO_AXIS_HEAD, sign * 7);
        TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
        drift_by(NEURO_AXIS_HEAD, sign);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_DRIFTED));
        rig_cycle(&rig);
        expect_in_doubt(NEURO_AXIS_HEAD, 0U);
    }
}

/* 31 ticks of the needle are a fiftieth of a millimetre. */
void test_SWR_AXIS_054_a_bound_that_is_nearer_than_a_tenth_of_a_millimetre_holds_as_well(void)
{
    const int32_t bound = (int32_t)robot_neuro.axes[NEURO_AXIS_INSERTION].drift_ticks;
    drift_to(NEURO_AXIS_INSERTION, bound);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    drift_by(NEURO_AXIS_INSERTION, 1);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_DRIFTED));
    TEST_ASSERT_EQUAL_INT32(bound + 1, rig.events[0].value);
    rig_cycle(&rig);
    expect_in_doubt(NEURO_AXIS_INSERTION, 0U);
}

void test_SWR_AXIS_054_who_confirms_without_a_target_left_begins_a_new_account(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    drift_to(NEURO_AXIS_HEAD, (int32_t)robot_neuro.axes[NEURO_AXIS_HEAD].drift_ticks + 1);
    rig_cycles(&rig, 500U);
    press_button();
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    rig_cycles(&rig, 2U * ROBOT_AXIS_MAX);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
}

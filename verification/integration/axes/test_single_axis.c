/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: in MANUAL the console has a single axis homed, forgotten, jogged, enabled or
 * disabled by the rules of START_UP. On the simulated box; in every test the rig counts cycles that
 * drive without the pedal.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"
#include "integration/support/single_axis.inc"

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* How far what is shown is from what is true. */
static double shown_apart(uint32_t axis)
{
    return rig_position(&rig, axis) - rig.box.axes[axis].motor.position_ticks;
}

static uint32_t driven_axes(void)
{
    uint32_t driven = 0U;
    for (uint32_t i = 0U; i < rig.box.robot->axis_count; i++) {
        driven |= (rig_sent(&rig, i).drive.mode != (uint32_t)CARD_DRIVE_OFF) ? (1UL << i) : 0U;
    }
    return driven;
}

/* Homes it under the pedal, which is released once on the way. */
static void home(uint32_t axis)
{
    uint32_t driven = 0U;
    TEST_ASSERT_EQUAL_UINT32(0U, act(COMMAND_HOME_AXIS, axis).is_final);
    rig_press(&rig);
    rig_cycles(&rig, 200U);
    rig_release(&rig);
    rig_press(&rig);
    while (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE) {
        rig_cycle(&rig);
        driven |= driven_axes();
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.sealed.cycle);
    }
    TEST_ASSERT_EQUAL_UINT32(1UL << axis, driven);
    const answer_t *const last = &rig.answers[(rig.answer_count - 1U) % RIG_ANSWERS];
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, last->kind);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_HOME_AXIS, last->command);
    expect_grade(AXIS_REFERENCE_VERIFIED, axis);
    rig_release(&rig);
}

void test_SWR_AXIS_034_one_axis_homes_under_the_pedal_and_no_other_is_driven(void)
{
    static const uint32_t homed[] = {NEURO_AXIS_LATERAL, NEURO_AXIS_INSERTION, NEURO_AXIS_HEAD};
    start_manual();
    for (uint32_t i = 0U; i < (sizeof homed / sizeof homed[0]); i++) {
        const double before = shown_apart(homed[i]);
        home(homed[i]);
        TEST_ASSERT_DOUBLE_WITHIN(3.0, before, shown_apart(homed[i]));
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_AXIS_034_nothing_moves_before_the_pedal_is_pressed_anew(void)
{
    start_manual();
    rig_press(&rig);
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_LATERAL);
    for (uint32_t i = 0U; i < 500U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_AXIS_034_an_axis_without_a_switch_is_taken_once_as_in_start_up(void)
{
    start_fresh();
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_ROTATION);
    expect_grade(AXIS_REFERENCE_FRESH, NEURO_AXIS_ROTATION);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 100U).kind);
    expect_grade(AXIS_REFERENCE_TAKEN, NEURO_AXIS_ROTATION);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_TAKEN));
    rig_release(&rig);
    expect(STATUS_HOMES_OTHERWISE, COMMAND_HOME_AXIS, NEURO_AXIS_ROTATION);
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_ROTATION);
    expect(STATUS_HOMES_OTHERWISE, COMMAND_HOME_AXIS, NEURO_AXIS_ROTATION);
}

void test_SWR_AXIS_034_a_homing_that_is_given_up_is_answered_and_leaves_the_axis_lost(void)
{
    start_manual();
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_LATERAL);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(axis_is_homing(&rig.controller.axes[NEURO_AXIS_LATERAL]));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig.outputs.answers[0].kind);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_HOME_AXIS, rig.outputs.answers[0].command);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    expect_grade(AXIS_REFERENCE_LOST, NEURO_AXIS_LATERAL);
    rig_release(&rig);
}

/* In the way of the head's switch once it homes: the feet, where they are not believed to be. */
void test_SWR_AXIS_034_a_limit_that_bars_the_way_fails_the_homing(void)
{
    start_manual();
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_HEAD);
    encoder_set_position(&rig.controller.axes[NEURO_AXIS_FEET].sealed.encoder, -5000);
    supervision_shift(&rig.controller.axes[NEURO_AXIS_FEET].supervision, -5000);
    drift_audit_settle(&rig.controller.axes[NEURO_AXIS_FEET].sealed.drift);
    controller_seal(&rig.controller);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_HOMING_BARRED));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_release(&rig);
}

void test_SWR_AXIS_035_who_homes_anew_is_not_relied_on_from_then_on(void)
{
    start_manual();
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_YAW);
    expect_grade(AXIS_REFERENCE_LOST, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_REFERENCE_LOST));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_WAITING, rig.outputs.snapshot.order);
}

void test_SWR_AXIS_035_who_was_unverified_may_still_be_confirmed(void)
{
    start_manual();
    axis_doubt(&rig.controller.axes[NEURO_AXIS_LATERAL]);
    rig_cycle(&rig);
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_LATERAL);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_LATERAL);
    enter_manual();
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button());
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_LATERAL);
}

void test_SWR_AXIS_036_nothing_homes_across_a_needle_that_is_not_homed_and_out(void)
{
    start_manual();
    jog(NEURO_AXIS_INSERTION, 20000);
    expect(STATUS_NEEDLE_IN, COMMAND_HOME_AXIS, NEURO_AXIS_PITCH);
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_PITCH);
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_INSERTION);
    expect(STATUS_NEEDLE_IN, COMMAND_HOME_AXIS, NEURO_AXIS_PITCH);
    home(NEURO_AXIS_INSERTION);
    home(NEURO_AXIS_PITCH);
}

void test_SWR_AXIS_036_a_needle_that_comes_in_meanwhile_stops_it(void)
{
    start_manual();
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_LATERAL);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_INSERTION]);
    rig_box(&rig, "pedal press");
    for (uint32_t i = 0U; i < 500U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_MOVING, rig.outputs.snapshot.order);
    rig_release(&rig);
}

void test_SWR_AXIS_036_a_limit_that_its_switch_would_miss_bars_it_by_name(void)
{
    start_manual();
    jog(NEURO_AXIS_HEAD, -2000);
    jog(NEURO_AXIS_FEET, -2000);
    const answer_t answer = act(COMMAND_HOME_AXIS, NEURO_AXIS_HEAD);
    TEST_ASSERT_EQUAL_UINT32(STATUS_SEPARATION_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(1U, answer_as_shared_limit(&answer)->is_maximum);
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_HEAD);
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_HEAD);
    expect(STATUS_SEPARATION_LIMIT, COMMAND_HOME_AXIS, NEURO_AXIS_HEAD);
}

void test_SWR_AXIS_036_who_shares_its_limit_must_be_homed(void)
{
    start_manual();
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_FEET);
    expect(STATUS_NOT_HOMED, COMMAND_HOME_AXIS, NEURO_AXIS_HEAD);
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_HEAD);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button());
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_HEAD);
}

static const command_kind_t acts[] = {COMMAND_HOME_AXIS, COMMAND_CLEAR_AXIS,  COMMAND_CONFIRM_AXIS,
                                      COMMAND_SET_HOME,  COMMAND_ENABLE_AXIS, COMMAND_DISABLE_AXIS};
#define ACTS (sizeof acts / sizeof acts[0])

void test_SWR_AXIS_037_they_are_for_manual_only(void)
{
    start_manual();
    axis_doubt(&rig.controller.axes[NEURO_AXIS_FEET]);
    rig_cycle(&rig);
    for (uint32_t phase = (uint32_t)WORKPHASE_START_UP; phase < WORKPHASE_COUNT; phase++) {
        if ((rig_workphase(&rig, (workphase_t)phase).status != (uint32_t)STATUS_OK) ||
            (phase == (uint32_t)WORKPHASE_MANUAL)) {
            continue;
        }
        for (uint32_t i = 0U; i < ACTS; i++) {
            const uint32_t axis =
                (i == 0U) ? (uint32_t)NEURO_AXIS_LATERAL : (uint32_t)NEURO_AXIS_FEET;
            expect(STATUS_WRONG_WORKPHASE, acts[i], axis);
        }
    }
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_FEET);
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_LATERAL);
}

void test_SWR_AXIS_037_they_are_for_axes_of_the_robot_and_the_console(void)
{
    start_manual();
    for (uint32_t i = 0U; i < ACTS; i++) {
        const command_t foreign = {.source = (uint32_t)COMMAND_SOURCE_IGTL,
                                   .peer = RIG_CONNECTION,
                                   .kind = (uint32_t)acts[i]};
        expect(STATUS_UNKNOWN_COMMAND, acts[i], robot_neuro.axis_count);
        expect(STATUS_UNKNOWN_COMMAND, acts[i], UINT32_MAX);
        TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_ALLOWED, rig_command(&rig, foreign).status);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_AXIS_037_who_has_no_authority_is_refused(void)
{
    start_manual();
    for (uint32_t i = 0U; i < ACTS; i++) {
        command_t other = commands_of_number(acts[i], NEURO_AXIS_FEET);
        other.source = (uint32_t)COMMAND_SOURCE_HTTP;
        other.peer = RIG_PAGE + 1U;
        TEST_ASSERT_EQUAL_UINT32(STATUS_NO_AUTHORITY, rig_command(&rig, other).status);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_AXIS_037_nothing_is_done_by_a_table_that_was_damaged(void)
{
    start_manual();
    rig.robot.axes[NEURO_AXIS_FEET].home_ticks++;
    rig_cycle(&rig);
    for (uint32_t i = 0U; i < ACTS; i++) {
        expect(STATUS_MEMORY_DAMAGED, acts[i], NEURO_AXIS_FEET);
    }
}

void test_SWR_AXIS_038_a_reference_is_forgotten_by_command(void)
{
    start_manual();
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_LATERAL);
    expect_grade(AXIS_REFERENCE_LOST, NEURO_AXIS_LATERAL);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_LATERAL);
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_REFERENCE_LOST));
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_CONSOLE, rig.events[0].cause);
    home(NEURO_AXIS_LATERAL);
}

void test_SWR_AXIS_038_who_was_never_known_stays_fresh(void)
{
    start_fresh();
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_FEET);
    expect_grade(AXIS_REFERENCE_FRESH, NEURO_AXIS_FEET);
}

void test_SWR_AXIS_038_nothing_is_forgotten_under_an_order(void)
{
    start_manual();
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_LATERAL);
    expect(STATUS_NOT_AT_REST, COMMAND_CLEAR_AXIS, NEURO_AXIS_YAW);
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_YAW);
}

static void jog_by(status_t status, uint32_t axis, int32_t way)
{
    const command_t command = {.kind = (uint32_t)COMMAND_JOG_BY,
                               .as.jog_by = {.axis = axis, .by_ticks = way}};
    TEST_ASSERT_EQUAL_UINT32(status, rig_command(&rig, command).status);
}

void test_SWR_MODE_007_a_jog_by_a_way_ends_that_far_from_where_the_axis_stood(void)
{
    start_manual();
    const int32_t before = rig_position(&rig, NEURO_AXIS_YAW);
    jog_by(STATUS_OK, NEURO_AXIS_YAW, -150);
    rig_press(&rig);
    rig_cycles(&rig, 20U);
    rig_release(&rig);
    rig_press(&rig);
    const answer_t answer = rig_finish(&rig, MOST_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_JOG_BY, answer.command);
    TEST_ASSERT_INT32_WITHIN(robot_neuro.axes[NEURO_AXIS_YAW].deadband_ticks, before - 150,
                             rig_position(&rig, NEURO_AXIS_YAW));
}

void test_SWR_MODE_007_a_jog_by_a_way_is_judged_by_where_it_ends(void)
{
    start_manual();
    jog_by(STATUS_AXIS_LIMIT, NEURO_AXIS_YAW, INT32_MAX);
    jog_by(STATUS_AXIS_LIMIT, NEURO_AXIS_YAW, INT32_MIN);
    jog_by(STATUS_UNKNOWN_COMMAND, ROBOT_AXIS_MAX, 1);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    jog_by(STATUS_WRONG_WORKPHASE, NEURO_AXIS_YAW, -150);
}

static uint32_t power(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].power;
}

/* The yaw axis has stalled, and is free again. */
static void stall_yaw(void)
{
    start_manual();
    rig_box(&rig, "motor yaw stuck");
    jog_by(STATUS_OK, NEURO_AXIS_YAW, -150);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, MOST_CYCLES).kind);
    rig_release(&rig);
    rig_box(&rig, "motor yaw normal");
    rig_cycles(&rig, REST_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, power(NEURO_AXIS_YAW));
}

void test_SWR_MODE_008_one_that_has_stalled_is_enabled_and_homed_alone(void)
{
    stall_yaw();
    expect(STATUS_FAULT_PRESENT, COMMAND_HOME_AXIS, NEURO_AXIS_YAW);
    rig_forget(&rig);
    expect(STATUS_OK, COMMAND_ENABLE_AXIS, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_ENABLED));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_ENABLED, power(NEURO_AXIS_YAW));
    expect_grade(AXIS_REFERENCE_LOST, NEURO_AXIS_YAW);
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_LATERAL);
    home(NEURO_AXIS_YAW);
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_YAW);
}

void test_SWR_MODE_008_the_fault_of_another_axis_stays(void)
{
    stall_yaw();
    rig_box(&rig, "motor pitch runs");
    rig_cycles(&rig, 1000U);
    rig_box(&rig, "motor pitch normal");
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, power(NEURO_AXIS_PITCH));
    expect(STATUS_OK, COMMAND_ENABLE_AXIS, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, power(NEURO_AXIS_PITCH));
}

void test_SWR_MODE_008_one_that_is_disabled_is_not_driven_and_keeps_its_place(void)
{
    start_manual();
    rig_forget(&rig);
    expect(STATUS_OK, COMMAND_DISABLE_AXIS, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_DISABLED));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, power(NEURO_AXIS_YAW));
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_YAW);
    jog_by(STATUS_FAULT_PRESENT, NEURO_AXIS_YAW, -150);
    jog(NEURO_AXIS_PITCH, rig_position(&rig, NEURO_AXIS_PITCH) - 150);
    expect(STATUS_OK, COMMAND_ENABLE_AXIS, NEURO_AXIS_YAW);
    jog_by(STATUS_OK, NEURO_AXIS_YAW, -150);
}

void test_SWR_MODE_008_refusals_name_what_is_missing(void)
{
    start_manual();
    jog_by(STATUS_OK, NEURO_AXIS_YAW, -150);
    expect(STATUS_NOT_AT_REST, COMMAND_DISABLE_AXIS, NEURO_AXIS_YAW);
    expect(STATUS_NOT_AT_REST, COMMAND_ENABLE_AXIS, NEURO_AXIS_YAW);
    start_manual();
    rig_box(&rig, "card yaw silent");
    rig_cycles(&rig, 20U);
    expect(STATUS_HARDWARE_NOT_READY, COMMAND_ENABLE_AXIS, NEURO_AXIS_YAW);
    start_manual();
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    enter_manual();
    expect(STATUS_FAULT_PRESENT, COMMAND_ENABLE_AXIS, NEURO_AXIS_YAW);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 50U);
    expect(STATUS_FAULT_PRESENT, COMMAND_ENABLE_AXIS, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, power(NEURO_AXIS_YAW));
}

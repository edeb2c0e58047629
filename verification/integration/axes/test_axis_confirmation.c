/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: in MANUAL the console has a single axis confirmed, or its home set at its
 * present position; the button at the box alone verifies it. On the simulated box; in every test
 * the rig counts cycles that drive without the pedal.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"
#include "integration/support/single_axis.inc"

#define ASK_CYCLES (LIMIT_AUTHORITY_ASK_US / LIMIT_CYCLE_US)
#define OTHER_PAGE 7U

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* Two axes in doubt, in MANUAL. */
static void start_doubted(void)
{
    start_manual();
    axis_doubt(&rig.controller.axes[NEURO_AXIS_FEET]);
    axis_doubt(&rig.controller.axes[NEURO_AXIS_YAW]);
    rig_cycle(&rig);
}

void test_SWR_AXIS_039_the_next_press_confirms_that_axis_and_the_one_after_it_the_other(void)
{
    start_doubted();
    rig_forget(&rig);
    expect(STATUS_OK, COMMAND_CONFIRM_AXIS, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CONFIRM_ASKED));
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_REQUEST_CONFIRM_AXIS, rig.outputs.snapshot.request);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_YAW, rig.outputs.snapshot.request_axis);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button());
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_YAW);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_REQUEST_NONE, rig.outputs.snapshot.request);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button());
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_FEET);
}

void test_SWR_AXIS_039_it_lapses_and_a_press_from_before_means_nothing(void)
{
    start_doubted();
    rig_box(&rig, "button press");
    rig_cycles(&rig, HOLD_CYCLES / 2U);
    expect(STATUS_OK, COMMAND_CONFIRM_AXIS, NEURO_AXIS_YAW);
    rig_cycles(&rig, 2U * HOLD_CYCLES);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_YAW);
    rig_box(&rig, "button release");
    rig_cycles(&rig, ASK_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_REQUEST_NONE, rig.outputs.snapshot.request);
    TEST_ASSERT_EQUAL_UINT32(2U, hold_button());
}

void test_SWR_AXIS_039_another_ones_request_is_not_replaced(void)
{
    const command_t take = {.source = (uint32_t)COMMAND_SOURCE_HTTP,
                            .peer = RIG_PAGE + 1U,
                            .kind = (uint32_t)COMMAND_REQUEST,
                            .as.request = {.request = AUTHORITY_REQUEST_TAKE}};
    start_doubted();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, take).status);
    expect(STATUS_BUSY, COMMAND_CONFIRM_AXIS, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_REQUEST_TAKE, rig.outputs.snapshot.request);
}

void test_SWR_AXIS_040_what_a_press_would_not_verify_is_refused(void)
{
    start_manual();
    expect(STATUS_NOTHING_TO_CONFIRM, COMMAND_CONFIRM_AXIS, NEURO_AXIS_YAW);
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_YAW);
    expect(STATUS_NOTHING_TO_CONFIRM, COMMAND_CONFIRM_AXIS, NEURO_AXIS_YAW);
    rig.controller.axes[NEURO_AXIS_YAW].sealed.elsewhere_ticks = 500;
    controller_seal(&rig.controller);
    expect(STATUS_OK, COMMAND_CONFIRM_AXIS, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button());
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_FEET);
    expect(STATUS_OK, COMMAND_CONFIRM_AXIS, NEURO_AXIS_FEET);
    start_fresh();
    expect(STATUS_NOTHING_TO_CONFIRM, COMMAND_CONFIRM_AXIS, NEURO_AXIS_FEET);
}

void test_SWR_AXIS_040_without_a_button_nothing_is_asked_of_it(void)
{
    start_doubted();
    rig.has_no_button = true;
    expect(STATUS_NO_BUTTON, COMMAND_CONFIRM_AXIS, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_REQUEST_NONE, rig.outputs.snapshot.request);
}

void test_SWR_AXIS_041_where_the_axis_stands_is_its_home_once_the_operator_has_confirmed_it(void)
{
    start_manual();
    jog(NEURO_AXIS_FEET, 800);
    const double place = rig.box.axes[NEURO_AXIS_FEET].motor.position_ticks;
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    expect(STATUS_OK, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_INT32(robot_neuro.axes[NEURO_AXIS_FEET].home_ticks,
                            rig_position(&rig, NEURO_AXIS_FEET));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_UNVERIFIED));
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button());
    expect_grade(AXIS_REFERENCE_VERIFIED, NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_INT32(robot_neuro.axes[NEURO_AXIS_FEET].home_ticks,
                            rig_position(&rig, NEURO_AXIS_FEET));
    TEST_ASSERT_DOUBLE_WITHIN(0.5, place, rig.box.axes[NEURO_AXIS_FEET].motor.position_ticks);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_ENABLED, rig.outputs.snapshot.axes[NEURO_AXIS_FEET].power);
    jog(NEURO_AXIS_FEET, -100);
    TEST_ASSERT_DOUBLE_WITHIN(3.0, place - 100.0,
                              rig.box.axes[NEURO_AXIS_FEET].motor.position_ticks);
}

void test_SWR_AXIS_041_the_home_of_a_lost_or_unverified_axis_is_set_as_well(void)
{
    start_manual();
    jog(NEURO_AXIS_ROTATION, 300);
    expect(STATUS_OK, COMMAND_CLEAR_AXIS, NEURO_AXIS_ROTATION);
    expect(STATUS_OK, COMMAND_SET_HOME, NEURO_AXIS_ROTATION);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_ROTATION);
    TEST_ASSERT_EQUAL_INT32(0, rig_position(&rig, NEURO_AXIS_ROTATION));
    expect(STATUS_OK, COMMAND_SET_HOME, NEURO_AXIS_ROTATION);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button());
}

void test_SWR_AXIS_041_a_press_from_before_does_not_confirm_the_home(void)
{
    start_manual();
    rig_box(&rig, "button press");
    rig_cycles(&rig, HOLD_CYCLES / 2U);
    expect(STATUS_OK, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    rig_cycles(&rig, 2U * HOLD_CYCLES);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_FEET);
}

/* Another client asks for authority while the home that was set waits to be confirmed. */
static void start_asked(void)
{
    const command_t ask = {.source = (uint32_t)COMMAND_SOURCE_HTTP,
                           .kind = (uint32_t)COMMAND_REQUEST,
                           .peer = OTHER_PAGE,
                           .as.request = {.request = (uint32_t)AUTHORITY_REQUEST_TAKE}};
    start_manual();
    expect(STATUS_OK, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, ask).status);
}

void test_SWR_AUTH_009_a_press_for_a_request_that_lapses_confirms_nothing(void)
{
    start_asked();
    rig_cycles(&rig, ASK_CYCLES - (HOLD_CYCLES / 2U));
    rig_box(&rig, "button press");
    rig_cycles(&rig, 2U * HOLD_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_FEET);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button());
}

void test_SWR_AUTH_009_a_press_for_a_request_that_is_withdrawn_confirms_nothing(void)
{
    const command_t withdraw = {.source = (uint32_t)COMMAND_SOURCE_HTTP,
                                .peer = OTHER_PAGE,
                                .kind = (uint32_t)COMMAND_RELEASE};
    start_asked();
    rig_box(&rig, "button press");
    rig_cycles(&rig, HOLD_CYCLES / 2U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, withdraw).status);
    rig_cycles(&rig, 2U * HOLD_CYCLES);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_FEET);
}

void test_SWR_AUTH_009_a_press_for_a_request_that_memory_lost_confirms_nothing(void)
{
    start_asked();
    rig_box(&rig, "button press");
    rig_cycles(&rig, HOLD_CYCLES / 2U);
    rig.controller.authority.chart.state_inverse ^= 1U;
    rig_cycles(&rig, 2U * HOLD_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
    expect_grade(AXIS_REFERENCE_UNVERIFIED, NEURO_AXIS_FEET);
}

void test_SWR_AXIS_042_an_axis_with_a_switch_finds_home_by_it(void)
{
    start_manual();
    expect(STATUS_HOMES_OTHERWISE, COMMAND_SET_HOME, NEURO_AXIS_LATERAL);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_AXIS_042_home_is_not_set_in_a_hurry(void)
{
    start_manual();
    jog(NEURO_AXIS_FEET, 800);
    expect(STATUS_OK, COMMAND_HOME_AXIS, NEURO_AXIS_LATERAL);
    expect(STATUS_NOT_AT_REST, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    enter_manual();
    rig_press(&rig);
    expect(STATUS_NOT_AT_REST, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    rig_release(&rig);
    rig_box(&rig, "motor feet runs");
    rig_cycles(&rig, 20U);
    expect(STATUS_NOT_AT_REST, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    TEST_ASSERT_NOT_EQUAL_INT32(0, rig_position(&rig, NEURO_AXIS_FEET));
}

void test_SWR_AXIS_042_home_is_set_only_of_what_is_seen_and_without_a_needle_that_is_in(void)
{
    start_manual();
    jog(NEURO_AXIS_FEET, 800);
    jog(NEURO_AXIS_INSERTION, 20000);
    expect(STATUS_NEEDLE_IN, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    rig_box(&rig, "card feet silent");
    rig_cycles(&rig, 3U);
    expect(STATUS_HARDWARE_NOT_READY, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    TEST_ASSERT_NOT_EQUAL_INT32(0, rig_position(&rig, NEURO_AXIS_FEET));
}

void test_SWR_AXIS_043_who_set_a_home_and_how_far_it_went_is_reported(void)
{
    start_manual();
    jog(NEURO_AXIS_FEET, 800);
    const int32_t position = rig_position(&rig, NEURO_AXIS_FEET);
    rig_forget(&rig);
    expect(STATUS_OK, COMMAND_SET_HOME, NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_UINT32(EVENT_HOME_SET, rig.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_FEET, rig.events[0].subject);
    TEST_ASSERT_EQUAL_INT32(robot_neuro.axes[NEURO_AXIS_FEET].home_ticks - position,
                            rig.events[0].value);
    TEST_ASSERT_EQUAL_UINT32(EVENT_SEVERITY_WARNING, rig.events[0].severity);
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_CONSOLE, rig.events[0].cause);
    TEST_ASSERT_EQUAL_UINT32(RIG_PAGE, rig.events[0].peer);
}

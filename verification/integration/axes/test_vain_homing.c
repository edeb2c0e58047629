/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the way of vain START_UPs is added up and bounded; beyond the bound nothing is
 * homed until the operator has said where an axis is, and what lets the needle out is cleared all
 * the same. In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "http/view/mode_availability.h"
#include "base/seal.h"
#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include <stddef.h>

#define MOST_CYCLES 5000U
#define HOLD_CYCLES (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US)
#define REST_CYCLES 500U
/* Beyond half a millimetre of the head, whose encoder has 78.74 ticks per mm. */
#define FAR_TICKS 50
#define NEEDLE_TICKS 10000 /* 3 mm */

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void expect_step(next_step_t step)
{
    TEST_ASSERT_EQUAL_UINT32(step, rig.outputs.snapshot.next_step);
}

static void seal_account(void)
{
    homing_account_t *const account = &rig.controller.account;
    account->seal = seal_of(SEAL_START, (const uint8_t *)account, offsetof(homing_account_t, seal));
    controller_seal(&rig.controller);
}

/* A try of START_UP in which the head is seen to count `way_ticks` and fails. */
static void try_in_vain(int32_t way_ticks)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig.controller.account.from_readings[NEURO_AXIS_HEAD] -= way_ticks;
    seal_account();
    rig_box(&rig, "card head silent");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, MOST_CYCLES).kind);
    rig_box(&rig, "card head normal");
    rig_cycles(&rig, REST_CYCLES);
}

static void lose_head(void)
{
    const command_t clear = {.kind = COMMAND_CLEAR_AXIS, .as.axis = {.axis = NEURO_AXIS_HEAD}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
}

/* Homed, with the needle somewhat in. */
static void start(void)
{
    const command_t jog = {.kind = COMMAND_JOG_BY,
                           .as.jog_by = {.axis = NEURO_AXIS_INSERTION, .by_ticks = NEEDLE_TICKS}};
    rig_start_homed(&rig);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOST_CYCLES).kind);
    rig_release(&rig);
}

/* The bound is passed in so many tries as lead to service. */
static void spend(void)
{
    start();
    lose_head();
    for (uint32_t i = 0U; i < LIMIT_SERVICE_START_UPS; i++) {
        try_in_vain(FAR_TICKS);
    }
    TEST_ASSERT_EQUAL_UINT32(HOMING_ACCOUNT_SPENT, rig.controller.sealed.account_state);
}

static status_t home_head(void)
{
    const command_t home = {.kind = COMMAND_HOME_AXIS, .as.axis = {.axis = NEURO_AXIS_HEAD}};
    return (status_t)rig_command(&rig, home).status;
}

static status_t restore_head(void)
{
    command_t restore = {.kind = COMMAND_RESTORE,
                         .as.positions = {.axes = (uint32_t)1U << NEURO_AXIS_HEAD}};
    restore.as.positions.ticks[NEURO_AXIS_HEAD] = rig_position(&rig, NEURO_AXIS_HEAD);
    return (status_t)rig_command(&rig, restore).status;
}

static status_t retract(void)
{
    const command_t command = {.kind = COMMAND_RETRACT};
    return (status_t)rig_command(&rig, command).status;
}

/* Once START_UP, which is refused, has enabled its axis. */
static void draw_needle_out(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, retract());
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOST_CYCLES).kind);
    rig_release(&rig);
}

static void expect_anew(void)
{
    TEST_ASSERT_EQUAL_UINT32(HOMING_ACCOUNT_EMPTY, rig.controller.sealed.account_state);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.sealed.vain_start_ups);
}

void test_SWR_NEXT_024_beyond_the_bound_nothing_is_homed_and_service_is_due(void)
{
    spend();
    expect_step(NEXT_STEP_SERVICE);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, home_head());
    rig_press(&rig);
    rig_cycles(&rig, REST_CYCLES);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    expect_step(NEXT_STEP_RELEASE_PEDAL);
}

void test_SWR_NEXT_024_what_is_shown_of_homing_is_what_becomes_of_it(void)
{
    spend();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    const snapshot_t *const shown = &rig.outputs.snapshot;
    TEST_ASSERT_EQUAL(STATUS_MOVED_IN_VAIN,
                      workphase_availability(&rig.robot, shown, WORKPHASE_START_UP));
    TEST_ASSERT_EQUAL(
        STATUS_MOVED_IN_VAIN,
        mode_availability(&rig.robot, shown, rig.controller.rows[0].ticks, MODE_HOMING));
    TEST_ASSERT_EQUAL(STATUS_OK, workphase_availability(&rig.robot, shown, WORKPHASE_STOP));
}

void test_SWR_NEXT_024_tries_that_move_less_are_not_refused(void)
{
    rig_start_homed(&rig);
    rig_release(&rig);
    lose_head();
    for (uint32_t i = 0U; i < LIMIT_SERVICE_START_UPS; i++) {
        try_in_vain(1);
    }
    expect_step(NEXT_STEP_SERVICE);
    TEST_ASSERT_EQUAL_UINT32(HOMING_ACCOUNT_OPEN, rig.controller.sealed.account_state);
    try_in_vain(FAR_TICKS);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, rig_workphase(&rig, WORKPHASE_START_UP).status);
}

void test_SWR_NEXT_024_a_long_way_that_fails_once_is_not_refused(void)
{
    rig_start_homed(&rig);
    rig_release(&rig);
    lose_head();
    try_in_vain(100 * FAR_TICKS);
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    expect_anew();
}

/* Nor is one that the operator gives up. */
void test_SWR_NEXT_024_a_START_UP_that_is_stopped_is_charged_nothing(void)
{
    rig_start_homed(&rig);
    rig_release(&rig);
    lose_head();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig.controller.account.from_readings[NEURO_AXIS_HEAD] -= FAR_TICKS;
    controller_seal(&rig.controller);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    TEST_ASSERT_EQUAL_INT32(0, rig.controller.account.ways_ticks[NEURO_AXIS_HEAD]);
}

void test_SWR_NEXT_025_a_position_that_is_restored_begins_anew_and_leads_to_the_end(void)
{
    spend();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore_head());
    expect_anew();
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_NEXT_025_a_home_that_is_set_begins_anew(void)
{
    const command_t set = {.kind = COMMAND_SET_HOME, .as.axis = {.axis = NEURO_AXIS_FEET}};
    spend();
    draw_needle_out();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, set).status);
    expect_anew();
}

static void hold_button(void)
{
    rig_box(&rig, "button press");
    rig_cycles(&rig, HOLD_CYCLES + 2U);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
}

static void doubt_feet(void)
{
    axis_place(&rig.controller.axes[NEURO_AXIS_FEET], &robot_neuro.axes[NEURO_AXIS_FEET],
               rig_position(&rig, NEURO_AXIS_FEET));
    controller_seal(&rig.controller);
    rig_cycle(&rig);
}

void test_SWR_NEXT_025_a_position_that_is_confirmed_begins_anew(void)
{
    const command_t ask = {.kind = COMMAND_CONFIRM_AXIS, .as.axis = {.axis = NEURO_AXIS_FEET}};
    spend();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    doubt_feet();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, ask).status);
    hold_button();
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_CONFIRMED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MENDED));
    expect_anew();
}

void test_SWR_AXIS_080_once_it_is_said_at_the_box_that_it_is_mended_START_UP_leads_on(void)
{
    spend();
    expect_step(NEXT_STEP_SERVICE);
    hold_button();
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MENDED));
    expect_anew();
    expect_step(NEXT_STEP_START_UP);
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MENDED));
}

/* The operator has not compared it: the screen asked for service. */
void test_SWR_AXIS_080_the_press_that_says_it_confirms_no_position(void)
{
    spend();
    doubt_feet();
    expect_step(NEXT_STEP_SERVICE);
    hold_button();
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_CONFIRMED));
    expect_step(NEXT_STEP_CONFIRM);
    hold_button();
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_CONFIRMED));
    expect_step(NEXT_STEP_START_UP);
}

/* A request of another page for authority has the press, and the step says so. */
void test_SWR_AXIS_080_who_asks_for_the_button_has_it_first(void)
{
    const command_t request = {.kind = COMMAND_REQUEST,
                               .source = COMMAND_SOURCE_HTTP,
                               .peer = 7U,
                               .as.request = {.request = AUTHORITY_REQUEST_TAKE}};
    spend();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, request).status);
    expect_step(NEXT_STEP_GRANT);
    hold_button();
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MENDED));
    TEST_ASSERT_EQUAL_UINT32(HOMING_ACCOUNT_SPENT, rig.controller.sealed.account_state);
}

void test_SWR_AXIS_081_what_bars_the_button_comes_before_service(void)
{
    spend();
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, retract());
    rig_cycles(&rig, REST_CYCLES);
    expect_step(NEXT_STEP_PRESS_PEDAL);
    axis_disable(&rig.controller.axes[NEURO_AXIS_HEAD]);
    controller_seal(&rig.controller);
    rig_cycles(&rig, REST_CYCLES);
    expect_step(NEXT_STEP_STOP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    rig_cycles(&rig, 2U);
    expect_step(NEXT_STEP_SERVICE);
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, REST_CYCLES);
    expect_step(NEXT_STEP_SCANNER);
}

/* Otherwise an axis that is confirmed after each try would keep service away for ever. */
void test_SWR_NEXT_025_before_the_bound_a_restored_position_does_not_begin_anew(void)
{
    rig_start_homed(&rig);
    rig_release(&rig);
    lose_head();
    try_in_vain(FAR_TICKS);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore_head());
    TEST_ASSERT_EQUAL_UINT32(1U, rig.controller.sealed.vain_start_ups);
    TEST_ASSERT_EQUAL_INT32(FAR_TICKS, rig.controller.account.ways_ticks[NEURO_AXIS_HEAD]);
}

static void pull(void)
{
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 20U);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U);
}

void test_SWR_NEXT_026_the_needle_comes_out_after_an_e_stop_though_START_UP_is_refused(void)
{
    spend();
    pull();
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, retract());
    draw_needle_out();
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_CLEAR, rig.controller.estop.state);
}

void test_SWR_NEXT_026_nothing_is_cleared_while_the_e_stop_is_open_or_something_is_armed(void)
{
    spend();
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_NOT_EQUAL(ESTOP_LATCH_STATE_CLEAR, rig.controller.estop.state);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, retract());
    axis_disable(&rig.controller.axes[NEURO_AXIS_HEAD]);
    controller_seal(&rig.controller);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_FALSE(axis_is_enabled(&rig.controller.axes[NEURO_AXIS_HEAD]));
    TEST_ASSERT_TRUE(procedure_is_armed(&rig.controller.procedure));
}

void test_SWR_MEMORY_002_an_account_of_vain_tries_that_is_damaged_is_spent(void)
{
    start();
    lose_head();
    try_in_vain(0);
    rig.controller.account.ways_ticks[NEURO_AXIS_FEET] ^= 0x1;
    for (uint32_t i = 1U; i < LIMIT_SERVICE_START_UPS; i++) {
        TEST_ASSERT_EQUAL_UINT32(HOMING_ACCOUNT_OPEN, rig.controller.sealed.account_state);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
        rig_box(&rig, "card head silent");
        TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, MOST_CYCLES).kind);
        rig_box(&rig, "card head normal");
        rig_cycles(&rig, REST_CYCLES);
    }
    TEST_ASSERT_EQUAL_UINT32(HOMING_ACCOUNT_SPENT, rig.controller.sealed.account_state);
}

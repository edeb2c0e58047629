/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a carriage that cannot home with its block is homed alone, moved or placed by
 * hand, or named for service, on the ProstateRobot.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "limits/requirement_limits.h"

#include <stdio.h>

#include "integration/support/followers_world.inc"

#define MOST_TRIES 12U

void setUp(void)
{
    set_robot();
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void silence(const char *axis)
{
    char order[40];
    (void)snprintf(order, sizeof order, "card %s silent", axis);
    rig_box(&rig, order);
    rig_cycles(&rig, 200U);
    (void)snprintf(order, sizeof order, "card %s normal", axis);
    rig_box(&rig, order);
    rig_cycles(&rig, 50U);
}

/* Half of the block would turn the needle guide by 12 degrees. */
void test_SWR_AXIS_053_two_carriages_in_doubt_home_one_after_the_other(void)
{
    start_at_home();
    silence("front_right");
    silence("rear_right");
    TEST_ASSERT_FALSE(is_homed(FRONT_RIGHT));
    TEST_ASSERT_FALSE(is_homed(REAR_RIGHT));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    while (!is_homed(FRONT_RIGHT)) {
        rig_cycle(&rig);
        TEST_ASSERT_TRUE(is_homed(FRONT_RIGHT) || !is_homing(REAR_RIGHT));
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, rig.controller.sealed.cycle);
    }
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOST_CYCLES).kind);
    expect_at_home();
}

static void expect_step(next_step_t step, uint32_t axis)
{
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(step, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_UINT32(axis, rig.outputs.snapshot.step_axis);
}

/* No carriage has room, and the needle guide may not be turned at all. */
static void fail_for_want_of_a_way(void)
{
    const command_t clear = {.kind = COMMAND_CLEAR_AXIS, .as.axis = {.axis = FRONT_LEFT}};
    start_at_home();
    for (uint32_t i = 0U; i <= REAR_RIGHT; i++) {
        robot.axes[i].minimum_ticks = rig_position(&rig, i) - 100;
        robot.axes[i].maximum_ticks = rig_position(&rig, i) + 100;
    }
    robot.coupled_limits[2].minimum = -1;
    robot.coupled_limits[2].maximum = 1;
    seal_robot();
    rig.robot = robot;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 1000U).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_HOMING_NO_WAY));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_release(&rig);
}

static void hold_button(void)
{
    rig_box(&rig, "button press");
    rig_cycles(&rig, (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 2U);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
}

void test_SWR_NEXT_022_one_without_a_way_to_its_switch_is_to_be_moved_by_hand(void)
{
    fail_for_want_of_a_way();
    expect_step(NEXT_STEP_BY_HAND, FRONT_LEFT);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PRESS_PEDAL, rig.outputs.snapshot.next_step);
}

/* Once an operator states where it is, there is nothing to be moved. */
void test_SWR_NEXT_022_one_that_is_restored_is_to_be_confirmed_instead(void)
{
    const command_t clear = {.kind = COMMAND_CLEAR_AXIS, .as.axis = {.axis = FRONT_RIGHT}};
    command_t restore = {.kind = COMMAND_RESTORE, .as.positions = {.axes = 1U << FRONT_LEFT}};
    fail_for_want_of_a_way();
    restore.as.positions.ticks[FRONT_LEFT] = rig_position(&rig, FRONT_LEFT);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, restore).status);
    expect_step(NEXT_STEP_CONFIRM, FRONT_LEFT);
    hold_button();
    TEST_ASSERT_TRUE(is_homed(FRONT_LEFT));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    expect_step(NEXT_STEP_START_UP, ROBOT_AXIS_MAX);
}

/* As saved; then the operator says that it is so. */
void test_SWR_NEXT_021_one_without_a_switch_that_is_lost_is_to_be_placed_and_confirmed(void)
{
    const command_t clear = {.kind = COMMAND_CLEAR_AXIS, .as.axis = {.axis = REAR_LEFT}};
    command_t restore = {.kind = COMMAND_RESTORE, .as.positions = {.axes = 1U << REAR_LEFT}};
    start_at_home();
    rig_cycles(&rig, 500U);
    restore.as.positions.ticks[REAR_LEFT] = rig_position(&rig, REAR_LEFT);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    expect_step(NEXT_STEP_PLACE, REAR_LEFT);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, restore).status);
    expect_step(NEXT_STEP_CONFIRM, REAR_LEFT);
    hold_button();
    TEST_ASSERT_TRUE(is_homed(REAR_LEFT));
}

/* It moves by itself under START_UP, rests, and is placed where it stands. */
static void lose_and_place(uint32_t axis)
{
    command_t restore = {.kind = COMMAND_RESTORE, .as.positions = {.axes = 1U << axis}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig.box.axes[axis].motor.fault = SIM_MOTOR_RUNS;
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 1000U).kind);
    rig.box.axes[axis].motor.fault = SIM_MOTOR_NORMAL;
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    restore.as.positions.ticks[axis] = rig_position(&rig, axis);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, restore).status);
}

/* The button would only lead to the next START_UP that fails, unless what has failed is mended. */
void test_SWR_AXIS_080_SWR_NEXT_035_one_that_is_placed_in_vain_is_for_service(void)
{
    const command_t clear = {.kind = COMMAND_CLEAR_AXIS, .as.axis = {.axis = FRONT_LEFT}};
    start_at_home();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    for (uint32_t i = 1U; i < LIMIT_SERVICE_START_UPS; i++) {
        lose_and_place(REAR_LEFT);
        expect_step(NEXT_STEP_CONFIRM, REAR_LEFT);
        hold_button();
    }
    lose_and_place(REAR_LEFT);
    expect_step(NEXT_STEP_SERVICE, REAR_LEFT);
    hold_button();
    expect_step(NEXT_STEP_CONFIRM, REAR_LEFT);
    hold_button();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
}

static void fail_in_vain(uint32_t axis)
{
    rig.controller.sealed.vain_start_ups = LIMIT_SERVICE_START_UPS;
    rig.controller.sealed.vain_axis = axis;
    controller_seal(&rig.controller);
}

void test_SWR_NEXT_035_another_one_is_placed_all_the_same(void)
{
    const command_t clear = {.kind = COMMAND_CLEAR_AXIS, .as.axis = {.axis = REAR_LEFT}};
    start_at_home();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    fail_in_vain(FRONT_LEFT);
    expect_step(NEXT_STEP_PLACE, REAR_LEFT);
}

void test_SWR_NEXT_035_what_is_to_be_moved_by_hand_is_not_for_service(void)
{
    fail_for_want_of_a_way();
    fail_in_vain(FRONT_LEFT);
    expect_step(NEXT_STEP_BY_HAND, FRONT_LEFT);
}

/* Its encoder counts half: each try moves it unseen until it is found out, by 0.13 mm. */
static void lose_with_half_an_encoder(void)
{
    const command_t clear = {.kind = COMMAND_CLEAR_AXIS, .as.axis = {.axis = FRONT_LEFT}};
    start_at_home();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    rig_box(&rig, "encoder front_left half");
}

static void try_in_vain(void)
{
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 5000U).kind);
    rig_release(&rig);
    rig_cycles(&rig, 500U);
}

void test_SWR_NEXT_004_SWR_NEXT_024_what_vain_tries_move_is_bounded_and_service_is_called(void)
{
    uint32_t tries = 0U;
    lose_with_half_an_encoder();
    const double from = true_ticks(FRONT_LEFT);
    while (rig_workphase(&rig, WORKPHASE_START_UP).status == (uint32_t)STATUS_OK) {
        TEST_ASSERT_LESS_THAN_UINT32(MOST_TRIES, tries);
        try_in_vain();
        tries++;
        TEST_ASSERT_EQUAL(tries >= LIMIT_SERVICE_START_UPS,
                          rig.outputs.snapshot.next_step == (uint32_t)NEXT_STEP_SERVICE);
    }
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOVED_IN_VAIN, rig.answers[rig.answer_count - 1U].status);
    expect_step(NEXT_STEP_SERVICE, FRONT_LEFT);
    TEST_ASSERT_DOUBLE_WITHIN(1.5 * TICKS_PER_MM, from, true_ticks(FRONT_LEFT));
}

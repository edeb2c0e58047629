/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * How far the controller trusts the position of an axis, and what makes it trusted again, on the
 * simulated box.
 */
#include "rig.h"

#include "unity.h"

#include "controller.h"

TEST_SOURCE_FILE("axis.c")
TEST_SOURCE_FILE("axis_chart.c")
TEST_SOURCE_FILE("box.c")
TEST_SOURCE_FILE("box_orders.c")
TEST_SOURCE_FILE("card_frame.c")
TEST_SOURCE_FILE("card_link_chart.c")
TEST_SOURCE_FILE("confirm_button.c")
TEST_SOURCE_FILE("controller_drive.c")
TEST_SOURCE_FILE("controller_move.c")
TEST_SOURCE_FILE("controller_obey.c")
TEST_SOURCE_FILE("controller_observe.c")
TEST_SOURCE_FILE("controller_show.c")
TEST_SOURCE_FILE("crc.c")
TEST_SOURCE_FILE("encoder.c")
TEST_SOURCE_FILE("estop_latch.c")
TEST_SOURCE_FILE("estop_latch_chart.c")
TEST_SOURCE_FILE("fixed.c")
TEST_SOURCE_FILE("homing.c")
TEST_SOURCE_FILE("link.c")
TEST_SOURCE_FILE("loop_guard.c")
TEST_SOURCE_FILE("loop_guard_chart.c")
TEST_SOURCE_FILE("motor_model.c")
TEST_SOURCE_FILE("neuro.c")
TEST_SOURCE_FILE("neuro_limits.c")
TEST_SOURCE_FILE("pedal_gate.c")
TEST_SOURCE_FILE("pedal_gate_chart.c")
TEST_SOURCE_FILE("permit.c")
TEST_SOURCE_FILE("plan.c")
TEST_SOURCE_FILE("profile.c")
TEST_SOURCE_FILE("rigid.c")
TEST_SOURCE_FILE("robot_neuro.c")
TEST_SOURCE_FILE("servo.c")
TEST_SOURCE_FILE("sim_card.c")
TEST_SOURCE_FILE("sim_encoder.c")
TEST_SOURCE_FILE("sim_motor.c")
TEST_SOURCE_FILE("sim_switch.c")
TEST_SOURCE_FILE("speed_cap.c")
TEST_SOURCE_FILE("stall_watchdog_chart.c")
TEST_SOURCE_FILE("supervision.c")
TEST_SOURCE_FILE("workphase.c")
TEST_SOURCE_FILE("workphases_chart.c")

#define HOLD_CYCLES (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US)

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static uint32_t grade(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].reference;
}

/* The button is held for so long, and released. @return the axes that were confirmed by it */
static uint32_t hold_button(uint32_t cycles)
{
    const uint32_t before = rig_count(&rig, EVENT_AXIS_CONFIRMED);
    rig_box(&rig, "button press");
    rig_cycles(&rig, cycles);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
    return rig_count(&rig, EVENT_AXIS_CONFIRMED) - before;
}

static void start_with_doubt(uint32_t axis)
{
    rig_start_homed(&rig);
    axis_doubt(&rig.controller.axes[axis]);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(axis));
}

void test_SWR_REF_006_the_operator_holds_the_button_and_the_axis_is_verified(void)
{
    start_with_doubt(AXIS_ROTATION);
    const int32_t position = rig.outputs.snapshot.axes[AXIS_ROTATION].position_ticks;
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(AXIS_ROTATION));
    TEST_ASSERT_EQUAL_INT32(position, rig.outputs.snapshot.axes[AXIS_ROTATION].position_ticks);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_TAKEN, grade(AXIS_FEET));
}

void test_SWR_REF_006_a_short_press_confirms_nothing(void)
{
    start_with_doubt(AXIS_ROTATION);
    TEST_ASSERT_EQUAL_UINT32(0U, hold_button(HOLD_CYCLES - 2U));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(AXIS_ROTATION));
}

void test_SWR_REF_006_a_button_that_is_held_from_the_start_confirms_nothing(void)
{
    start_with_doubt(AXIS_ROTATION);
    rig_box(&rig, "button press");
    rig_cycle(&rig);
    rig.controller.confirm = (confirm_button_t){0U, 0U};
    TEST_ASSERT_EQUAL_UINT32(0U, hold_button(3U * HOLD_CYCLES));
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
}

void test_SWR_REF_006_nothing_is_confirmed_while_an_order_is_armed(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG, .argument = AXIS_FEET, .value = 10};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    axis_lose_reference(&rig.controller.axes[AXIS_ROTATION]);
    TEST_ASSERT_EQUAL_UINT32(0U, hold_button(3U * HOLD_CYCLES));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(AXIS_ROTATION));
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
}

void test_SWR_REF_006_nothing_is_confirmed_while_the_emergency_stop_is_open(void)
{
    start_with_doubt(AXIS_FEET);
    rig_box(&rig, "estop pull");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, hold_button(3U * HOLD_CYCLES));
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
}

void test_SWR_REF_007_an_axis_whose_card_is_silent_is_not_confirmed(void)
{
    start_with_doubt(AXIS_FEET);
    axis_doubt(&rig.controller.axes[AXIS_ROTATION]);
    rig_box(&rig, "card rotation silent");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(AXIS_FEET));
    TEST_ASSERT_NOT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(AXIS_ROTATION));
    rig_box(&rig, "card rotation normal");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(AXIS_ROTATION));
}

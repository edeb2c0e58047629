/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: requirements/known_limits.yml is true. A test of these that fails is
 * no fault of the product: the limit has gone, and its entry is to be changed or taken out.
 * On the simulated box, whose true positions are compared with those believed.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "robot/robot_neuro.h"

#define MOST_CYCLES 40000U

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static double true_ticks(uint32_t axis)
{
    return rig.box.axes[axis].motor.position_ticks;
}

/* As it was left by a hand before the box was switched on. */
static void stand_uncounted(uint32_t axis, int32_t ticks)
{
    rig.box.axes[axis].motor.position_ticks += ticks;
    rig.box.axes[axis].encoder.state += ticks;
}

static uint32_t grade(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].reference;
}

static void cycle_until(uint32_t axis, axis_reference_t wanted)
{
    for (uint32_t i = 0U; grade(axis) != (uint32_t)wanted; i++) {
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, i);
        rig_cycle(&rig);
    }
}

static void jog_lateral(int32_t ticks)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_LATERAL, .to_ticks = ticks}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOST_CYCLES).kind);
    rig_release(&rig);
}

static void start_manual(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
}

/* The motor has run by two millimetres, and nothing was said. */
void test_SWR_AXIS_016_a_motor_that_runs_at_rest_behind_a_stuck_encoder_is_not_found(void)
{
    start_manual();
    jog_lateral(-500);
    const double before = true_ticks(NEURO_AXIS_LATERAL);
    rig_box(&rig, "encoder lateral stuck");
    rig_box(&rig, "motor lateral runs");
    for (uint32_t i = 0U; true_ticks(NEURO_AXIS_LATERAL) < (before + 94.0); i++) {
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, i);
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_LATERAL));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

/* It arrives in its time, by its counts, at twice the way. */
void test_SWR_AXIS_019_an_encoder_that_loses_what_its_motor_gains_is_not_found(void)
{
    start_manual();
    const double before = true_ticks(NEURO_AXIS_LATERAL);
    rig_box(&rig, "encoder lateral half");
    rig_box(&rig, "motor lateral twice");
    jog_lateral(-500);
    TEST_ASSERT_DOUBLE_WITHIN(50.0, before - 1000.0, true_ticks(NEURO_AXIS_LATERAL));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_LATERAL));
}

/* Both times at the same wrong place. */
void test_SWR_AXIS_026_the_first_homing_believes_its_switch(void)
{
    rig_start(&rig);
    stand_uncounted(NEURO_AXIS_INSERTION, 20000);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    cycle_until(NEURO_AXIS_INSERTION, AXIS_REFERENCE_APPROACH);
    rig_cycles(&rig, 100U);
    const double place = true_ticks(NEURO_AXIS_INSERTION);
    rig_box(&rig, "switch insertion stuck");
    cycle_until(NEURO_AXIS_INSERTION, AXIS_REFERENCE_BACK_OFF);
    rig_cycles(&rig, 10U);
    rig_box(&rig, "switch insertion normal");
    cycle_until(NEURO_AXIS_INSERTION, AXIS_REFERENCE_LATCH);
    while (true_ticks(NEURO_AXIS_INSERTION) > place) {
        rig_cycle(&rig);
    }
    rig_box(&rig, "switch insertion stuck");
    cycle_until(NEURO_AXIS_INSERTION, AXIS_REFERENCE_VERIFIED);
    TEST_ASSERT_DOUBLE_WITHIN(200.0, 0.0, (double)rig_position(&rig, NEURO_AXIS_INSERTION));
    TEST_ASSERT_TRUE(true_ticks(NEURO_AXIS_INSERTION) > 3200.0); /* A millimetre. */
    rig_box(&rig, "switch insertion normal");
    rig_release(&rig);
}

void test_SWR_PHASE_009_a_hot_motor_keeps_the_needle_in(void)
{
    const command_t retract = {.kind = (uint32_t)COMMAND_RETRACT};
    rig_start_arrived(&rig);
    rig_box(&rig, "motor insertion hot");
    rig_cycles(&rig, 200U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_HOT));
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_command(&rig, retract).status);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_INSERTION));
}

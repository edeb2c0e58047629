/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: homing goes by the stages of the robot's table, takes the needle out before the
 * base homes, takes axes without a switch where they stand, and fails when a coupled limit bars it.
 */
#include "unity.h"

#include "axis/axis.h"
#include "mode/homing_mode.h"
#include "mode/leg.h"
#include "mode/mode_frame.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

static leg_t leg;

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
}

void tearDown(void)
{
}

/* As after the power-on. */
static void start_fresh(void)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_grade(i, AXIS_REFERENCE_FRESH);
    }
    frame.is_every_axis_homed = false;
}

static void step(void)
{
    mode_clear(&result);
    homing_mode_step(&leg, &frame, &result);
}

void test_SWR_JOG_016_the_needle_homes_before_all_else(void)
{
    start_fresh();
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL(i == (uint32_t)AXIS_INSERTION, axis_is_homing(&axes[i]));
        TEST_ASSERT_EQUAL(i != (uint32_t)AXIS_INSERTION, world_rests(i));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

void test_SWR_REF_002_axes_without_a_switch_are_taken_in_the_second_stage(void)
{
    start_fresh();
    world_grade(AXIS_INSERTION, AXIS_REFERENCE_VERIFIED);
    world_put(AXIS_FEET, 12);
    step();
    TEST_ASSERT_EQUAL_UINT32(2U, result.note_count);
    TEST_ASSERT_EQUAL(EVENT_AXIS_TAKEN, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(AXIS_FEET, result.notes[0].axis);
    TEST_ASSERT_EQUAL_INT32(-12, result.notes[0].value);
    TEST_ASSERT_EQUAL_UINT32(AXIS_ROTATION, result.notes[1].axis);
    TEST_ASSERT_TRUE(axis_is_homing(&axes[AXIS_HEAD]));
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    step();
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

/* Whoever is homed stays where it is. */
void test_SWR_AXIS_006_a_homed_axis_rests_while_another_homes(void)
{
    world_lose(AXIS_LATERAL);
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL(i == (uint32_t)AXIS_LATERAL, axis_is_homing(&axes[i]));
        TEST_ASSERT_EQUAL(i != (uint32_t)AXIS_LATERAL, world_rests(i));
    }
}

void test_SWR_JOG_016_a_needle_that_is_in_leaves_alone_before_the_base_homes(void)
{
    const int32_t out_ticks = needle_retracted_ticks(&robot);
    uint32_t cycles = 0U;
    world_lose(AXIS_LATERAL);
    world_put(AXIS_INSERTION, 20000);
    while (needle_must_leave(&robot, axes)) {
        step();
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
        TEST_ASSERT_TRUE(axes[AXIS_INSERTION].setpoint_ticks <= 20000);
        TEST_ASSERT_FALSE(axis_is_homing(&axes[AXIS_LATERAL]));
        TEST_ASSERT_TRUE(world_rests(AXIS_LATERAL));
        TEST_ASSERT_TRUE(world_rests(AXIS_PITCH));
        TEST_ASSERT_LESS_THAN_UINT32(20000U, cycles);
        cycles++;
        world_follow();
        world_put(AXIS_PITCH, 5);
    }
    TEST_ASSERT_EQUAL_INT32(out_ticks, leg.profile.end_ticks[AXIS_INSERTION]);
    step();
    TEST_ASSERT_EQUAL_UINT32(0U, leg.is_running);
    TEST_ASSERT_TRUE(axis_is_homing(&axes[AXIS_LATERAL]));
    TEST_ASSERT_TRUE(world_rests(AXIS_INSERTION));
}

void test_SWR_COUPLE_003_an_axis_that_is_barred_fails_it_and_no_other_begins(void)
{
    world_lose(AXIS_HEAD);
    world_lose(AXIS_LATERAL);
    world_put(AXIS_FEET, -5000);
    step();
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_FAULT_PRESENT, result.status);
    TEST_ASSERT_EQUAL_UINT32(AXIS_HEAD, result.axis);
    TEST_ASSERT_EQUAL_UINT32(1U, result.note_count);
    TEST_ASSERT_EQUAL(EVENT_HOMING_BARRED, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(AXIS_HEAD, result.notes[0].axis);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_FALSE(axis_is_homing(&axes[i]));
        TEST_ASSERT_TRUE(world_rests(i));
    }
}

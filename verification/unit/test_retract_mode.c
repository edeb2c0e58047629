/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a retraction takes the needle outwards to where one that is out is taken, never
 * inwards, and holds all other axes.
 */
#include "unity.h"

#include "axis/axis.h"
#include "mode/leg.h"
#include "mode/mode_frame.h"
#include "mode/retract_mode.h"
#include "motion/motor_model.h"
#include "robot/joints.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

#define DEEP_TICKS 60000
#define LONG_CYCLES 100000U

static leg_t leg;

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
}

void tearDown(void)
{
}

static int32_t needle_ticks(void)
{
    return axes[AXIS_INSERTION].encoder.position_ticks;
}

static bool is_driven_inwards(void)
{
    const card_drive_t *const request = &result.requests[AXIS_INSERTION];
    return (request->mode != (uint32_t)CARD_DRIVE_OFF) &&
           motor_model_is_upwards(&robot.axes[AXIS_INSERTION], request);
}

static void step(void)
{
    mode_clear(&result);
    retract_mode_step(&leg, &frame, &result);
}

void test_SWR_MOTION_023_the_needle_goes_outwards_and_nothing_else_moves(void)
{
    static const int32_t base[ROBOT_AXIS_MAX] = {-400, 150, -200, DEEP_TICKS, 500, 30, -60};
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, base[i]);
    }
    int32_t before = DEEP_TICKS;
    for (uint32_t cycles = 0U; !retract_mode_is_done(&frame); cycles++) {
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
        step();
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
        TEST_ASSERT_FALSE(is_driven_inwards());
        world_follow();
        TEST_ASSERT_LESS_OR_EQUAL_INT32(before, needle_ticks());
        before = needle_ticks();
    }
    TEST_ASSERT_INT32_WITHIN(robot.axes[AXIS_INSERTION].deadband_ticks,
                             needle_retracted_ticks(&robot), needle_ticks());
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32((i == (uint32_t)AXIS_INSERTION) ? needle_ticks() : base[i],
                                axes[i].encoder.position_ticks);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

/* Pushed off its place an axis is driven back. */
void test_SWR_MOTION_023_the_other_axes_are_held(void)
{
    world_put(AXIS_INSERTION, DEEP_TICKS);
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        if (i != (uint32_t)AXIS_INSERTION) {
            TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, result.requests[i].mode);
            world_put(i, 50 + robot.axes[i].deadband_ticks);
        }
    }
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        if (i != (uint32_t)AXIS_INSERTION) {
            TEST_ASSERT_EQUAL_INT32(0, axes[i].setpoint_ticks);
            TEST_ASSERT_NOT_EQUAL_UINT32(CARD_DRIVE_OFF, result.requests[i].mode);
        }
    }
}

/* As when it is pulled, or its motor is faster than its table says. */
void test_SWR_MOTION_023_a_needle_ahead_of_its_set_point_waits_for_it(void)
{
    world_put(AXIS_INSERTION, DEEP_TICKS);
    for (uint32_t i = 0U; i < 200U; i++) {
        step();
        world_follow();
    }
    world_put(AXIS_INSERTION, needle_ticks() - 3000);
    for (uint32_t i = 0U; i < 30U; i++) {
        step();
        TEST_ASSERT_FALSE(is_driven_inwards());
    }
    TEST_ASSERT_EQUAL_UINT32(1U, leg.is_running);
}

void test_SWR_MOTION_023_a_needle_that_is_out_is_not_taken_back_in(void)
{
    const int32_t place = needle_retracted_ticks(&robot);
    const int32_t deadband = robot.axes[AXIS_INSERTION].deadband_ticks;
    world_put(AXIS_INSERTION, place + deadband);
    TEST_ASSERT_TRUE(retract_mode_is_done(&frame));
    world_put(AXIS_INSERTION, place - 500);
    TEST_ASSERT_TRUE(retract_mode_is_done(&frame));
    world_put(AXIS_INSERTION, place + deadband + 1);
    TEST_ASSERT_FALSE(retract_mode_is_done(&frame));
}

void test_SWR_MOTION_005_a_retraction_that_is_held_fails(void)
{
    world_put(AXIS_INSERTION, 10000);
    mode_clear(&result);
    while (result.progress == MODE_RUNNING) {
        step();
        world_follow_but(AXIS_INSERTION);
    }
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL_UINT32(AXIS_INSERTION, result.axis);
}

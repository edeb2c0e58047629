/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: one axis homes alone as homing would have it home, and all others rest; one that
 * homes with others or without a switch is refused.
 */
#include "unity.h"

#include "axis/axis.h"
#include "mode/home_axis/home_axis_mode.h"
#include "mode/leg/mode_frame.h"
#include "unit/support/mode_world.h"

void setUp(void)
{
    world_start();
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

static void step_axis(uint32_t axis)
{
    mode_clear(&result);
    home_axis_mode_step(axis, &frame, &result);
}

void test_SWR_AXIS_034_one_axis_homes_and_all_others_rest(void)
{
    start_fresh();
    step_axis(NEURO_AXIS_LATERAL);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL(i == (uint32_t)NEURO_AXIS_LATERAL, axis_is_homing(&axes[i]));
        TEST_ASSERT_EQUAL(i != (uint32_t)NEURO_AXIS_LATERAL, world_rests(i));
    }
    TEST_ASSERT_FALSE(home_axis_mode_is_done(NEURO_AXIS_LATERAL, &frame));
    world_grade(NEURO_AXIS_LATERAL, AXIS_REFERENCE_VERIFIED);
    TEST_ASSERT_TRUE(home_axis_mode_is_done(NEURO_AXIS_LATERAL, &frame));
}

void test_SWR_AXIS_034_one_without_a_switch_is_taken_where_it_stands(void)
{
    start_fresh();
    world_put(NEURO_AXIS_FEET, 12);
    step_axis(NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL(EVENT_AXIS_TAKEN, result.notes[0].id);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_FEET));
    TEST_ASSERT_TRUE(home_axis_mode_is_done(NEURO_AXIS_FEET, &frame));
}

void test_SWR_AXIS_034_an_axis_that_there_is_not_is_not_driven_and_never_done(void)
{
    start_fresh();
    step_axis(robot.axis_count);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_TRUE(world_rests(i));
    }
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    TEST_ASSERT_FALSE(home_axis_mode_is_done(robot.axis_count, &frame));
}

static status_t judged(uint32_t axis)
{
    return home_axis_mode_judge(axis, &robot, axes).status;
}

void test_SWR_AXIS_036_what_homes_with_others_does_not_home_alone(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, judged(NEURO_AXIS_HEAD));
    robot.axes[NEURO_AXIS_LATERAL].leaders[0] = 1U + NEURO_AXIS_HEAD;
    TEST_ASSERT_EQUAL(STATUS_HOMES_WITH_OTHERS, judged(NEURO_AXIS_LATERAL));
    robot.axes[NEURO_AXIS_HEAD].home_stage = 1U;
    TEST_ASSERT_EQUAL(STATUS_HOMES_WITH_OTHERS, judged(NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND, judged(robot.axis_count));
}

void test_SWR_AXIS_036_what_has_no_switch_is_taken_only_while_it_is_fresh(void)
{
    TEST_ASSERT_EQUAL(STATUS_HOMES_OTHERWISE, judged(NEURO_AXIS_FEET));
    world_lose(NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL(STATUS_HOMES_OTHERWISE, judged(NEURO_AXIS_FEET));
    world_lose(NEURO_AXIS_INSERTION);
    world_grade(NEURO_AXIS_FEET, AXIS_REFERENCE_FRESH);
    TEST_ASSERT_EQUAL(STATUS_OK, judged(NEURO_AXIS_FEET));
    TEST_ASSERT_EQUAL(STATUS_NEEDLE_IN, judged(NEURO_AXIS_LATERAL));
    TEST_ASSERT_EQUAL(STATUS_OK, judged(NEURO_AXIS_INSERTION));
}

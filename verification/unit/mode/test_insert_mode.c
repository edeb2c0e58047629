/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the needle alone goes in, only while every other axis stands at the target; an
 * insertion never moves the base, nor draws the needle out to do so.
 */
#include "unity.h"

#include "mode/insert/insert_mode.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/leg/steer.h"
#include "mode/move/move_mode.h"
#include "unit/support/mode_world.h"

#define LONG_CYCLES 100000U
#define DEEP_TICKS 60000

static const move_mode_t move = {.target_ticks = {-400, 150, -200, DEEP_TICKS, 500, 30, -60}};

static leg_t leg;
static steer_t steer;

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
    steer = (steer_t){0};
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, move.target_ticks[i]);
    }
    world_put(NEURO_AXIS_INSERTION, 1000);
}

void tearDown(void)
{
}

static void steps(uint32_t count)
{
    for (uint32_t i = 0U; (i < count) && (result.progress == MODE_RUNNING); i++) {
        mode_clear(&result);
        insert_mode_step(&move, &leg, &steer, &frame, &result);
        world_follow();
    }
}

static void expect_given_up(void)
{
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_NOT_ALIGNED, result.status);
    TEST_ASSERT_EQUAL_UINT32(MODE_NO_AXIS, result.axis);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_TRUE(world_rests(i));
    }
}

void test_SWR_ALIGN_005_the_needle_goes_to_its_depth_and_the_base_stays(void)
{
    steps(LONG_CYCLES);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(move.target_ticks[i], axes[i].sealed.encoder.position_ticks);
    }
}

/* On either side, by a tick more than counts as aligned. */
void test_SWR_ALIGN_004_each_axis_but_the_needle_must_stand_at_the_target(void)
{
    for (int32_t side = -1; side <= 1; side += 2) {
        for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
            const int32_t slack = robot.axes[axis].deadband_ticks + 2;
            const bool is_needle = axis == (uint32_t)NEURO_AXIS_INSERTION;
            world_put(axis, move.target_ticks[axis] + (side * slack));
            TEST_ASSERT_EQUAL(STATUS_OK, insert_mode_judge(&move, &robot, axes).status);
            world_put(axis, move.target_ticks[axis] + (side * (slack + 1)));
            TEST_ASSERT_EQUAL(is_needle ? STATUS_OK : STATUS_NOT_ALIGNED,
                              insert_mode_judge(&move, &robot, axes).status);
            world_put(axis, move.target_ticks[axis]);
        }
    }
}

void test_SWR_ALIGN_005_it_does_not_begin_beside_the_line(void)
{
    world_put(NEURO_AXIS_YAW, move.target_ticks[NEURO_AXIS_YAW] + 3);
    steps(1U);
    expect_given_up();
}

void test_SWR_ALIGN_005_it_does_not_go_on_beside_the_line_nor_draw_the_needle_out(void)
{
    steps(200U);
    const int32_t depth = axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks;
    TEST_ASSERT_GREATER_THAN_INT32(1000, depth);
    leg_stop(&leg);
    world_put(NEURO_AXIS_YAW, move.target_ticks[NEURO_AXIS_YAW] - 3);
    steps(10U);
    expect_given_up();
    TEST_ASSERT_EQUAL_INT32(depth, axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks);
}

void test_SWR_ALIGN_005_it_goes_on_after_a_pause_while_the_base_is_aligned(void)
{
    steps(200U);
    leg_stop(&leg);
    steps(LONG_CYCLES);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
}

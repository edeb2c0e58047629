/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a move retracts the needle, aligns everything else and inserts, each only if it
 * is needed; it is done at the target, and at no end of a leg before.
 */
#include "unity.h"

#include "axis/axis.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/leg/steer.h"
#include "mode/move/move_mode.h"
#include "robot/joints.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

#define DEEP_TICKS 60000
#define LONG_CYCLES 100000U

static leg_t leg;
static steer_t steer;
static move_mode_t move;

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
    steer = (steer_t){0};
    move = (move_mode_t){.target_ticks = {-400, 150, -200, DEEP_TICKS, 500, 30, -60}};
}

void tearDown(void)
{
}

/* One leg, to its end. */
static void run_leg(void)
{
    uint32_t cycles = 0U;
    do {
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
        cycles++;
        mode_clear(&result);
        move_mode_step(&move, &leg, &steer, &frame, &result);
        world_follow();
    } while ((leg.is_running != 0U) && (result.progress == MODE_RUNNING));
}

static void expect_base_at(const int32_t ticks[ROBOT_AXIS_MAX])
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        if (i != (uint32_t)NEURO_AXIS_INSERTION) {
            TEST_ASSERT_EQUAL_INT32(ticks[i], axes[i].sealed.encoder.position_ticks);
        }
    }
}

static void expect_needle_at(int32_t ticks)
{
    TEST_ASSERT_EQUAL_INT32(ticks, axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks);
}

void test_SWR_MOTION_002_retract_align_insert(void)
{
    static const int32_t start[ROBOT_AXIS_MAX] = {0};
    world_put(NEURO_AXIS_INSERTION, 30000);
    run_leg();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    expect_base_at(start);
    expect_needle_at(needle_retracted_ticks(&robot));
    run_leg();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    expect_base_at(move.target_ticks);
    expect_needle_at(needle_retracted_ticks(&robot));
    run_leg();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    expect_base_at(move.target_ticks);
    expect_needle_at(DEEP_TICKS);
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

void test_SWR_MOTION_002_a_needle_that_is_out_stays_where_it_is_while_the_base_is_aligned(void)
{
    world_put(NEURO_AXIS_INSERTION, needle_out_ticks(&robot));
    run_leg();
    expect_base_at(move.target_ticks);
    expect_needle_at(needle_out_ticks(&robot));
    run_leg();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
}

void test_SWR_MOTION_002_only_the_needle_goes_where_the_base_is_aligned(void)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, move.target_ticks[i]);
    }
    world_put(NEURO_AXIS_INSERTION, DEEP_TICKS - 5000);
    world_put(NEURO_AXIS_HEAD, move.target_ticks[NEURO_AXIS_HEAD] + 2);
    run_leg();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    expect_needle_at(DEEP_TICKS);
    expect_base_at(move.target_ticks);
}

/* On either side, by a tick more than counts as aligned. */
void test_SWR_MOTION_002_an_axis_that_is_not_aligned_lets_the_needle_be_retracted(void)
{
    for (int32_t side = -1; side <= 1; side += 2) {
        for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
            world_start();
            leg = (leg_t){.axes = 0U};
            steer = (steer_t){0};
            for (uint32_t i = 0U; i < robot.axis_count; i++) {
                world_put(i, move.target_ticks[i]);
            }
            world_put(axis,
                      move.target_ticks[axis] + (side * (robot.axes[axis].deadband_ticks + 3)));
            run_leg();
            expect_needle_at((axis == (uint32_t)NEURO_AXIS_INSERTION)
                                 ? DEEP_TICKS
                                 : needle_retracted_ticks(&robot));
        }
    }
}

void test_SWR_MOTION_005_a_move_that_is_held_fails(void)
{
    while (result.progress == MODE_RUNNING) {
        mode_clear(&result);
        move_mode_step(&move, &leg, &steer, &frame, &result);
        world_follow_but(NEURO_AXIS_YAW);
    }
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_YAW, result.axis);
    TEST_ASSERT_EQUAL_INT32(-60, result.notes[0].value);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an alignment is a move to the target with the needle out: it is taken out first,
 * never in, and is out at the end.
 */
#include "unity.h"

#include "mode/align/align_mode.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/move/move_mode.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

#define LONG_CYCLES 100000U

static const int32_t target[ROBOT_AXIS_MAX] = {-400, 150, -200, 60000, 500, 30, -60};

static leg_t leg;
static int32_t deepest_ticks;
static bool is_base_moved_with_needle_in;

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
    deepest_ticks = 0;
    is_base_moved_with_needle_in = false;
}

void tearDown(void)
{
}

static void watch(int32_t head_before)
{
    const int32_t needle_ticks = axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks;
    const bool is_in = needle_ticks > needle_out_ticks(&robot);
    const bool has_moved = axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks != head_before;
    deepest_ticks = (needle_ticks > deepest_ticks) ? needle_ticks : deepest_ticks;
    is_base_moved_with_needle_in = is_base_moved_with_needle_in || (is_in && has_moved);
}

static void run(const move_mode_t *move)
{
    uint32_t cycles = 0U;
    do {
        const int32_t head_before = axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks;
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
        cycles++;
        mode_clear(&result);
        move_mode_go(move, &leg, &frame, &result);
        world_follow();
        watch(head_before);
    } while (result.progress == MODE_RUNNING);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
}

static void expect_aligned(int32_t needle_ticks)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        const int32_t place = (i == (uint32_t)NEURO_AXIS_INSERTION) ? needle_ticks : target[i];
        TEST_ASSERT_EQUAL_INT32(place, axes[i].sealed.encoder.position_ticks);
    }
}

void test_SWR_ALIGN_002_a_needle_that_is_in_is_taken_out_before_the_base_moves(void)
{
    world_put(NEURO_AXIS_INSERTION, 30000);
    const move_mode_t move = align_mode_move(&robot, axes, target);
    run(&move);
    expect_aligned(needle_retracted_ticks(&robot));
    TEST_ASSERT_FALSE(is_base_moved_with_needle_in);
}

void test_SWR_ALIGN_002_a_needle_that_is_out_goes_no_farther_in(void)
{
    world_put(NEURO_AXIS_INSERTION, 7);
    const move_mode_t move = align_mode_move(&robot, axes, target);
    run(&move);
    expect_aligned(7);
    TEST_ASSERT_EQUAL_INT32(7, deepest_ticks);
}

void test_SWR_ALIGN_002_where_the_base_is_aligned_the_needle_alone_is_taken_out(void)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, target[i]);
    }
    const move_mode_t move = align_mode_move(&robot, axes, target);
    run(&move);
    expect_aligned(needle_retracted_ticks(&robot));
    TEST_ASSERT_EQUAL_INT32(target[NEURO_AXIS_INSERTION], deepest_ticks);
}

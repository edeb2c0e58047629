/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a move retracts the needle, aligns everything else and inserts, each only if it
 * is needed; it is done at the target, and at no end of a leg before.
 */
#include "unity.h"

#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/leg/steer.h"
#include "mode/move/move_mode.h"
#include "robot/robot_prostate.h"
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

/* The needle of the ProstateRobot goes in while its rotation turns. */
static void insert_steered(uint32_t cycles)
{
    robot = robot_prostate;
    frame.axis_count = robot.axis_count;
    move = (move_mode_t){.target_ticks = {380000, -370000, 375000, -375000, 150000, 0}};
    (void)steering_set(&move.steering, &robot.steering, (uint32_t)STEERING_BIDIRECTIONAL, 1000U,
                       90);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, (i == robot.needle_axis) ? 0 : move.target_ticks[i]);
    }
    for (uint32_t i = 0U; i < cycles; i++) {
        mode_clear(&result);
        move_mode_step(&move, &leg, &steer, &frame, &result);
        world_follow();
    }
}

/* Beside its place by more than counts as aligned, whether the needle moves or waits. */
void test_SWR_STEER_007_a_base_that_is_pushed_aside_never_draws_the_needle_out(void)
{
    uint32_t waits = 0U;
    insert_steered(1000U);
    for (uint32_t i = 0U; i < 6000U; i++) {
        const int32_t before = axes[robot.needle_axis].sealed.encoder.position_ticks;
        world_put(0U, move.target_ticks[0] + 6);
        mode_clear(&result);
        move_mode_step(&move, &leg, &steer, &frame, &result);
        waits += (leg.is_running == 0U) ? 1U : 0U;
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
        TEST_ASSERT_EQUAL_INT32(move.target_ticks[0], axes[0].sealed.setpoint_ticks);
        TEST_ASSERT_TRUE(axes[robot.needle_axis].sealed.setpoint_ticks >= before);
        world_follow();
    }
    TEST_ASSERT_GREATER_THAN_UINT32(100U, waits);
}

/* The rotation is asked for its drive in each cycle, and turns. */
void test_SWR_STEER_008_the_rotation_turns_in_each_cycle_in_which_the_needle_moves(void)
{
    insert_steered(1000U);
    for (uint32_t i = 0U; i < 6000U; i++) {
        const int32_t needle = axes[robot.needle_axis].sealed.setpoint_ticks;
        const int32_t turned = axes[PROSTATE_AXIS_ROTATION].sealed.setpoint_speed_ticks_per_s_q8;
        mode_clear(&result);
        move_mode_step(&move, &leg, &steer, &frame, &result);
        TEST_ASSERT_TRUE((axes[robot.needle_axis].sealed.setpoint_ticks == needle) ||
                         (turned != 0));
        world_follow();
    }
}

/* The pedal was released, and the base has moved meanwhile: as a move that is not steered. */
void test_SWR_STEER_007_after_a_pause_beside_the_line_the_needle_is_drawn_out_first(void)
{
    insert_steered(3000U);
    leg_stop(&leg);
    steer_pause(&steer);
    world_put(0U, move.target_ticks[0] + 600);
    mode_clear(&result);
    move_mode_step(&move, &leg, &steer, &frame, &result);
    TEST_ASSERT_EQUAL_INT32(needle_retracted_ticks(&robot),
                            leg.profile.end_ticks[robot.needle_axis]);
    TEST_ASSERT_EQUAL_INT32(0, steer.heading);
    world_put(0U, move.target_ticks[0]);
    mode_clear(&result);
    move_mode_step(&move, &leg, &steer, &frame, &result);
    TEST_ASSERT_EQUAL_INT32(0, steer.heading); /* That leg is gone to its end. */
}

/* It never follows: the order is given up, and nothing is driven. */
void test_SWR_STEER_007_an_insertion_that_has_waited_too_long_is_given_up(void)
{
    insert_steered(1000U);
    world_put(PROSTATE_AXIS_ROTATION, 7000);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (result.progress == MODE_RUNNING); i++) {
        mode_clear(&result);
        move_mode_step(&move, &leg, &steer, &frame, &result);
        world_follow_but(PROSTATE_AXIS_ROTATION);
    }
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL_UINT32(PROSTATE_AXIS_ROTATION, result.axis);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, result.requests[i].mode);
    }
}

/* INSERT again once it has arrived: nothing moves, whatever place the rotation has. */
void test_SWR_STEER_015_a_needle_at_its_depth_is_not_turned(void)
{
    insert_steered(0U);
    world_put(robot.needle_axis, move.target_ticks[robot.needle_axis]);
    world_put(PROSTATE_AXIS_ROTATION, 4000);
    mode_clear(&result);
    move_mode_step(&move, &leg, &steer, &frame, &result);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(4000, axes[PROSTATE_AXIS_ROTATION].sealed.setpoint_ticks);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, result.requests[i].mode);
    }
    TEST_ASSERT_FALSE(steer_is_turning(&steer));
}

/* While it waits, a base that stands beside its place keeps it waiting. */
void test_SWR_STEER_007_it_goes_on_once_the_base_stands_at_its_place_again(void)
{
    insert_steered(1000U);
    leg_stop(&leg);
    for (uint32_t i = 0U; i < 100U; i++) {
        world_put(0U, move.target_ticks[0] + 6);
        mode_clear(&result);
        move_mode_step(&move, &leg, &steer, &frame, &result);
        TEST_ASSERT_EQUAL_UINT32(0U, leg.is_running);
        world_follow_but(0U);
    }
    world_put(0U, move.target_ticks[0]);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (result.progress == MODE_RUNNING); i++) {
        mode_clear(&result);
        move_mode_step(&move, &leg, &steer, &frame, &result);
        world_follow();
    }
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(move.target_ticks[robot.needle_axis],
                            axes[robot.needle_axis].sealed.encoder.position_ticks);
}

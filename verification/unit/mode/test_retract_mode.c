/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a retraction takes the needle outwards to where one that is out is taken, never
 * inwards, and drives no other axis; without a reference to its switch or a whole stroke.
 */
#include "unity.h"

#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/retract/retract_mode.h"
#include "motion/motor_model.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

#define DEEP_TICKS 60000
#define LONG_CYCLES 100000U

static leg_t leg;
static int32_t end_ticks;

/* Where a retraction that is armed now ends. */
static int32_t asked_end(void)
{
    const mode_asked_t asked = {.robot = &robot, .axes = axes};
    mode_way_t way;
    TEST_ASSERT_EQUAL_HEX32(LEG_AXIS(robot.needle_axis), retract_mode_ask(&asked, &way));
    TEST_ASSERT_EQUAL_UINT32(robot.needle_axis, way.axis);
    return way.end_ticks;
}

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
    end_ticks = needle_retracted_ticks(&robot);
}

void tearDown(void)
{
}

static int32_t needle_ticks(void)
{
    return axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks;
}

static bool is_driven_inwards(void)
{
    const card_drive_t *const request = &result.requests[NEURO_AXIS_INSERTION];
    return (request->mode != (uint32_t)CARD_DRIVE_OFF) &&
           motor_model_is_upwards(&robot.axes[NEURO_AXIS_INSERTION], request);
}

static void step(void)
{
    mode_clear(&result);
    retract_mode_step(end_ticks, &leg, &frame, &result);
}

void test_SWR_MOTION_023_the_needle_goes_outwards_and_nothing_else_moves(void)
{
    static const int32_t base[ROBOT_AXIS_MAX] = {-400, 150, -200, DEEP_TICKS, 500, 30, -60};
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, base[i]);
    }
    int32_t before = DEEP_TICKS;
    for (uint32_t cycles = 0U; !retract_mode_is_done(end_ticks, &frame); cycles++) {
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
        step();
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
        TEST_ASSERT_FALSE(is_driven_inwards());
        world_follow();
        TEST_ASSERT_LESS_OR_EQUAL_INT32(before, needle_ticks());
        before = needle_ticks();
    }
    TEST_ASSERT_INT32_WITHIN(robot.axes[NEURO_AXIS_INSERTION].deadband_ticks,
                             needle_retracted_ticks(&robot), needle_ticks());
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32((i == (uint32_t)NEURO_AXIS_INSERTION) ? needle_ticks() : base[i],
                                axes[i].sealed.encoder.position_ticks);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

/* Also with a fault, and when a hand pushes one. */
void test_SWR_MOTION_023_the_other_axes_rest(void)
{
    world_put(NEURO_AXIS_INSERTION, DEEP_TICKS);
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, (i == (uint32_t)NEURO_AXIS_INSERTION) ? DEEP_TICKS
                                                           : (50 + robot.axes[i].deadband_ticks));
    }
    step();
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        if (i != (uint32_t)NEURO_AXIS_INSERTION) {
            TEST_ASSERT_EQUAL_INT32(axes[i].sealed.encoder.position_ticks,
                                    axes[i].sealed.setpoint_ticks);
            TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, result.requests[i].mode);
        }
    }
}

/* As when it is pulled, or its motor is faster than its table says. */
void test_SWR_MOTION_023_a_needle_ahead_of_its_set_point_waits_for_it(void)
{
    world_put(NEURO_AXIS_INSERTION, DEEP_TICKS);
    for (uint32_t i = 0U; i < 200U; i++) {
        step();
        world_follow();
    }
    world_put(NEURO_AXIS_INSERTION, needle_ticks() - 3000);
    for (uint32_t i = 0U; i < 30U; i++) {
        step();
        TEST_ASSERT_FALSE(is_driven_inwards());
    }
    TEST_ASSERT_EQUAL_UINT32(1U, leg.is_running);
}

void test_SWR_MOTION_023_a_needle_that_is_out_is_not_taken_back_in(void)
{
    const int32_t place = needle_retracted_ticks(&robot);
    const int32_t deadband = robot.axes[NEURO_AXIS_INSERTION].deadband_ticks;
    world_put(NEURO_AXIS_INSERTION, place + deadband);
    TEST_ASSERT_TRUE(retract_mode_is_done(end_ticks, &frame));
    world_put(NEURO_AXIS_INSERTION, place - 500);
    TEST_ASSERT_TRUE(retract_mode_is_done(end_ticks, &frame));
    world_put(NEURO_AXIS_INSERTION, place + deadband + 1);
    TEST_ASSERT_FALSE(retract_mode_is_done(end_ticks, &frame));
}

void test_SWR_MOTION_005_a_retraction_that_is_held_fails(void)
{
    world_put(NEURO_AXIS_INSERTION, 10000);
    mode_clear(&result);
    while (result.progress == MODE_RUNNING) {
        step();
        world_follow_but(NEURO_AXIS_INSERTION);
    }
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_INSERTION, result.axis);
}

static int32_t stroke_ticks(void)
{
    return robot.axes[NEURO_AXIS_INSERTION].maximum_ticks -
           robot.axes[NEURO_AXIS_INSERTION].minimum_ticks;
}

void test_SWR_MODE_005_without_a_reference_it_ends_a_stroke_from_where_it_was_armed(void)
{
    TEST_ASSERT_EQUAL_INT32(needle_retracted_ticks(&robot), asked_end());
    world_lose(NEURO_AXIS_INSERTION);
    world_put(NEURO_AXIS_INSERTION, -700);
    end_ticks = asked_end();
    TEST_ASSERT_EQUAL_INT32(-700 - stroke_ticks(), end_ticks);
    TEST_ASSERT_FALSE(retract_mode_is_done(end_ticks, &frame));
    world_put(NEURO_AXIS_INSERTION, end_ticks + robot.axes[NEURO_AXIS_INSERTION].deadband_ticks);
    TEST_ASSERT_TRUE(retract_mode_is_done(end_ticks, &frame));
    world_put(NEURO_AXIS_INSERTION, INT32_MIN + 1);
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, asked_end());
}

void test_SWR_MODE_005_without_a_reference_it_ends_at_its_switch_which_says_nothing_of_a_homed_one(
    void)
{
    world_put(NEURO_AXIS_INSERTION, DEEP_TICKS);
    axes[NEURO_AXIS_INSERTION].sealed.limit_switches = 1U;
    TEST_ASSERT_FALSE(retract_mode_is_done(end_ticks, &frame));
    world_lose(NEURO_AXIS_INSERTION);
    TEST_ASSERT_TRUE(retract_mode_is_done(DEEP_TICKS - stroke_ticks(), &frame));
}

void test_SWR_MODE_005_without_a_reference_it_goes_outwards_only_and_no_faster_than_its_cap(void)
{
    world_lose(NEURO_AXIS_INSERTION);
    frame.speed_cap_percent[NEURO_AXIS_INSERTION] = LIMIT_UNHOMED_SPEED_PERCENT;
    end_ticks = asked_end();
    int32_t before = needle_ticks();
    while (!retract_mode_is_done(end_ticks, &frame)) {
        step();
        TEST_ASSERT_FALSE(is_driven_inwards());
        world_follow();
        TEST_ASSERT_LESS_OR_EQUAL_INT32(before, needle_ticks());
        TEST_ASSERT_LESS_OR_EQUAL_INT32(
            256 * robot.axes[NEURO_AXIS_INSERTION].home_speed_ticks_per_s + 256,
            -axes[NEURO_AXIS_INSERTION].sealed.setpoint_speed_ticks_per_s_q8);
        before = needle_ticks();
    }
}

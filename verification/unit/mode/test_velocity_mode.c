/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: axes run at the speeds that they were commanded, with ramps, for a time or a
 * way and no longer.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/velocity/velocity_share.h"
#include "unit/support/mode_world.h"

#include "unit/mode/velocity_world.inc"

void setUp(void)
{
    begin_velocity();
}

void tearDown(void)
{
}

static void rest_one_cycle(void)
{
    leg_stop(&leg);
    mode_rest(&frame, &result);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        before_q8[i] = 0;
    }
}

void test_SWR_VEL_001_speeds_are_armed_for_a_time_or_one_for_a_way(void)
{
    ask(NEURO_AXIS_YAW, -833, 1);
    expect(STATUS_OK, 0U);
    ask(NEURO_AXIS_ROTATION, 1285, (int32_t)LIMIT_VELOCITY_TIME_MS);
    expect(STATUS_OK, 0U);
    mode.axes = ONE(NEURO_AXIS_ROTATION);
    mode.time_ms = 0U;
    mode.way_ticks = 1U;
    expect(STATUS_OK, 0U);
}

void test_SWR_VEL_002_no_axis_no_end_and_no_speed_are_refused_by_name(void)
{
    mode.time_ms = 1U;
    expect(STATUS_UNKNOWN_COMMAND, 0U);
    mode.axes = ONE(robot.axis_count);
    expect(STATUS_UNKNOWN_COMMAND, 0U);
    mode.axes = 0U;
    ask(NEURO_AXIS_YAW, 100, 0);
    expect(STATUS_OUT_OF_RANGE, 0U);
    mode.time_ms = LIMIT_VELOCITY_TIME_MS + 1U;
    expect(STATUS_OUT_OF_RANGE, 0U);
    ask(NEURO_AXIS_PITCH, 100, -10);
    expect(STATUS_OUT_OF_RANGE, 0U);
    ask(NEURO_AXIS_PITCH, 0, 10);
    expect(STATUS_OUT_OF_RANGE, NEURO_AXIS_PITCH);
    ask(NEURO_AXIS_PITCH, 834, 10);
    expect(STATUS_TOO_FAST, NEURO_AXIS_PITCH);
    ask(NEURO_AXIS_PITCH, INT32_MIN, 10);
    expect(STATUS_TOO_FAST, NEURO_AXIS_PITCH);
}

void test_SWR_VEL_005_six_hundred_ticks_at_the_speed_of_the_thesis(void)
{
    int32_t fastest_q8 = 0;
    ask(NEURO_AXIS_YAW, -833, -600);
    while (is_ramping()) {
        step();
        fastest_q8 =
            (before_q8[NEURO_AXIS_YAW] < fastest_q8) ? before_q8[NEURO_AXIS_YAW] : fastest_q8;
    }
    TEST_ASSERT_EQUAL_INT32(-833 * 256, fastest_q8);
    TEST_ASSERT_EQUAL_INT32(VELOCITY_END_WAY, result.notes[0].value);
    TEST_ASSERT_EQUAL_INT32(-600, axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks);
    /* 600 / 833 + 833 / 1929 s, and the last hundredths of a tick. */
    TEST_ASSERT_UINT32_WITHIN(20U, 1160U, cycles);
    finish(STATUS_OK, 0U);
    TEST_ASSERT_EQUAL_INT32(-600, axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks);
}

void test_SWR_VEL_005_each_way_is_met_to_the_tick(void)
{
    for (uint32_t i = 0U; i < 60U; i++) {
        setUp();
        random_state = i + 7U;
        const int32_t way = random_within(1, 700);
        const int32_t speed = random_within(20, 1285);
        const int32_t sign = ((i & 1U) != 0U) ? 1 : -1;
        ask(NEURO_AXIS_ROTATION, sign * speed, -way);
        TEST_ASSERT_EQUAL(VELOCITY_END_WAY, run_down(NEURO_AXIS_ROTATION));
        TEST_ASSERT_EQUAL_INT32(sign * way, axes[NEURO_AXIS_ROTATION].sealed.setpoint_ticks);
    }
}

void test_SWR_VEL_005_a_slow_way_ends_with_the_longest_time(void)
{
    ask(NEURO_AXIS_YAW, -1, -600);
    TEST_ASSERT_EQUAL(VELOCITY_END_TIME, run_down(NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_INT32(-60, axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks);
    finish(STATUS_OK, 0U);
}

void test_SWR_VEL_004_every_set_point_is_at_rest_when_the_time_is_over(void)
{
    static const int32_t times_ms[] = {1, 2, 50, 777, 2000};
    for (uint32_t i = 0U; i < (sizeof times_ms / sizeof times_ms[0]); i++) {
        setUp();
        ask(NEURO_AXIS_YAW, -300, times_ms[i]);
        ask(NEURO_AXIS_PITCH, -100, times_ms[i]);
        while ((int32_t)cycles < times_ms[i]) {
            step();
            TEST_ASSERT_TRUE(((int32_t)cycles == times_ms[i]) || is_ramping());
        }
        TEST_ASSERT_EQUAL_INT32(0, axes[NEURO_AXIS_YAW].sealed.setpoint_speed_ticks_per_s_q8);
        TEST_ASSERT_EQUAL_INT32(0, axes[NEURO_AXIS_PITCH].sealed.setpoint_speed_ticks_per_s_q8);
        TEST_ASSERT_EQUAL_UINT32(1U, leg.is_running);
        finish(STATUS_OK, 0U);
    }
}

void test_SWR_VEL_003_each_axis_has_its_own_ramp_and_its_own_speed(void)
{
    ask(NEURO_AXIS_ROTATION, 1285, 3000);
    ask(NEURO_AXIS_INSERTION, 16667, 3000);
    put(NEURO_AXIS_INSERTION, 5000);
    for (uint32_t i = 0U; i < 1500U; i++) {
        step();
    }
    TEST_ASSERT_EQUAL_INT32(1285 * 256, before_q8[NEURO_AXIS_ROTATION]);
    TEST_ASSERT_EQUAL_INT32(16667 * 256, before_q8[NEURO_AXIS_INSERTION]);
    TEST_ASSERT_EQUAL(VELOCITY_END_TIME, run_down(NEURO_AXIS_INSERTION));
    finish(STATUS_OK, 0U);
}

void test_SWR_VEL_003_it_keeps_to_the_cap_also_when_that_comes_later(void)
{
    ask(NEURO_AXIS_ROTATION, 1285, 4000);
    for (uint32_t i = 0U; i < 1000U; i++) {
        step();
    }
    frame.speed_cap_percent[NEURO_AXIS_ROTATION] = 25U;
    for (uint32_t i = 0U; i < 500U; i++) {
        step();
    }
    TEST_ASSERT_INT32_WITHIN(256, 321 * 256, before_q8[NEURO_AXIS_ROTATION]);
}

void test_SWR_VEL_003_an_axis_that_is_not_homed_keeps_to_its_home_speed(void)
{
    ask(NEURO_AXIS_ROTATION, 1285, 4000);
    world_lose(NEURO_AXIS_ROTATION);
    for (uint32_t i = 0U; i < 80U; i++) {
        step();
    }
    TEST_ASSERT_EQUAL_INT32(321 * 256, before_q8[NEURO_AXIS_ROTATION]);
}

void test_SWR_VEL_010_a_pause_leaves_what_is_left_of_the_way(void)
{
    ask(NEURO_AXIS_YAW, -833, -600);
    for (uint32_t i = 0U; i < 300U; i++) {
        step();
    }
    rest_one_cycle();
    world_put(NEURO_AXIS_YAW, axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks - 2);
    rest_one_cycle();
    TEST_ASSERT_EQUAL(VELOCITY_END_WAY, run_down(NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_INT32(-600, axes[NEURO_AXIS_YAW].sealed.setpoint_ticks);
}

void test_SWR_VEL_010_a_pause_leaves_what_is_left_of_the_time(void)
{
    ask(NEURO_AXIS_YAW, -100, 1000);
    for (uint32_t i = 0U; i < 400U; i++) {
        step();
    }
    for (uint32_t i = 0U; i < 5000U; i++) {
        rest_one_cycle();
    }
    const uint32_t paused = cycles;
    TEST_ASSERT_EQUAL(VELOCITY_END_TIME, run_down(NEURO_AXIS_YAW));
    TEST_ASSERT_UINT32_WITHIN(2U, 600U, cycles - paused);
}

void test_SWR_VEL_010_what_has_ended_does_not_start_again(void)
{
    put(NEURO_AXIS_HEAD, -20);
    put(NEURO_AXIS_FEET, -100);
    ask(NEURO_AXIS_FEET, -400, 3000);
    TEST_ASSERT_EQUAL(VELOCITY_END_COUPLED_LIMIT, run_down(NEURO_AXIS_FEET));
    rest_one_cycle();
    world_put(NEURO_AXIS_FEET, 0);
    rest_one_cycle();
    while (result.progress == MODE_RUNNING) {
        step();
        TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
        TEST_ASSERT_EQUAL_INT32(0, axes[NEURO_AXIS_FEET].sealed.encoder.position_ticks);
    }
    TEST_ASSERT_EQUAL(STATUS_SEPARATION_LIMIT, result.status);
}

void test_SWR_VEL_012_an_axis_that_the_robot_does_not_have_is_not_driven(void)
{
    mode.axes = ~(ONE(robot.axis_count) - 1U);
    mode.time_ms = 100U;
    for (uint32_t i = 0U; i < 120U; i++) {
        step();
        for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
            TEST_ASSERT_TRUE(world_rests(axis));
        }
    }
}

static velocity_mode_t of_way(uint32_t axis, int32_t ticks_per_s, int32_t ticks)
{
    velocity_mode_t asked = {.axes = LEG_AXIS(axis), .way_ticks = (uint32_t)ticks};
    asked.speeds_ticks_per_s[axis] = ticks_per_s;
    return asked;
}

void test_SWR_MODE_006_a_time_lasts_as_long_as_it_is(void)
{
    const velocity_mode_t asked = {.axes = 3U, .time_ms = 1500U};
    TEST_ASSERT_EQUAL_UINT32(1500U, velocity_share_span_ms(&asked));
}

void test_SWR_MODE_006_a_way_lasts_as_its_speed_says_on_any_axis(void)
{
    for (uint32_t axis = 0U; axis < ROBOT_AXIS_MAX; axis++) {
        velocity_mode_t asked = of_way(axis, -500, 250);
        TEST_ASSERT_EQUAL_UINT32(500U, velocity_share_span_ms(&asked));
        asked = of_way(axis, 500, 100);
        TEST_ASSERT_EQUAL_UINT32(200U, velocity_share_span_ms(&asked));
    }
}

void test_SWR_MODE_006_no_way_lasts_beyond_the_longest_time(void)
{
    const velocity_mode_t asked = of_way(ROBOT_AXIS_MAX - 1U, 1, INT32_MAX);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_VELOCITY_TIME_MS, velocity_share_span_ms(&asked));
}

void test_SWR_MODE_006_nothing_is_left_of_what_has_not_begun(void)
{
    const velocity_mode_t asked = of_way(ROBOT_AXIS_MAX - 1U, 500, 250);
    TEST_ASSERT_EQUAL_UINT32(0U, velocity_share_left_ms(&asked, axes));
}

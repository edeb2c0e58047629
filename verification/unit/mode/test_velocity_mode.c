/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: axes run at the speeds that they were commanded, with ramps, for a time or a way
 * and no longer, and come to rest before their limits.
 */
#include "unity.h"

#include "axis/axis.h"
#include "limits/requirement_limits.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/velocity/velocity_bound.h"
#include "mode/velocity/velocity_mode.h"
#include "mode/velocity/velocity_share.h"
#include "motion/ramp.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "robot/margin.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"
#include "unit/support/scenes.h"

#define LONG_CYCLES 200000U
#define ONE(axis) LEG_AXIS(axis)

static leg_t leg;
static velocity_mode_t mode;
static uint32_t cycles;
static int32_t before_q8[ROBOT_AXIS_MAX];
static uint32_t random_state;

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
    mode = (velocity_mode_t){.axes = 0U};
    cycles = 0U;
    random_state = 1U;
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        before_q8[i] = 0;
    }
}

void tearDown(void)
{
}

static int32_t random_within(int32_t least, int32_t most)
{
    random_state = (random_state * 1664525U) + 1013904223U;
    return least + (int32_t)((random_state >> 8U) % (uint32_t)(most - least + 1));
}

static void ask(uint32_t axis, int32_t speed_ticks_per_s, int32_t bound)
{
    mode.axes |= ONE(axis);
    mode.speeds_ticks_per_s[axis] = speed_ticks_per_s;
    mode.time_ms = (bound > 0) ? (uint32_t)bound : 0U;
    mode.way_ticks = (bound < 0) ? (uint32_t)-bound : 0U;
}

static void put(uint32_t axis, int32_t ticks)
{
    world_put(axis, ticks);
    axes[axis].sealed.setpoint_ticks = ticks;
}

static void expect(status_t status, uint32_t axis)
{
    const solution_t judged = velocity_mode_judge(&mode, &robot, axes);
    TEST_ASSERT_EQUAL(status, judged.status);
    TEST_ASSERT_EQUAL_UINT32(axis, judged.axis);
}

static int32_t magnitude(int32_t value)
{
    return (value < 0) ? -value : value;
}

/* Checks that must hold for every set-point in every cycle in which it ramps. */
static void expect_ramps(void)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        const axis_config_t *const config = &robot.axes[i];
        const int32_t now_q8 = axes[i].sealed.setpoint_speed_ticks_per_s_q8;
        const int32_t step_q8 = (config->acceleration_ticks_per_s2 * 256) / 1000;
        const int32_t most_q8 =
            (config->speed_ticks_per_s * 256 / 100) * (int32_t)frame.speed_cap_percent[i];
        TEST_ASSERT_INT32_WITHIN(magnitude(mode.speeds_ticks_per_s[i]) * 256, 0, now_q8);
        TEST_ASSERT_TRUE((magnitude(now_q8) <= (most_q8 + 256)) ||
                         (magnitude(now_q8) < magnitude(before_q8[i])));
        TEST_ASSERT_INT32_WITHIN(step_q8, before_q8[i], now_q8);
        before_q8[i] = now_q8;
    }
}

static void step(void)
{
    mode_clear(&result);
    velocity_mode_step(&mode, &leg, &frame, &result);
    cycles++;
    TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
    if (leg.is_running == 0U) {
        expect_ramps();
    }
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_TRUE(((mode.axes & ONE(i)) != 0U) || world_rests(i));
    }
    world_follow();
}

static void rest_one_cycle(void)
{
    leg_stop(&leg);
    mode_rest(&frame, &result);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        before_q8[i] = 0;
    }
}

static bool is_ramping(void)
{
    return (result.progress == MODE_RUNNING) && (leg.is_running == 0U);
}

/* Until the set-points are at rest. @return the note of `axis` */
static velocity_end_t run_down(uint32_t axis)
{
    do {
        step();
    } while (is_ramping());
    for (uint32_t i = 0U; i < result.note_count; i++) {
        if (result.notes[i].axis == axis) {
            TEST_ASSERT_EQUAL(EVENT_VELOCITY_ENDED, result.notes[i].id);
            return (velocity_end_t)result.notes[i].value;
        }
    }
    TEST_FAIL_MESSAGE("nothing was reported of the axis");
    return VELOCITY_END_TIME;
}

static void finish(status_t status, uint32_t axis)
{
    while (result.progress == MODE_RUNNING) {
        step();
        TEST_ASSERT_TRUE((result.progress != MODE_RUNNING) || (result.note_count == 0U));
    }
    TEST_ASSERT_EQUAL((status == STATUS_OK) ? MODE_DONE : MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(status, result.status);
    if (status != STATUS_OK) {
        TEST_ASSERT_EQUAL_UINT32(axis, result.axis);
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

void test_SWR_VEL_009_no_speed_across_a_needle_that_is_in(void)
{
    put(NEURO_AXIS_INSERTION, 20000);
    ask(NEURO_AXIS_ROTATION, 100, 1000);
    expect(STATUS_OK, 0U);
    ask(NEURO_AXIS_LATERAL, -100, 1000);
    expect(STATUS_NEEDLE_IN, NEURO_AXIS_LATERAL);
}

void test_SWR_VEL_009_nor_together_with_one_that_takes_it_in(void)
{
    put(NEURO_AXIS_INSERTION, 400);
    ask(NEURO_AXIS_LATERAL, -100, 1000);
    ask(NEURO_AXIS_INSERTION, 100, 1000);
    expect(STATUS_NEEDLE_IN, NEURO_AXIS_LATERAL);
    ask(NEURO_AXIS_INSERTION, -100, 1000);
    expect(STATUS_OK, 0U);
    ask(NEURO_AXIS_INSERTION, 100, 1000);
    mode.axes = ONE(NEURO_AXIS_INSERTION) | ONE(NEURO_AXIS_ROTATION);
    mode.speeds_ticks_per_s[NEURO_AXIS_ROTATION] = 100;
    expect(STATUS_OK, 0U);
    world_lose(NEURO_AXIS_INSERTION);
    expect(STATUS_NEEDLE_IN, NEURO_AXIS_INSERTION);
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

static velocity_end_t end_at(uint32_t axis, int32_t soft_ticks, int32_t zone_ticks)
{
    return (axes[axis].sealed.setpoint_ticks == soft_ticks) && (soft_ticks == zone_ticks)
               ? VELOCITY_END_SOFT_LIMIT
               : VELOCITY_END_SWITCH_ZONE;
}

static bool shares_limit(uint32_t axis)
{
    return coupled_limit_has(&robot.coupled_limits[0], axis);
}

/* From anywhere, at any speed. */
static void run_to_limit(uint32_t axis, bool is_up)
{
    const axis_config_t *const config = &robot.axes[axis];
    const int32_t target = is_up ? config->target_maximum_ticks : config->target_minimum_ticks;
    const int32_t soft = is_up ? config->maximum_ticks : config->minimum_ticks;
    const int32_t start = random_within(config->target_minimum_ticks, config->target_maximum_ticks);
    const int32_t least = 1 + (magnitude(target - start) / 50);
    const int32_t speed = (least < config->speed_ticks_per_s)
                              ? random_within(least, config->speed_ticks_per_s)
                              : config->speed_ticks_per_s;
    put(axis, start);
    ask(axis, is_up ? speed : -speed, (int32_t)LIMIT_VELOCITY_TIME_MS);
    const velocity_end_t end = run_down(axis);
    TEST_ASSERT_EQUAL_INT32(target, axes[axis].sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL(end_at(axis, soft, target), end);
    finish((end == VELOCITY_END_SOFT_LIMIT) ? STATUS_AXIS_LIMIT : STATUS_SWITCH_ZONE, axis);
}

void test_SWR_VEL_006_each_axis_comes_to_rest_at_its_limits(void)
{
    for (uint32_t i = 0U; i < SCENES(40U); i++) {
        for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
            if (!shares_limit(axis)) {
                const uint32_t seed = (i * 8U) + axis + 1U;
                setUp();
                random_state = seed;
                run_to_limit(axis, (i & 1U) != 0U);
            }
        }
    }
}

void test_SWR_VEL_006_what_stands_in_the_zone_of_its_switch_does_not_go_on(void)
{
    put(NEURO_AXIS_YAW, 8);
    ask(NEURO_AXIS_YAW, 100, 1000);
    TEST_ASSERT_EQUAL(VELOCITY_END_SWITCH_ZONE, run_down(NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_INT32(8, axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks);
    finish(STATUS_SWITCH_ZONE, NEURO_AXIS_YAW);
}

static int64_t separation_nm(void)
{
    joints_t joints = {.value = {0}};
    joints.value[NEURO_AXIS_HEAD] =
        joints_of(&robot.axes[NEURO_AXIS_HEAD], axes[NEURO_AXIS_HEAD].sealed.setpoint_ticks);
    joints.value[NEURO_AXIS_FEET] =
        joints_of(&robot.axes[NEURO_AXIS_FEET], axes[NEURO_AXIS_FEET].sealed.setpoint_ticks);
    return kinematics_coupled(&robot, 0U, &joints);
}

static void expect_apart(void)
{
    const int64_t value = separation_nm();
    /* A tick of each. */
    const int64_t tolerance = 2 * 12700;
    TEST_ASSERT_TRUE(value >= (int64_t)robot.coupled_limits[0].minimum +
                                  (int64_t)LIMIT_COUPLED_MARGIN_NM - tolerance);
    TEST_ASSERT_TRUE(value <= (int64_t)robot.coupled_limits[0].maximum -
                                  (int64_t)LIMIT_COUPLED_MARGIN_NM + tolerance);
}

static int32_t any_speed(uint32_t axis)
{
    const int32_t most = robot.axes[axis].speed_ticks_per_s;
    const int32_t speed = random_within(-most, most);
    return (speed == 0) ? 1 : speed;
}

void test_SWR_VEL_007_two_axes_at_any_speeds_come_to_rest_before_the_limit_they_share(void)
{
    uint32_t ended = 0U;
    for (uint32_t i = 0U; i < SCENES(100U); i++) {
        setUp();
        random_state = i + 1U;
        put(NEURO_AXIS_HEAD, random_within(-5000, -300));
        put(NEURO_AXIS_FEET, random_within(-100, 200));
        ask(NEURO_AXIS_HEAD, any_speed(NEURO_AXIS_HEAD), 12000);
        ask(NEURO_AXIS_FEET, any_speed(NEURO_AXIS_FEET), 12000);
        robot.axes[NEURO_AXIS_HEAD].acceleration_ticks_per_s2 = random_within(500, 6000);
        while (is_ramping()) {
            step();
            expect_apart();
        }
        if (mode.barred != 0U) {
            TEST_ASSERT_EQUAL_INT32(VELOCITY_END_COUPLED_LIMIT, result.notes[0].value);
            finish(STATUS_SEPARATION_LIMIT, NEURO_AXIS_HEAD);
            ended++;
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(20U), ended);
}

void test_SWR_VEL_007_what_is_outside_may_come_back_but_go_no_farther_out(void)
{
    put(NEURO_AXIS_HEAD, -20);
    put(NEURO_AXIS_FEET, -350);
    ask(NEURO_AXIS_FEET, -100, 500);
    TEST_ASSERT_EQUAL(VELOCITY_END_COUPLED_LIMIT, run_down(NEURO_AXIS_FEET));
    finish(STATUS_SEPARATION_LIMIT, NEURO_AXIS_FEET);
    setUp();
    put(NEURO_AXIS_HEAD, -20);
    put(NEURO_AXIS_FEET, -350);
    ask(NEURO_AXIS_FEET, 100, 500);
    TEST_ASSERT_EQUAL(VELOCITY_END_TIME, run_down(NEURO_AXIS_FEET));
    setUp();
    put(NEURO_AXIS_HEAD, -5400);
    ask(NEURO_AXIS_HEAD, -100, 500);
    TEST_ASSERT_EQUAL(VELOCITY_END_COUPLED_LIMIT, run_down(NEURO_AXIS_HEAD));
    setUp();
    put(NEURO_AXIS_HEAD, -5400);
    ask(NEURO_AXIS_HEAD, 100, 500);
    TEST_ASSERT_EQUAL(VELOCITY_END_TIME, run_down(NEURO_AXIS_HEAD));
}

void test_SWR_VEL_008_before_homing_a_short_way_at_home_speed(void)
{
    const int32_t way = (int32_t)((int64_t)LIMIT_UNHOMED_JOG_BAM * 65536 /
                                  robot.axes[NEURO_AXIS_YAW].unit_per_tick_q16);
    world_lose(NEURO_AXIS_YAW);
    put(NEURO_AXIS_YAW, 5);
    ask(NEURO_AXIS_YAW, 833, 5000);
    TEST_ASSERT_EQUAL(VELOCITY_END_SHORT_WAY, run_down(NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_INT32(5 + way, axes[NEURO_AXIS_YAW].sealed.setpoint_ticks);
    finish(STATUS_JOG_TOO_FAR, NEURO_AXIS_YAW);
}

void test_SWR_VEL_008_what_shares_a_limit_with_one_that_is_not_homed_as_well(void)
{
    const int32_t way = (int32_t)((int64_t)LIMIT_UNHOMED_JOG_NM * 65536 /
                                  robot.axes[NEURO_AXIS_FEET].unit_per_tick_q16);
    world_lose(NEURO_AXIS_HEAD);
    put(NEURO_AXIS_FEET, 100);
    ask(NEURO_AXIS_FEET, -196, 5000);
    TEST_ASSERT_EQUAL(VELOCITY_END_SHORT_WAY, run_down(NEURO_AXIS_FEET));
    TEST_ASSERT_EQUAL_INT32(100 - way, axes[NEURO_AXIS_FEET].sealed.setpoint_ticks);
}

void test_SWR_VEL_008_its_switch_ends_it_where_it_stands(void)
{
    world_lose(NEURO_AXIS_YAW);
    ask(NEURO_AXIS_YAW, 200, 2000);
    for (uint32_t i = 0U; i < 60U; i++) {
        step();
    }
    const int32_t met = axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks;
    axes[NEURO_AXIS_YAW].sealed.limit_switches = CARD_LIMIT_UPPER;
    do {
        step();
        put(NEURO_AXIS_YAW, axes[NEURO_AXIS_YAW].sealed.setpoint_ticks);
        world_put(NEURO_AXIS_YAW, met);
    } while (is_ramping());
    TEST_ASSERT_EQUAL_INT32(VELOCITY_END_SWITCH_ZONE, result.notes[0].value);
    TEST_ASSERT_EQUAL_INT32(met, leg.profile.end_ticks[NEURO_AXIS_YAW]);
    finish(STATUS_SWITCH_ZONE, NEURO_AXIS_YAW);
    /* Away from it. */
    setUp();
    world_lose(NEURO_AXIS_YAW);
    axes[NEURO_AXIS_YAW].sealed.limit_switches = CARD_LIMIT_UPPER;
    ask(NEURO_AXIS_YAW, -200, 100);
    TEST_ASSERT_EQUAL(VELOCITY_END_TIME, run_down(NEURO_AXIS_YAW));
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

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: axes that run at commanded speeds come to rest before their limits, those that
 * they share and the needle.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "unit/support/mode_world.h"
#include "unit/support/scenes.h"

#include "unit/mode/velocity_world.inc"

void setUp(void)
{
    begin_velocity();
}

void tearDown(void)
{
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

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a jog is refused where it must not go; it drives its axis there and no other.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "mode/jog/jog_mode.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "robot/joints.h"
#include "unit/support/mode_world.h"

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

static void expect(uint32_t axis, int32_t ticks, status_t status, bool is_maximum)
{
    const mode_way_t asked = {.axis = axis, .end_ticks = ticks};
    const solution_t judged = jog_mode_judge(&asked, &robot, axes);
    const bool has_limit = (status == STATUS_AXIS_LIMIT) || (status == STATUS_SWITCH_ZONE) ||
                           (status == STATUS_SEPARATION_LIMIT);
    TEST_ASSERT_EQUAL(status, judged.status);
    TEST_ASSERT_EQUAL_UINT32(has_limit ? axis : 0U, judged.axis);
    TEST_ASSERT_EQUAL_UINT32(is_maximum ? 1U : 0U, judged.is_maximum);
}

void test_SWR_AXIS_004_a_homed_axis_is_not_jogged_beyond_its_limits(void)
{
    const axis_config_t *const head = &robot.axes[NEURO_AXIS_HEAD];
    const axis_config_t *const feet = &robot.axes[NEURO_AXIS_FEET];
    expect(NEURO_AXIS_HEAD, -100, STATUS_OK, false);
    expect(NEURO_AXIS_HEAD, head->minimum_ticks - 1, STATUS_AXIS_LIMIT, false);
    expect(NEURO_AXIS_HEAD, head->maximum_ticks + 1, STATUS_AXIS_LIMIT, true);
    expect(NEURO_AXIS_HEAD, head->target_maximum_ticks + 1, STATUS_SWITCH_ZONE, false);
    expect(NEURO_AXIS_INSERTION, robot.axes[NEURO_AXIS_INSERTION].target_minimum_ticks - 1,
           STATUS_SWITCH_ZONE, false);
    expect(NEURO_AXIS_FEET, feet->minimum_ticks, STATUS_SEPARATION_LIMIT, true);
    expect(NEURO_AXIS_FEET, feet->maximum_ticks, STATUS_SEPARATION_LIMIT, false);
}

void test_SWR_AXIS_004_there_is_no_jog_of_an_axis_that_the_robot_does_not_have(void)
{
    expect(robot.axis_count, 0, STATUS_UNKNOWN_COMMAND, false);
    expect(UINT32_MAX, 0, STATUS_UNKNOWN_COMMAND, false);
}

void test_SWR_JOG_001_no_jog_across_a_needle_that_is_in(void)
{
    world_put(NEURO_AXIS_INSERTION, 20000);
    expect(NEURO_AXIS_LATERAL, -100, STATUS_NEEDLE_IN, false);
    expect(NEURO_AXIS_ROTATION, 100, STATUS_OK, false);
}

void test_SWR_JOG_003_a_needle_that_is_not_homed_is_jogged_outwards_only(void)
{
    world_lose(NEURO_AXIS_INSERTION);
    expect(NEURO_AXIS_INSERTION, 1, STATUS_NEEDLE_IN, false);
    expect(NEURO_AXIS_INSERTION, -1, STATUS_OK, false);
}

void test_SWR_JOG_002_before_homing_a_short_way_only(void)
{
    const int32_t head_ticks = (int32_t)((int64_t)LIMIT_UNHOMED_JOG_NM * 65536 /
                                         robot.axes[NEURO_AXIS_HEAD].unit_per_tick_q16);
    const int32_t yaw_ticks = (int32_t)((int64_t)LIMIT_UNHOMED_JOG_BAM * 65536 /
                                        robot.axes[NEURO_AXIS_YAW].unit_per_tick_q16);
    world_lose(NEURO_AXIS_HEAD);
    world_lose(NEURO_AXIS_YAW);
    expect(NEURO_AXIS_HEAD, head_ticks, STATUS_OK, false);
    expect(NEURO_AXIS_HEAD, -head_ticks, STATUS_OK, false);
    expect(NEURO_AXIS_HEAD, head_ticks + 1, STATUS_JOG_TOO_FAR, false);
    expect(NEURO_AXIS_HEAD, -head_ticks - 1, STATUS_JOG_TOO_FAR, false);
    expect(NEURO_AXIS_YAW, yaw_ticks + 1, STATUS_JOG_TOO_FAR, false);
    /* Homed itself, but not what it shares a limit with. */
    expect(NEURO_AXIS_FEET, 1000, STATUS_JOG_TOO_FAR, false);
}

void test_SWR_JOG_004_a_jog_drives_its_axis_alone_and_is_done_there(void)
{
    const mode_way_t jog = {.axis = NEURO_AXIS_PITCH, .end_ticks = 45};
    uint32_t cycles = 0U;
    while (result.progress == MODE_RUNNING) {
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
        world_put(NEURO_AXIS_FEET, (cycles > 10U) ? 5 : 0);
        cycles++;
        jog_mode_step(&jog, &leg, &frame, &result);
        for (uint32_t i = 0U; i < robot.axis_count; i++) {
            TEST_ASSERT_TRUE((i == (uint32_t)NEURO_AXIS_PITCH) || world_rests(i));
        }
        world_follow();
    }
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(45, axes[NEURO_AXIS_PITCH].sealed.encoder.position_ticks);
}

void test_SWR_AXIS_006_a_jog_keeps_to_the_cap_of_its_axis(void)
{
    const mode_way_t jog = {.axis = NEURO_AXIS_HEAD, .end_ticks = -1000};
    const int32_t most_q8 = robot.axes[NEURO_AXIS_HEAD].speed_ticks_per_s * 256 / 4;
    frame.speed_cap_percent[NEURO_AXIS_HEAD] = 25U;
    while (result.progress == MODE_RUNNING) {
        jog_mode_step(&jog, &leg, &frame, &result);
        TEST_ASSERT_INT32_WITHIN(most_q8, 0,
                                 axes[NEURO_AXIS_HEAD].sealed.setpoint_speed_ticks_per_s_q8);
        world_follow();
    }
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
}

void test_SWR_MEMORY_006_an_axis_that_the_robot_does_not_have_is_not_driven(void)
{
    const mode_way_t jog = {.axis = UINT32_MAX, .end_ticks = 1000};
    for (uint32_t i = 0U; i < 20U; i++) {
        jog_mode_step(&jog, &leg, &frame, &result);
        for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
            TEST_ASSERT_TRUE(world_rests(axis));
        }
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a leg takes its axes from where they stand to where they shall stand, within the
 * cap of each, leaves the others alone, and either arrives or is given up.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "unit/support/mode_world.h"

#define LONG_CYCLES 100000U
#define OVERTIME_CYCLES (LIMIT_OVERTIME_US / LIMIT_CYCLE_US)

static leg_t leg;
static int32_t ends[ROBOT_AXIS_MAX];

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        ends[i] = 300 + (int32_t)i;
    }
}

void tearDown(void)
{
}

/* Runs the leg until it has arrived. @return in how many cycles */
static uint32_t run(uint32_t of_axes)
{
    uint32_t cycles = 1U;
    leg_begin(&leg, &frame, of_axes, ends);
    while (!leg_step(&leg, &frame, &result)) {
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
        world_follow();
        cycles++;
    }
    return cycles;
}

void test_SWR_DEMO_001_every_axis_arrives_and_then_rests(void)
{
    (void)run(LEG_EVERY_AXIS);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(ends[i], axes[i].sealed.encoder.position_ticks);
        TEST_ASSERT_TRUE(world_rests(i));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, leg.is_running);
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
}

/* Also where it is pushed: it is not brought back. */
void test_SWR_JOG_004_an_axis_that_is_not_of_the_leg_is_left_alone(void)
{
    leg_begin(&leg, &frame, LEG_AXIS(NEURO_AXIS_HEAD) | LEG_AXIS(NEURO_AXIS_YAW), ends);
    world_put(NEURO_AXIS_FEET, -77);
    while (!leg_step(&leg, &frame, &result)) {
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_FEET));
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_LATERAL));
        world_follow();
    }
    TEST_ASSERT_EQUAL_INT32(ends[NEURO_AXIS_HEAD],
                            axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(ends[NEURO_AXIS_YAW],
                            axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(-77, axes[NEURO_AXIS_FEET].sealed.encoder.position_ticks);
}

void test_SWR_MOTION_006_it_has_arrived_after_fifty_cycles_at_its_end(void)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        ends[i] = 0;
    }
    TEST_ASSERT_EQUAL_UINT32(50U, run(LEG_EVERY_AXIS));
}

void test_SWR_MOTION_006_cycles_at_the_end_count_only_in_a_row(void)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        ends[i] = 0;
    }
    leg_begin(&leg, &frame, LEG_EVERY_AXIS, ends);
    for (uint32_t i = 0U; i < 49U; i++) {
        TEST_ASSERT_FALSE(leg_step(&leg, &frame, &result));
    }
    world_put(NEURO_AXIS_PITCH, robot.axes[NEURO_AXIS_PITCH].deadband_ticks + 1);
    TEST_ASSERT_FALSE(leg_step(&leg, &frame, &result));
    TEST_ASSERT_EQUAL_UINT32(0U, leg.settled_cycles);
}

void test_SWR_PERMIT_005_the_slowest_cap_of_its_axes_is_not_exceeded(void)
{
    frame.speed_cap_percent[NEURO_AXIS_LATERAL] = LIMIT_UNHOMED_SPEED_PERCENT;
    leg_begin(&leg, &frame, LEG_EVERY_AXIS, ends);
    while (!leg_step(&leg, &frame, &result)) {
        for (uint32_t i = 0U; i < robot.axis_count; i++) {
            const int64_t most_q8 =
                (int64_t)robot.axes[i].speed_ticks_per_s * 256 * LIMIT_UNHOMED_SPEED_PERCENT / 100;
            TEST_ASSERT_TRUE(axes[i].sealed.setpoint_speed_ticks_per_s_q8 <= most_q8);
        }
        world_follow();
    }
}

void test_SWR_AXIS_006_the_cap_of_an_axis_that_it_does_not_drive_does_not_count(void)
{
    ends[NEURO_AXIS_HEAD] = 3000;
    const uint32_t fast = run(LEG_AXIS(NEURO_AXIS_HEAD));
    world_put(NEURO_AXIS_HEAD, 0);
    frame.speed_cap_percent[NEURO_AXIS_FEET] = LIMIT_UNHOMED_SPEED_PERCENT;
    TEST_ASSERT_EQUAL_UINT32(fast, run(LEG_AXIS(NEURO_AXIS_HEAD)));
    world_put(NEURO_AXIS_HEAD, 0);
    frame.speed_cap_percent[NEURO_AXIS_HEAD] = LIMIT_UNHOMED_SPEED_PERCENT;
    TEST_ASSERT_GREATER_THAN_UINT32(3U * fast, run(LEG_AXIS(NEURO_AXIS_HEAD)));
}

void test_SWR_MOTION_005_a_leg_that_does_not_end_fails_for_the_axis_that_is_astray(void)
{
    uint32_t over = 0U;
    ends[NEURO_AXIS_PITCH] = 40;
    leg_begin(&leg, &frame, LEG_EVERY_AXIS, ends);
    while (result.progress == MODE_RUNNING) {
        TEST_ASSERT_FALSE(leg_step(&leg, &frame, &result));
        over += profile_is_finished(&leg.profile) ? 1U : 0U;
        world_follow_but(NEURO_AXIS_PITCH);
    }
    TEST_ASSERT_EQUAL_UINT32(OVERTIME_CYCLES, over);
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_FAULT_PRESENT, result.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_PITCH, result.axis);
    TEST_ASSERT_EQUAL_UINT32(1U, result.note_count);
    TEST_ASSERT_EQUAL(EVENT_ORDER_OVERDUE, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_PITCH, result.notes[0].axis);
    TEST_ASSERT_EQUAL_INT32(40, result.notes[0].value);
}

void test_SWR_PEDAL_005_a_leg_that_was_stopped_begins_anew_from_where_the_axes_are(void)
{
    leg_begin(&leg, &frame, LEG_EVERY_AXIS, ends);
    for (uint32_t i = 0U; i < 200U; i++) {
        (void)leg_step(&leg, &frame, &result);
        world_follow();
    }
    leg_stop(&leg);
    TEST_ASSERT_EQUAL_UINT32(0U, leg.is_running);
    leg_begin(&leg, &frame, LEG_EVERY_AXIS, ends);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(axes[i].sealed.encoder.position_ticks, leg.profile.start_ticks[i]);
    }
    (void)leg_step(&leg, &frame, &result);
    TEST_ASSERT_INT32_WITHIN(robot.axes[NEURO_AXIS_HEAD].acceleration_ticks_per_s2 * 256 / 1000, 0,
                             axes[NEURO_AXIS_HEAD].sealed.setpoint_speed_ticks_per_s_q8);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a trajectory is driven from where the axes stand, each point in its time; the
 * pedal stops its time, and what is late or damaged ends it.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/lists/trajectory_list.h"
#include "mode/lists/trajectory_row.h"
#include "mode/trajectory/trajectory_mode.h"
#include "robot/joints.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

#include <string.h>

#define LONG_CYCLES 20000U
#define PEAK 300
#define LATERAL (-2000)

static trajectory_list_t list;
static trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];
static const trajectory_t trajectory = {.list = &list, .rows = rows};
static trajectory_mode_t mode;
static leg_t leg;

static void add(uint32_t time_ms, int32_t yaw_ticks, int32_t yaw_speed)
{
    trajectory_row_t row = {.time_ms = time_ms};
    row.ticks[NEURO_AXIS_INSERTION] = robot.axes[NEURO_AXIS_INSERTION].target_minimum_ticks;
    row.ticks[NEURO_AXIS_LATERAL] = LATERAL;
    row.ticks[NEURO_AXIS_YAW] = yaw_ticks;
    row.speeds_ticks_per_s[NEURO_AXIS_YAW] = yaw_speed;
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_add(&list, rows, &robot, list.count, &row).status);
}

/* Three rows of one axis: a second to -300, on through with speed, a second to rest. */
void setUp(void)
{
    world_start();
    world_put(NEURO_AXIS_INSERTION, robot.axes[NEURO_AXIS_INSERTION].target_minimum_ticks);
    world_put(NEURO_AXIS_LATERAL, LATERAL);
    leg = (leg_t){.axes = 0U};
    memset(rows, 0, sizeof rows);
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_begin(&list, 3U));
    add(500U, 0, 0);
    add(1500U, -PEAK, -400);
    add(2500U, -2 * PEAK, 0);
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_end(&list, list.crc));
    trajectory_mode_begin(&mode, rows[0].time_ms);
}

void tearDown(void)
{
}

static void step(void)
{
    mode_clear(&result);
    frame.rows = rows;
    trajectory_mode_step(&mode, &list, &leg, &frame, &result);
    world_follow();
}

static void step_until_on_way(void)
{
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (mode.is_on_way == 0U); i++) {
        step();
    }
    TEST_ASSERT_EQUAL_UINT32(1U, mode.is_on_way);
}

static void steps(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        step();
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    }
}

static int32_t yaw(void)
{
    return axes[NEURO_AXIS_YAW].sealed.setpoint_ticks;
}

static void expect_judged(status_t status, uint32_t axis)
{
    const solution_t judged = trajectory_mode_judge(&trajectory, list.crc, &robot, axes);
    TEST_ASSERT_EQUAL(status, judged.status);
    if (status != STATUS_OK) {
        TEST_ASSERT_EQUAL_UINT8(axis, judged.axis);
    }
}

void test_SWR_TRAJ_006_only_the_list_that_is_meant_is_run(void)
{
    expect_judged(STATUS_OK, 0U);
    TEST_ASSERT_EQUAL(STATUS_TRAJECTORY_SUM,
                      trajectory_mode_judge(&trajectory, list.crc + 1U, &robot, axes).status);
    list.is_whole = 0U;
    expect_judged(STATUS_TRAJECTORY_EMPTY, 0U);
}

void test_SWR_TRAJ_007_an_axis_that_is_not_homed_is_not_driven(void)
{
    world_lose(NEURO_AXIS_PITCH);
    expect_judged(STATUS_NOT_HOMED, NEURO_AXIS_PITCH);
}

void test_SWR_TRAJ_007_the_way_to_the_first_row_is_short(void)
{
    const int64_t unit = robot.axes[NEURO_AXIS_LATERAL].unit_per_tick_q16;
    const int32_t most = (int32_t)(((int64_t)LIMIT_TRAJECTORY_LEAD_NM * 65536) / unit);
    world_put(NEURO_AXIS_LATERAL, LATERAL + most);
    expect_judged(STATUS_OK, 0U);
    world_put(NEURO_AXIS_LATERAL, LATERAL + most + 1);
    expect_judged(STATUS_TRAJECTORY_FAR, NEURO_AXIS_LATERAL);
    world_put(NEURO_AXIS_LATERAL, LATERAL - most - 1);
    expect_judged(STATUS_TRAJECTORY_FAR, NEURO_AXIS_LATERAL);
}

void test_SWR_TRAJ_007_the_way_to_the_first_row_cuts_nothing(void)
{
    world_put(NEURO_AXIS_INSERTION, needle_out_ticks(&robot) + 1);
    expect_judged(STATUS_OK, 0U);
    world_put(NEURO_AXIS_LATERAL, LATERAL + robot.axes[NEURO_AXIS_LATERAL].deadband_ticks + 1);
    expect_judged(STATUS_NEEDLE_IN, NEURO_AXIS_LATERAL);
    world_put(NEURO_AXIS_INSERTION, needle_out_ticks(&robot));
    expect_judged(STATUS_OK, 0U);
    rows[0].ticks[NEURO_AXIS_INSERTION] = needle_out_ticks(&robot) + 1;
    rows[0].crc = trajectory_row_crc(&rows[0]);
    expect_judged(STATUS_NEEDLE_IN, NEURO_AXIS_LATERAL);
}

void test_SWR_TRAJ_007_no_axis_is_taken_to_where_its_switch_may_be_active(void)
{
    const int32_t zone = robot.axes[NEURO_AXIS_INSERTION].target_minimum_ticks - 1;
    rows[0].ticks[NEURO_AXIS_INSERTION] = zone;
    rows[0].crc = trajectory_row_crc(&rows[0]);
    world_put(NEURO_AXIS_INSERTION, zone);
    expect_judged(STATUS_OK, 0U);
    world_put(NEURO_AXIS_INSERTION, zone + 2 + robot.axes[NEURO_AXIS_INSERTION].deadband_ticks);
    expect_judged(STATUS_SWITCH_ZONE, NEURO_AXIS_INSERTION);
}

void test_SWR_TRAJ_008_it_begins_with_a_way_from_where_the_axes_stand(void)
{
    world_put(NEURO_AXIS_YAW, 200);
    world_put(NEURO_AXIS_ROTATION, -100);
    step();
    TEST_ASSERT_INT32_WITHIN(1, 200, yaw());
    step_until_on_way();
    TEST_ASSERT_EQUAL_INT32(0, yaw());
    TEST_ASSERT_EQUAL_INT32(0, axes[NEURO_AXIS_ROTATION].sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_UINT32(500000U, mode.time_us);
}

void test_SWR_TRAJ_009_each_row_is_met_in_its_cycle(void)
{
    step_until_on_way();
    steps(1000U);
    TEST_ASSERT_EQUAL_INT32(-PEAK, yaw());
    TEST_ASSERT_INT32_WITHIN(1, -400 * 256,
                             axes[NEURO_AXIS_YAW].sealed.setpoint_speed_ticks_per_s_q8);
    TEST_ASSERT_EQUAL_UINT32(1U, mode.row);
    steps(999U);
    TEST_ASSERT_INT32_WITHIN(1, -2 * PEAK, yaw());
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (result.progress == MODE_RUNNING); i++) {
        step();
    }
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(-2 * PEAK, yaw());
    TEST_ASSERT_EQUAL_UINT32(1U, list.is_whole); /* It may be run again. */
}

void test_SWR_TRAJ_009_a_single_row_is_a_way_there(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_begin(&list, 1U));
    add(0U, -50, 0);
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_end(&list, list.crc));
    trajectory_mode_begin(&mode, rows[0].time_ms);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (result.progress == MODE_RUNNING); i++) {
        step();
    }
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(-50, yaw());
}

static void expect_failed(event_id_t id, uint32_t subject, status_t status)
{
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(status, result.status);
    TEST_ASSERT_EQUAL_UINT32(MODE_NO_AXIS, result.axis);
    TEST_ASSERT_EQUAL_UINT32(1U, result.note_count);
    TEST_ASSERT_EQUAL(id, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(subject, result.notes[0].axis);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_YAW));
}

void test_SWR_TRAJ_010_lost_time_ends_it_by_name(void)
{
    const uint32_t lost = LIMIT_TRAJECTORY_LATE_US / LIMIT_CYCLE_US;
    step_until_on_way();
    steps(1100U);
    frame.elapsed_us = 2U * LIMIT_CYCLE_US;
    steps(lost - 1U);
    step();
    expect_failed(EVENT_TRAJECTORY_LATE, 1U, STATUS_FAULT_PRESENT);
}

void test_SWR_TRAJ_010_cycles_that_come_early_and_late_in_turn_lose_no_time(void)
{
    step_until_on_way();
    for (uint32_t i = 0U; i < 900U; i++) {
        frame.elapsed_us = ((i % 2U) == 0U) ? (LIMIT_CYCLE_US + 400U) : (LIMIT_CYCLE_US - 400U);
        steps(1U);
    }
}

void test_SWR_TRAJ_011_after_a_pause_it_goes_on_from_where_the_axes_stand(void)
{
    step_until_on_way();
    steps(600U);
    const uint32_t time_us = mode.time_us;
    const int32_t before = yaw();
    trajectory_mode_pause(&mode);
    leg_stop(&leg);
    world_put(NEURO_AXIS_YAW, before + 20);
    step();
    TEST_ASSERT_INT32_WITHIN(1, before + 20, yaw());
    TEST_ASSERT_EQUAL_UINT32(time_us, mode.time_us);
    step_until_on_way();
    TEST_ASSERT_EQUAL_INT32(before, yaw());
    TEST_ASSERT_EQUAL_UINT32(time_us, mode.time_us);
}

void test_SWR_TRAJ_011_time_gains_its_pace_after_a_pause(void)
{
    const uint32_t cycles = LIMIT_TRAJECTORY_RAMP_US / LIMIT_CYCLE_US;
    step_until_on_way();
    steps(200U);
    trajectory_mode_pause(&mode);
    leg_stop(&leg);
    step_until_on_way();
    const uint32_t time_us = mode.time_us;
    step();
    TEST_ASSERT_EQUAL_UINT32(LIMIT_CYCLE_US / cycles, mode.time_us - time_us);
    TEST_ASSERT_INT32_WITHIN(256, 0, axes[NEURO_AXIS_YAW].sealed.setpoint_speed_ticks_per_s_q8);
    steps(cycles - 1U);
    TEST_ASSERT_UINT32_WITHIN(2U * LIMIT_CYCLE_US, LIMIT_TRAJECTORY_RAMP_US / 2U,
                              mode.time_us - time_us);
    const uint32_t later_us = mode.time_us;
    step();
    TEST_ASSERT_EQUAL_UINT32(LIMIT_CYCLE_US, mode.time_us - later_us);
}

void test_SWR_TRAJ_011_a_pause_on_the_way_to_the_first_row_begins_that_anew(void)
{
    world_put(NEURO_AXIS_YAW, 200);
    steps(10U);
    trajectory_mode_pause(&mode);
    leg_stop(&leg);
    step_until_on_way();
    step();
    TEST_ASSERT_EQUAL_UINT32(500000U + LIMIT_CYCLE_US, mode.time_us);
}

void test_SWR_TRAJ_012_a_row_that_changed_ends_it_before_it_is_driven(void)
{
    rows[2].ticks[NEURO_AXIS_YAW] -= 1;
    step_until_on_way();
    steps(1000U);
    step();
    expect_failed(EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_TRAJECTORY, STATUS_MEMORY_DAMAGED);
    TEST_ASSERT_EQUAL_INT32(1, result.notes[0].value);
    rows[1].crc ^= 1U;
    step();
    expect_failed(EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_TRAJECTORY, STATUS_MEMORY_DAMAGED);
}

void test_SWR_TRAJ_012_a_first_row_that_changed_is_not_armed(void)
{
    rows[0].time_ms ^= 1U;
    expect_judged(STATUS_MEMORY_DAMAGED, 0U);
}

void test_SWR_TRAJ_012_a_list_that_is_gone_is_not_driven(void)
{
    trajectory_list_clear(&list);
    step();
    expect_failed(EVENT_MEMORY_DAMAGED, (uint32_t)EVENT_MEMORY_TRAJECTORY, STATUS_FAULT_PRESENT);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a treatment program is held only as the whole list that was sent, each step
 * judged for the accepted target; what has changed since is not given out.
 */
#include "unity.h"

#include "interface/command.h"
#include "limits/requirement_limits.h"
#include "mode/lists/program_list.h"
#include "mode/lists/program_step.h"
#include "robot/joints.h"
#include "robot/robot_bench2.h"
#include "robot/robot_neuro.h"

#include <string.h>

#define DEPTH 60000 /* Depth of the target. */

static program_list_t list;
static robot_t robot;
static int32_t target[ROBOT_AXIS_MAX];
static program_step_t step;

void setUp(void)
{
    robot = robot_neuro;
    memset(&list, 0, sizeof list);
    memcpy(target, robot.poses[POSE_HOME].ticks, sizeof target);
    target[NEURO_AXIS_INSERTION] = DEPTH;
    step = (program_step_t){.depth_ticks = DEPTH - 10000, .angle_ticks = 700, .dwell_ms = 3000U};
}

void tearDown(void)
{
}

static void begin(uint32_t total)
{
    TEST_ASSERT_EQUAL(STATUS_OK, program_list_begin(&list, total, COMMAND_SOURCE_HTTP, target));
}

static solution_t add(void)
{
    return program_list_add(&list, &robot, target, list.count, &step);
}

static void expect_added(status_t status)
{
    TEST_ASSERT_EQUAL(status, add().status);
}

/* Two steps. */
static uint32_t hold(void)
{
    uint32_t crc = program_list_crc(0U, &step);
    begin(2U);
    expect_added(STATUS_OK);
    step.depth_ticks = DEPTH;
    step.is_gated = 1U;
    crc = program_list_crc(crc, &step);
    expect_added(STATUS_OK);
    TEST_ASSERT_EQUAL(STATUS_OK, program_list_end(&list, crc));
    return crc;
}

void test_SWR_PROG_001_a_list_is_held_as_it_was_sent(void)
{
    const uint32_t crc = hold();
    TEST_ASSERT_EQUAL_UINT32(1U, list.is_whole);
    TEST_ASSERT_EQUAL_UINT32(2U, list.count);
    TEST_ASSERT_EQUAL_HEX32(crc, list.crc);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_SOURCE_HTTP, list.source);
    TEST_ASSERT_EQUAL_INT32(DEPTH, program_list_step(&list, 1U)->depth_ticks);
    TEST_ASSERT_EQUAL_INT32(700, program_list_step(&list, 0U)->angle_ticks);
    TEST_ASSERT_EQUAL_UINT32(1U, program_list_step(&list, 1U)->is_gated);
}

void test_SWR_PROG_001_more_steps_than_there_is_room_for_are_refused(void)
{
    begin(LIMIT_PROGRAM_STEPS);
    TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE,
                      program_list_begin(&list, LIMIT_PROGRAM_STEPS + 1U, 0U, target));
    for (uint32_t i = 0U; i < LIMIT_PROGRAM_STEPS; i++) {
        expect_added(STATUS_OK);
    }
    expect_added(STATUS_PROGRAM_ORDER);
    TEST_ASSERT_EQUAL_UINT32(0U, list.count);
}

void test_SWR_PROG_001_what_is_missing_or_another_leaves_nothing(void)
{
    begin(2U);
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_ORDER,
                      program_list_add(&list, &robot, target, 1U, &step).status);
    expect_added(STATUS_PROGRAM_ORDER); /* Nothing was begun any more. */
    begin(2U);
    expect_added(STATUS_OK);
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_ORDER, program_list_end(&list, list.crc));
    begin(1U);
    expect_added(STATUS_OK);
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_ORDER, program_list_end(&list, list.crc + 1U));
    TEST_ASSERT_EQUAL_UINT32(0U, list.is_whole);
    begin(0U);
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_ORDER, program_list_end(&list, 0U));
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_ORDER, program_list_end(&list, 0U));
}

void test_SWR_PROG_001_a_whole_list_takes_no_more(void)
{
    (void)hold();
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_ORDER,
                      program_list_add(&list, &robot, target, 1U, &step).status);
}

void test_SWR_PROG_002_a_dwell_is_bounded_and_a_gate_has_one(void)
{
    begin(1U);
    step.dwell_ms = LIMIT_PROGRAM_DWELL_MS;
    expect_added(STATUS_OK);
    begin(1U);
    step.dwell_ms = 0U;
    expect_added(STATUS_OK);
    begin(1U);
    step.is_gated = 1U;
    expect_added(STATUS_PROGRAM_DWELL);
    begin(1U);
    step.dwell_ms = LIMIT_PROGRAM_DWELL_MS + 1U;
    expect_added(STATUS_PROGRAM_DWELL);
}

static void expect_refused(status_t status, uint32_t axis, uint32_t is_maximum)
{
    begin(2U);
    const solution_t judged = add();
    TEST_ASSERT_EQUAL(status, judged.status);
    TEST_ASSERT_EQUAL_UINT8(axis, judged.axis);
    TEST_ASSERT_EQUAL_UINT8(is_maximum, judged.is_maximum);
}

void test_SWR_PROG_003_no_step_is_deeper_than_the_target(void)
{
    step.depth_ticks = DEPTH;
    begin(1U);
    expect_added(STATUS_OK);
    step.depth_ticks = DEPTH + 1;
    expect_refused(STATUS_PROGRAM_DEPTH, NEURO_AXIS_INSERTION, 1U);
}

void test_SWR_PROG_003_each_axis_keeps_its_limits(void)
{
    step.depth_ticks = robot.axes[NEURO_AXIS_INSERTION].target_minimum_ticks;
    begin(1U);
    expect_added(STATUS_OK);
    step.depth_ticks--;
    expect_refused(STATUS_SWITCH_ZONE, NEURO_AXIS_INSERTION, 0U);
    step.depth_ticks = robot.axes[NEURO_AXIS_INSERTION].minimum_ticks - 1;
    expect_refused(STATUS_AXIS_LIMIT, NEURO_AXIS_INSERTION, 0U);
    step.depth_ticks = DEPTH;
    step.angle_ticks = robot.axes[NEURO_AXIS_ROTATION].maximum_ticks + 1;
    expect_refused(STATUS_AXIS_LIMIT, NEURO_AXIS_ROTATION, 1U);
    robot.axes[NEURO_AXIS_ROTATION].target_maximum_ticks = 100;
    step.angle_ticks = 101;
    expect_refused(STATUS_SWITCH_ZONE, NEURO_AXIS_ROTATION, 1U);
}

void test_SWR_PROG_003_what_axes_share_is_kept(void)
{
    target[NEURO_AXIS_FEET] =
        target[NEURO_AXIS_HEAD] + robot.axes[NEURO_AXIS_FEET].maximum_ticks * 3;
    begin(1U);
    TEST_ASSERT_NOT_EQUAL(STATUS_OK, add().status);
    TEST_ASSERT_EQUAL_UINT32(0U, list.total);
}

void test_SWR_PROG_003_a_robot_that_turns_no_needle_has_depths_alone(void)
{
    robot = robot_bench2;
    target[robot.needle_axis] = robot.axes[robot.needle_axis].target_maximum_ticks;
    TEST_ASSERT_EQUAL_UINT32(robot.axis_count, program_step_turning_axis(&robot));
    program_step_place(&robot, target, &step);
    TEST_ASSERT_EQUAL_INT32(target[robot.needle_axis], step.depth_ticks);
    TEST_ASSERT_EQUAL_INT32(0, step.angle_ticks);
    begin(1U);
    expect_added(STATUS_OK);
}

void test_SWR_PROG_003_a_step_is_at_the_positions_that_it_was_made_of(void)
{
    int32_t ends[ROBOT_AXIS_MAX];
    target[NEURO_AXIS_ROTATION] = -300;
    program_step_place(&robot, target, &step);
    TEST_ASSERT_EQUAL_INT32(-300, step.angle_ticks);
    program_list_ends(&robot, target, &step, ends);
    TEST_ASSERT_EQUAL_INT32_ARRAY(target, ends, ROBOT_AXIS_MAX);
}

void test_SWR_PROG_004_it_is_of_one_target(void)
{
    const uint32_t crc = hold();
    TEST_ASSERT_TRUE(program_list_is_meant(&list, crc, target));
    TEST_ASSERT_FALSE(program_list_is_meant(&list, crc + 1U, target));
    target[NEURO_AXIS_YAW]++;
    TEST_ASSERT_FALSE(program_list_is_meant(&list, crc, target));
    begin(2U);
    target[NEURO_AXIS_YAW]++;
    expect_added(STATUS_PROGRAM_OTHER);
}

void test_SWR_PROG_004_what_is_not_whole_or_has_changed_is_not_meant(void)
{
    const uint32_t crc = hold();
    list.steps[1].dwell_ms ^= 1U;
    TEST_ASSERT_FALSE(program_list_is_meant(&list, crc, target));
    list.steps[1].dwell_ms ^= 1U;
    list.total ^= 1U;
    TEST_ASSERT_FALSE(program_list_is_meant(&list, crc, target));
    begin(1U);
    expect_added(STATUS_OK);
    TEST_ASSERT_FALSE(program_list_is_meant(&list, list.crc, target));
}

void test_SWR_PROG_009_a_changed_step_is_not_given_out(void)
{
    (void)hold();
    TEST_ASSERT_NULL(program_list_step(&list, 2U));
    list.steps[1].depth_ticks ^= 1;
    TEST_ASSERT_NULL(program_list_step(&list, 1U));
    TEST_ASSERT_NOT_NULL(program_list_step(&list, 0U));
    list.count ^= 4U;
    TEST_ASSERT_NULL(program_list_step(&list, 0U));
    begin(1U);
    expect_added(STATUS_OK);
    TEST_ASSERT_NULL(program_list_step(&list, 0U));
}

void test_SWR_PROG_001_a_damaged_list_is_neither_filled_nor_ended(void)
{
    begin(1U);
    list.target_crc ^= 1U;
    expect_added(STATUS_PROGRAM_ORDER);
    begin(1U);
    expect_added(STATUS_OK);
    list.source ^= 1U;
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_ORDER, program_list_end(&list, list.crc));
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a treatment program goes to each step on a leg of the axes along and about the
 * needle and dwells there; time counts only there and under the pedal, the dose of the same step
 * ends it, and the stop of the gate ends all.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/move/move_mode.h"
#include "mode/lists/program_list.h"
#include "mode/lists/program_step.h"
#include "mode/program/program_mode.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

#include <string.h>

#define LONG_CYCLES 20000U
#define DEPTH 20000 /* Depth of the target. */
#define DWELL_MS 300U

static program_list_t list;
static program_mode_t mode;
static move_mode_t target;
static leg_t leg;

static void add(int32_t depth_ticks, int32_t angle_ticks, uint32_t is_gated)
{
    const program_step_t step = {.depth_ticks = depth_ticks,
                                 .angle_ticks = angle_ticks,
                                 .dwell_ms = DWELL_MS,
                                 .is_gated = is_gated};
    TEST_ASSERT_EQUAL(
        STATUS_OK, program_list_add(&list, &robot, target.target_ticks, list.count, &step).status);
}

/* Aligned with the needle out; a plain step, then one with a gate. */
void setUp(void)
{
    world_start();
    frame.program = &list;
    frame.is_dose_reached = false;
    memcpy(target.target_ticks, robot.poses[POSE_HOME].ticks, sizeof target.target_ticks);
    target.target_ticks[NEURO_AXIS_INSERTION] = DEPTH;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, target.target_ticks[i]);
    }
    world_put(NEURO_AXIS_INSERTION, needle_retracted_ticks(&robot));
    leg = (leg_t){.axes = 0U};
    TEST_ASSERT_EQUAL(STATUS_OK, program_list_begin(&list, 2U, 0U, target.target_ticks));
    add(DEPTH - 5000, 200, 0U);
    add(DEPTH, -100, 1U);
    TEST_ASSERT_EQUAL(STATUS_OK, program_list_end(&list, list.crc));
    program_mode_begin(&mode);
}

void tearDown(void)
{
}

static void step(void)
{
    mode_clear(&result);
    program_mode_step(&mode, &target, &leg, &frame, &result);
    world_follow();
}

static void steps(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        step();
        TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    }
}

/* Until it dwells in the step after `done`. */
static void step_until_there(uint32_t done)
{
    for (uint32_t i = 0U;
         (i < LONG_CYCLES) && ((mode.stage != PROGRAM_STAGE_DWELLS) || (mode.step != done)); i++) {
        step();
    }
    TEST_ASSERT_EQUAL_UINT32(PROGRAM_STAGE_DWELLS, mode.stage);
    TEST_ASSERT_EQUAL_UINT32(done, mode.step);
    TEST_ASSERT_EQUAL_UINT32(0U, mode.dwelt_us);
}

static void expect_step_note(uint32_t number, int32_t is_by_dose)
{
    TEST_ASSERT_EQUAL_UINT32(1U, result.note_count);
    TEST_ASSERT_EQUAL(EVENT_PROGRAM_STEP, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(number, result.notes[0].axis);
    TEST_ASSERT_EQUAL_INT32(is_by_dose, result.notes[0].value);
}

static void expect_judged(status_t status)
{
    TEST_ASSERT_EQUAL(status,
                      program_mode_judge(&list, list.crc, &target, &robot, axes, false).status);
}

void test_SWR_PROG_004_only_the_list_that_is_meant_for_this_target_is_run(void)
{
    expect_judged(STATUS_OK);
    TEST_ASSERT_EQUAL(
        STATUS_PROGRAM_OTHER,
        program_mode_judge(&list, list.crc + 1U, &target, &robot, axes, false).status);
    target.target_ticks[NEURO_AXIS_PITCH]++;
    expect_judged(STATUS_PROGRAM_OTHER);
}

void test_SWR_PROG_005_it_is_run_along_the_line_only_however_the_needle_is_turned(void)
{
    world_put(NEURO_AXIS_ROTATION, 3000);
    expect_judged(STATUS_OK);
    world_put(NEURO_AXIS_LATERAL, target.target_ticks[NEURO_AXIS_LATERAL] + 3);
    expect_judged(STATUS_NOT_ALIGNED);
}

void test_SWR_PROG_008_while_the_gate_says_stop_it_is_not_run(void)
{
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_STOPPED,
                      program_mode_judge(&list, list.crc, &target, &robot, axes, true).status);
}

void test_SWR_PROG_006_each_step_is_gone_to_and_dwelt_in(void)
{
    step_until_there(0U);
    TEST_ASSERT_EQUAL_INT32(DEPTH - 5000, axes[NEURO_AXIS_INSERTION].sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(200, axes[NEURO_AXIS_ROTATION].sealed.setpoint_ticks);
    steps(DWELL_MS - 1U);
    TEST_ASSERT_EQUAL_UINT32(0U, mode.step);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_INSERTION));
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_ROTATION));
    step();
    expect_step_note(1U, 0);
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    step_until_there(1U);
    TEST_ASSERT_EQUAL_INT32(DEPTH, axes[NEURO_AXIS_INSERTION].sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(-100, axes[NEURO_AXIS_ROTATION].sealed.setpoint_ticks);
    steps(DWELL_MS - 1U);
    step();
    expect_step_note(2U, 0);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_UINT32(1U, list.is_whole); /* It may be run again. */
}

void test_SWR_PROG_005_all_other_axes_rest(void)
{
    world_put(NEURO_AXIS_LATERAL,
              target.target_ticks[NEURO_AXIS_LATERAL] + 2); /* Aligned, but not there. */
    for (uint32_t i = 0U; i < 1000U; i++) {
        step();
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_HEAD));
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_LATERAL));
        TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_YAW));
    }
    TEST_ASSERT_EQUAL_INT32(target.target_ticks[NEURO_AXIS_LATERAL] + 2,
                            axes[NEURO_AXIS_LATERAL].sealed.setpoint_ticks);
}

void test_SWR_PROG_006_beside_the_step_no_time_counts(void)
{
    const int32_t slack = robot.axes[NEURO_AXIS_INSERTION].deadband_ticks + 2;
    step_until_there(0U);
    steps(100U);
    world_put(NEURO_AXIS_INSERTION, DEPTH - 5000 - slack);
    steps(1U);
    TEST_ASSERT_EQUAL_UINT32(101U * LIMIT_CYCLE_US, mode.dwelt_us);
    world_put(NEURO_AXIS_INSERTION, DEPTH - 5000 + slack + 1);
    steps(1U);
    TEST_ASSERT_EQUAL_UINT32(PROGRAM_STAGE_GOES, mode.stage);
    TEST_ASSERT_EQUAL_UINT32(101U * LIMIT_CYCLE_US, mode.dwelt_us);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (mode.stage != PROGRAM_STAGE_DWELLS); i++) {
        step();
    }
    TEST_ASSERT_EQUAL_INT32(DEPTH - 5000, axes[NEURO_AXIS_INSERTION].sealed.setpoint_ticks);
    world_put(NEURO_AXIS_ROTATION, 200 - robot.axes[NEURO_AXIS_ROTATION].deadband_ticks - 3);
    steps(1U);
    TEST_ASSERT_EQUAL_UINT32(PROGRAM_STAGE_GOES, mode.stage);
}

void test_SWR_PROG_005_a_base_that_has_moved_ends_it(void)
{
    step_until_there(0U);
    steps(DWELL_MS - 1U);
    world_put(NEURO_AXIS_YAW, target.target_ticks[NEURO_AXIS_YAW] - 3);
    step();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    step();
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_NOT_ALIGNED, result.status);
    TEST_ASSERT_EQUAL_UINT32(MODE_NO_AXIS, result.axis);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_INSERTION));
}

void test_SWR_PROG_007_the_dose_ends_a_step_with_a_gate_early(void)
{
    frame.is_dose_reached = true;
    step_until_there(0U);
    frame.is_dose_reached = false;
    steps(10U);
    frame.is_dose_reached = true;
    steps(DWELL_MS - 11U); /* The first step has no gate. */
    step();
    expect_step_note(1U, 0);
    frame.is_dose_reached = false;
    step_until_there(1U);
    steps(50U);
    frame.is_dose_reached = true;
    step();
    expect_step_note(2U, 1);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
}

void test_SWR_PROG_007_the_dose_of_the_step_before_ends_nothing(void)
{
    step_until_there(0U);
    steps(10U);
    frame.is_dose_reached = true;
    step_until_there(1U);
    steps(DWELL_MS - 1U);
    step();
    expect_step_note(2U, 0);
}

/* As after a pause, in which the probe was moved. */
void test_SWR_PROG_007_a_dose_that_is_reached_beside_the_step_counts_there(void)
{
    step_until_there(1U);
    steps(50U);
    world_put(NEURO_AXIS_INSERTION, DEPTH - 500);
    frame.is_dose_reached = true;
    steps(100U);
    TEST_ASSERT_EQUAL_UINT32(PROGRAM_STAGE_GOES, mode.stage);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (mode.step != 2U); i++) {
        step();
    }
    expect_step_note(2U, 1);
}

void test_SWR_PROG_008_the_stop_says_in_which_step(void)
{
    step_until_there(1U);
    steps(50U);
    mode_clear(&result);
    program_mode_stop(&mode, &frame, &result);
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_PROGRAM_STOPPED, result.status);
    TEST_ASSERT_EQUAL(EVENT_PROGRAM_STOPPED, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(2U, result.notes[0].axis);
    TEST_ASSERT_EQUAL_INT32(50, result.notes[0].value);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_INSERTION));
}

void test_SWR_PROG_009_a_changed_step_ends_it_by_its_number(void)
{
    step_until_there(0U);
    list.steps[1].angle_ticks ^= 1;
    steps(DWELL_MS - 1U);
    step();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    step();
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_MEMORY_DAMAGED, result.status);
    TEST_ASSERT_EQUAL(EVENT_MEMORY_DAMAGED, result.notes[0].id);
    TEST_ASSERT_EQUAL_UINT32(EVENT_MEMORY_PROGRAM, result.notes[0].axis);
    TEST_ASSERT_EQUAL_INT32(1, result.notes[0].value);
    TEST_ASSERT_EQUAL_UINT32(MODE_NO_AXIS, result.axis);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_INSERTION));
}

void test_SWR_PROG_005_a_robot_that_turns_no_needle_goes_to_depths(void)
{
    robot.axes[NEURO_AXIS_ROTATION].needle_motion = (uint32_t)NEEDLE_ACROSS;
    world_put(NEURO_AXIS_ROTATION, target.target_ticks[NEURO_AXIS_ROTATION]);
    expect_judged(STATUS_OK);
    step_until_there(0U);
    TEST_ASSERT_EQUAL_INT32(DEPTH - 5000, axes[NEURO_AXIS_INSERTION].sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(target.target_ticks[NEURO_AXIS_ROTATION],
                            axes[NEURO_AXIS_ROTATION].sealed.encoder.position_ticks);
}

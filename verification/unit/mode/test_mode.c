/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the mode that was begun runs in its workphase under the pedal, and rests
 * without it.
 */
#include "unity.h"

#include "axis/axis.h"
#include "interface/mode_list.h"
#include "mode/leg/leg.h"
#include "mode/mode.h"
#include "mode/leg/mode_frame.h"
#include "mode/lists/program_list.h"
#include "mode/lists/program_step.h"
#include "mode/program/program_mode.h"
#include "mode/lists/trajectory_list.h"
#include "mode/lists/trajectory_row.h"
#include "motion/curv.h"
#include "robot/robot_prostate.h"
#include "robot/robot_neuro.h"
#include "unit/support/mode_world.h"

#include <string.h>

#include "unit/mode/armed_mode_world.inc"

void setUp(void)
{
    world_start();
    mode = (mode_state_t){.sealed.kind = MODE_NONE};
}

void tearDown(void)
{
}

static void steps(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        mode_step(&mode, &frame, &result);
        world_follow();
    }
}

static void run(void)
{
    uint32_t cycles = 0U;
    do {
        TEST_ASSERT_LESS_THAN_UINT32(100000U, cycles);
        cycles++;
        steps(1U);
    } while (result.progress == MODE_RUNNING);
}

static void expect_rest(void)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_TRUE(world_rests(i));
    }
}

void test_SWR_ALIGN_001_an_alignment_and_then_an_insertion_run_to_their_ends(void)
{
    begin(MODE_ALIGN, WORKPHASE_TARGETING);
    run();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    begin(MODE_INSERT, WORKPHASE_MOVE_TO_TARGET);
    TEST_ASSERT_EQUAL(STATUS_OK, mode_judge(MODE_INSERT, &request, &robot, axes).status);
    run();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(-60, axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks);
}

void test_SWR_POSE_001_a_pose_runs_to_its_end_and_heeds_the_needle(void)
{
    world_put(NEURO_AXIS_INSERTION, 7);
    begin(MODE_POSE, WORKPHASE_MANUAL);
    run();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(-60, axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(7, axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks);
    TEST_ASSERT_TRUE(heeds(MODE_POSE, NEURO_AXIS_LATERAL, true));
    TEST_ASSERT_FALSE(heeds(MODE_POSE, NEURO_AXIS_ROTATION, true));
}

void test_SWR_AXIS_034_the_homing_of_one_axis_is_done_once_it_is_homed_and_another_lost(void)
{
    begin(MODE_HOME_AXIS, WORKPHASE_MANUAL);
    world_lose(NEURO_AXIS_YAW);
    world_lose(NEURO_AXIS_LATERAL);
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    TEST_ASSERT_TRUE(axis_is_homing(&axes[NEURO_AXIS_YAW]));
    TEST_ASSERT_FALSE(axis_is_homing(&axes[NEURO_AXIS_LATERAL]));
    world_grade(NEURO_AXIS_YAW, AXIS_REFERENCE_VERIFIED);
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    expect_rest();
}

void test_SWR_PEDAL_005_without_the_pedal_every_mode_rests_and_goes_on_from_there(void)
{
    begin(MODE_MOVE, WORKPHASE_MOVE_TO_TARGET);
    steps(300U);
    TEST_ASSERT_EQUAL_UINT32(1U, mode.sealed.leg.is_running);
    frame.is_moving = false;
    steps(1U);
    expect_rest();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    frame.is_moving = true;
    const int32_t there = axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks;
    TEST_ASSERT_INT32_WITHIN(390, -200, there);
    steps(1U);
    TEST_ASSERT_EQUAL_INT32(there, mode.sealed.leg.profile.start_ticks[NEURO_AXIS_HEAD]);
    run();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(-400, axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks);
    expect_rest();
}

void test_SWR_JOG_004_a_jog_runs_to_its_end(void)
{
    begin(MODE_JOG, WORKPHASE_MANUAL);
    run();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(200, axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(0, axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks);
}

void test_SWR_MOTION_023_a_needle_that_is_out_is_retracted_already_even_without_the_pedal(void)
{
    begin(MODE_RETRACT, WORKPHASE_MOVE_TO_TARGET);
    frame.is_moving = false;
    world_put(NEURO_AXIS_INSERTION, 30000);
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    expect_rest();
    frame.is_moving = true;
    run();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    expect_rest();
    TEST_ASSERT_EQUAL_UINT32(0U, mode.sealed.leg.is_running);
    frame.is_moving = false;
    begin(MODE_RETRACT, WORKPHASE_MOVE_TO_TARGET);
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
}

void test_SWR_AXIS_006_homing_is_done_once_every_axis_is_homed_even_without_the_pedal(void)
{
    begin(MODE_HOMING, WORKPHASE_START_UP);
    frame.is_moving = false;
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    frame.is_moving = true;
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    expect_rest();
    world_lose(NEURO_AXIS_LATERAL);
    frame.is_moving = false;
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    expect_rest();
    frame.is_moving = true;
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    TEST_ASSERT_TRUE(axis_is_homing(&axes[NEURO_AXIS_LATERAL]));
}

void test_SWR_MEMORY_002_an_armed_motion_that_is_not_known_any_more_fails_at_rest(void)
{
    begin(MODE_MOVE, WORKPHASE_MOVE_TO_TARGET);
    mode.sealed.kind ^= 4U;
    mode_step(&mode, &frame, &result);
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(STATUS_FAULT_PRESENT, result.status);
    TEST_ASSERT_EQUAL_UINT32(MODE_NO_AXIS, result.axis);
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
    expect_rest();
}

void test_SWR_PHASE_005_what_was_given_up_homes_no_axis_and_runs_no_leg(void)
{
    world_lose(NEURO_AXIS_LATERAL);
    begin(MODE_HOMING, WORKPHASE_START_UP);
    steps(1U);
    TEST_ASSERT_TRUE(axis_is_homing(&axes[NEURO_AXIS_LATERAL]));
    mode.sealed.leg.is_running = 1U;
    mode.sealed.leg.settled_cycles = 3U;
    mode_stop(&mode, axes, robot.axis_count);
    TEST_ASSERT_FALSE(axis_is_homing(&axes[NEURO_AXIS_LATERAL]));
    TEST_ASSERT_EQUAL_UINT32(0U, mode.sealed.leg.is_running);
    TEST_ASSERT_EQUAL_UINT32(0U, mode.sealed.leg.settled_cycles);
}

void test_SWR_PHASE_005_a_mode_that_is_begun_does_not_go_on_with_the_leg_of_another(void)
{
    begin(MODE_MOVE, WORKPHASE_MOVE_TO_TARGET);
    steps(100U);
    begin(MODE_JOG, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(0U, mode.sealed.leg.is_running);
    steps(1U);
    TEST_ASSERT_EQUAL_HEX32(LEG_AXIS(NEURO_AXIS_YAW), mode.sealed.leg.axes);
}

void test_SWR_EVENT_001_a_mode_notes_in_order_and_one_note_too_many_is_dropped(void)
{
    for (uint32_t i = 0U; i < MODE_NOTES; i++) {
        mode_note(&result, EVENT_AXIS_TAKEN, i, (int32_t)i);
        TEST_ASSERT_EQUAL_INT32(i, result.notes[i].value);
    }
    mode_fail(&result, EVENT_HOMING_BARRED, NEURO_AXIS_HEAD, 0);
    TEST_ASSERT_EQUAL_UINT32(MODE_NOTES, result.note_count);
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
}

void test_SWR_TRAJ_011_without_the_pedal_the_time_of_a_trajectory_stands(void)
{
    static trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];
    const trajectory_row_t row = {.time_ms = 20U};
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_begin(&mode.sealed.list, 2U));
    TEST_ASSERT_EQUAL(STATUS_OK,
                      trajectory_list_add(&mode.sealed.list, rows, &robot, 0U, &row).status);
    const trajectory_row_t last = {.time_ms = 2020U};
    TEST_ASSERT_EQUAL(STATUS_OK,
                      trajectory_list_add(&mode.sealed.list, rows, &robot, 1U, &last).status);
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_end(&mode.sealed.list, mode.sealed.list.crc));
    const mode_request_t run_it = {.sealed.span = {.start_ms = 20U}};
    frame.rows = rows;
    frame.workphase = WORKPHASE_MANUAL;
    mode_begin(&mode, MODE_TRAJECTORY, &run_it);
    steps(1000U);
    const uint32_t time_us = mode.sealed.trajectory.time_us;
    TEST_ASSERT_GREATER_THAN_UINT32(20000U, time_us);
    frame.is_moving = false;
    steps(100U);
    expect_rest();
    TEST_ASSERT_EQUAL_UINT32(time_us, mode.sealed.trajectory.time_us);
    frame.is_moving = true;
    run();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
}

/* One step, where the axes stand. */
static void begin_program(program_list_t *list)
{
    const program_step_t there = {
        .depth_ticks = robot.axes[NEURO_AXIS_INSERTION].target_minimum_ticks, .dwell_ms = 400U};
    mode_request_t asked = {.sealed.axes = LEG_EVERY_AXIS};
    (void)memcpy(asked.sealed.move.target_ticks, robot.poses[POSE_HOME].ticks,
                 sizeof asked.sealed.move.target_ticks);
    asked.sealed.move.target_ticks[NEURO_AXIS_INSERTION] = there.depth_ticks;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        world_put(i, asked.sealed.move.target_ticks[i]);
    }
    TEST_ASSERT_EQUAL(STATUS_OK, program_list_begin(list, 1U, 0U, asked.sealed.move.target_ticks));
    TEST_ASSERT_EQUAL(
        STATUS_OK,
        program_list_add(list, &robot, asked.sealed.move.target_ticks, 0U, &there).status);
    TEST_ASSERT_EQUAL(STATUS_OK, program_list_end(list, list->crc));
    frame.program = list;
    frame.workphase = WORKPHASE_MOVE_TO_TARGET;
    frame.is_treatment_stopped = false;
    mode_begin(&mode, MODE_PROGRAM, &asked);
}

static void step_until_dwelling(void)
{
    for (uint32_t i = 0U; (i < 10000U) && (mode.sealed.program.stage != PROGRAM_STAGE_DWELLS);
         i++) {
        steps(1U);
    }
    TEST_ASSERT_EQUAL_UINT32(PROGRAM_STAGE_DWELLS, mode.sealed.program.stage);
}

void test_SWR_PROG_006_without_the_pedal_the_dwell_of_a_program_stands(void)
{
    static program_list_t list;
    begin_program(&list);
    step_until_dwelling();
    steps(100U);
    const uint32_t dwelt_us = mode.sealed.program.dwelt_us;
    frame.is_moving = false;
    steps(100U);
    expect_rest();
    TEST_ASSERT_EQUAL_UINT32(dwelt_us, mode.sealed.program.dwelt_us);
    frame.is_moving = true;
    run();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
}

void test_SWR_PROG_008_the_stop_ends_a_program_in_a_pause_too_and_nothing_else(void)
{
    static program_list_t list;
    begin_program(&list);
    frame.is_treatment_stopped = true;
    for (uint32_t i = 0U; i < 2U; i++) {
        frame.is_moving = i == 0U;
        steps(1U);
        TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
        TEST_ASSERT_EQUAL(STATUS_PROGRAM_STOPPED, result.status);
        expect_rest();
    }
    mode_stop(&mode, axes, robot.axis_count);
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    TEST_ASSERT_EQUAL_UINT32(0U, result.note_count);
    begin_program(&list);
    begin(MODE_JOG, WORKPHASE_MANUAL);
    frame.is_treatment_stopped = true;
    steps(1U);
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
}

void test_SWR_PROG_011_share_and_time_left_are_those_of_the_dwell(void)
{
    static program_list_t list;
    begin_program(&list);
    step_until_dwelling();
    steps(100U);
    mode_share_t share = mode_share(&mode, MODE_PROGRAM, axes, robot.axis_count);
    TEST_ASSERT_EQUAL_UINT32(250U, share.done_per_mille);
    TEST_ASSERT_EQUAL_UINT32(300U, share.left_ms);
    mode.sealed.program.dwell_ms = 100U;
    share = mode_share(&mode, MODE_PROGRAM, axes, robot.axis_count);
    TEST_ASSERT_EQUAL_UINT32(1000U, share.done_per_mille);
    TEST_ASSERT_EQUAL_UINT32(0U, share.left_ms);
}

/* The ProstateRobot's rotation stands where it is, and its needle is in. */
static void steer_with_needle_in(mode_kind_t kind)
{
    const axis_config_t *const needle = &robot_prostate.axes[robot_prostate.needle_axis];
    mode_request_t steered = {.sealed.axes = LEG_EVERY_AXIS};
    (void)steering_set(&steered.sealed.move.steering, &robot_prostate.steering,
                       (uint32_t)STEERING_BIDIRECTIONAL, 1000U, 0);
    world_put(robot_prostate.needle_axis, needle->maximum_ticks / 2);
    mode_begin(&mode, kind, &steered);
}

void test_SWR_STEER_006_the_needle_waits_in_every_insertion_and_no_other_mode(void)
{
    for (uint32_t kind = 0U; kind < MODE_KIND_COUNT; kind++) {
        const bool is_insertion = (kind == (uint32_t)MODE_MOVE) ||
                                  (kind == (uint32_t)MODE_INSERT) ||
                                  (kind == (uint32_t)MODE_COOPERATE);
        steer_with_needle_in((mode_kind_t)kind);
        TEST_ASSERT_EQUAL(is_insertion,
                          mode_waits_for_rotation(&mode, (mode_kind_t)kind, &robot_prostate, axes));
    }
}

void test_SWR_STEER_006_a_needle_that_is_out_a_stroke_and_a_law_that_is_followed_wait_for_nothing(
    void)
{
    const uint32_t rotation = robot_prostate.steering.axis;
    steer_with_needle_in(MODE_COOPERATE);
    mode.request.own.cooperate.stage = (uint32_t)COOPERATE_VIBRATES;
    TEST_ASSERT_FALSE(mode_waits_for_rotation(&mode, MODE_COOPERATE, &robot_prostate, axes));
    mode.request.own.cooperate.stage = (uint32_t)COOPERATE_BRAKES;
    TEST_ASSERT_TRUE(mode_waits_for_rotation(&mode, MODE_COOPERATE, &robot_prostate, axes));
    axes[rotation].sealed.setpoint_speed_ticks_per_s_q8 =
        (int32_t)curv_speed_q8(&robot_prostate.axes[rotation], &mode.request.sealed.move.steering,
                               axes[rotation].sealed.encoder.position_ticks);
    TEST_ASSERT_FALSE(mode_waits_for_rotation(&mode, MODE_COOPERATE, &robot_prostate, axes));
    axes[rotation].sealed.setpoint_speed_ticks_per_s_q8 = 0;
    world_put(robot_prostate.needle_axis, 0);
    TEST_ASSERT_FALSE(mode_waits_for_rotation(&mode, MODE_COOPERATE, &robot_prostate, axes));
}

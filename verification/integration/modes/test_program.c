/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a treatment program that was sent and judged for the accepted target is an armed
 * order like any other: under the pedal alone, paused by pedal and scanner, ended by its gate,
 * reported at its end, replayed bit by bit. On the simulated box, whose true positions are looked
 * at.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "charts/arming_chart.h"
#include "controller/controller.h"
#include "robot/robot_neuro.h"

#define LONG_CYCLES 30000U
#define DWELL_MS 500

static rig_t rig;
static uint32_t sum;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static answer_t send(command_kind_t kind, uint32_t argument)
{
    return rig_command(&rig, commands_of_number(kind, argument));
}

static answer_t send_step(uint32_t index, int32_t depth_ticks, int32_t angle_ticks, int32_t dwell)
{
    const program_step_t step = {.depth_ticks = depth_ticks,
                                 .angle_ticks = angle_ticks,
                                 .dwell_ms = (uint32_t)((dwell < 0) ? -dwell : dwell),
                                 .is_gated = (dwell < 0) ? 1U : 0U};
    command_t command = {
        .kind = (uint32_t)COMMAND_PROGRAM_STEP,
        .as.step = {.index = index, .dwell_ms = step.dwell_ms, .is_gated = step.is_gated}};
    command.as.step.ticks[rig.robot.needle_axis] = depth_ticks;
    command.as.step.ticks[program_step_turning_axis(&rig.robot)] = angle_ticks;
    sum = program_list_crc(sum, &step);
    return rig_command(&rig, command);
}

static int32_t depth(void)
{
    return rig.controller.plan.target_ticks[rig.robot.needle_axis];
}

/* 3 mm short of the target, then at it, with the gate. */
static void send_program(void)
{
    sum = 0U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_PROGRAM_BEGIN, 2U).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send_step(0U, depth() - 10000, 400, DWELL_MS).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send_step(1U, depth(), -200, -DWELL_MS).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_PROGRAM_END, sum).status);
}

static command_t entry(void)
{
    command_t command = {.kind = (uint32_t)COMMAND_ENTRY};
    rigid_set_identity(&command.as.pose.pose);
    command.as.pose.pose.translation = (point_t){5000000, 246000000, 60000000};
    return command;
}

static void run(command_kind_t kind)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(kind, 0U).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    rig_cycles(&rig, 100U);
}

/* In TARGETING, lined up with a target that was accepted with its entry point. */
static void start_aligned(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry()).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    run(COMMAND_ALIGN);
    rig_forget(&rig);
}

/* In MOVE_TO_TARGET, the program held. */
static void start_held(void)
{
    start_aligned();
    send_program();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_forget(&rig);
}

static void start_armed(void)
{
    start_held();
    const answer_t answer = send(COMMAND_RUN_PROGRAM, sum);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, answer.is_final);
}

/* Until it dwells in the step after `done`. */
static void run_until_dwelling(uint32_t done)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    for (uint32_t i = 0U;
         (i < LONG_CYCLES) && ((shown->program_step != done) || (shown->program_dwelt_us == 0U));
         i++) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(done, shown->program_step);
}

static double truly(uint32_t axis)
{
    double ticks[ROBOT_AXIS_MAX];
    box_true_positions(&rig.box, ticks);
    return ticks[axis];
}

void test_SWR_PROG_011_a_program_goes_through_its_steps_shows_them_and_reports_its_end(void)
{
    start_held();
    TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.snapshot.program_steps);
    TEST_ASSERT_EQUAL_HEX32(sum, rig.outputs.snapshot.program_crc);
    const double yaw = truly(NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_RUN_PROGRAM, sum).status);
    TEST_ASSERT_EQUAL_UINT32(MODE_PROGRAM, rig.outputs.snapshot.mode);
    rig_press(&rig);
    run_until_dwelling(0U);
    TEST_ASSERT_INT32_WITHIN(20, depth() - 10000, (int32_t)truly(NEURO_AXIS_INSERTION));
    TEST_ASSERT_INT32_WITHIN(4, 400, (int32_t)truly(NEURO_AXIS_ROTATION));
    rig_cycles(&rig, 249U);
    TEST_ASSERT_EQUAL_UINT32(500U, rig.outputs.snapshot.done_per_mille);
    TEST_ASSERT_EQUAL_UINT32(250U, rig.outputs.snapshot.left_ms);
    run_until_dwelling(1U);
    TEST_ASSERT_INT32_WITHIN(20, depth(), (int32_t)truly(NEURO_AXIS_INSERTION));
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_RUN_PROGRAM, answer.command);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.snapshot.program_step);
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_PROGRAM_STEP));
    TEST_ASSERT_TRUE(truly(NEURO_AXIS_YAW) == yaw);
}

void test_SWR_MODE_011_its_end_is_shown_as_that_of_a_program_not_as_the_target(void)
{
    start_armed();
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PROGRAM_DONE, rig.outputs.snapshot.next_step);
}

void test_SWR_PROG_011_it_may_be_run_again_with_the_needle_turned(void)
{
    start_held();
    for (uint32_t i = 0U; i < 2U; i++) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_RUN_PROGRAM, sum).status);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
        rig_release(&rig);
    }
}

void test_SWR_PROG_011_pedal_and_scanner_pause_it(void)
{
    start_armed();
    rig_press(&rig);
    run_until_dwelling(0U);
    rig_cycles(&rig, 100U);
    rig_release(&rig);
    const uint32_t dwelt_us = rig.outputs.snapshot.program_dwelt_us;
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_EQUAL_UINT32(dwelt_us, rig.outputs.snapshot.program_dwelt_us);
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 5U);
    const uint32_t before_us = rig.outputs.snapshot.program_dwelt_us;
    TEST_ASSERT_GREATER_THAN_UINT32(dwelt_us, before_us);
    rig_cycles(&rig, 500U);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_UINT32(before_us, rig.outputs.snapshot.program_dwelt_us);
    rig_release(&rig);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
}

void test_SWR_PROG_011_the_dose_ends_the_step_with_the_gate(void)
{
    start_armed();
    rig_press(&rig);
    run_until_dwelling(1U);
    rig_cycles(&rig, 100U);
    rig_box(&rig, "gate dose");
    rig_forget(&rig);
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PROGRAM_STEP));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DONE));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_dose_reached);
}

static void expect_stopped(void)
{
    rig_forget(&rig);
    rig_box(&rig, "gate stop");
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig.answers[0].kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROGRAM_STOPPED, rig.answers[0].status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PROGRAM_STOPPED));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROGRAM_STOPPED, send(COMMAND_RUN_PROGRAM, sum).status);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PROGRAM_STOPPED));
}

void test_SWR_PROG_011_the_stop_ends_it_on_its_way(void)
{
    start_armed();
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    expect_stopped();
}

void test_SWR_PROG_011_the_stop_ends_it_without_the_pedal(void)
{
    start_armed();
    expect_stopped();
    rig_box(&rig, "gate off");
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_RUN_PROGRAM, sum).status);
}

void test_SWR_PROG_011_only_the_program_that_is_meant_is_armed_and_with_the_base_aligned(void)
{
    start_held();
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROGRAM_OTHER, send(COMMAND_RUN_PROGRAM, sum + 1U).status);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, send(COMMAND_RUN_PROGRAM, sum).status);
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_ENTRY_POINT, send(COMMAND_RUN_PROGRAM, sum).status);
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry()).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    send_program();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_ALIGNED, send(COMMAND_RUN_PROGRAM, sum).status);
}

void test_SWR_PROG_011_a_step_that_is_damaged_ends_it_by_name(void)
{
    start_armed();
    rig_press(&rig);
    run_until_dwelling(0U);
    rig_forget(&rig);
    rig.controller.program.steps[1].angle_ticks ^= 1;
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, answer.status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
}

void test_SWR_PROG_011_a_program_is_part_of_the_state_that_is_replayed(void)
{
    static controller_t other;
    static controller_outputs_t outputs;
    start_armed();
    rig_press(&rig);
    run_until_dwelling(0U);
    other = rig.controller;
    for (uint32_t i = 0U; i < 2000U; i++) {
        rig_cycle(&rig);
        controller_step(&other, &rig.robot, &rig.inputs, &outputs);
        TEST_ASSERT_EQUAL_MEMORY(&rig.outputs, &outputs, sizeof outputs);
    }
}

void test_SWR_PROG_010_a_program_is_taken_for_a_target_and_at_rest_alone(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, send(COMMAND_PROGRAM_BEGIN, 1U).status);
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_PROGRAM_BEGIN, 1U).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED, send(COMMAND_PROGRAM_BEGIN, 1U).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED, send_step(0U, depth(), 0, 1).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED, send(COMMAND_PROGRAM_END, 0U).status);
    rig_start_homed(&rig);
    rigid_t identity;
    rigid_set_identity(&identity);
    rig_register(&rig, &identity);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET, send(COMMAND_PROGRAM_BEGIN, 1U).status);
}

void test_SWR_PROG_010_a_refused_step_is_named_and_nothing_is_held(void)
{
    start_aligned();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OUT_OF_RANGE,
                             send(COMMAND_PROGRAM_BEGIN, LIMIT_PROGRAM_STEPS + 1U).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_PROGRAM_BEGIN, 2U).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send_step(0U, depth(), 0, 1).status);
    const answer_t answer = send_step(1U, depth(), 9000, 1);
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_ROTATION, answer_axis(&answer));
    TEST_ASSERT_EQUAL_UINT32(1U, answer_as_limit(&answer)->is_maximum);
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROGRAM_ORDER, send(COMMAND_PROGRAM_END, sum).status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.program_steps);
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: in every workphase the needle is drawn out by a command of its own, under a
 * pedal that is pressed anew; afterwards the robot may be sent to its target again. A needle
 * seen in an image moves nothing. On the simulated box, whose true positions are looked at.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "charts/arming_chart.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "safety/needle.h"
#include "unit/support/scenes.h"

static rig_t rig;
static const command_t retract = {.kind = (uint32_t)COMMAND_RETRACT};

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* The needle at its target, the pedal released. */
static void start_inserted(void)
{
    rig_start_arrived(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_NOTHING, rig.outputs.snapshot.next_step);
}

static void expect_armed(void)
{
    const answer_t answer = rig_command(&rig, retract);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, answer.is_final);
}

void test_SWR_MOTION_023_the_needle_is_drawn_out_under_the_pedal_and_the_base_stays(void)
{
    double before[ROBOT_AXIS_MAX];
    double after[ROBOT_AXIS_MAX];
    start_inserted();
    box_true_positions(&rig.box, before);
    expect_armed();
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PRESS_PEDAL, rig.outputs.snapshot.next_step);
    rig_cycles(&rig, 500U);
    box_true_positions(&rig.box, after);
    TEST_ASSERT_DOUBLE_WITHIN(1.0, before[NEURO_AXIS_INSERTION], after[NEURO_AXIS_INSERTION]);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_HOLD_PEDAL, rig.outputs.snapshot.next_step);
    const answer_t answer = rig_finish(&rig, 30000U);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_RETRACT, answer.command);
    TEST_ASSERT_EQUAL_UINT32(1U, answer.is_final);
    rig_cycles(&rig, 100U);
    box_true_positions(&rig.box, after);
    TEST_ASSERT_DOUBLE_WITHIN(5.0, needle_retracted_ticks(&robot_neuro),
                              after[NEURO_AXIS_INSERTION]);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (i != (uint32_t)NEURO_AXIS_INSERTION) {
            TEST_ASSERT_DOUBLE_WITHIN(1.5, before[i], after[i]);
        }
    }
}

/* As it is for every order. */
void test_SWR_PEDAL_005_a_pedal_that_is_held_already_does_not_retract(void)
{
    start_inserted();
    rig_press(&rig);
    const int32_t before = rig_position(&rig, NEURO_AXIS_INSERTION);
    expect_armed();
    rig_cycles(&rig, 300U);
    TEST_ASSERT_INT32_WITHIN(1, before, rig_position(&rig, NEURO_AXIS_INSERTION));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    rig_release(&rig);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
}

void test_SWR_PHASE_008_in_the_middle_of_a_move_the_move_is_discarded(void)
{
    rig_start_moving(&rig);
    rig_forget(&rig);
    expect_armed();
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_ARMED));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    bool is_reported = false;
    for (uint32_t i = 0U; i < rig.answer_count; i++) {
        is_reported = is_reported || ((rig.answers[i].command == (uint32_t)COMMAND_WORKPHASE) &&
                                      (rig.answers[i].status == (uint32_t)STATUS_DISCARDED));
    }
    TEST_ASSERT_TRUE(is_reported);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_MOVE_TO_TARGET, rig.outputs.snapshot.workphase);
}

void test_SWR_NEXT_002_a_retracted_needle_is_not_shown_as_arrived_and_may_go_in_again(void)
{
    start_inserted();
    expect_armed();
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(rig.outputs.snapshot.axes[i].setpoint_ticks,
                                rig.outputs.snapshot.axes[i].target_ticks);
    }
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_MOVE, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_NOTHING, rig.outputs.snapshot.next_step);
    TEST_ASSERT_INT32_WITHIN(robot_neuro.axes[NEURO_AXIS_INSERTION].deadband_ticks,
                             rig.controller.plan.target_ticks[NEURO_AXIS_INSERTION],
                             rig_position(&rig, NEURO_AXIS_INSERTION));
}

void test_SWR_MOTION_023_a_needle_that_is_out_is_done_at_once_and_not_taken_in(void)
{
    start_inserted();
    expect_armed();
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    rig_release(&rig);
    const int32_t before = rig_position(&rig, NEURO_AXIS_INSERTION);
    rig_forget(&rig);
    expect_armed();
    TEST_ASSERT_EQUAL_UINT32(2U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.answers[1].kind);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_INT32(before, rig_position(&rig, NEURO_AXIS_INSERTION));
}

void test_SWR_PHASE_009_refusals_name_what_is_missing(void)
{
    rig_start(&rig);
    rig_cycles(&rig, 10U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, rig_command(&rig, retract).status);
    rig_start_moving(&rig);
    rig_box(&rig, "card yaw silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES + 20U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_command(&rig, retract).status);
    rig_start_moving(&rig);
    rig_box(&rig, "pedal a open");
    rig_cycles(&rig, 200U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_command(&rig, retract).status);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

void test_SWR_PHASE_009_with_the_e_stop_pulled_or_latched_nothing_is_drawn_out(void)
{
    start_inserted();
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_command(&rig, retract).status);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, rig.outputs.snapshot.workphase);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_command(&rig, retract).status);
}

static void expect_drawn_out(void)
{
    expect_armed();
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
}

void test_SWR_PHASE_008_the_needle_is_drawn_out_in_each_workphase(void)
{
    static const workphase_t workphases[] = {
        WORKPHASE_START_UP, WORKPHASE_PLANNING, WORKPHASE_CALIBRATION, WORKPHASE_TARGETING,
        WORKPHASE_MANUAL,   WORKPHASE_STOP,     WORKPHASE_EMERGENCY};
    static rig_t inserted;
    start_inserted();
    inserted = rig;
    for (uint32_t i = 0U; i < SCENES(sizeof workphases / sizeof workphases[0]); i++) {
        rig = inserted;
        const bool is_calibration = workphases[i] == WORKPHASE_CALIBRATION;
        (void)rig_workphase(&rig, is_calibration ? WORKPHASE_PLANNING : WORKPHASE_STOP);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, workphases[i]).status);
        expect_drawn_out();
        TEST_ASSERT_EQUAL_UINT32(workphases[i], rig.outputs.snapshot.workphase);
        TEST_ASSERT_INT32_WITHIN(robot_neuro.axes[NEURO_AXIS_INSERTION].deadband_ticks,
                                 needle_retracted_ticks(&robot_neuro),
                                 rig_position(&rig, NEURO_AXIS_INSERTION));
    }
}

/* The needle deep in, its place forgotten. */
static void lose_needle(void)
{
    const command_t clear = {.kind = (uint32_t)COMMAND_CLEAR_AXIS,
                             .as.axis = {.axis = NEURO_AXIS_INSERTION}};
    start_inserted();
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    rig_forget(&rig);
}

void test_SWR_MODE_005_a_needle_whose_place_is_lost_goes_out_slowly_to_its_switch(void)
{
    double before[ROBOT_AXIS_MAX];
    double after[ROBOT_AXIS_MAX];
    double last[ROBOT_AXIS_MAX];
    const double most_ticks = (double)robot_neuro.axes[NEURO_AXIS_INSERTION].speed_ticks_per_s *
                              ((double)LIMIT_UNHOMED_SPEED_PERCENT / 100.0) * 1.15 / 1000.0;
    lose_needle();
    box_true_positions(&rig.box, before);
    expect_armed();
    rig_press(&rig);
    bool is_done = false;
    box_true_positions(&rig.box, last);
    for (uint32_t i = 0U; (i < 60000U) && !is_done; i++) {
        rig_cycle(&rig);
        is_done = rig.outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE;
        if ((i % 100U) == 99U) {
            box_true_positions(&rig.box, after);
            TEST_ASSERT_TRUE(after[NEURO_AXIS_INSERTION] <= (last[NEURO_AXIS_INSERTION] + 1.0));
            TEST_ASSERT_TRUE(after[NEURO_AXIS_INSERTION] >=
                             (last[NEURO_AXIS_INSERTION] - (100.0 * most_ticks)));
            box_true_positions(&rig.box, last);
        }
    }
    TEST_ASSERT_TRUE(is_done);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DONE));
    TEST_ASSERT_NOT_EQUAL_UINT32(0U,
                                 rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].limit_switches);
    rig_cycles(&rig, 100U);
    box_true_positions(&rig.box, after);
    TEST_ASSERT_DOUBLE_WITHIN(300.0, 0.0, after[NEURO_AXIS_INSERTION]);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (i != (uint32_t)NEURO_AXIS_INSERTION) {
            TEST_ASSERT_DOUBLE_WITHIN(1.5, before[i], after[i]);
        }
    }
}

void test_SWR_MODE_005_with_the_pedal_pressed_anew_it_goes_on_to_the_same_end(void)
{
    lose_needle();
    const int32_t place = rig_position(&rig, NEURO_AXIS_INSERTION);
    expect_armed();
    const int32_t end_ticks = rig.controller.mode.request.sealed.way.end_ticks;
    TEST_ASSERT_EQUAL_INT32(place - robot_neuro.axes[NEURO_AXIS_INSERTION].maximum_ticks,
                            end_ticks);
    rig_press(&rig);
    rig_cycles(&rig, 2000U);
    rig_release(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_LESS_THAN_INT32(place, rig_position(&rig, NEURO_AXIS_INSERTION));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_INT32(end_ticks, rig.controller.mode.request.sealed.way.end_ticks);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
}

void test_SWR_MODE_005_a_switch_that_never_comes_ends_at_the_stop_with_a_fault(void)
{
    lose_needle();
    rig_box(&rig, "switch insertion open");
    expect_armed();
    rig_press(&rig);
    const answer_t answer = rig_finish(&rig, 60000U);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_INSERTION, answer_axis(&answer));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_PHASE_008_in_the_middle_of_homing_the_needle_goes_out_and_homing_is_discarded(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    rig_release(&rig);
    expect_drawn_out();
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_START_UP, rig.outputs.snapshot.workphase);
    rig_home(&rig);
}

void test_SWR_MOTION_024_a_needle_that_is_seen_is_shown_and_moves_nothing(void)
{
    command_t seen = {.kind = (uint32_t)COMMAND_NEEDLE,
                      .as.seen_pose = {.pose = rig_pose(5100000, 190000000, 60000000)}};
    rig_start_moving(&rig);
    static rig_t blind;
    blind = rig;
    rig_cycle(&blind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, seen).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_seen_needle);
    TEST_ASSERT_EQUAL_INT32(5100000, rig.outputs.snapshot.seen_needle.translation.x_nm);
    for (uint32_t i = 0U; i < 500U; i++) {
        rig_cycle(&rig);
        rig_cycle(&blind);
        TEST_ASSERT_EQUAL_MEMORY(blind.outputs.frames, rig.outputs.frames,
                                 sizeof blind.outputs.frames);
    }
    seen.as.seen_pose.pose.rotation_q30[0][0] = 0;
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_RIGID, rig_command(&rig, seen).status);
    TEST_ASSERT_EQUAL_UINT32(5100000, rig.outputs.snapshot.seen_needle.translation.x_nm);
}

void test_SWR_MOTION_024_a_needle_is_seen_in_move_to_target_only_and_forgotten_with_the_target(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    const command_t seen = {.kind = (uint32_t)COMMAND_NEEDLE, .as.seen_pose = {.pose = pose}};
    rig_start_moving(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, seen).status);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, rig_command(&rig, seen).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_seen_needle);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_seen_needle);
    rig_start_moving(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, seen).status);
    rig_box(&rig, "card yaw silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES + 20U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_seen_needle);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: axes run at commanded speeds only in MANUAL and under the pedal, as the motors
 * let them, come to rest before every limit, and what has ended them is reported. On the simulated
 * box, whose true positions are looked at.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

#define LONG_CYCLES 90000U
#define HOME_MM 143.0
#define LEAST_MM 75.0
#define MOST_MM 146.0
#define MARGIN_MM 0.2

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static command_t speed_of(uint32_t axis, int32_t ticks_per_s, int32_t bound)
{
    command_t command = {.kind = (uint32_t)COMMAND_VELOCITY,
                         .as.velocity = {.axes = 1UL << axis,
                                         .time_ms = (bound > 0) ? (uint32_t)bound : 0U,
                                         .way_ticks = (bound < 0) ? (uint32_t)-bound : 0U}};
    command.as.velocity.speeds_ticks_per_s[axis] = ticks_per_s;
    return command;
}

static void expect(command_t command, status_t status)
{
    TEST_ASSERT_EQUAL_UINT32(status, rig_command(&rig, command).status);
}

static void start_manual(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
}

static answer_t run(command_t command)
{
    expect(command, STATUS_OK);
    rig_press(&rig);
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    rig_release(&rig);
    return answer;
}

static int32_t end_reported(uint32_t axis)
{
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if ((rig.events[i].id == (uint32_t)EVENT_VELOCITY_ENDED) &&
            (rig.events[i].subject == axis)) {
            return rig.events[i].value;
        }
    }
    return -1;
}

static double true_ticks(uint32_t axis)
{
    return rig.box.axes[axis].motor.position_ticks;
}

static double separation_mm(void)
{
    return HOME_MM + ((true_ticks(NEURO_AXIS_HEAD) - true_ticks(NEURO_AXIS_FEET)) / 78.74);
}

void test_SWR_VEL_001_a_speed_is_armed_in_manual_alone_and_moves_nothing_without_the_pedal(void)
{
    rig_start_homed(&rig);
    const int32_t start = rig_position(&rig, NEURO_AXIS_YAW);
    expect(speed_of(NEURO_AXIS_YAW, -100, 500), STATUS_WRONG_WORKPHASE);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    expect(speed_of(NEURO_AXIS_YAW, -834, 500), STATUS_TOO_FAST);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    expect(speed_of(NEURO_AXIS_YAW, -100, 500), STATUS_OK);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_EQUAL_INT32(start, rig_position(&rig, NEURO_AXIS_YAW));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 2000U).kind);
    TEST_ASSERT_INT32_WITHIN(8, start - 45, rig_position(&rig, NEURO_AXIS_YAW));
}

void test_SWR_VEL_011_time_and_way_are_done_and_reported_by_name(void)
{
    start_manual();
    const int32_t start = rig_position(&rig, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, run(speed_of(NEURO_AXIS_YAW, -400, 1000)).kind);
    TEST_ASSERT_EQUAL_INT32(VELOCITY_END_TIME, end_reported(NEURO_AXIS_YAW));
    const int32_t way = rig_position(&rig, NEURO_AXIS_YAW) - start;
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, run(speed_of(NEURO_AXIS_YAW, -833, -600)).kind);
    TEST_ASSERT_EQUAL_INT32(VELOCITY_END_WAY, end_reported(NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_INT32(start + way - 600, rig_position(&rig, NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DONE));
}

void test_SWR_VEL_011_a_limit_aborts_it_by_its_name(void)
{
    start_manual();
    const answer_t soft = run(speed_of(NEURO_AXIS_YAW, -833, 20000));
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, soft.kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, soft.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_YAW, answer_axis(&soft));
    TEST_ASSERT_EQUAL_INT32(VELOCITY_END_SOFT_LIMIT, end_reported(NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_INT32(robot_neuro.axes[NEURO_AXIS_YAW].minimum_ticks,
                            rig_position(&rig, NEURO_AXIS_YAW));
    rig_forget(&rig);
    const answer_t zone = run(speed_of(NEURO_AXIS_YAW, 833, 20000));
    TEST_ASSERT_EQUAL_UINT32(STATUS_SWITCH_ZONE, zone.status);
    TEST_ASSERT_EQUAL_INT32(VELOCITY_END_SWITCH_ZONE, end_reported(NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.axes[NEURO_AXIS_YAW].limit_switches);
}

void test_SWR_VEL_007_two_carriages_at_any_speeds_stay_inside_of_the_limit_they_share(void)
{
    static const int32_t speeds[][2] = {{-787, 787}, {-787, 300}, {-200, 787},  {-100, -787},
                                        {787, -787}, {-787, 0},   {-787, -400}, {-787, -787}};
    for (uint32_t i = 0U; i < SCENES(sizeof speeds / sizeof speeds[0]); i++) {
        start_manual();
        command_t command = speed_of(NEURO_AXIS_HEAD, speeds[i][0], 12000);
        command.as.velocity.speeds_ticks_per_s[NEURO_AXIS_FEET] = speeds[i][1];
        command.as.velocity.axes |= (speeds[i][1] != 0) ? (1UL << NEURO_AXIS_FEET) : 0UL;
        expect(command, STATUS_OK);
        rig_press(&rig);
        while (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE) {
            rig_cycle(&rig);
            TEST_ASSERT_TRUE(separation_mm() >= (LEAST_MM + MARGIN_MM - 0.05));
            TEST_ASSERT_TRUE(separation_mm() <= (MOST_MM - MARGIN_MM + 0.05));
        }
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_VELOCITY_ENDED) -
                                         ((speeds[i][1] != 0) ? 1U : 0U));
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ORDER_OVERDUE));
    }
    if (ARE_SCENES_WHOLE) {
        TEST_ASSERT_EQUAL_INT32(VELOCITY_END_SOFT_LIMIT, end_reported(NEURO_AXIS_FEET));
    }
}

void test_SWR_VEL_009_an_axis_across_a_needle_that_comes_in_is_not_driven(void)
{
    start_manual();
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, run(speed_of(NEURO_AXIS_INSERTION, 5000, -1500)).kind);
    expect(speed_of(NEURO_AXIS_LATERAL, -100, 2000), STATUS_OK);
    axis_t *const needle = &rig.controller.axes[NEURO_AXIS_INSERTION];
    encoder_set_position(&needle->sealed.encoder, needle->sealed.encoder.position_ticks + 20000);
    supervision_shift(&needle->supervision, 20000);
    drift_audit_settle(&needle->sealed.drift);
    controller_seal(&rig.controller);
    rig_cycle(&rig);
    TEST_ASSERT_TRUE((rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].permit_reasons &
                      (1UL << PERMIT_REASON_NEEDLE_IN)) != 0U);
    const int32_t start = rig_position(&rig, NEURO_AXIS_LATERAL);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_INT32(start, rig_position(&rig, NEURO_AXIS_LATERAL));
    expect(speed_of(NEURO_AXIS_LATERAL, -100, 2000), STATUS_NEEDLE_IN);
}

void test_SWR_VEL_010_the_pedal_pauses_it_and_does_not_make_it_longer(void)
{
    start_manual();
    const int32_t start = rig_position(&rig, NEURO_AXIS_YAW);
    expect(speed_of(NEURO_AXIS_YAW, -833, -600), STATUS_OK);
    for (uint32_t i = 0U; i < 4U; i++) {
        rig_press(&rig);
        rig_cycles(&rig, 250U);
        rig_release(&rig);
        rig_cycles(&rig, 300U);
    }
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    TEST_ASSERT_EQUAL_INT32(start - 600, rig_position(&rig, NEURO_AXIS_YAW));
}

void test_SWR_VEL_012_all_that_are_commanded_run_at_once_and_no_other(void)
{
    static const uint32_t axes[] = {NEURO_AXIS_HEAD, NEURO_AXIS_FEET, NEURO_AXIS_LATERAL,
                                    NEURO_AXIS_ROTATION, NEURO_AXIS_PITCH};
    int32_t starts[ROBOT_AXIS_MAX];
    start_manual();
    command_t command = {.kind = (uint32_t)COMMAND_VELOCITY, .as.velocity = {.time_ms = 1500}};
    for (uint32_t i = 0U; i < (sizeof axes / sizeof axes[0]); i++) {
        command.as.velocity.axes |= 1UL << axes[i];
        command.as.velocity.speeds_ticks_per_s[axes[i]] =
            -robot_neuro.axes[axes[i]].speed_ticks_per_s / 2;
    }
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        starts[i] = rig_position(&rig, i);
    }
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, run(command).kind);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const int64_t speed = -(int64_t)command.as.velocity.speeds_ticks_per_s[i];
        const int64_t way = ((speed * 1500) / 1000) -
                            ((speed * speed) / robot_neuro.axes[i].acceleration_ticks_per_s2);
        TEST_ASSERT_INT32_WITHIN(3, starts[i] - (int32_t)way, rig_position(&rig, i));
    }
}

void test_SWR_VEL_008_before_homing_it_goes_a_short_way_up_to_its_switch(void)
{
    answer_t answer = {.status = (uint32_t)STATUS_JOG_TOO_FAR};
    uint32_t runs = 0U;
    rig_start_needle_homed(&rig);
    while (answer.status == (uint32_t)STATUS_JOG_TOO_FAR) {
        const double start = true_ticks(NEURO_AXIS_LATERAL);
        answer = run(speed_of(NEURO_AXIS_LATERAL, 472, 10000));
        TEST_ASSERT_TRUE((true_ticks(NEURO_AXIS_LATERAL) - start) <= 95.0);
        runs++;
        TEST_ASSERT_LESS_THAN_UINT32(20U, runs);
    }
    TEST_ASSERT_GREATER_THAN_UINT32(5U, runs);
    TEST_ASSERT_EQUAL_UINT32(STATUS_SWITCH_ZONE, answer.status);
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].limit_switches);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ORDER_OVERDUE));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_FOLLOWING_ERROR));
}

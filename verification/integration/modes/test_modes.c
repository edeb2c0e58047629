/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rules that every mode has in common: trouble of an axis ends what is armed, and after that the
 * axes that have none go on, but for what needs them all.
 */
#include "unity.h"

#include "integration/support/rig.h"
#include "robot/robot_neuro.h"
#include "safety/needle.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
}

static command_t jog(uint32_t axis, int32_t ticks)
{
    const command_t command = {.kind = (uint32_t)COMMAND_JOG,
                               .as.jog = {.axis = axis, .to_ticks = ticks}};
    return command;
}

/* In MANUAL, with the pitch axis stuck on its way. */
static void stall_pitch(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog(NEURO_AXIS_PITCH, -200)).status);
    rig_box(&rig, "motor pitch stuck");
    rig_press(&rig);
    const answer_t answer = rig_finish(&rig, 5000U);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_PITCH, answer_axis(&answer));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[NEURO_AXIS_PITCH].power);
    rig_release(&rig);
}

void test_SWR_MODE_003_after_a_stall_of_one_axis_another_one_jogs_and_homes(void)
{
    stall_pitch();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog(NEURO_AXIS_YAW, -200)).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    TEST_ASSERT_EQUAL_INT32(-200, rig_position(&rig, NEURO_AXIS_YAW));
    rig_release(&rig);
    const command_t home = {.kind = (uint32_t)COMMAND_HOME_AXIS,
                            .as.axis = {.axis = NEURO_AXIS_YAW}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, home).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
}

void test_SWR_MODE_002_the_axis_that_has_stalled_and_what_needs_all_are_refused(void)
{
    stall_pitch();
    TEST_ASSERT_EQUAL_UINT32(
        STATUS_FAULT_PRESENT,
        rig_command(&rig, jog(NEURO_AXIS_PITCH, rig_position(&rig, NEURO_AXIS_PITCH))).status);
    rig_box(&rig, "card yaw silent");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT,
                             rig_command(&rig, jog(NEURO_AXIS_HEAD, -200)).status);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

void test_SWR_MODE_003_the_fault_of_another_axis_ends_what_is_armed(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog(NEURO_AXIS_YAW, -200)).status);
    rig_box(&rig, "motor pitch runs");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 5000U).kind);
}

void test_SWR_MODE_003_after_the_fault_of_another_axis_the_needle_is_drawn_out(void)
{
    const command_t retract = {.kind = (uint32_t)COMMAND_RETRACT};
    rig_start_moving(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    rig_box(&rig, "motor yaw runs");
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[NEURO_AXIS_YAW].power);
    rig_box(&rig, "motor yaw normal");
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, retract).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    TEST_ASSERT_LESS_OR_EQUAL_INT32(needle_retracted_ticks(&robot_neuro) +
                                        robot_neuro.axes[NEURO_AXIS_INSERTION].deadband_ticks,
                                    rig_position(&rig, NEURO_AXIS_INSERTION));
}

static const snapshot_t *shown(void)
{
    return &rig.outputs.snapshot;
}

void test_SWR_MODE_006_what_is_armed_is_shown_and_how_far_it_has_come(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(MODE_NONE, shown()->mode);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog(NEURO_AXIS_YAW, -400)).status);
    TEST_ASSERT_EQUAL_UINT32(MODE_JOG, shown()->mode);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->done_per_mille);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->left_ms);
    rig_press(&rig);
    uint32_t done = 0U;
    uint32_t left = UINT32_MAX;
    while (shown()->order == (uint32_t)ARMING_STATE_MOVING) {
        TEST_ASSERT_GREATER_OR_EQUAL_UINT32(done, shown()->done_per_mille);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(left, shown()->left_ms);
        done = shown()->done_per_mille;
        left = shown()->left_ms;
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(1000U, done);
    TEST_ASSERT_EQUAL_UINT32(0U, left);
    TEST_ASSERT_EQUAL_UINT32(MODE_NONE, shown()->mode);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->done_per_mille);
}

void test_SWR_MODE_006_the_time_left_is_that_of_the_set_points(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog(NEURO_AXIS_YAW, -400)).status);
    rig_press(&rig);
    const uint32_t left = shown()->left_ms;
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, left);
    rig_cycles(&rig, left - 1U);
    TEST_ASSERT_EQUAL_UINT32(1U, shown()->left_ms);
    TEST_ASSERT_LESS_THAN_UINT32(1000U, shown()->done_per_mille);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1000U, shown()->done_per_mille);
}

void test_SWR_MODE_006_homing_shows_how_many_axes_are_homed(void)
{
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    uint32_t homed = 0U;
    while (shown()->order == (uint32_t)ARMING_STATE_MOVING) {
        homed = 0U;
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            homed += axis_is_homed(&rig.controller.axes[i]) ? 1U : 0U;
        }
        TEST_ASSERT_EQUAL_UINT32(MODE_HOMING, shown()->mode);
        TEST_ASSERT_EQUAL_UINT32((1000U * homed) / robot_neuro.axis_count, shown()->done_per_mille);
        rig_cycle(&rig);
    }
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, homed);
}

static command_t speed(int32_t ticks_per_s, int32_t bound)
{
    command_t command = {.kind = (uint32_t)COMMAND_VELOCITY,
                         .as.velocity = {.axes = 1UL << NEURO_AXIS_YAW,
                                         .time_ms = (bound > 0) ? (uint32_t)bound : 0U,
                                         .way_ticks = (bound < 0) ? (uint32_t)-bound : 0U}};
    command.as.velocity.speeds_ticks_per_s[NEURO_AXIS_YAW] = ticks_per_s;
    return command;
}

/* Lasts `span_ms`; to its last cycle. */
static void expect_speed_shown(command_t command, uint32_t span_ms)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(0U, shown()->left_ms);
    rig_press(&rig);
    TEST_ASSERT_UINT32_WITHIN(6U, span_ms, shown()->left_ms); /* The pedal closes in four. */
    uint32_t done = 0U;
    uint32_t left = span_ms;
    while (shown()->order == (uint32_t)ARMING_STATE_MOVING) {
        TEST_ASSERT_EQUAL_UINT32(MODE_VELOCITY, shown()->mode);
        TEST_ASSERT_GREATER_OR_EQUAL_UINT32(done, shown()->done_per_mille);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(left, shown()->left_ms);
        TEST_ASSERT_UINT32_WITHIN(1U, ((span_ms - shown()->left_ms) * 1000U) / span_ms,
                                  shown()->done_per_mille);
        done = shown()->done_per_mille;
        left = shown()->left_ms;
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(1000U, done);
    TEST_ASSERT_EQUAL_UINT32(0U, left);
    rig_release(&rig);
}

void test_SWR_MODE_006_of_a_speed_its_time_or_its_way_is_shown(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    expect_speed_shown(speed(-400, 1500), 1500U);
    expect_speed_shown(speed(-833, -600), 720U);
    expect_speed_shown(speed(400, -200), 500U);
}

/* The event `id` names the motion. */
static void expect_named(event_id_t id, mode_kind_t kind, int32_t value)
{
    uint32_t found = 0U;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if (rig.events[i].id == (uint32_t)id) {
            TEST_ASSERT_EQUAL_UINT32(kind, rig.events[i].subject);
            TEST_ASSERT_EQUAL_INT32(value, rig.events[i].value);
            found++;
        }
    }
    TEST_ASSERT_EQUAL_UINT32(1U, found);
    rig_forget(&rig);
}

void test_SWR_FLOW_001_what_is_armed_and_done_is_named(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    expect_named(EVENT_ORDER_ARMED, MODE_HOMING, WORKPHASE_START_UP);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 120000U).kind);
    rig_release(&rig);
    expect_named(EVENT_ORDER_DONE, MODE_HOMING, 0);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog(NEURO_AXIS_YAW, -400)).status);
    expect_named(EVENT_ORDER_ARMED, MODE_JOG, WORKPHASE_MANUAL);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    expect_named(EVENT_ORDER_DONE, MODE_JOG, 0);
}

void test_SWR_FLOW_001_of_two_motions_the_one_that_gives_way_and_the_new_one_are_named(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    (void)rig_command(&rig, jog(NEURO_AXIS_YAW, -400));
    rig_forget(&rig);
    (void)rig_command(&rig, speed(-400, 1500));
    TEST_ASSERT_EQUAL_UINT32(2U, rig.event_count);
    TEST_ASSERT_EQUAL_UINT32(EVENT_ORDER_DISCARDED, rig.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(MODE_JOG, rig.events[0].subject);
    rig.events[0] = rig.events[1];
    rig.event_count = 1U;
    expect_named(EVENT_ORDER_ARMED, MODE_VELOCITY, WORKPHASE_MANUAL);
    rig_let_expire(&rig);
    expect_named(EVENT_ORDER_EXPIRED, MODE_VELOCITY, 0);
}

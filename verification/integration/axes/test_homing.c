/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * START_UP on the simulated box: homing finds every reference, or ends in a named fault.
 * In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "controller/cycle/controller_drive.h"
#include "controller/controller_facts.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

#include <stdio.h>

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_PHASE_003_start_up_homes_every_axis_while_the_pedal_is_down(void)
{
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_workphase(&rig, WORKPHASE_START_UP).kind);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.answers[0].is_final);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count - 2U, rig_count(&rig, EVENT_AXIS_HOMED));
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_AXIS_TAKEN));
    double true_ticks[ROBOT_AXIS_MAX];
    box_true_positions(&rig.box, true_ticks);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 0.0, true_ticks[NEURO_AXIS_HEAD]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 0.0, true_ticks[NEURO_AXIS_LATERAL]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 516.0, true_ticks[NEURO_AXIS_PITCH]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 8.0, true_ticks[NEURO_AXIS_YAW]);
    TEST_ASSERT_DOUBLE_WITHIN(30.0, 0.0, true_ticks[NEURO_AXIS_INSERTION]);
}

void test_SWR_AXIS_002_the_needle_homes_before_the_other_axes_move(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    while (rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].reference !=
           (uint32_t)AXIS_REFERENCE_VERIFIED) {
        TEST_ASSERT_EQUAL_INT32(0, rig_position(&rig, NEURO_AXIS_HEAD));
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(40000U, rig.controller.sealed.cycle);
    }
}

/* At its target, `axis` was out of sight for a while and is to be homed again. */
static void lose_at_target(uint32_t axis)
{
    char order[32];
    rig_start_arrived(&rig);
    (void)snprintf(order, sizeof order, "card %s silent", robot_neuro.axes[axis].name);
    rig_box(&rig, order);
    rig_cycles(&rig, 200U);
    (void)snprintf(order, sizeof order, "card %s normal", robot_neuro.axes[axis].name);
    rig_box(&rig, order);
    rig_cycles(&rig, 50U);
}

void test_SWR_JOG_016_the_needle_leaves_before_the_base_homes(void)
{
    static const uint32_t lost[] = {NEURO_AXIS_LATERAL, NEURO_AXIS_PITCH, NEURO_AXIS_YAW};
    const double *const needle = &rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks;
    for (uint32_t i = 0U; i < SCENES(sizeof lost / sizeof lost[0]); i++) {
        const double *const place = &rig.box.axes[lost[i]].motor.position_ticks;
        lose_at_target(lost[i]);
        const double start = *place;
        TEST_ASSERT_TRUE(*needle > 10000.0);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
        rig_press(&rig);
        while (*needle > 3000.0) {
            rig_cycle(&rig);
            TEST_ASSERT_DOUBLE_WITHIN(0.5, start, *place);
            TEST_ASSERT_EQUAL(CARD_DRIVE_OFF, rig_sent(&rig, lost[i]).drive.mode);
            TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.sealed.cycle);
        }
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
        TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED,
                                 rig.outputs.snapshot.axes[lost[i]].reference);
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_HOMING_BARRED));
    }
}

/* Homed, the head would open the carriages too far; but who sees it may say that it stands there.
 */
void test_SWR_COUPLE_003_a_barred_axis_in_doubt_may_be_confirmed(void)
{
    const command_t jog = {.kind = COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_FEET, .to_ticks = -2000}};
    const command_t follow = {.kind = COMMAND_JOG,
                              .as.jog = {.axis = NEURO_AXIS_HEAD, .to_ticks = -2000}};
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    for (uint32_t i = 0U; i < 2U; i++) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, (i == 0U) ? follow : jog).status);
        rig_release(&rig);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    }
    rig_release(&rig);
    rig_box(&rig, "card head silent");
    rig_cycles(&rig, 200U);
    rig_box(&rig, "card head normal");
    rig_cycles(&rig, 200U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].reference);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_CONFIRM, rig.outputs.snapshot.next_step);
    rig_box(&rig, "button press");
    rig_cycles(&rig, (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 100U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].reference);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
}

/* For every caller the permit allows no drive across a needle that is in. */
void test_SWR_JOG_016_the_permit_drives_nothing_across_a_needle_that_is_in(void)
{
    const cycle_t cycle = {.robot = &rig.robot, .inputs = &rig.inputs, .outputs = &rig.outputs};
    card_drive_t requests[ROBOT_AXIS_MAX] = {{0}};
    lose_at_target(NEURO_AXIS_LATERAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    requests[NEURO_AXIS_LATERAL].mode = CARD_DRIVE_NON_PWM;
    requests[NEURO_AXIS_INSERTION] = rig_sent(&rig, NEURO_AXIS_INSERTION).drive;
    TEST_ASSERT_NOT_EQUAL(CARD_DRIVE_OFF, requests[NEURO_AXIS_INSERTION].mode);
    controller_drive(&rig.controller, &cycle, controller_facts(&rig.controller, &cycle), requests);
    TEST_ASSERT_EQUAL_HEX32(1UL << PERMIT_REASON_NEEDLE_IN,
                            rig.controller.records[NEURO_AXIS_LATERAL].sealed.reason_hold.shown);
    TEST_ASSERT_EQUAL(CARD_DRIVE_OFF, rig_sent(&rig, NEURO_AXIS_LATERAL).drive.mode);
    TEST_ASSERT_NOT_EQUAL(CARD_DRIVE_OFF, rig_sent(&rig, NEURO_AXIS_INSERTION).drive.mode);
}

void test_SWR_PHASE_003_start_up_again_when_homed_ends_at_once(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.outputs.answers[1].kind);
}

void test_SWR_AXIS_003_homing_that_finds_no_switch_gives_up(void)
{
    rig_start(&rig);
    rig_box(&rig, "motor insertion stuck");
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 31000U).kind);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST,
                             rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].reference);
}

/* START_UP with the pedal held, until it ends. @return the farthest forward way of the needle */
static double needle_way_in_start_up(answer_kind_t expected)
{
    const double *const needle = &rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks;
    const double start = *needle;
    double most = 0.0;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_box(&rig, "pedal press");
    const uint32_t before = rig.answer_count;
    while (rig.answer_count == before) {
        rig_cycle(&rig);
        most = ((*needle - start) > most) ? (*needle - start) : most;
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.sealed.cycle);
    }
    TEST_ASSERT_EQUAL_UINT32(expected, rig.answers[before % RIG_ANSWERS].kind);
    rig_release(&rig);
    return most;
}

#define NEEDLE_WAY_TICKS 667.0 /* 0.2 mm */

/* The needle stands at 18 mm and its card was lost. */
static void lose_deep_needle(void)
{
    rig_start_homed(&rig);
    rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks = 60000.0;
    rig.box.axes[NEURO_AXIS_INSERTION].encoder.state = 60000;
    rig_box(&rig, "card insertion silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES);
    rig_box(&rig, "card insertion normal");
    rig_cycles(&rig, 20U);
    rig_forget(&rig);
}

void test_SWR_AXIS_013_a_switch_that_stays_active_drives_no_needle_forwards(void)
{
    lose_deep_needle();
    rig_box(&rig, "switch insertion stuck");
    const double way = needle_way_in_start_up(ANSWER_ABORTED);
    TEST_ASSERT_TRUE(way <= NEEDLE_WAY_TICKS + 5.0);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_FAULT));
    rig_expect_nothing_known(&rig, NEURO_AXIS_INSERTION);
    TEST_ASSERT_TRUE(needle_way_in_start_up(ANSWER_ABORTED) <= 5.0);
}

void test_SWR_AXIS_013_a_reversed_switch_drives_no_needle_forwards(void)
{
    lose_deep_needle();
    rig_box(&rig, "switch insertion reversed");
    TEST_ASSERT_TRUE(needle_way_in_start_up(ANSWER_ABORTED) <= NEEDLE_WAY_TICKS + 5.0);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_FAULT));
}

void test_SWR_AXIS_014_a_chattering_switch_homes_nowhere(void)
{
    for (uint32_t seed = 1U; seed <= SCENES(50U); seed++) {
        lose_deep_needle();
        rig.box.axes[NEURO_AXIS_INSERTION].limit_switch.random.state = seed;
        rig_box(&rig, "switch insertion chatter");
        TEST_ASSERT_TRUE(needle_way_in_start_up(ANSWER_ABORTED) <= NEEDLE_WAY_TICKS + 5.0);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_FAULT));
    }
}

void test_SWR_AXIS_003_a_switch_that_never_acts_ends_in_a_fault_at_the_stop(void)
{
    rig_start(&rig);
    rig_box(&rig, "switch insertion open");
    (void)needle_way_in_start_up(ANSWER_ABORTED);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_NO_COUNTS));
}

void test_SWR_AXIS_015_a_reversed_encoder_is_found_in_the_first_leg_of_homing(void)
{
    static const char *const reversed[] = {"encoder head reversed", "encoder lateral reversed",
                                           "encoder insertion reversed", "encoder pitch reversed",
                                           "encoder yaw reversed"};
    for (uint32_t i = 0U; i < (sizeof reversed / sizeof reversed[0]); i++) {
        rig_start(&rig);
        rig_box(&rig, reversed[i]);
        (void)rig_workphase(&rig, WORKPHASE_START_UP);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 40000U).kind);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_WRONG_WAY));
    }
}

void test_SWR_AXIS_013_every_axis_homes_from_both_ends(void)
{
    double true_ticks[ROBOT_AXIS_MAX];
    for (uint32_t end = 0U; end < SCENES(2U); end++) {
        rig_start(&rig);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            sim_motor_t *const motor = &rig.box.axes[i].motor;
            if (robot_neuro.axes[i].limit_switch != (uint8_t)LIMIT_SWITCH_NONE) {
                motor->position_ticks = (end == 0U) ? motor->lowest_ticks : motor->highest_ticks;
                rig.box.axes[i].encoder.state = (int32_t)motor->position_ticks;
            }
        }
        rig_cycles(&rig, 20U);
        (void)rig_workphase(&rig, WORKPHASE_START_UP);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 200000U).kind);
        box_true_positions(&rig.box, true_ticks);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            if (robot_neuro.axes[i].limit_switch != (uint8_t)LIMIT_SWITCH_NONE) {
                TEST_ASSERT_DOUBLE_WITHIN(20.0, (double)rig_position(&rig, i), true_ticks[i]);
            }
        }
        rig_release(&rig);
    }
}

/* The axis counts, but not what its motor makes of the order. */
static void move_uncounted(uint32_t axis, double ticks)
{
    rig.box.axes[axis].motor.position_ticks += ticks;
    rig.box.axes[axis].encoder.state += (int32_t)ticks;
}

static void lose_needle(void)
{
    rig_box(&rig, "card insertion silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES);
    rig_box(&rig, "card insertion normal");
    rig_cycles(&rig, 20U);
    rig_forget(&rig);
}

static void jog_to(uint32_t axis, int32_t ticks)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = axis, .to_ticks = ticks}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    rig_release(&rig);
}

static axis_reference_t needle_grade(void)
{
    return (axis_reference_t)rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].reference;
}

static void cycle_while(axis_reference_t leg)
{
    while (needle_grade() == leg) {
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.sealed.cycle);
        rig_cycle(&rig);
    }
}

/* At `place`, far from home, the switch of the needle acts as if it were there: twice alike. */
static void home_at_impostor(double place)
{
    const double *const needle = &rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks;
    rig_start_homed(&rig);
    jog_to(NEURO_AXIS_INSERTION, 20000);
    lose_needle();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    while (*needle > place) {
        rig_cycle(&rig);
    }
    rig_box(&rig, "switch insertion stuck");
    cycle_while(AXIS_REFERENCE_APPROACH);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_BACK_OFF, needle_grade());
    rig_cycles(&rig, 10U);
    rig_box(&rig, "switch insertion normal");
    cycle_while(AXIS_REFERENCE_BACK_OFF);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LATCH, needle_grade());
    while (*needle > place) {
        rig_cycle(&rig);
    }
    rig_box(&rig, "switch insertion stuck");
    cycle_while(AXIS_REFERENCE_LATCH);
    rig_box(&rig, "switch insertion normal");
    rig_release(&rig);
}

static void expect_elsewhere(uint32_t axis, int32_t ticks, int32_t within)
{
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_ELSEWHERE));
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if (rig.events[i].id == (uint32_t)EVENT_AXIS_SWITCH_ELSEWHERE) {
            TEST_ASSERT_EQUAL_UINT32(axis, rig.events[i].subject);
            TEST_ASSERT_INT32_WITHIN(within, ticks, rig.events[i].value);
        }
    }
    rig_expect_nothing_known(&rig, axis);
}

static void expect_needle_where_shown(void)
{
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, needle_grade());
    TEST_ASSERT_DOUBLE_WITHIN(60.0, (double)rig_position(&rig, NEURO_AXIS_INSERTION),
                              rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks);
}

void test_SWR_AXIS_026_a_switch_that_poses_as_another_twice_is_not_believed(void)
{
    home_at_impostor(15000.0);
    expect_elsewhere(NEURO_AXIS_INSERTION, 15000, 100);
    rig_cycles(&rig, 500U); /* It comes to rest. */
    TEST_ASSERT_EQUAL_INT32(NEXT_STEP_COMPARE, rig.outputs.snapshot.next_step);
}

void test_SWR_AXIS_026_homing_at_the_true_switch_heals_a_contradiction(void)
{
    home_at_impostor(15000.0);
    rig_home(&rig);
    expect_needle_where_shown();
}

static void hold_button(void)
{
    rig_box(&rig, "button press");
    rig_cycles(&rig, 2U + (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US));
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
}

/* The switch is right, and the counts are wrong by 3 mm. */
void test_SWR_AXIS_026_what_the_counts_contradict_for_good_the_operator_decides(void)
{
    rig_start_homed(&rig);
    jog_to(NEURO_AXIS_INSERTION, 20000);
    move_uncounted(NEURO_AXIS_INSERTION, 10000.0);
    lose_needle();
    for (uint32_t i = 0U; i < 2U; i++) {
        rig_forget(&rig);
        TEST_ASSERT_TRUE(needle_way_in_start_up(ANSWER_ABORTED) <= NEEDLE_WAY_TICKS + 5.0);
        expect_elsewhere(NEURO_AXIS_INSERTION, -10000, 100);
    }
    rig_cycles(&rig, LIMIT_SPEED_TIMEOUT_US / LIMIT_CYCLE_US);
    hold_button();
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_CONFIRMED));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    expect_needle_where_shown();
}

void test_SWR_AXIS_025_a_switch_that_is_active_far_from_home_is_a_fault_at_once(void)
{
    rig_start_homed(&rig);
    jog_to(NEURO_AXIS_LATERAL, -500);
    rig_box(&rig, "switch lateral stuck");
    rig_cycles(&rig, 20U);
    expect_elsewhere(NEURO_AXIS_LATERAL, -500, 1);
    TEST_ASSERT_EQUAL_HEX32(0U, rig_sent(&rig, NEURO_AXIS_LATERAL).control);
}

/* The counts have it beyond home, where the switch must have acted. */
void test_SWR_AXIS_025_a_switch_that_is_free_beyond_home_is_a_fault(void)
{
    axis_t *const lateral = &rig.controller.axes[NEURO_AXIS_LATERAL];
    rig_start_homed(&rig);
    jog_to(NEURO_AXIS_LATERAL, -500);
    encoder_set_position(&lateral->sealed.encoder, 30);
    supervision_shift(&lateral->supervision, 530);
    drift_audit_settle(&lateral->sealed.drift);
    controller_seal(&rig.controller);
    rig_cycle(&rig);
    expect_elsewhere(NEURO_AXIS_LATERAL, 30, 1);
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Motion and its interlocks, on the simulated box: the pedal, the e-stop, links, faults, expiry.
 * In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "rig.h"

#include "unity.h"

#include "contract_trap.h"
#include "controller.h"
#include "permit.h"
#include "requirement_limits.h"

#include <stdio.h>
#include <string.h>

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void begin_move(void)
{
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    rig_cycles(&rig, 400U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

static int32_t position(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].position_ticks;
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
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_COUNT - 2U, rig_count(&rig, EVENT_AXIS_HOMED));
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_AXIS_TAKEN));
    double true_ticks[ROBOT_AXIS_COUNT];
    box_true_positions(&rig.box, true_ticks);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 0.0, true_ticks[AXIS_HEAD]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 0.0, true_ticks[AXIS_LATERAL]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 516.0, true_ticks[AXIS_PITCH]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 8.0, true_ticks[AXIS_YAW]);
    TEST_ASSERT_DOUBLE_WITHIN(30.0, 0.0, true_ticks[AXIS_INSERTION]);
}

void test_SWR_AXIS_002_the_needle_homes_before_the_other_axes_move(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    while (rig.outputs.snapshot.axes[AXIS_INSERTION].reference !=
           (uint32_t)AXIS_REFERENCE_VERIFIED) {
        TEST_ASSERT_EQUAL_INT32(0, position(AXIS_HEAD));
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(40000U, rig.controller.cycle);
    }
}

void test_SWR_PHASE_003_start_up_again_when_homed_ends_at_once(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.outputs.answers[1].kind);
}

void test_SWR_PEDAL_001_nothing_is_driven_before_the_pedal_is_pressed(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    for (uint32_t i = 0U; i < 2000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PRESS_PEDAL, rig.outputs.snapshot.next_step);
}

void test_SWR_PEDAL_002_release_zeroes_every_drive_word_in_the_same_cycle(void)
{
    begin_move();
    rig_box(&rig, "pedal a open");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.inputs.pedal_a);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_PEDAL_003_a_pedal_held_while_arming_does_not_start_the_move(void)
{
    rig_start_targeted(&rig);
    rig_press(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    for (uint32_t i = 0U; i < 1000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 200U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_PEDAL_005_pressing_again_continues_from_the_actual_position_from_rest(void)
{
    begin_move();
    rig_release(&rig);
    rig_cycles(&rig, 100U);
    const int32_t held = position(AXIS_HEAD);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_INT32(held, position(AXIS_HEAD));
    rig_box(&rig, "pedal press");
    while (rig.outputs.snapshot.order != (uint32_t)WORKPHASES_ORDER_MOVING) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_INT32_WITHIN(1, held, rig.outputs.snapshot.axes[AXIS_HEAD].setpoint_ticks);
    const int32_t limit_q8 = (robot_neuro.axes[AXIS_HEAD].acceleration_ticks_per_s2 * 256) / 500;
    TEST_ASSERT_INT32_WITHIN(limit_q8, 0,
                             rig.outputs.snapshot.axes[AXIS_HEAD].setpoint_speed_ticks_per_s_q8);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
}

void test_SWR_PEDAL_006_sixty_seconds_without_the_pedal_discard_the_move(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_forget(&rig);
    rig_cycles(&rig, (LIMIT_ARMED_HOLD_US / 1000U) - 2U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.answer_count);
    const answer_t answer = rig_finish(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_EXPIRED, answer.status);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_PEDAL_004_disagreeing_channels_stop_the_move_and_latch_a_fault(void)
{
    begin_move();
    rig_box(&rig, "pedal b open");
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_finish(&rig, 120U).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PEDAL_FAULT));
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_PEDAL_FAULT,
                          rig.outputs.snapshot.axes[0].permit_reasons);
}

void test_SWR_PEDAL_007_a_pedal_fault_is_cleared_by_start_up_with_the_pedal_released(void)
{
    begin_move();
    rig_box(&rig, "pedal b open");
    rig_cycles(&rig, 200U);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_release(&rig);
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_PEDAL_FAULT,
                          rig.outputs.snapshot.axes[0].permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_BITS_LOW(1UL << PERMIT_REASON_PEDAL_FAULT,
                         rig.outputs.snapshot.axes[0].permit_reasons);
}

void test_SWR_ESTOP_001_the_e_stop_zeroes_every_drive_word_in_the_same_cycle(void)
{
    begin_move();
    rig_box(&rig, "estop pull");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.inputs.estop_open);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_ESTOP_002_the_e_stop_stays_latched_until_start_up(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 5U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_ESTOP, rig.outputs.snapshot.next_step);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_ESTOP_LATCHED,
                          rig.outputs.snapshot.axes[0].permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_CLEAR, rig.outputs.snapshot.estop);
}

void test_SWR_ESTOP_003_the_e_stop_disables_the_axes_and_discards_the_move(void)
{
    begin_move();
    rig_forget(&rig);
    rig_box(&rig, "estop pull");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 3U).kind);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, rig.outputs.snapshot.workphase);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASES_ORDER_NONE, rig.outputs.snapshot.order);
    for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, rig.outputs.snapshot.axes[i].power);
    }
    rig_box(&rig, "estop reset");
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_LINK_001_a_silent_card_stops_every_axis_in_the_fifth_cycle(void)
{
    begin_move();
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES - 1U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_CHECK_CARDS, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
}

void test_SWR_LINK_002_a_corrupt_card_is_refused_and_lost(void)
{
    begin_move();
    rig_box(&rig, "card lateral corrupt");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_LINK_AGE_CYCLES, rig_count(&rig, EVENT_FRAME_REFUSED));
}

void test_SWR_IGTL_014_the_pose_is_known_only_while_every_axis_is_homed_and_registered(void)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    rigid_t identity;
    rigid_set_identity(&identity);
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_HOMED, shown->pose_status);
    rig_start_homed(&rig);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_REGISTERED, shown->pose_status);
    rig_register(&rig, &identity);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, shown->pose_status);
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES + 2U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_HOMED, shown->pose_status);
}

void test_SWR_LINK_003_a_lost_card_returns_only_by_start_up_and_is_homed_again(void)
{
    begin_move();
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, 30U);
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_box(&rig, "card lateral normal");
    rig_cycles(&rig, 30U);
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_LINK_LOST,
                          rig.outputs.snapshot.axes[0].permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST,
                             rig.outputs.snapshot.axes[AXIS_LATERAL].reference);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED,
                             rig.outputs.snapshot.axes[AXIS_HEAD].reference);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
}

void test_SWR_STALL_001_a_blocked_motor_stalls_and_needs_start_up(void)
{
    begin_move();
    rig_box(&rig, "motor head stuck");
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_finish(&rig, 700U).status);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[AXIS_HEAD].power);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_release(&rig);
    rig_box(&rig, "motor head normal");
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_ENABLED, rig.outputs.snapshot.axes[AXIS_HEAD].power);
}

/* The axis has just faulted; what it stands at is not known any more. */
static void expect_nothing_known(uint32_t axis)
{
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[axis].power);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, rig.outputs.snapshot.axes[axis].reference);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
}

void test_SWR_AXIS_012_after_an_encoder_was_gone_in_a_move_the_axis_homes_anew(void)
{
    double true_ticks[ROBOT_AXIS_COUNT];
    begin_move();
    rig_box(&rig, "encoder head stuck");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 700U).kind);
    rig_box(&rig, "encoder head normal");
    expect_nothing_known(AXIS_HEAD);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_workphase(&rig, WORKPHASE_START_UP).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.answer_count);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
    box_true_positions(&rig.box, true_ticks);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, (double)position(AXIS_HEAD), true_ticks[AXIS_HEAD]);
}

void test_SWR_AXIS_012_a_stall_loses_reference_and_target(void)
{
    begin_move();
    rig_box(&rig, "motor head stuck");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 700U).kind);
    expect_nothing_known(AXIS_HEAD);
}

static void begin_jog(uint32_t axis, int32_t ticks)
{
    const command_t jog = {.kind = COMMAND_JOG, .argument = axis, .value = ticks};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_release(&rig);
    rig_press(&rig);
}

/* Its counts go forth and back: the motor seems to turn, and gets nowhere. */
void test_SWR_STALL_003_an_axis_that_trembles_in_place_stalls_and_is_reported_once(void)
{
    sim_motor_t *const motor = &rig.box.axes[AXIS_INSERTION].motor;
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    begin_jog(AXIS_INSERTION, 1000);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    const int32_t place = position(AXIS_INSERTION);
    begin_jog(AXIS_INSERTION, place + 12);
    for (uint32_t i = 0U; i < 2000U; i++) {
        motor->asymmetry = (position(AXIS_INSERTION) > place) ? -1.2 : -0.5;
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_STALLED));
    expect_nothing_known(AXIS_INSERTION);
}

void test_SWR_AXIS_018_a_cut_encoder_is_reported_exactly_once(void)
{
    begin_move();
    rig_box(&rig, "encoder head stuck");
    rig_forget(&rig);
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_NO_COUNTS));
}

void test_SWR_AXIS_009_an_axis_that_runs_the_wrong_way_is_stopped(void)
{
    begin_move();
    rig_box(&rig, "encoder head reversed");
    rig_forget(&rig);
    rig_cycles(&rig, 600U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[AXIS_HEAD].power);
}

void test_SWR_AXIS_003_homing_that_finds_no_switch_gives_up(void)
{
    rig_start(&rig);
    rig_box(&rig, "motor insertion stuck");
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 31000U).kind);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST,
                             rig.outputs.snapshot.axes[AXIS_INSERTION].reference);
}

/* START_UP with the pedal held, until it ends. @return the farthest forward way of the needle */
static double needle_way_in_start_up(answer_kind_t expected)
{
    const double *const needle = &rig.box.axes[AXIS_INSERTION].motor.position_ticks;
    const double start = *needle;
    double most = 0.0;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_box(&rig, "pedal press");
    const uint32_t before = rig.answer_count;
    while (rig.answer_count == before) {
        rig_cycle(&rig);
        most = ((*needle - start) > most) ? (*needle - start) : most;
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.cycle);
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
    rig.box.axes[AXIS_INSERTION].motor.position_ticks = 60000.0;
    rig.box.axes[AXIS_INSERTION].encoder.state = 60000;
    rig_box(&rig, "card insertion silent");
    rig_cycles(&rig, 20U);
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
    expect_nothing_known(AXIS_INSERTION);
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
    for (uint32_t seed = 1U; seed <= 50U; seed++) {
        lose_deep_needle();
        rig.box.axes[AXIS_INSERTION].limit_switch.random.state = seed;
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
    double true_ticks[ROBOT_AXIS_COUNT];
    for (uint32_t end = 0U; end < 2U; end++) {
        rig_start(&rig);
        for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
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
        for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
            if (robot_neuro.axes[i].limit_switch != (uint8_t)LIMIT_SWITCH_NONE) {
                TEST_ASSERT_DOUBLE_WITHIN(20.0, (double)position(i), true_ticks[i]);
            }
        }
        rig_release(&rig);
    }
}

/* Way of `axis` in 0.1 mm or 0.5 degrees. */
static double rest_ways(uint32_t axis, double ticks)
{
    const axis_config_t *const config = &robot_neuro.axes[axis];
    const bool is_mm = config->unit == (uint8_t)AXIS_UNIT_MM;
    const double way = ticks * (double)config->unit_per_tick_q16 / 65536.0;
    return way / (is_mm ? (double)LIMIT_REST_WAY_NM : (double)LIMIT_REST_WAY_BAM);
}

/* The motor of `axis` runs by itself. @return cycles from when it had moved too far to the fault */
static uint32_t cycles_to_notice(uint32_t axis)
{
    const double *const at = &rig.box.axes[axis].motor.position_ticks;
    const double start = *at;
    uint32_t late = 0U;
    rig.box.axes[axis].motor.fault = SIM_MOTOR_RUNS;
    while (rig_count(&rig, EVENT_AXIS_MOVED_OFF) == 0U) {
        rig_cycle(&rig);
        late += (rest_ways(axis, *at - start) >= 1.0) ? 1U : 0U;
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.cycle);
    }
    return late;
}

void test_SWR_AXIS_016_a_motor_that_runs_while_off_is_noticed_on_every_axis(void)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
        rig_start_targeted(&rig);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(LIMIT_REST_NOTICE_US / LIMIT_CYCLE_US,
                                         cycles_to_notice(i));
        expect_nothing_known(i);
        TEST_ASSERT_EQUAL_HEX32(0U, rig_sent(&rig, i).control);
    }
}

void test_SWR_AXIS_016_a_motor_that_runs_on_after_the_release_is_noticed(void)
{
    begin_move();
    rig_release(&rig);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(20U, cycles_to_notice(AXIS_FEET));
    expect_nothing_known(AXIS_FEET);
}

void test_SWR_AXIS_017_a_card_that_is_told_nothing_more_switches_off_where_it_may_not_be(void)
{
    begin_move();
    const card_command_t sent = rig_sent(&rig, AXIS_HEAD);
    const uint32_t width = (uint32_t)sent.guard_maximum_ticks - (uint32_t)sent.guard_minimum_ticks;
    const uint32_t most = 2U * (uint32_t)robot_neuro.axes[AXIS_HEAD].following_error_ticks;
    TEST_ASSERT_LESS_THAN_UINT32(most + most, width);
    rig_cycles(&rig, 5U);
    rig.box.axes[AXIS_HEAD].encoder.count += most;
    box_advance(&rig.box, 200U);
    TEST_ASSERT_BITS_HIGH(CARD_STATUS_GUARD, rig.box.axes[AXIS_HEAD].card.faults);
}

void test_SWR_AXIS_017_a_lost_card_gets_no_guard(void)
{
    rig_start(&rig);
    rig_box(&rig, "card head silent");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_INT32(rig_sent(&rig, AXIS_HEAD).guard_minimum_ticks,
                            rig_sent(&rig, AXIS_HEAD).guard_maximum_ticks);
}

/* `axis` is jogged and has run at its speed for a while. */
static void cruise(uint32_t axis)
{
    static const int32_t ends[ROBOT_AXIS_COUNT] = {-5000, 4000, -2000, 60000, 5000, -300, -1100};
    const command_t jog = {.kind = COMMAND_JOG, .argument = axis, .value = ends[axis]};
    const int32_t speed_q8 = robot_neuro.axes[axis].speed_ticks_per_s * 230;
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[axis];
    while ((shown->setpoint_speed_ticks_per_s_q8 < speed_q8) &&
           (shown->setpoint_speed_ticks_per_s_q8 > -speed_q8)) {
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.cycle);
    }
    rig_cycles(&rig, 100U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_forget(&rig);
}

/* A fault, its event, and the figures within which it must come. */
typedef struct {
    const char *part;
    const char *fault;
    event_id_t event;
    uint32_t most_ms;
    double most_ways[2]; /* For lines, 0.1 mm; for turns, 0.5 degrees. */
} blindness_t;

/* The fault's event, or the lag that it makes. */
static bool is_noticed(event_id_t event)
{
    return (rig_count(&rig, event) + rig_count(&rig, EVENT_AXIS_FOLLOWING_ERROR)) != 0U;
}

/* Time to the event, and how far true and believed position have gone apart. */
static void expect_notice(uint32_t axis, const blindness_t *fault)
{
    char order[48];
    const double *const at = &rig.box.axes[axis].motor.position_ticks;
    cruise(axis);
    const double start = *at - (double)position(axis);
    (void)snprintf(order, sizeof order, "%s %s %s", fault->part, robot_neuro.axes[axis].name,
                   fault->fault);
    rig_box(&rig, order);
    uint32_t cycles = 0U;
    while (!is_noticed(fault->event)) {
        rig_cycle(&rig);
        cycles++;
        TEST_ASSERT_LESS_OR_EQUAL_UINT32_MESSAGE(fault->most_ms, cycles, order);
    }
    rig_cycles(&rig, 200U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_WRONG_WAY) +
                                     rig_count(&rig, EVENT_AXIS_NO_COUNTS) +
                                     rig_count(&rig, EVENT_AXIS_FOLLOWING_ERROR) +
                                     rig_count(&rig, EVENT_AXIS_WRONG_SPEED));
    const double apart = rest_ways(axis, *at - (double)position(axis) - start);
    const double most = fault->most_ways[robot_neuro.axes[axis].unit];
    TEST_ASSERT_TRUE_MESSAGE((apart <= most) && (apart >= -most), order);
    expect_nothing_known(axis);
}

static void expect_notice_on_every_axis(blindness_t fault)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
        expect_notice(i, &fault);
    }
}

void test_SWR_AXIS_018_a_cut_encoder_is_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"encoder", "stuck", EVENT_AXIS_NO_COUNTS, 40U, {3.0, 5.0}});
}

void test_SWR_AXIS_018_a_blocked_shaft_is_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"motor", "stuck", EVENT_AXIS_NO_COUNTS, 40U, {0.4, 0.4}});
}

void test_SWR_AXIS_015_swapped_lines_are_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"encoder", "reversed", EVENT_AXIS_WRONG_WAY, 30U, {3.0, 5.0}});
}

void test_SWR_AXIS_019_half_the_counts_are_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"encoder", "half", EVENT_AXIS_WRONG_SPEED, 150U, {8.0, 18.0}});
}

void test_SWR_AXIS_019_a_motor_half_as_fast_is_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"motor", "half", EVENT_AXIS_WRONG_SPEED, 150U, {0.4, 0.4}});
}

void test_SWR_AXIS_019_a_motor_twice_as_fast_is_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"motor", "twice", EVENT_AXIS_WRONG_SPEED, 150U, {0.4, 0.4}});
}

/* Homing and a move to a target with motors that are `gain` times as fast as the table says. */
static void move_with_gain(double gain)
{
    rigid_t identity;
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    rigid_set_identity(&identity);
    rig_start(&rig);
    for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
        rig.box.axes[i].motor.full_speed_ticks_per_s *= gain;
    }
    rig_home(&rig);
    rig_register(&rig, &identity);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
}

void test_SWR_AXIS_019_motors_a_fifth_slower_or_faster_raise_no_alarm(void)
{
    move_with_gain(0.8);
    move_with_gain(1.2);
}

void test_SWR_MOTION_005_a_move_that_a_switch_blocks_is_discarded_by_name(void)
{
    command_t jog = {.kind = COMMAND_JOG, .argument = AXIS_LATERAL, .value = -500};
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    (void)rig_command(&rig, jog);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 10000U).kind);
    rig_release(&rig);
    rig_box(&rig, "switch lateral stuck");
    jog.value = -400;
    (void)rig_command(&rig, jog);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 7000U).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_OVERDUE));
    TEST_ASSERT_EQUAL_UINT32(AXIS_LATERAL, rig.events[rig.event_count - 2U].subject);
    TEST_ASSERT_INT32_WITHIN(2, 100, rig.events[rig.event_count - 2U].value);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_PERMIT_004_the_axes_rest_while_the_scanner_acquires(void)
{
    begin_move();
    rig_box(&rig, "scanner on");
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_SCANNER, rig.outputs.snapshot.next_step);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 300U);
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_SCANNER));
}

void test_SWR_PEDAL_003_after_a_scan_the_pedal_must_be_pressed_anew(void)
{
    begin_move();
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 50U);
    rig_box(&rig, "scanner off");
    for (uint32_t i = 0U; i < 500U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_PEDAL_003_a_channel_that_closes_during_a_scan_needs_a_fresh_release(void)
{
    begin_move();
    rig_release(&rig);
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 20U);
    rig_box(&rig, "pedal a close");
    rig_cycles(&rig, 20U);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 5U);
    rig_box(&rig, "pedal b close");
    for (uint32_t i = 0U; i < 200U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_ESTOP_004_an_e_stop_pulse_shorter_than_a_cycle_stops_and_latches(void)
{
    begin_move();
    rig_box(&rig, "estop pulse");
    box_advance(&rig.box, 500U);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, rig.outputs.snapshot.workphase);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, rig.outputs.snapshot.estop);
}

void test_SWR_ESTOP_004_a_release_of_the_pedal_shorter_than_a_cycle_is_a_release(void)
{
    begin_move();
    rig_forget(&rig);
    rig_box(&rig, "pedal pulse");
    box_advance(&rig.box, 500U);
    rig_cycles(&rig, 4U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PEDAL_RELEASED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PEDAL_PRESSED));
}

void test_SWR_PERMIT_003_each_axis_tells_its_reasons_and_since_when(void)
{
    rig_start(&rig);
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_AXIS_DISABLED,
                          rig.outputs.snapshot.axes[2].permit_reasons);
    const uint32_t since = rig.outputs.snapshot.axes[2].permit_since_cycle;
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(since, rig.outputs.snapshot.axes[2].permit_since_cycle);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    TEST_ASSERT_EQUAL_UINT32(rig.outputs.snapshot.cycle,
                             rig.outputs.snapshot.axes[2].permit_since_cycle);
}

void test_SWR_PERMIT_002_the_frame_carries_a_drive_only_with_the_permit(void)
{
    begin_move();
    TEST_ASSERT_BITS_HIGH(CARD_SYSTEM_PERMIT | CARD_SYSTEM_PEDAL,
                          rig_sent(&rig, AXIS_HEAD).system_state);
    TEST_ASSERT_EQUAL_HEX32(CARD_CONTROL_AMPLIFIER, rig_sent(&rig, AXIS_HEAD).control);
    rig_release(&rig);
    TEST_ASSERT_BITS_LOW(CARD_SYSTEM_PERMIT | CARD_SYSTEM_PEDAL,
                         rig_sent(&rig, AXIS_HEAD).system_state);
    TEST_ASSERT_EQUAL_HEX32(0U, rig_sent(&rig, AXIS_HEAD).control);
}

void test_SWR_LOOP_002_three_late_cycles_stop_the_motion(void)
{
    begin_move();
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, LIMIT_OVERRUNS_IN_A_ROW - 1U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_LOOP_STOPPED));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OVERRUNS_IN_A_ROW, rig.outputs.snapshot.overruns);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_LOOP_STOPPED));
}

void test_SWR_LOOP_003_a_late_cycle_advances_the_profile_by_one_cycle(void)
{
    begin_move();
    const uint32_t before = rig.controller.profile.cycle;
    box_advance(&rig.box, 4000U);
    rig.elapsed_us = 5000U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(before + 1U, rig.controller.profile.cycle);
}

void test_SWR_PHASE_004_stop_and_emergency_zero_the_drive_in_the_same_cycle(void)
{
    begin_move();
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    begin_move();
    (void)rig_workphase(&rig, WORKPHASE_EMERGENCY);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_PHASE_005_every_change_of_workphase_discards_the_armed_move(void)
{
    static const workphase_t others[] = {WORKPHASE_PLANNING, WORKPHASE_TARGETING, WORKPHASE_MANUAL,
                                         WORKPHASE_STOP, WORKPHASE_EMERGENCY};
    for (uint32_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        begin_move();
        (void)rig_workphase(&rig, others[i]);
        TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.answer_count);
        TEST_ASSERT_EQUAL_UINT32(STATUS_DISCARDED, rig.outputs.answers[0].status);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        rig_release(&rig);
        rig_press(&rig);
        rig_cycles(&rig, 100U);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
}

void test_SWR_MOTION_004_the_move_ends_at_the_target_with_the_drive_off(void)
{
    begin_move();
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
        TEST_ASSERT_INT32_WITHIN(robot_neuro.axes[i].deadband_ticks,
                                 rig.controller.plan.target_ticks[i], position(i));
    }
    int32_t distance_nm = 0;
    int32_t angle_bam = 0;
    neuro_pose_difference(&rig.outputs.snapshot.scanner_treatment,
                          &rig.controller.plan.scanner_target, &distance_nm, &angle_bam);
    TEST_ASSERT_LESS_OR_EQUAL_INT32(2000, distance_nm);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_NOTHING, rig.outputs.snapshot.next_step);
}

void test_SWR_MOTION_002_the_needle_is_retracted_before_the_base_moves_again(void)
{
    const rigid_t other = rig_pose(-8000000, 185000000, 40000000);
    begin_move();
    (void)rig_finish(&rig, 30000U);
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &other).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    const int32_t head = position(AXIS_HEAD);
    rig_press(&rig);
    const int32_t stroke = robot_neuro.axes[AXIS_INSERTION].maximum_ticks;
    while (position(AXIS_INSERTION) > (stroke / 64)) {
        TEST_ASSERT_INT32_WITHIN(1, head, position(AXIS_HEAD));
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(100000U, rig.controller.cycle);
    }
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
}

void test_SWR_MOTION_004_the_base_also_moves_towards_larger_positions(void)
{
    const rigid_t far = rig_pose(-8000000, 185000000, 40000000);
    const rigid_t near = rig_pose(5000000, 190000000, 60000000);
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &far).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    (void)rig_finish(&rig, 40000U);
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &near).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
    TEST_ASSERT_EQUAL_INT32(rig.controller.plan.target_ticks[AXIS_HEAD], position(AXIS_HEAD));
}

void test_SWR_CMD_003_no_sequence_of_commands_drives_an_axis_without_the_pedal(void)
{
    uint32_t seed = 12345U;
    rig_start_targeted(&rig);
    for (uint32_t i = 0U; i < 5000U; i++) {
        seed = (seed * 1664525U) + 1013904223U;
        const command_t command = {.kind = (seed >> 8) % 9U,
                                   .argument = (seed >> 16) % 10U,
                                   .value = (int32_t)(seed % 2000U) - 1000,
                                   .pose = rig_pose(5000000, 190000000, 60000000)};
        (void)rig_command(&rig, command);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
}

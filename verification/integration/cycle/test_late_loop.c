/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a loop that is late too often stops the motion, and nothing is lost by that. It
 * says which stage was late and by how much; one START_UP without homing goes on. The same holds
 * for a box that stutters. Only an axis whose card's counts do not go on is lost.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "interface/loop_figures.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

#include <math.h>
#include <stddef.h>

#define AFTER_CYCLES 20U
#define MOVE_CYCLES 60000U
#define TRIP_US (LIMIT_CARD_WATCHDOG_US + 1000U)

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* `count` cycles in a row come `late_us` late, in the world as well. */
static void be_late(uint32_t count, uint32_t late_us)
{
    for (uint32_t i = 0U; i < count; i++) {
        rig.late_us = late_us;
        rig_cycle(&rig);
    }
    rig.late_us = 0U;
}

/* The box stands for `cycles`, with all its cards: no report comes, and of what is sent meanwhile
 * only the first command arrives, when it goes on. */
static void be_held(uint32_t cycles)
{
    rig.held_cycles = cycles;
    rig_cycles(&rig, cycles);
}

static void expect_stopped(void)
{
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_LOOP_STOPPED));
    TEST_ASSERT_EQUAL_UINT32(LOOP_GUARD_STATE_STOPPED, rig.outputs.snapshot.loop);
}

static void expect_all_homed(void)
{
    for (uint32_t i = 0U; i < rig.box.robot->axis_count; i++) {
        TEST_ASSERT_TRUE_MESSAGE(axis_is_homed(&rig.controller.axes[i]),
                                 rig.box.robot->axes[i].name);
    }
}

/* How far the true position is from the one believed; a switch is some ticks wide. */
static double apart(uint32_t axis)
{
    return rig.box.axes[axis].motor.position_ticks - (double)rig_position(&rig, axis);
}

/* A move that is begun from rest, where each axis is as far apart as `homed` says. */
static double homed[ROBOT_AXIS_MAX];

static void start_moving(void)
{
    rig_start_targeted(&rig);
    for (uint32_t i = 0U; i < rig.box.robot->axis_count; i++) {
        homed[i] = apart(i);
    }
    rig_start_moving(&rig);
    rig_forget(&rig);
}

static void expect_true(void)
{
    for (uint32_t i = 0U; i < rig.box.robot->axis_count; i++) {
        TEST_ASSERT_TRUE_MESSAGE(fabs(apart(i) - homed[i]) < 2.0, rig.box.robot->axes[i].name);
    }
}

/* START_UP, for which nothing moves. */
static void start_up_at_rest(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_box(&rig, "pedal press");
    for (uint32_t i = 0U; rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE; i++) {
        TEST_ASSERT_LESS_THAN_UINT32(AFTER_CYCLES, i);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        rig_cycle(&rig);
    }
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DONE));
}

/* From where it pauses to the target, by START_UP alone. */
static void go_on_from_pause(void)
{
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    expect_all_homed();
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    start_up_at_rest();
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_PLANNING).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_TARGETING).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOVE_CYCLES).kind);
    rig_release(&rig);
    expect_true();
}

static void go_on(void)
{
    rig_cycles(&rig, AFTER_CYCLES);
    expect_stopped();
    go_on_from_pause();
}

void test_SWR_LOOP_009_a_cycle_in_which_cards_may_switch_off_stops_the_loop_alone(void)
{
    start_moving();
    be_late(1U, LIMIT_LOOP_SILENT_US - LIMIT_CYCLE_US);
    rig_cycles(&rig, 3U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    be_late(1U, LIMIT_LOOP_SILENT_US - LIMIT_CYCLE_US + 1U);
    expect_stopped();
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_OVERRUN));
}

void test_SWR_LOOP_010_late_cycles_lose_no_reference_and_no_target(void)
{
    start_moving();
    be_late(LIMIT_OVERRUNS_IN_A_ROW, 2000U);
    go_on();
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_CARD_LOST));
}

void test_SWR_LOOP_010_cards_that_switched_off_meanwhile_lose_none_either(void)
{
    static const uint32_t late_us[] = {TRIP_US, 2U * TRIP_US, 50U * TRIP_US};
    for (uint32_t i = 0U; i < SCENES(sizeof late_us / sizeof late_us[0]); i++) {
        start_moving();
        be_late(1U, late_us[i]);
        rig_cycles(&rig, 3U);
        TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, rig_count(&rig, EVENT_CARD_LOST));
        go_on();
    }
}

/* The same pause, in which the card of one axis is switched off and on. */
void test_SWR_LOOP_010_exactly_the_axis_whose_card_began_to_count_anew_is_lost(void)
{
    start_moving();
    be_late(1U, TRIP_US);
    rig.box.axes[NEURO_AXIS_LATERAL].card.heartbeat = 0U;
    rig_cycles(&rig, AFTER_CYCLES);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL(i != NEURO_AXIS_LATERAL, axis_is_homed(&rig.controller.axes[i]));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
}

void test_SWR_LOOP_010_a_card_that_counts_a_jump_meanwhile_is_lost(void)
{
    start_moving();
    be_late(1U, TRIP_US);
    rig.box.axes[NEURO_AXIS_LATERAL].encoder.count += 4000U;
    rig_cycles(&rig, AFTER_CYCLES);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL(i != NEURO_AXIS_LATERAL, axis_is_homed(&rig.controller.axes[i]));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
}

/* The loop is punctual, and every count was seen. */
void test_SWR_LOOP_010_a_trip_in_a_punctual_loop_loses_nothing(void)
{
    start_moving();
    rig.box.axes[NEURO_AXIS_LATERAL].card.faults |= CARD_STATUS_WATCHDOG;
    rig_cycles(&rig, AFTER_CYCLES);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
    go_on_from_pause();
}

/* Any other fault that is reported with it. */
void test_SWR_LOOP_010_another_fault_of_a_late_card_loses_its_position(void)
{
    start_moving();
    be_late(1U, TRIP_US);
    rig.box.axes[NEURO_AXIS_LATERAL].card.faults |= CARD_STATUS_HOT;
    rig_cycles(&rig, AFTER_CYCLES);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL(i != NEURO_AXIS_LATERAL, axis_is_homed(&rig.controller.axes[i]));
    }
}

void test_SWR_LOOP_010_a_homing_that_is_late_begins_again_for_its_axis_alone(void)
{
    rig_start_homed(&rig);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_INSERTION]);
    controller_seal(&rig.controller);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    be_late(1U, TRIP_US);
    rig_cycles(&rig, AFTER_CYCLES);
    rig_release(&rig);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL(i != NEURO_AXIS_INSERTION, axis_is_homed(&rig.controller.axes[i]));
    }
    rig_forget(&rig);
    rig_home(&rig);
    expect_all_homed();
}

static void expect_paused(uint32_t cards)
{
    rig_cycles(&rig, AFTER_CYCLES);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(cards, rig_count(&rig, EVENT_CARD_LOST));
    go_on_from_pause();
}

void test_SWR_REF_014_a_box_that_stands_for_a_while_loses_nothing(void)
{
    static const uint32_t held[] = {5U, 8U, 9U, 10U, 11U, 14U, 25U, 60U};
    for (uint32_t i = 0U; i < SCENES(sizeof held / sizeof held[0]); i++) {
        start_moving();
        rig_cycles(&rig, 37U * i);
        be_held(held[i]);
        expect_paused(robot_neuro.axis_count);
    }
}

/* Neither alone is as long as the watchdog of a card. */
void test_SWR_REF_014_a_box_that_stands_beside_a_late_loop_loses_nothing(void)
{
    static const uint32_t late_us[] = {2000U, 4000U, 6000U, 8000U};
    for (uint32_t i = 0U; i < SCENES(sizeof late_us / sizeof late_us[0]); i++) {
        start_moving();
        be_held(4U);
        be_late(1U, late_us[i]);
        rig.held_cycles = 3U;
        be_late(3U, late_us[i] / 2U);
        rig_cycles(&rig, AFTER_CYCLES);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        go_on_from_pause();
    }
}

void test_SWR_REF_014_frames_that_the_board_has_too_late_lose_nothing(void)
{
    for (uint32_t cycles = 5U; cycles <= 60U; cycles += 11U * SCENE_DIVISOR) {
        start_moving();
        rig.frames_late = CARD_EVERY_SLOT;
        rig_cycles(&rig, cycles);
        rig.frames_late = 0U;
        expect_paused(robot_neuro.axis_count);
    }
}

void test_SWR_REF_014_one_card_that_is_silent_for_a_while_loses_nothing(void)
{
    start_moving();
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES - 1U);
    rig_box(&rig, "card lateral normal");
    expect_paused(1U);
}

void test_SWR_REF_015_a_silence_that_lasts_leaves_the_position_in_doubt(void)
{
    start_moving();
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES - 1U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    expect_all_homed();
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].reference);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    rig_box(&rig, "card lateral normal");
    rig_cycles(&rig, AFTER_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].reference);
    TEST_ASSERT_TRUE(fabs(apart(NEURO_AXIS_LATERAL) - homed[NEURO_AXIS_LATERAL]) < 2.0);
}

/* It lost its counter with its power; what it counts is right by chance at most. */
static void expect_lost_alone(uint32_t lost)
{
    rig_cycles(&rig, AFTER_CYCLES);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL(i != lost, axis_is_homed(&rig.controller.axes[i]));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_REFERENCE_LOST));
}

void test_SWR_REF_016_a_card_that_began_anew_while_the_box_stood_is_lost_alone(void)
{
    start_moving();
    be_held(12U);
    rig.box.axes[NEURO_AXIS_LATERAL].card.heartbeat = 0U;
    expect_lost_alone(NEURO_AXIS_LATERAL);
}

void test_SWR_REF_016_a_card_that_begins_anew_while_it_waits_for_start_up_is_lost(void)
{
    start_moving();
    be_held(12U);
    rig_cycles(&rig, AFTER_CYCLES);
    expect_all_homed();
    rig.box.axes[NEURO_AXIS_LATERAL].card.heartbeat = 0U;
    expect_lost_alone(NEURO_AXIS_LATERAL);
}

void test_SWR_REF_016_a_card_that_comes_back_with_a_fault_is_lost_alone(void)
{
    start_moving();
    be_held(12U);
    rig.box.axes[NEURO_AXIS_LATERAL].card.faults |= CARD_STATUS_HOT;
    expect_lost_alone(NEURO_AXIS_LATERAL);
}

void test_SWR_REF_016_another_card_that_answers_instead_is_lost_alone(void)
{
    start_moving();
    be_held(12U);
    rig_box(&rig, "card lateral foreign");
    expect_lost_alone(NEURO_AXIS_LATERAL);
}

/* Its program stands: the reports of the next cycles are all the same. */
static void stand(uint32_t axis, uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        rig.box.axes[axis].card.heartbeat--;
        rig_cycle(&rig);
    }
}

static uint32_t grade(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].reference;
}

/* The silence is longer than the card was on before, and its new heartbeat seems to go on. */
void test_SWR_REF_030_a_card_that_may_have_begun_anew_in_a_silence_is_lost(void)
{
    start_moving();
    rig_box(&rig, "card lateral silent");
    const uint32_t age = rig.box.axes[NEURO_AXIS_LATERAL].card.heartbeat;
    rig_cycles(&rig, age + 100U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(NEURO_AXIS_LATERAL));
    rig.box.axes[NEURO_AXIS_LATERAL].card.heartbeat = age + 50U;
    rig.box.axes[NEURO_AXIS_LATERAL].card.uptime_us = (age + 50U) * LIMIT_CYCLE_US;
    rig_box(&rig, "card lateral normal");
    rig_cycles(&rig, AFTER_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(NEURO_AXIS_LATERAL));
}

void test_SWR_REF_030_a_card_that_was_silent_for_longer_than_it_was_on_is_in_doubt(void)
{
    start_moving();
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, rig.box.axes[NEURO_AXIS_LATERAL].card.heartbeat + 100U);
    rig_box(&rig, "card lateral normal");
    rig_cycles(&rig, AFTER_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(NEURO_AXIS_LATERAL));
}

void test_SWR_REF_031_a_driven_card_that_repeats_its_report_is_lost_alone(void)
{
    start_moving();
    stand(NEURO_AXIS_LATERAL, LIMIT_LINK_AGE_CYCLES);
    expect_lost_alone(NEURO_AXIS_LATERAL);
}

void test_SWR_REF_031_a_card_that_repeats_its_report_at_rest_is_in_doubt(void)
{
    rig_start_homed(&rig);
    rig_cycles(&rig, 300U);
    stand(NEURO_AXIS_LATERAL, LIMIT_LINK_AGE_CYCLES);
    rig_cycles(&rig, AFTER_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(NEURO_AXIS_LATERAL));
}

/* It was silent first; the motor was driven then. */
void test_SWR_REF_031_a_silent_card_that_comes_back_with_its_last_report_is_lost_alone(void)
{
    start_moving();
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, 12U);
    expect_all_homed();
    rig_box(&rig, "card lateral normal");
    stand(NEURO_AXIS_LATERAL, 1U);
    expect_lost_alone(NEURO_AXIS_LATERAL);
}

void test_SWR_REF_031_a_single_report_that_is_repeated_after_a_trip_loses_nothing(void)
{
    start_moving();
    rig.box.axes[NEURO_AXIS_LATERAL].card.faults |= CARD_STATUS_WATCHDOG;
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
    stand(NEURO_AXIS_LATERAL, 1U);
    expect_paused(1U);
}

/* It is not driven: its motion meanwhile was counted all the same. */
void test_SWR_REF_014_an_axis_that_is_moved_in_a_silence_is_where_it_is_shown(void)
{
    for (uint32_t cycles = 10U; cycles < LIMIT_SILENT_KEPT_CYCLES; cycles += 30U * SCENE_DIVISOR) {
        start_moving();
        rig_box(&rig, "card lateral silent");
        rig_cycles(&rig, cycles);
        rig_box(&rig, "motor lateral runs");
        rig_cycles(&rig, 8U);
        rig_box(&rig, "motor lateral normal");
        rig_box(&rig, "card lateral normal");
        rig_cycles(&rig, AFTER_CYCLES);
        TEST_ASSERT_TRUE((grade(NEURO_AXIS_LATERAL) == (uint32_t)AXIS_REFERENCE_LOST) ||
                         (fabs(apart(NEURO_AXIS_LATERAL) - homed[NEURO_AXIS_LATERAL]) < 2.0));
    }
}

static const event_t *find(event_id_t id)
{
    const event_t *found = NULL;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        found = (rig.events[i].id == (uint32_t)id) ? &rig.events[i] : found;
    }
    return found;
}

void test_SWR_LOOP_011_the_stop_names_stage_and_figure(void)
{
    start_moving();
    be_late(1U, 900U);
    be_late(1U, 4100U);
    be_late(1U, 700U);
    const snapshot_t *const shown = &rig.outputs.snapshot;
    const event_t *const event = find(EVENT_LOOP_STOPPED);
    TEST_ASSERT_NOT_NULL(event);
    TEST_ASSERT_EQUAL_UINT32(LOOP_STAGE_WAKE, event->subject);
    TEST_ASSERT_EQUAL_INT32(5100, event->value);
    TEST_ASSERT_EQUAL_UINT32(LOOP_STAGE_WAKE, shown->late_stage);
    TEST_ASSERT_EQUAL_UINT32(3U, shown->late_count);
    TEST_ASSERT_EQUAL_UINT32(4100U, shown->late_us);
    TEST_ASSERT_EQUAL_UINT32(8700U, shown->late_span_us);
}

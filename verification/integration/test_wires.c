/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: what the controller shows is what is so, whichever axis it concerns.
 */
#include "rig.h"

#include "unity.h"

#include "controller.h"
#include "fixed.h"

#include <stdio.h>
#include <string.h>

TEST_SOURCE_FILE("axis.c")
TEST_SOURCE_FILE("axis_chart.c")
TEST_SOURCE_FILE("box.c")
TEST_SOURCE_FILE("box_orders.c")
TEST_SOURCE_FILE("card_frame.c")
TEST_SOURCE_FILE("card_link_chart.c")
TEST_SOURCE_FILE("controller_drive.c")
TEST_SOURCE_FILE("controller_move.c")
TEST_SOURCE_FILE("controller_obey.c")
TEST_SOURCE_FILE("controller_observe.c")
TEST_SOURCE_FILE("controller_show.c")
TEST_SOURCE_FILE("crc.c")
TEST_SOURCE_FILE("encoder.c")
TEST_SOURCE_FILE("estop_latch.c")
TEST_SOURCE_FILE("estop_latch_chart.c")
TEST_SOURCE_FILE("fixed.c")
TEST_SOURCE_FILE("homing.c")
TEST_SOURCE_FILE("link.c")
TEST_SOURCE_FILE("loop_guard.c")
TEST_SOURCE_FILE("loop_guard_chart.c")
TEST_SOURCE_FILE("neuro.c")
TEST_SOURCE_FILE("neuro_limits.c")
TEST_SOURCE_FILE("pedal_gate.c")
TEST_SOURCE_FILE("pedal_gate_chart.c")
TEST_SOURCE_FILE("permit.c")
TEST_SOURCE_FILE("plan.c")
TEST_SOURCE_FILE("profile.c")
TEST_SOURCE_FILE("rigid.c")
TEST_SOURCE_FILE("robot_neuro.c")
TEST_SOURCE_FILE("servo.c")
TEST_SOURCE_FILE("sim_card.c")
TEST_SOURCE_FILE("sim_encoder.c")
TEST_SOURCE_FILE("sim_motor.c")
TEST_SOURCE_FILE("sim_switch.c")
TEST_SOURCE_FILE("speed_cap.c")
TEST_SOURCE_FILE("stall_watchdog_chart.c")
TEST_SOURCE_FILE("supervision.c")
TEST_SOURCE_FILE("workphase.c")
TEST_SOURCE_FILE("workphases_chart.c")

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void expect_step(next_step_t expected)
{
    TEST_ASSERT_EQUAL_UINT32(expected, rig.outputs.snapshot.next_step);
}

static void begin_move(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
}

static void box(const char *format, uint32_t axis)
{
    char order[64];
    (void)snprintf(order, sizeof order, format, robot_neuro.axes[axis].name);
    rig_box(&rig, order);
}

void test_SWR_NEXT_001_a_fault_of_any_axis_asks_for_start_up(void)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
        begin_move();
        rig.controller.axes[i].setpoint_ticks += 2 * robot_neuro.axes[i].following_error_ticks;
        rig.controller.profile.start_ticks[i] += 2 * robot_neuro.axes[i].following_error_ticks;
        rig_cycles(&rig, 3U);
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[i].power);
        expect_step(NEXT_STEP_START_UP);
    }
}

void test_SWR_NEXT_001_a_lost_card_is_looked_after_before_start_up(void)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
        rig_start_homed(&rig);
        box("card %s silent", i);
        rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES);
        expect_step(NEXT_STEP_CHECK_CARDS);
    }
}

void test_SWR_NEXT_001_a_pedal_fault_asks_for_its_release_and_start_up(void)
{
    rig_start_targeted(&rig);
    rig_box(&rig, "pedal b close");
    rig_cycles(&rig, 150U);
    expect_step(NEXT_STEP_PEDAL_FAULT);
}

void test_SWR_NEXT_001_an_order_asks_for_the_pedal_until_it_has_ended(void)
{
    rig_start_targeted(&rig);
    rig_press(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    expect_step(NEXT_STEP_RELEASE_PEDAL);
    rig_release(&rig);
    expect_step(NEXT_STEP_PRESS_PEDAL);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    expect_step(NEXT_STEP_HOLD_PEDAL);
    rig_box(&rig, "scanner on");
    rig_cycle(&rig);
    expect_step(NEXT_STEP_SCANNER);
}

void test_SWR_NEXT_001_the_workphase_decides_how_a_move_is_commanded(void)
{
    rig_start_targeted(&rig);
    expect_step(NEXT_STEP_MOVE);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    expect_step(NEXT_STEP_TARGETING);
    (void)rig_workphase(&rig, WORKPHASE_EMERGENCY);
    expect_step(NEXT_STEP_START_UP);
}

void test_SWR_NEXT_002_a_move_that_expired_or_was_discarded_has_not_arrived(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_cycles(&rig, (LIMIT_ARMED_HOLD_US / 1000U) + 1U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_EXPIRED));
    expect_step(NEXT_STEP_MOVE);
    begin_move();
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, LIMIT_OVERRUNS_IN_A_ROW);
    rig.elapsed_us = 1000U;
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    expect_step(NEXT_STEP_START_UP);
}

void test_SWR_NEXT_002_arrival_is_shown_until_the_next_order(void)
{
    begin_move();
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    expect_step(NEXT_STEP_NOTHING);
    rig_release(&rig);
    expect_step(NEXT_STEP_NOTHING);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    expect_step(NEXT_STEP_PRESS_PEDAL);
    rig_cycles(&rig, (LIMIT_ARMED_HOLD_US / 1000U) + 1U);
    expect_step(NEXT_STEP_MOVE);
}

void test_SWR_NEXT_002_a_jog_that_is_done_is_no_arrival(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG, .argument = AXIS_YAW, .value = -200};
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    (void)rig_command(&rig, jog);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    expect_step(NEXT_STEP_TARGETING);
}

void test_SWR_LINK_008_a_wrong_card_is_named_whenever_it_is_put_in(void)
{
    rig_start(&rig);
    rig_forget(&rig);
    rig_box(&rig, "card yaw foreign");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(EVENT_CARD_LOST, rig.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axes[AXIS_YAW].slot, rig.events[0].subject);
    TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_WRONG_CARD, rig.events[0].value);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    expect_step(NEXT_STEP_CHECK_CARDS);
    rig_box(&rig, "card yaw normal");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
}

/* Frames of the lateral card, heard again and again in place of those of now. */
void test_SWR_BOX_008_a_replay_of_old_frames_moves_no_motor_beyond_the_watchdog(void)
{
    static uint8_t old[50][CARD_FRAME_BYTES];
    const uint32_t slot = robot_neuro.axes[AXIS_LATERAL].slot;
    double before[ROBOT_AXIS_COUNT];
    double after[ROBOT_AXIS_COUNT];
    begin_move();
    for (uint32_t i = 0U; i < 50U; i++) {
        (void)memcpy(old[i], rig.outputs.frames[slot], CARD_FRAME_BYTES);
        rig_cycle(&rig);
    }
    for (uint32_t i = 0U; i < 300U; i++) {
        (void)memcpy(rig.outputs.frames[slot], old[i % 50U], CARD_FRAME_BYTES);
        rig_cycle(&rig);
        if (i == ((LIMIT_CARD_WATCHDOG_US / 1000U) + 5U)) {
            box_true_positions(&rig.box, before);
        }
    }
    box_true_positions(&rig.box, after);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, before[AXIS_LATERAL], after[AXIS_LATERAL]);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
}

void test_SWR_EVENT_004_counters_that_wrap_in_a_move_repeat_no_event(void)
{
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_STARTED));
    begin_move();
    rig_forget(&rig);
    rig.controller.cycle = UINT32_MAX - 20U;
    rig.controller.time_us = UINT32_MAX - 20000U;
    rig.controller.events = UINT32_MAX;
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.event_count);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, rig.events[0].number);
}

void test_SWR_EVENT_004_the_sequence_of_frames_wraps_without_losing_a_card(void)
{
    (void)memset(&rig, 0, sizeof rig);
    rig.elapsed_us = 1000U;
    box_init(&rig.box, &robot_neuro, 1U);
    controller_init(&rig.controller, &robot_neuro);
    rig.controller.sequence = UINT32_MAX - 30U;
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_CARD_LOST));
    for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
        TEST_ASSERT_EQUAL_UINT32(rig.controller.sequence - 3U,
                                 rig.controller.links[i].report.accepted_sequence);
    }
}

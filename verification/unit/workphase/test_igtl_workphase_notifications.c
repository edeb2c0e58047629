/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the commanding client is informed at once of events without a command, once
 * each, after the answers that it is owed; no other client is, and nothing is said of what its own
 * command did.
 */
#include "charts/arming_chart.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_dialect.h"
#include "procedure/command_kinds.h"
#include "unit/support/workphase_world.h"
#include "unity.h"
#include "charts/axis_chart.h"
#include "charts/card_link_chart.h"
#include "charts/estop_latch_chart.h"
#include "charts/loop_guard_chart.h"
#include "charts/pedal_gate_chart.h"
#include "charts/stall_watchdog_chart.h"

/* Peer 0 commands, in PLANNING, and nothing is left to be said. */
void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2021);
    snapshot.workphase = (uint32_t)WORKPHASE_STOP;
    pass_us(0U);
    enter(0U, "CMD_1", "PLANNING");
    EXPECT(0U, "STRING ACK_1 PLANNING");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
    EXPECT(0U, "STATUS PLANNING 1 PLANNING|");
    pass_us(0U);
    EXPECT(0U, "");
}

void tearDown(void)
{
}

static void pull_estop(void)
{
    snapshot.estop = (uint32_t)ESTOP_LATCH_STATE_PULLED;
    snapshot.workphase = (uint32_t)WORKPHASE_EMERGENCY;
    snapshot.order = (uint32_t)ARMING_STATE_NONE;
}

static void lose_card(uint32_t slot)
{
    snapshot.cards[slot].link = (uint32_t)CARD_LINK_STATE_LOST;
}

/* Armed by peer 0, and both answers read. */
static command_t armed_move(void)
{
    say(0U, "CMD_M", "MOVE_TO_TARGET");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    accept(0U);
    EXPECT(0U, "STRING ACK_M MOVE_TO_TARGET");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET|");
    EXPECT(0U, "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET|");
    EXPECT_BEGIN(0U, "TRANSFORM CURRENT_POSITION ");
    return command;
}

void test_SWR_IGTL_033_the_estop_is_said_once_to_who_commands(void)
{
    pull_estop();
    pass_us(0U);
    EXPECT(0U, "STATUS EMERGENCY 3 PANIC_MODE|PANIC_MODE: The e-stop was pulled.");
    pass_us(1000000U);
    EXPECT(0U, "");
    EXPECT(1U, "");
}

void test_SWR_IGTL_110_an_estop_that_is_not_read_is_not_said_to_be_pulled(void)
{
    snapshot.unread_inputs = 1U << BOX_INPUT_ESTOP;
    pull_estop();
    pass_us(0U);
    EXPECT(0U, "STATUS EMERGENCY 3 PANIC_MODE|PANIC_MODE: The e-stop is not read: check the box.");
    pass_us(1000000U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_an_estop_pulled_and_released_between_two_looks_is_said(void)
{
    snapshot.estop = (uint32_t)ESTOP_LATCH_STATE_LATCHED;
    pass_us(0U);
    EXPECT(0U, "STATUS EMERGENCY 3 PANIC_MODE|PANIC_MODE: The e-stop was pulled, or not read, for "
               "a moment.");
    snapshot.estop = (uint32_t)ESTOP_LATCH_STATE_PULLED; /* Again. */
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS EMERGENCY 3 ");
    snapshot.estop = (uint32_t)ESTOP_LATCH_STATE_LATCHED;
    pass_us(0U);
    snapshot.estop = (uint32_t)ESTOP_LATCH_STATE_CLEAR;
    pass_us(0U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_a_stop_of_someone_else_is_said(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_STOP;
    pass_us(0U);
    EXPECT(0U, "STATUS STOP 1 STOP|Another connection commanded it, or the console.");
    snapshot.workphase = (uint32_t)WORKPHASE_EMERGENCY;
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS EMERGENCY 3 PANIC_MODE|PANIC_MODE: Another connection ");
    pass_us(1000000U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_its_own_stop_is_not_said_twice(void)
{
    enter(0U, "CMD_S", "STOP");
    pass_us(0U);
    EXPECT(0U, "STRING ACK_S STOP");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 STOP|");
    EXPECT(0U, "STATUS STOP 1 STOP|");
    enter(0U, "CMD_E", "EMERGENCY");
    pass_us(0U);
    EXPECT(0U, "STRING ACK_E EMERGENCY");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 EMERGENCY|");
    EXPECT(0U, "STATUS EMERGENCY 1 EMERGENCY|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_it_waits_for_the_answer_to_a_command(void)
{
    say(0U, "CMD_S", "STOP");
    snapshot.workphase = (uint32_t)WORKPHASE_STOP; /* Shown before the answer comes. */
    pass_us(1000U);
    EXPECT(0U, "STRING ACK_S STOP");
    EXPECT(0U, "");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    accept(1U);
    pass_us(0U);
    EXPECT(0U, "STATUS CURRENT_STATUS 1 STOP|");
    EXPECT(0U, "STATUS STOP 1 STOP|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_it_does_not_wait_for_ever(void)
{
    (void)armed_move();
    pull_estop(); /* The end of the order never comes. */
    pass_us(0U);
    pass_us(IGTL_ANSWER_TIMEOUT_US - 1U);
    EXPECT(0U, "");
    pass_us(1U);
    EXPECT_BEGIN(0U, "STATUS EMERGENCY 3 ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_the_end_of_an_order_goes_first(void)
{
    const command_t move = armed_move();

    pull_estop();
    pass_us(0U);
    EXPECT(0U, "");
    answer_to(&move, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 13 EMERGENCY|DISCARDED: ");
    EXPECT_BEGIN(0U, "STATUS EMERGENCY 3 PANIC_MODE|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_lost_cards_and_failed_axes_are_said_by_name(void)
{
    lose_card(3U);
    pass_us(0U);
    EXPECT(0U, "STATUS PLANNING 18 HARDWARE_FAILURE|HARDWARE_FAILURE: Card 3 is lost.");
    snapshot.axes[3].power = (uint32_t)AXIS_POWER_FAULT;
    pass_us(0U);
    EXPECT(0U, "STATUS PLANNING 18 HARDWARE_FAILURE|HARDWARE_FAILURE: Axis insertion has a fault.");
    snapshot.axes[3].stall = (uint32_t)STALL_WATCHDOG_STATE_STALLED; /* The same axis. */
    lose_card(9U);                                                   /* Not of this robot. */
    pass_us(0U);
    EXPECT(0U, "");
    snapshot.cards[3].link = (uint32_t)CARD_LINK_STATE_LIVE;
    snapshot.axes[3].power = (uint32_t)AXIS_POWER_ENABLED;
    snapshot.axes[3].stall = (uint32_t)STALL_WATCHDOG_STATE_IDLE;
    pass_us(0U);
    EXPECT(0U, ""); /* That all is well is said when asked. */
}

void test_SWR_IGTL_033_an_axis_that_stalls_is_said_though_its_power_is_well(void)
{
    snapshot.axes[3].stall = (uint32_t)STALL_WATCHDOG_STATE_STALLED;
    pass_us(0U);
    EXPECT(0U, "STATUS PLANNING 18 HARDWARE_FAILURE|HARDWARE_FAILURE: Axis insertion has a fault.");
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_what_stops_everything_is_said(void)
{
    snapshot.loop = (uint32_t)LOOP_GUARD_STATE_STOPPED;
    snapshot.pedal = (uint32_t)PEDAL_GATE_STATE_FAULT;
    pass_us(0U);
    EXPECT(0U, "STATUS PLANNING 18 HARDWARE_FAILURE|HARDWARE_FAILURE: The loop was late too often: "
               "WAKE by 0.0 ms, 0 in 0.0 ms. The pedal's channels disagree.");
}

void test_SWR_IGTL_080_a_loop_that_was_late_names_stage_and_figures(void)
{
    snapshot.loop = (uint32_t)LOOP_GUARD_STATE_STOPPED;
    snapshot.late_stage = (uint32_t)LOOP_STAGE_CARDS;
    snapshot.late_us = 4100U;
    snapshot.late_count = 3U;
    snapshot.late_span_us = 8700U;
    pass_us(0U);
    EXPECT(0U, "STATUS PLANNING 18 HARDWARE_FAILURE|HARDWARE_FAILURE: The loop was late too often: "
               "CARDS by 4.1 ms, 3 in 8.7 ms.");
}

void test_SWR_IGTL_033_a_lost_reference_is_said(void)
{
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS PLANNING 13 NOT_REGISTERED|NOT_REGISTERED: ");
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS PLANNING 13 NOT_HOMED|NOT_HOMED: ");
    snapshot.pose_status = (uint32_t)STATUS_OK;
    pass_us(0U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_a_reference_lost_by_a_failure_is_one_happening(void)
{
    lose_card(3U);
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS PLANNING 18 ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_a_controller_that_falls_silent_is_said_once(void)
{
    workphase_dialect_control_lost(&dialect, &moment);
    EXPECT_BEGIN(0U, "STATUS PLANNING 7 NO_ANSWER|NO_ANSWER: ");
    pass_us(1000000U);
    workphase_dialect_control_lost(&dialect, &moment);
    EXPECT(0U, "");
    snapshot.cycle++; /* It has come back. */
    pass_us(0U);
    workphase_dialect_control_lost(&dialect, &moment);
    EXPECT_BEGIN(0U, "STATUS PLANNING 7 ");
}

void test_SWR_IGTL_008_lost_controller_is_reported_to_who_waits(void)
{
    (void)armed_move();
    workphase_dialect_control_lost(&dialect, &moment);
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 7 NO_ANSWER|");
    workphase_dialect_control_lost(&dialect, &moment);
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_no_client_is_informed_while_none_commands(void)
{
    workphase_dialect_disconnected(&dialect, 0U);
    pull_estop();
    pass_us(0U);
    expect_released(0U);
    workphase_dialect_control_lost(&dialect, &moment);
    for (uint32_t i = 1U; i < IGTL_PEERS; i++) {
        EXPECT(i, "");
    }
    snapshot.estop = (uint32_t)ESTOP_LATCH_STATE_LATCHED;
    enter(1U, "CMD_1", "PLANNING"); /* The next commanding client gets nothing of the past. */
    pass_us(0U);
    EXPECT(1U, "STRING ACK_1 PLANNING");
    EXPECT(1U, "STATUS CURRENT_STATUS 1 PLANNING|");
    EXPECT(1U, "STATUS PLANNING 1 PLANNING|");
    EXPECT(1U, "");
}

void test_SWR_IGTL_033_before_the_first_snapshot_nothing_has_changed(void)
{
    moment.snapshot = NULL;
    pass_us(0U);
    workphase_dialect_control_lost(&dialect, &moment);
    EXPECT_BEGIN(0U, "STATUS PLANNING 7 ");
}

void test_SWR_IGTL_033_what_was_deferred_goes_first(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
    pass_us(0U);
    enter(0U, "CMD_1", "PLANNING");
    pass_us(0U);
    pull_estop();
    pass_us(0U);
    EXPECT(0U, "STRING ACK_1 PLANNING");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
    EXPECT(0U, "STATUS PLANNING 1 PLANNING|");
    EXPECT_BEGIN(0U, "STATUS EMERGENCY 3 ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_clearing_faults_sends_nothing_early(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    pass_us(0U);
    enter(0U, "CMD_1", "CALIBRATION");
    snapshot.pose_status = (uint32_t)STATUS_OK;
    pass_us(0U);
    EXPECT(0U, "STRING ACK_1 CALIBRATION");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 CALIBRATION|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_032_an_order_ended_by_a_fault_names_it_once(void)
{
    const command_t move = armed_move();

    lose_card(3U);
    snapshot.axes[3].power = (uint32_t)AXIS_POWER_FAULT;
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    snapshot.order = (uint32_t)ARMING_STATE_NONE;
    pass_us(0U);
    EXPECT(0U, "");
    answer_to(&move, ANSWER_ABORTED, STATUS_FAULT_PRESENT, 1U);
    EXPECT(0U, "STATUS MOVE_TO_TARGET 18 MOVE_TO_TARGET|HARDWARE_FAILURE: Card 3 is lost. Axis "
               "insertion has a fault.");
    pass_us(1000000U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_an_estop_beside_the_fault_that_ends_an_order_is_said_as_well(void)
{
    const command_t move = armed_move();

    lose_card(3U);
    pull_estop();
    answer_to(&move, ANSWER_ABORTED, STATUS_FAULT_PRESENT, 1U);
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 18 ");
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS EMERGENCY 3 PANIC_MODE|PANIC_MODE: The e-stop ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_033_a_stop_of_someone_else_beside_such_a_fault_is_said_as_well(void)
{
    const command_t move = armed_move();

    lose_card(3U);
    snapshot.workphase = (uint32_t)WORKPHASE_STOP;
    answer_to(&move, ANSWER_ABORTED, STATUS_FAULT_PRESENT, 1U);
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 18 ");
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS STOP 1 STOP|");
    EXPECT(0U, "");
}

/* The peer's order is over by a fault of `axis`, ROBOT_AXIS_MAX for none. */
static void end_by(const command_t *order, uint32_t axis)
{
    const answer_t end = {.id = order->id,
                          .command = order->kind,
                          .asked = (uint32_t)command_kinds_workphase(order),
                          .kind = (uint32_t)ANSWER_ABORTED,
                          .status = (uint32_t)STATUS_FAULT_PRESENT,
                          .is_final = 1U,
                          .as.ended = {.axis = axis},
                          .workphase = (uint32_t)command_kinds_workphase(order)};

    TEST_ASSERT_TRUE(workphase_dialect_answer(&dialect, &end, &moment));
}

void test_SWR_IGTL_032_an_axis_that_ended_an_order_is_named_without_a_fault_of_its_own(void)
{
    const command_t move = armed_move();

    end_by(&move, 3U);
    EXPECT(0U, "STATUS MOVE_TO_TARGET 18 MOVE_TO_TARGET|HARDWARE_FAILURE: Axis insertion could "
               "not go on; the log of events says why.");
}

void test_SWR_IGTL_032_an_axis_with_a_fault_is_named_once(void)
{
    const command_t move = armed_move();

    snapshot.axes[3].power = (uint32_t)AXIS_POWER_FAULT;
    end_by(&move, 3U);
    EXPECT(0U, "STATUS MOVE_TO_TARGET 18 MOVE_TO_TARGET|HARDWARE_FAILURE: Axis insertion has a "
               "fault.");
}

void test_SWR_IGTL_032_a_fault_that_is_of_no_axis_names_none(void)
{
    const command_t move = armed_move();

    end_by(&move, ROBOT_AXIS_MAX);
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 18 MOVE_TO_TARGET|HARDWARE_FAILURE: A fault stands; ");
}

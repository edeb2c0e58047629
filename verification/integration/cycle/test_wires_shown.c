/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: each fact that stops a motion is shown, with the next step that it asks for and
 * as a reason at every axis that it concerns.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"

#include <stdio.h>

#include "integration/support/wires_world.inc"

static void box(const char *format, uint32_t axis)
{
    char order[64];
    (void)snprintf(order, sizeof order, format, robot_neuro.axes[axis].name);
    rig_box(&rig, order);
}

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_NEXT_001_a_fault_of_any_axis_asks_for_start_up(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_move();
        rig.controller.axes[i].sealed.setpoint_ticks +=
            2 * robot_neuro.axes[i].following_error_ticks;
        rig.controller.mode.sealed.leg.profile.start_ticks[i] +=
            2 * robot_neuro.axes[i].following_error_ticks;
        controller_seal(&rig.controller);
        rig_cycles(&rig, 3U);
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[i].power);
        const bool has_switch = robot_neuro.axes[i].home_method == (uint8_t)HOME_BY_SWITCH;
        rig_release(&rig);
        rig_cycles(&rig, 300U); /* It comes to rest. */
        expect_step(has_switch ? NEXT_STEP_START_UP : NEXT_STEP_PLACE);
    }
}

void test_SWR_NEXT_001_a_lost_card_is_looked_after_before_start_up(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
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
    rig_let_expire(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_EXPIRED));
    expect_step(NEXT_STEP_MOVE);
    begin_move();
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, LIMIT_OVERRUNS_IN_A_ROW);
    rig.elapsed_us = 1000U;
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    rig_release(&rig);
    expect_step(NEXT_STEP_START_UP);
}

void test_SWR_NEXT_002_arrival_is_shown_until_the_next_order(void)
{
    begin_move();
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    rig_release(&rig);
    expect_step(NEXT_STEP_NOTHING);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    expect_step(NEXT_STEP_PRESS_PEDAL);
    rig_let_expire(&rig);
    expect_step(NEXT_STEP_MOVE);
}

void test_SWR_NEXT_002_a_jog_that_is_done_is_no_arrival(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_YAW, .to_ticks = -200}};
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    (void)rig_command(&rig, jog);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    rig_release(&rig);
    expect_step(NEXT_STEP_TARGETING);
}

/* The reason stands at this axis, and no drive leaves for it. */
static void expect_reason(permit_reason_t reason, uint32_t axis)
{
    const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[axis];
    const card_drive_t drive = rig_sent(&rig, axis).drive;
    TEST_ASSERT_BITS_HIGH(1UL << reason, shown->permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(0U, drive.mode | drive.direction | drive.duty);
    TEST_ASSERT_EQUAL_UINT32(0U, shown->speed_cap_percent);
}

static void expect_everywhere(permit_reason_t reason)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        expect_reason(reason, i);
    }
}

void test_SWR_ESTOP_001_the_e_stop_is_a_reason_at_every_axis(void)
{
    begin_move();
    rig_box(&rig, "estop pull");
    rig_cycle(&rig);
    expect_everywhere(PERMIT_REASON_ESTOP_PULLED);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 2U);
    expect_everywhere(PERMIT_REASON_ESTOP_LATCHED);
}

void test_SWR_LOOP_002_a_loop_that_was_late_is_a_reason_at_every_axis(void)
{
    begin_move();
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, LIMIT_OVERRUNS_IN_A_ROW);
    expect_everywhere(PERMIT_REASON_LOOP_STOPPED);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OVERRUNS_IN_A_ROW, rig.outputs.snapshot.overruns);
}

void test_SWR_LINK_001_one_lost_card_is_a_reason_at_every_axis(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_move();
        box("card %s corrupt", i);
        rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES);
        expect_everywhere(PERMIT_REASON_LINK_LOST);
        const snapshot_card_t *const card = &rig.outputs.snapshot.cards[robot_neuro.axes[i].slot];
        TEST_ASSERT_EQUAL_UINT32(LIMIT_LINK_AGE_CYCLES, card->frame_errors);
        TEST_ASSERT_EQUAL_UINT32(LIMIT_LINK_AGE_CYCLES, card->age_cycles);
    }
}

void test_SWR_PEDAL_004_a_pedal_fault_is_a_reason_at_every_axis(void)
{
    begin_move();
    rig_box(&rig, "pedal b open");
    rig_cycles(&rig, 150U);
    expect_everywhere(PERMIT_REASON_PEDAL_FAULT);
}

void test_SWR_PERMIT_004_the_scanner_is_a_reason_at_every_axis(void)
{
    begin_move();
    rig_box(&rig, "scanner on");
    rig_cycle(&rig);
    expect_everywhere(PERMIT_REASON_SCANNER_ACTIVE);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_scanner_active);
}

void test_SWR_PERMIT_003_a_fault_is_a_reason_at_its_axis_alone(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_move();
        rig.controller.axes[i].sealed.encoder.reading ^= 0x40000000;
        controller_seal(&rig.controller);
        rig_cycles(&rig, 2U);
        expect_reason(PERMIT_REASON_AXIS_FAULT, i);
        expect_reason(PERMIT_REASON_AXIS_DISABLED, i);
        const uint32_t other = (i + 1U) % robot_neuro.axis_count;
        TEST_ASSERT_BITS_LOW(1UL << PERMIT_REASON_AXIS_FAULT,
                             rig.outputs.snapshot.axes[other].permit_reasons);
    }
}

void test_SWR_PERMIT_003_nothing_armed_is_a_reason_at_every_axis(void)
{
    rig_start_homed(&rig);
    rig_press(&rig);
    expect_everywhere(PERMIT_REASON_NOTHING_ARMED);
}

void test_SWR_PEDAL_003_a_pedal_not_yet_seen_released_is_a_reason_at_every_axis(void)
{
    rig_start_targeted(&rig);
    rig_press(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    expect_everywhere(PERMIT_REASON_PEDAL_UNPROVEN);
    rig_release(&rig);
    expect_everywhere(PERMIT_REASON_PEDAL_RELEASED);
}

void test_SWR_AXIS_006_an_axis_that_is_not_homed_has_its_reason_in_a_move(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_move();
        axis_lose_reference(&rig.controller.axes[i]);
        controller_seal(&rig.controller);
        rig_cycle(&rig);
        expect_reason(PERMIT_REASON_NOT_HOMED, i);
    }
}

/* The lateral axis is at an unknown place, on its way to its switch, which chatters far from there.
 */
void test_SWR_PERMIT_006_the_reason_of_a_chattering_switch_is_shown_as_standing(void)
{
    const uint32_t reason = UINT32_C(1) << PERMIT_REASON_LIMIT_SWITCH;
    const command_t away = {.kind = (uint32_t)COMMAND_JOG,
                            .as.jog = {.axis = NEURO_AXIS_LATERAL, .to_ticks = -1000}};
    command_t jog = {.kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = NEURO_AXIS_LATERAL}};
    const snapshot_axis_t *const lateral = &rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL];
    uint32_t changes = 0U;
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    (void)rig_command(&rig, away);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 20000U).kind);
    rig_release(&rig);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_LATERAL]);
    jog.as.jog.to_ticks = lateral->position_ticks + 94;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    rig_box(&rig, "switch lateral chatter");
    rig_cycles(&rig, 150U);
    const uint32_t since = lateral->permit_since_cycle;
    for (uint32_t i = 0U; i < 200U; i++) {
        const uint32_t before = rig.controller.records[NEURO_AXIS_LATERAL].sealed.speed_cap_percent;
        rig_cycle(&rig);
        changes += (rig.controller.records[NEURO_AXIS_LATERAL].sealed.speed_cap_percent != before)
                       ? 1U
                       : 0U;
        TEST_ASSERT_EQUAL_HEX32(reason, lateral->permit_reasons);
        TEST_ASSERT_EQUAL_UINT32(since, lateral->permit_since_cycle);
        expect_step(NEXT_STEP_HOLD_PEDAL);
    }
    TEST_ASSERT_GREATER_THAN_UINT32(4U, changes); /* The permit itself is not held. */
}

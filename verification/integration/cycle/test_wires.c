/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: each wire inside the controller is there. It shows the true state, whichever
 * axis it concerns; each fact reaches the permit, the cards and the record.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "controller/controller_events.h"
#include "robot/robot_neuro.h"
#include "safety/permit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* A fiftieth of its range, the way that is free. */
static void begin_jog(uint32_t axis)
{
    const axis_config_t *const config = &robot_neuro.axes[axis];
    const int32_t way = (config->maximum_ticks - config->minimum_ticks) / 50;
    command_t jog = {.kind = (uint32_t)COMMAND_JOG_BY,
                     .as.jog_by = {.axis = axis, .by_ticks = way}};
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    if (rig_command(&rig, jog).status != (uint32_t)STATUS_OK) {
        jog.as.jog_by.by_ticks = -way;
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    }
    rig_press(&rig);
    for (uint32_t i = 0U; (i < 100U) && (rig_sent(&rig, axis).drive.mode == 0U); i++) {
        rig_cycle(&rig);
    }
}

void test_SWR_PERMIT_005_an_axis_that_is_too_fast_gets_no_drive_though_its_permit_stands(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_jog(i);
        TEST_ASSERT_NOT_EQUAL_UINT32(CARD_DRIVE_OFF, rig_sent(&rig, i).drive.mode);
        /* As if it had come a second's way in this cycle. */
        rig.controller.records[i].sealed.speed_cap.position_ticks -=
            robot_neuro.axes[i].speed_ticks_per_s;
        controller_seal(&rig.controller);
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, rig_sent(&rig, i).drive.mode);
        TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.axes[i].permit_reasons);
        TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_MOVING, rig.outputs.snapshot.order);
    }
}

void test_SWR_LINK_008_a_wrong_card_is_named_whenever_it_is_put_in(void)
{
    rig_start(&rig);
    rig_forget(&rig);
    rig_box(&rig, "card yaw foreign");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(EVENT_CARD_LOST, rig.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axes[NEURO_AXIS_YAW].slot, rig.events[0].subject);
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
    const uint32_t slot = robot_neuro.axes[NEURO_AXIS_LATERAL].slot;
    double before[ROBOT_AXIS_MAX];
    double after[ROBOT_AXIS_MAX];
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
    TEST_ASSERT_DOUBLE_WITHIN(0.001, before[NEURO_AXIS_LATERAL], after[NEURO_AXIS_LATERAL]);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
}

void test_SWR_EVENT_004_counters_that_wrap_in_a_move_repeat_no_event(void)
{
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_STARTED));
    begin_move();
    rig_forget(&rig);
    rig.controller.sealed.cycle = UINT32_MAX - 20U;
    rig.controller.sealed.time_us = UINT32_MAX - 20000U;
    rig.controller.authority.sealed.since_us = rig.controller.sealed.time_us;
    rig.controller.sealed.events = UINT32_MAX;
    controller_seal(&rig.controller);
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
    rig.robot = robot_neuro;
    controller_init(&rig.controller, &rig.robot);
    rig.controller.sealed.sequence = UINT32_MAX - 30U;
    controller_seal(&rig.controller);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_CARD_LOST));
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(rig.controller.sealed.sequence - 3U,
                                 rig_link(&rig, i)->report.accepted_sequence);
    }
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

/* Homing was given up just before the switch: it comes first. */
void test_SWR_AXIS_005_an_active_switch_stops_what_drives_towards_it(void)
{
    const int32_t maximum_ticks = robot_neuro.axes[NEURO_AXIS_PITCH].maximum_ticks;
    command_t jog = {.kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = NEURO_AXIS_PITCH}};
    double true_ticks[ROBOT_AXIS_MAX];
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    while (rig.box.axes[NEURO_AXIS_PITCH].motor.position_ticks < (maximum_ticks - 15)) {
        TEST_ASSERT_LESS_THAN_UINT32(20000U, rig.controller.sealed.cycle);
        rig_cycle(&rig);
    }
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    jog.as.jog.to_ticks = rig.outputs.snapshot.axes[NEURO_AXIS_PITCH].position_ticks + 27;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    for (uint32_t i = 0U; rig.outputs.snapshot.axes[NEURO_AXIS_PITCH].limit_switches == 0U; i++) {
        TEST_ASSERT_LESS_THAN_UINT32(10000U, i);
        rig_cycle(&rig);
    }
    bool has_stood = false;
    for (uint32_t i = 0U; i < 400U; i++) {
        const uint32_t switches = rig.outputs.snapshot.axes[NEURO_AXIS_PITCH].limit_switches;
        TEST_ASSERT_TRUE((switches == 0U) ||
                         (rig_sent(&rig, NEURO_AXIS_PITCH).drive.mode == (uint32_t)CARD_DRIVE_OFF));
        has_stood = has_stood || ((rig.outputs.snapshot.axes[NEURO_AXIS_PITCH].permit_reasons &
                                   (1UL << PERMIT_REASON_LIMIT_SWITCH)) != 0U);
        rig_cycle(&rig);
    }
    TEST_ASSERT_TRUE(has_stood);
    box_true_positions(&rig.box, true_ticks);
    TEST_ASSERT_DOUBLE_WITHIN(10.0, (double)maximum_ticks, true_ticks[NEURO_AXIS_PITCH]);
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

/* A jog whose end was damaged after it had been accepted. */
void test_SWR_AXIS_004_the_soft_limit_stops_what_was_accepted(void)
{
    const int32_t minimum_ticks = robot_neuro.axes[NEURO_AXIS_YAW].minimum_ticks;
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_YAW, .to_ticks = minimum_ticks}};
    bool has_stood = false;
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig.controller.mode.request.sealed.way.end_ticks = minimum_ticks - 300;
    controller_seal(&rig.controller);
    rig_press(&rig);
    for (uint32_t i = 0U; i < 4000U; i++) {
        rig_cycle(&rig);
        const snapshot_axis_t *const yaw = &rig.outputs.snapshot.axes[NEURO_AXIS_YAW];
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(minimum_ticks - 5, yaw->position_ticks);
        has_stood = has_stood || ((yaw->permit_reasons & (1UL << PERMIT_REASON_SOFT_LIMIT)) != 0U);
    }
    TEST_ASSERT_TRUE(has_stood);
}

static uint32_t sent_to_cards(uint32_t axis)
{
    return rig_sent(&rig, axis).system_state;
}

void test_SWR_CARD_005_every_card_is_sent_pedal_e_stop_scanner_permit_and_homing(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_move();
        TEST_ASSERT_EQUAL_HEX32((uint32_t)WORKPHASE_MOVE_TO_TARGET << 8U,
                                sent_to_cards(i) & ~(uint32_t)CARD_SYSTEM_PERMIT &
                                    ~(uint32_t)CARD_SYSTEM_PEDAL);
        TEST_ASSERT_BITS_HIGH(CARD_SYSTEM_PERMIT | CARD_SYSTEM_PEDAL, sent_to_cards(i));
        rig_box(&rig, "scanner on");
        rig_cycle(&rig);
        TEST_ASSERT_BITS_HIGH(CARD_SYSTEM_SCANNER, sent_to_cards(i));
        TEST_ASSERT_BITS_LOW(CARD_SYSTEM_PERMIT | CARD_SYSTEM_PEDAL, sent_to_cards(i));
        rig_box(&rig, "estop pull");
        rig_cycle(&rig);
        TEST_ASSERT_BITS_HIGH(CARD_SYSTEM_ESTOP, sent_to_cards(i));
        rig_start(&rig);
        (void)rig_workphase(&rig, WORKPHASE_START_UP);
        TEST_ASSERT_BITS_HIGH(CARD_SYSTEM_HOMING, sent_to_cards(i));
    }
}

void test_SWR_PERMIT_002_the_drive_that_is_shown_is_the_one_that_leaves(void)
{
    uint32_t driven = 0U;
    begin_move();
    for (uint32_t i = 0U; i < (600U * robot_neuro.axis_count); i++) {
        const uint32_t axis = i % robot_neuro.axis_count;
        const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[axis];
        const card_drive_t drive = rig_sent(&rig, axis).drive;
        TEST_ASSERT_EQUAL_UINT32(drive.mode, shown->drive_mode);
        TEST_ASSERT_EQUAL_UINT32(drive.direction, shown->drive_direction);
        TEST_ASSERT_EQUAL_UINT32(drive.duty, shown->drive_duty);
        driven += (drive.duty != 0U) ? 1U : 0U;
        if (axis == 0U) {
            rig_cycle(&rig);
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(10U, driven);
}

void test_SWR_LINK_008_the_card_that_is_shown_is_the_one_that_answers(void)
{
    rig_start(&rig);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const config = &robot_neuro.axes[i];
        TEST_ASSERT_EQUAL_UINT32(config->card_type,
                                 rig.outputs.snapshot.cards[config->slot].card_type);
    }
}

static rig_t arrived;

void test_SWR_MOTION_004_every_axis_must_be_at_its_end_for_an_order_to_be_done(void)
{
    begin_move();
    while (
        (rig.controller.mode.sealed.leg.settled_cycles < 10U) ||
        (memcmp(rig.controller.mode.sealed.leg.profile.end_ticks, rig.controller.plan.target_ticks,
                sizeof rig.controller.plan.target_ticks) != 0)) {
        TEST_ASSERT_LESS_THAN_UINT32(100000U, rig.controller.sealed.cycle);
        rig_cycle(&rig);
    }
    arrived = rig;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig = arrived;
        rig.controller.mode.sealed.leg.profile.end_ticks[i] +=
            robot_neuro.axes[i].deadband_ticks + 3;
        controller_seal(&rig.controller);
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.mode.sealed.leg.settled_cycles);
    }
    rig = arrived;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(11U, rig.controller.mode.sealed.leg.settled_cycles);
}

/* The pose of the plan's ticks, registered by the identity. */
static void settle_target(void)
{
    joints_t joints;
    joints_from_ticks(&robot_neuro, rig.controller.plan.target_ticks, &joints);
    kinematics_forward(&robot_neuro, &robot_neuro.probe, &joints,
                       &rig.controller.plan.scanner_target);
    plan_seal(&rig.controller.plan);
}

void test_SWR_MOTION_002_the_needle_is_retracted_before_any_other_axis_moves(void)
{
    const axis_config_t *const needle = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    begin_move();
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    rig_release(&rig);
    arrived = rig;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig = arrived;
        rig.controller.plan.target_ticks[i] -= 50;
        settle_target();
        (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
        rig_press(&rig);
        const int32_t retracted =
            needle->home_ticks + ((needle->maximum_ticks - needle->minimum_ticks) / 128);
        const int32_t expected = (i == (uint32_t)NEURO_AXIS_INSERTION)
                                     ? rig.controller.plan.target_ticks[NEURO_AXIS_INSERTION]
                                     : retracted;
        TEST_ASSERT_EQUAL_INT32(
            expected, rig.controller.mode.sealed.leg.profile.end_ticks[NEURO_AXIS_INSERTION]);
    }
}

void test_SWR_PHASE_005_a_discarded_order_is_reported_with_its_cause(void)
{
    begin_move();
    rig_forget(&rig);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(EVENT_ORDER_DISCARDED, rig.events[0].id);
    TEST_ASSERT_EQUAL_INT32(STATUS_DISCARDED, rig.events[0].value);
    begin_move();
    rig_forget(&rig);
    rig_box(&rig, "card yaw silent");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(EVENT_CARD_LOST, rig.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(EVENT_ORDER_DISCARDED, rig.events[1].id);
    TEST_ASSERT_EQUAL_INT32(STATUS_FAULT_PRESENT, rig.events[1].value);
}

void test_SWR_EVENT_002_events_beyond_the_bound_are_counted(void)
{
    rig_start_homed(&rig);
    const uint32_t next = rig.controller.sealed.events;
    (void)memset(&rig.outputs, 0, sizeof rig.outputs);
    const cycle_t cycle = {.robot = &robot_neuro, .inputs = &rig.inputs, .outputs = &rig.outputs};
    for (uint32_t i = 0U; i < (CONTROLLER_EVENTS + 8U); i++) {
        controller_note(&rig.controller, &cycle, EVENT_PROPOSAL, i, 0);
    }
    TEST_ASSERT_EQUAL_UINT32(CONTROLLER_EVENTS, rig.outputs.event_count);
    controller_seal(&rig.controller);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(8U, rig.outputs.snapshot.events_lost);
    TEST_ASSERT_EQUAL_UINT32(next + CONTROLLER_EVENTS, rig.outputs.snapshot.events);
}

/* Wrong counts of the head, too slow for SWR-AXIS-016. */
static void creep(int32_t ticks)
{
    for (int32_t i = 0; i < ticks; i++) {
        rig.box.axes[NEURO_AXIS_HEAD].encoder.count++;
        rig_cycles(&rig, 300U);
    }
}

void test_SWR_AXIS_022_wrong_counts_in_small_steps_make_an_axis_unverified(void)
{
    rig_start_targeted(&rig);
    creep(7);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_DRIFTED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_forget(&rig);
    creep(1);
    TEST_ASSERT_EQUAL_UINT32(3U, rig.event_count);
    TEST_ASSERT_EQUAL_UINT32(EVENT_AXIS_DRIFTED, rig.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(EVENT_SEVERITY_WARNING, rig.events[0].severity);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, rig.events[0].subject);
    TEST_ASSERT_EQUAL_INT32(8, abs(rig.events[0].value));
    TEST_ASSERT_EQUAL_UINT32(EVENT_AXIS_UNVERIFIED, rig.events[1].id);
    TEST_ASSERT_EQUAL_UINT32(EVENT_ORDER_DISCARDED, rig.events[2].id);
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_AXIS, rig.events[2].cause);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].reference);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
}

void test_SWR_AXIS_022_homing_ends_the_doubt(void)
{
    rig_start_targeted(&rig);
    creep(8);
    rig_home(&rig);
    rig_forget(&rig);
    creep(7);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_DRIFTED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_AXIS_023_a_scan_leaves_an_account_of_each_axis(void)
{
    uint32_t axes = 0U;
    rig_start_homed(&rig);
    creep(2);
    rig_box(&rig, "scanner on");
    rig_cycle(&rig);
    creep(3);
    rig_forget(&rig);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 3U);
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        const event_t *const event = &rig.events[i];
        if (event->id == (uint32_t)EVENT_SCAN_DRIFT) {
            axes |= 1U << event->subject;
            TEST_ASSERT_INT32_WITHIN(2, (event->subject == (uint32_t)NEURO_AXIS_HEAD) ? -3 : 0,
                                     event->value);
            TEST_ASSERT_EQUAL_UINT32(EVENT_SEVERITY_INFORMATION, event->severity);
        }
    }
    TEST_ASSERT_EQUAL_HEX32(0x7FU, axes);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, rig_count(&rig, EVENT_SCAN_DRIFT));
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: each wire inside the controller is there. Each fact reaches the permit, the
 * cards, the order and the record, whichever axis it concerns.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "controller/controller_events.h"
#include "robot/robot_neuro.h"

#include <stdlib.h>
#include <string.h>

#include "integration/support/wires_world.inc"

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
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

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: memory that has changed by itself is found before it is used, named, forgotten,
 * and moves nothing.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"

#include <stddef.h>
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
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_forget(&rig);
}

/* The first event of the cycle names the section; nothing moves, and the order is given up. */
static void expect_noticed(event_memory_t section, uint32_t index)
{
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(EVENT_MEMORY_DAMAGED, rig.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(EVENT_SEVERITY_CRITICAL, rig.events[0].severity);
    TEST_ASSERT_EQUAL_UINT32(section, rig.events[0].subject);
    TEST_ASSERT_EQUAL_INT32(index, rig.events[0].value);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

static void expect_aborted(void)
{
    TEST_ASSERT_EQUAL_UINT32(1U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig.answers[0].kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig.answers[0].status);
}

void test_SWR_MEMORY_002_a_damaged_axis_is_faulty_and_not_homed_and_its_numbers_are_gone(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_move();
        rig.controller.axes[i].sealed.encoder.position_ticks ^= 0x00100000;
        expect_noticed(EVENT_MEMORY_AXIS, i);
        expect_aborted();
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[i].power);
        TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, rig.outputs.snapshot.axes[i].reference);
        TEST_ASSERT_INT32_WITHIN(100, 0, rig.outputs.snapshot.axes[i].position_ticks);
        TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    }
}

void test_SWR_MEMORY_002_a_fresh_axis_that_is_damaged_is_lost(void)
{
    rig_start(&rig);
    rig_forget(&rig);
    rig.controller.axes[NEURO_AXIS_FEET].sealed.encoder.reading ^= 0x40;
    expect_noticed(EVENT_MEMORY_AXIS, NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST,
                             rig.outputs.snapshot.axes[NEURO_AXIS_FEET].reference);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_FRESH,
                             rig.outputs.snapshot.axes[NEURO_AXIS_ROTATION].reference);
}

void test_SWR_MEMORY_002_what_was_damaged_can_be_started_and_homed_again(void)
{
    begin_move();
    rig.controller.axes[NEURO_AXIS_YAW].sealed.setpoint_ticks ^= 0x8000;
    expect_noticed(EVENT_MEMORY_AXIS, NEURO_AXIS_YAW);
    rig_release(&rig);
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_MEMORY_002_a_damaged_card_is_lost_and_known_again_from_the_table(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_move();
        link_t *const link = rig_link(&rig, i);
        link->sealed.card_type ^= 0x04U;
        expect_noticed(EVENT_MEMORY_CARD, i);
        TEST_ASSERT_EQUAL_UINT32(EVENT_CARD_LOST, rig.events[1].id);
        TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_MEMORY, rig.events[1].value);
        TEST_ASSERT_EQUAL_UINT32(robot_neuro.axes[i].card_type, link->sealed.card_type);
        TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, link->chart.state);
        TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, rig.outputs.snapshot.axes[i].reference);
        expect_aborted();
    }
}

void test_SWR_MEMORY_002_what_is_known_of_vain_START_UPs_is_under_a_seal(void)
{
    uint32_t *const known[] = {&rig.controller.sealed.vain_start_ups,
                               &rig.controller.sealed.vain_moves, &rig.controller.sealed.vain_axis,
                               &rig.controller.sealed.vain_card, &rig.controller.sealed.vain_event};
    for (uint32_t i = 0U; i < (sizeof known / sizeof known[0]); i++) {
        begin_move();
        *known[i] ^= 3U;
        expect_noticed(EVENT_MEMORY_REST, 0U);
        TEST_ASSERT_EQUAL_UINT32(0U, *known[i]);
    }
}

void test_SWR_MEMORY_002_a_damaged_plan_is_no_plan(void)
{
    begin_move();
    rig.controller.plan.target_ticks[NEURO_AXIS_INSERTION] ^= 0x1000;
    expect_noticed(EVENT_MEMORY_PLAN, 0U);
    expect_aborted();
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_registered);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_MEMORY_002_a_damaged_plan_is_found_where_something_else_is_too(void)
{
    begin_move();
    rig.controller.plan.target_ticks[NEURO_AXIS_INSERTION] ^= 0x1000;
    rig.controller.axes[NEURO_AXIS_YAW].sealed.encoder.position_ticks ^= 0x1000;
    rig.controller.sealed.has_arrived ^= 2U;
    rig_forget(&rig);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(3U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_registered);
}

void test_SWR_MEMORY_002_a_damaged_profile_ends_its_motion(void)
{
    begin_move();
    rig.controller.mode.sealed.leg.profile.end_ticks[NEURO_AXIS_HEAD] ^= 0x100;
    expect_noticed(EVENT_MEMORY_PROFILE, 0U);
    expect_aborted();
    TEST_ASSERT_EQUAL_INT32(0, rig.controller.mode.sealed.leg.profile.end_ticks[NEURO_AXIS_HEAD]);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
}

static void expect_all_disabled(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, rig.outputs.snapshot.axes[i].power);
    }
}

void test_SWR_MEMORY_002_damaged_interlocks_ask_for_start_up(void)
{
    begin_move();
    rig.controller.pedal.sealed.is_released ^= 1U;
    expect_noticed(EVENT_MEMORY_INTERLOCKS, 0U);
    expect_aborted();
    expect_all_disabled();
    begin_move();
    rig.controller.procedure.arming.pedal_missing_us ^= 1U;
    expect_noticed(EVENT_MEMORY_INTERLOCKS, 0U);
    begin_move();
    rig.controller.authority.sealed.since_us ^= 1U;
    expect_noticed(EVENT_MEMORY_INTERLOCKS, 0U);
    begin_move();
    rig.controller.loop.sealed.overruns ^= 1U;
    expect_noticed(EVENT_MEMORY_INTERLOCKS, 0U);
    begin_move();
    rig.controller.confirm.sealed.held_cycles ^= 0x100U;
    expect_noticed(EVENT_MEMORY_INTERLOCKS, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.confirm.sealed.held_cycles);
}

void test_SWR_MEMORY_002_a_held_pedal_counts_no_more_after_damage_to_the_interlocks(void)
{
    begin_move();
    rig.controller.loop.sealed.overruns ^= 1U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(PEDAL_GATE_STATE_UNPROVEN, rig.outputs.snapshot.pedal);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(PEDAL_GATE_STATE_UNPROVEN, rig.outputs.snapshot.pedal);
    rig_release(&rig);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(PEDAL_GATE_STATE_PRESSED, rig.outputs.snapshot.pedal);
}

void test_SWR_MEMORY_002_a_damaged_rest_is_forgotten_and_asks_for_start_up(void)
{
    begin_move();
    rig.controller.sealed.pending.id ^= 0x100U;
    expect_noticed(EVENT_MEMORY_REST, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.sealed.pending.is_waiting);
    expect_all_disabled();
    begin_move();
    rig.controller.sealed.table_damage ^= 2U;
    expect_noticed(EVENT_MEMORY_REST, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.sealed.table_damage);
}

void test_SWR_MEMORY_002_axes_that_wait_for_a_kept_position_that_is_damaged_are_lost(void)
{
    const kept_positions_t kept = {.verdict = (uint32_t)KEPT_GOOD};
    (void)memset(&rig, 0, sizeof rig);
    rig.elapsed_us = 1000U;
    rig.robot = robot_neuro;
    box_init(&rig.box, &robot_neuro, 1U);
    controller_init(&rig.controller, &rig.robot);
    controller_restore(&rig.controller, &kept);
    rig.controller.kept.sealed[NEURO_AXIS_FEET].position_ticks ^= 0x10;
    expect_noticed(EVENT_MEMORY_REST, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.positions_awaited);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, rig.outputs.snapshot.axes[i].reference);
    }
}

void test_SWR_MEMORY_002_a_damaged_seal_is_damage(void)
{
    begin_move();
    rig.controller.seals[NEURO_AXIS_PITCH] ^= 1U;
    expect_noticed(EVENT_MEMORY_AXIS, NEURO_AXIS_PITCH);
}

static rig_t moving;

/* One bit of each word of a part of the state, in turn; `count` is noticed of each. */
static void expect_each_word(const void *part, size_t bytes, uint32_t count)
{
    const size_t begin = (size_t)((const uint8_t *)part - (const uint8_t *)&rig);
    for (size_t i = 0U; i < bytes; i += 4U) {
        rig = moving;
        ((uint8_t *)&rig)[begin + i] ^= 0x01U; /* A bool stays one. */
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(count, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    }
    rig = moving;
}

void test_SWR_MEMORY_003_the_numbers_of_every_axis_and_card_are_under_seal(void)
{
    begin_move();
    moving = rig;
    const axis_t *const axis = &rig.controller.axes[NEURO_AXIS_LATERAL];
    const supervision_t *const supervision = &axis->supervision;
    const link_t *const link = rig_link(&rig, NEURO_AXIS_LATERAL);
    expect_each_word(&axis->sealed, sizeof axis->sealed, 1U);
    expect_each_word(&supervision->sealed, sizeof supervision->sealed, 1U);
    expect_each_word(&supervision->stall, STALL_WATCHDOG_CHART_BYTES, 1U);
    expect_each_word(&link->sealed, sizeof link->sealed, 1U);
}

void test_SWR_MEMORY_003_the_numbers_of_the_interlocks_the_mode_and_the_rest_are_under_seal(void)
{
    begin_move();
    moving = rig;
    const controller_t *const self = &rig.controller;
    const axis_record_t *const record = &self->records[NEURO_AXIS_ROTATION];
    expect_each_word(&self->pedal.sealed, sizeof self->pedal.sealed, 1U);
    expect_each_word(&self->pedal.chart, PEDAL_GATE_CHART_BYTES, 1U);
    expect_each_word(&self->loop.sealed, sizeof self->loop.sealed, 1U);
    expect_each_word(&self->confirm.sealed, sizeof self->confirm.sealed, 1U);
    expect_each_word(&self->authority.sealed, sizeof self->authority.sealed, 1U);
    expect_each_word(&self->procedure.arming, ARMING_CHART_BYTES, 1U);
    expect_each_word(&self->mode.sealed, sizeof self->mode.sealed, 1U);
    expect_each_word(&self->mode.request.sealed, sizeof self->mode.request.sealed, 1U);
    expect_each_word(&self->sealed, offsetof(controller_sealed_t, axis_count), 1U);
    /* The number of axes is taken anew from the whole table, before it is compared. */
    expect_each_word(&self->sealed.axis_count, sizeof self->sealed.axis_count, 0U);
    expect_each_word(&self->sealed.cycle,
                     sizeof self->sealed - offsetof(controller_sealed_t, cycle), 1U);
    expect_each_word(&record->sealed, sizeof record->sealed, 1U);
}

/* The clock and the trace of a chart only record; a report decides in the cycle in which it came.
 */
void test_SWR_MEMORY_260_a_field_outside_of_a_sealed_part_is_no_damage(void)
{
    begin_move();
    moving = rig;
    const link_t *const link = rig_link(&rig, NEURO_AXIS_LATERAL);
    const stall_watchdog_chart_t *const stall =
        &rig.controller.axes[NEURO_AXIS_LATERAL].supervision.stall;
    expect_each_word(&stall->now_us, sizeof stall->now_us, 0U);
    expect_each_word(&stall->trace, sizeof stall->trace, 0U);
    expect_each_word(&link->reported_us, sizeof link->reported_us, 0U);
    expect_each_word(&link->frames_missed, sizeof link->frames_missed, 0U);
    expect_each_word(rig.controller.health, sizeof rig.controller.health, 0U);
}

/* State that one mode alone reads. */
void test_SWR_MEMORY_003_what_only_speeds_need_is_under_seal_while_they_were_armed_last(void)
{
    begin_move();
    moving = rig;
    for (size_t i = 0U; i < sizeof rig.controller.mode.request.own.velocity; i += 4U) {
        rig = moving;
        ((uint8_t *)&rig.controller.mode.request.own.velocity)[i] ^= 0x10U;
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
        rig = moving;
        rig.controller.mode.sealed.kind = (uint32_t)MODE_VELOCITY;
        controller_seal(&rig.controller);
        ((uint8_t *)&rig.controller.mode.request.own.velocity)[i] ^= 0x10U;
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
        TEST_ASSERT_EQUAL_UINT32(EVENT_MEMORY_PROFILE, rig.events[0].subject);
    }
}

void test_SWR_MEMORY_003_a_mode_that_there_is_not_is_noticed(void)
{
    begin_move();
    rig.controller.mode.sealed.kind = MODE_KIND_COUNT;
    expect_noticed(EVENT_MEMORY_PROFILE, 0U);
}

void test_SWR_MEMORY_003_kept_positions_count_no_more_once_they_were_compared(void)
{
    begin_move();
    rig.controller.sealed.kept_verdict = (uint32_t)KEPT_GOOD;
    controller_seal(&rig.controller);
    rig.controller.kept.sealed[NEURO_AXIS_FEET].grade = (uint32_t)KEPT_KNOWN;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_CONTRADICTED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.positions_awaited);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_MEMORY_005_a_target_that_does_not_lead_to_its_pose_is_not_armed(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig_start_targeted(&rig);
        rig.controller.plan.target_ticks[i] += 1;
        plan_seal(&rig.controller.plan);
        TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED,
                                 rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
        TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
        TEST_ASSERT_EQUAL_UINT32(WORKPHASE_TARGETING, rig.outputs.snapshot.workphase);
        TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET,
                                 rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    }
}

/* Wild numbers that the seal does not reveal: they came within a cycle. */
void test_SWR_MEMORY_006_a_wild_slot_or_axis_stays_within_its_array(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_YAW, .to_ticks = -200}};
    rig_start_homed(&rig);
    rig.robot.crc ^= 1U; /* A table that is whole would be asked for the slot. */
    for (uint32_t slot = CARD_SLOT_COUNT; slot <= UINT8_MAX; slot++) {
        rig.controller.cards.slots[NEURO_AXIS_YAW] = slot;
        controller_step(&rig.controller, &rig.robot, &rig.inputs, &rig.outputs);
        TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.frames_to_send >> CARD_SLOT_COUNT);
    }
    (void)memset(&rig.robot.axes[NEURO_AXIS_PITCH], 0xFF, sizeof rig.robot.axes[0]);
    controller_init(&rig.controller, &rig.robot);
    controller_step(&rig.controller, &rig.robot, &rig.inputs, &rig.outputs);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.frames_to_send >> CARD_SLOT_COUNT);
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig.controller.mode.request.sealed.way.axis = UINT32_MAX;
    controller_seal(&rig.controller);
    rig_press(&rig);
    rig_cycles(&rig, 20U);
}

/* A damage that came after the check of its cycle is under seal. */
void test_SWR_MEMORY_002_an_armed_motion_of_no_known_mode_is_discarded_at_rest(void)
{
    rig_start_moving(&rig);
    rig_forget(&rig);
    rig.controller.mode.sealed.kind ^= 0x100U;
    controller_seal(&rig.controller);
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.event_count);
    TEST_ASSERT_EQUAL_UINT32(EVENT_ORDER_DISCARDED, rig.events[0].id);
    TEST_ASSERT_EQUAL_INT32(STATUS_FAULT_PRESENT, rig.events[0].value);
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_NONE, rig.events[0].cause);
}

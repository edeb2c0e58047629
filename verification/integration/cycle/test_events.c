/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: events are numbered and name their cause, a damaged chart is repaired to its
 * safe state and reported, and equal inputs give equal outputs. On the simulated box.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"

#include <string.h>

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_EVENT_001_events_are_numbered_without_gaps(void)
{
    rig_start(&rig);
    rig_home(&rig);
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(i, rig.events[i].number);
    }
    TEST_ASSERT_EQUAL_UINT32(rig.event_count, rig.outputs.snapshot.events);
}

/* The only event `id` since rig_forget(). */
static const event_t *only(event_id_t id)
{
    const event_t *found = NULL;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if (rig.events[i].id == (uint32_t)id) {
            TEST_ASSERT_NULL(found);
            found = &rig.events[i];
        }
    }
    TEST_ASSERT_NOT_NULL(found);
    return found;
}

static void expect_cause(event_id_t id, event_cause_t cause, uint32_t peer)
{
    TEST_ASSERT_EQUAL_UINT32(cause, only(id)->cause);
    TEST_ASSERT_EQUAL_UINT32(peer, only(id)->peer);
}

static void command_by(command_source_t source, uint32_t peer, command_kind_t kind,
                       uint32_t argument)
{
    command_t command = commands_of_number(kind, argument);
    command.source = (uint32_t)source;
    command.peer = peer;
    rig_forget(&rig);
    (void)rig_command(&rig, command);
}

void test_SWR_EVENT_005_what_a_command_caused_names_its_source_and_connection(void)
{
    rig_start_homed(&rig);
    rig_leave(&rig);
    command_by(COMMAND_SOURCE_IGTL, 3U, COMMAND_WORKPHASE, WORKPHASE_CALIBRATION);
    expect_cause(EVENT_WORKPHASE, EVENT_CAUSE_IGTL, 3U);
    command_by(COMMAND_SOURCE_IGTL, 3U, COMMAND_REGISTRATION, 0U);
    expect_cause(EVENT_REGISTERED, EVENT_CAUSE_IGTL, 3U);
    command_by(COMMAND_SOURCE_IGTL, 3U, COMMAND_TARGET, 0U);
    expect_cause(EVENT_COMMAND_REFUSED, EVENT_CAUSE_IGTL, 3U);
    command_by(COMMAND_SOURCE_IGTL, 5U, COMMAND_TARGET, 0U);
    expect_cause(EVENT_AUTHORITY_REFUSED, EVENT_CAUSE_IGTL, 5U);
    command_by(COMMAND_SOURCE_IGTL, 4U, COMMAND_PROPOSE_ENTRY, 0U);
    expect_cause(EVENT_PROPOSAL, EVENT_CAUSE_IGTL, 4U);
    rig_start_targeted(&rig);
    rig_leave(&rig);
    command_by(COMMAND_SOURCE_IGTL, 7U, COMMAND_WORKPHASE, WORKPHASE_MOVE_TO_TARGET);
    expect_cause(EVENT_ORDER_ARMED, EVENT_CAUSE_IGTL, 7U);
    command_by(COMMAND_SOURCE_HTTP, 0U, COMMAND_WORKPHASE, WORKPHASE_STOP);
    expect_cause(EVENT_ORDER_DISCARDED, EVENT_CAUSE_CONSOLE, 0U);
    expect_cause(EVENT_WORKPHASE, EVENT_CAUSE_CONSOLE, 0U);
}

void test_SWR_EVENT_009_a_workphase_that_stands_is_reported_once(void)
{
    rig_start_homed(&rig);
    rig_forget(&rig);
    for (uint32_t i = 0U; i < 20U; i++) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_WORKPHASE));
}

void test_SWR_EVENT_005_a_cleared_e_stop_and_an_accepted_target_name_who_asked(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    const command_t target = {.peer = 3U, .kind = COMMAND_TARGET, .as.pose = {.pose = pose}};
    rig_start_targeted(&rig);
    rig_leave(&rig);
    (void)rig_command(&rig, target);
    expect_cause(EVENT_TARGET_ACCEPTED, EVENT_CAUSE_IGTL, 3U);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 5U);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 5U);
    command_by(COMMAND_SOURCE_IGTL, 3U, COMMAND_WORKPHASE, WORKPHASE_START_UP);
    expect_cause(EVENT_ESTOP_CLEARED, EVENT_CAUSE_IGTL, 3U);
}

void test_SWR_EVENT_005_what_happens_after_a_command_is_not_put_down_to_it(void)
{
    rig_start_targeted(&rig);
    rig_leave(&rig);
    command_by(COMMAND_SOURCE_IGTL, 7U, COMMAND_WORKPHASE, WORKPHASE_MOVE_TO_TARGET);
    rig_let_expire(&rig);
    expect_cause(EVENT_ORDER_EXPIRED, EVENT_CAUSE_NONE, 0U);
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

void test_SWR_EVENT_006_what_ended_a_move_is_named(void)
{
    static const struct {
        const char *order;
        event_cause_t cause;
        uint32_t peer;
    } cases[] = {{"estop pull", EVENT_CAUSE_ESTOP, 0U},
                 {"pedal a open", EVENT_CAUSE_PEDAL, 0U},
                 {"motor head stuck", EVENT_CAUSE_AXIS, NEURO_AXIS_HEAD}};
    for (uint32_t i = 0U; i < (sizeof cases / sizeof cases[0]); i++) {
        begin_move();
        rig_box(&rig, cases[i].order);
        rig_cycles(&rig, 700U);
        expect_cause(EVENT_ORDER_DISCARDED, cases[i].cause, cases[i].peer);
    }
}

void test_SWR_EVENT_006_a_lost_card_and_late_cycles_are_named(void)
{
    begin_move();
    rig_box(&rig, "card insertion silent");
    rig_cycles(&rig, 20U);
    expect_cause(EVENT_ORDER_DISCARDED, EVENT_CAUSE_CARD,
                 robot_neuro.axes[NEURO_AXIS_INSERTION].slot);
    begin_move();
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, LIMIT_OVERRUNS_IN_A_ROW);
    expect_cause(EVENT_ORDER_DISCARDED, EVENT_CAUSE_LOOP, 0U);
}

void test_SWR_EVENT_006_a_shut_gate_says_whether_pedal_or_scanner_shut_it(void)
{
    begin_move();
    rig_release(&rig);
    expect_cause(EVENT_PEDAL_RELEASED, EVENT_CAUSE_PEDAL, 0U);
    begin_move();
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 3U);
    expect_cause(EVENT_PEDAL_RELEASED, EVENT_CAUSE_SCANNER, 0U);
    begin_move();
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_cycles(&rig, 3U);
    expect_cause(EVENT_PEDAL_RELEASED, EVENT_CAUSE_NONE, 0U); /* Arming shut it. */
}

static void damage_everything(void)
{
    rig.controller.pedal.chart.state_inverse ^= 1U;
    rig.controller.estop.state_inverse ^= 1U;
    rig.controller.loop.chart.state_inverse ^= 1U;
    rig.controller.procedure.workphase.state_inverse ^= 1U;
    rig.controller.procedure.arming.state_inverse ^= 1U;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig.controller.axes[i].chart.power_inverse ^= 1U;
        rig_link(&rig, i)->chart.state_inverse ^= 1U;
    }
}

void test_SWR_CORE_004_damaged_charts_are_repaired_to_their_safe_states_and_reported(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    damage_everything();
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(19U, rig_count(&rig, EVENT_CHART_REPAIRED));
    TEST_ASSERT_EQUAL_UINT32(PEDAL_GATE_STATE_FAULT, rig.outputs.snapshot.pedal);
    TEST_ASSERT_EQUAL_UINT32(LOOP_GUARD_STATE_STOPPED, rig.outputs.snapshot.loop);
}

void test_SWR_CHART_007_every_chart_is_advanced_in_every_cycle(void)
{
    rig_start_homed(&rig);
    const controller_t *const self = &rig.controller;
    const uint64_t now_us = self->loop.chart.now_us;
    TEST_ASSERT_GREATER_THAN_UINT64(0U, now_us);
    TEST_ASSERT_EQUAL_UINT64(now_us, self->pedal.chart.now_us);
    TEST_ASSERT_EQUAL_UINT64(now_us, self->estop.now_us);
    TEST_ASSERT_EQUAL_UINT64(now_us, self->procedure.workphase.now_us);
    TEST_ASSERT_EQUAL_UINT64(now_us, self->procedure.arming.now_us);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT64(now_us, rig_link(&rig, i)->chart.now_us);
        TEST_ASSERT_EQUAL_UINT64(now_us, self->axes[i].chart.now_us);
        /* It goes by the time between two reports; there was none before the first. */
        TEST_ASSERT_EQUAL_UINT64(now_us - LIMIT_CYCLE_US, self->axes[i].supervision.stall.now_us);
    }
}

/* Five charts of which there is one, and each card's and axis'. */
static void expect_all_charts_named(void)
{
    uint32_t single = 0U;
    uint32_t cards = 0U;
    uint32_t axes = 0U;
    for (uint32_t i = 0U; i < rig.outputs.event_count; i++) {
        const event_t *const event = &rig.outputs.events[i];
        if (event->id != (uint32_t)EVENT_CHART_REPAIRED) {
            continue;
        }
        if (event->subject == (uint32_t)EVENT_CHART_CARD) {
            cards |= (uint32_t)1U << (uint32_t)event->value;
        } else if (event->subject == (uint32_t)EVENT_CHART_AXIS) {
            axes |= (uint32_t)1U << (uint32_t)event->value;
        } else {
            single |= (uint32_t)1U << event->subject;
        }
    }
    TEST_ASSERT_EQUAL_HEX32(0x4FU, single);
    TEST_ASSERT_EQUAL_HEX32(0xFEU, cards);
    TEST_ASSERT_EQUAL_HEX32(0x7FU, axes);
}

void test_SWR_EVENT_003_each_repaired_chart_is_named_with_its_card_or_axis(void)
{
    rig_start_homed(&rig);
    damage_everything();
    rig_cycle(&rig);
    expect_all_charts_named();
}

/* For any value of the damaged copy, lost and absent among them. */
void test_SWR_LINK_003_a_damaged_link_is_a_lost_card(void)
{
    for (uint32_t state = 0U; state < 8U; state++) {
        rig_start_targeted(&rig);
        (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
        rig_link(&rig, 2U)->chart.state ^= (card_link_state_t)(state + 1U);
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
        TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, rig_link(&rig, 2U)->chart.state);
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, rig.outputs.snapshot.axes[2].power);
        TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, rig.outputs.snapshot.axes[2].reference);
        TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
        TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    }
}

/* One bit of one of the two charts. */
static void expect_aborted_once(uint32_t *word)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_forget(&rig);
    *word ^= 2U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig.answers[0].kind);
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_MAX, answer_axis(&rig.answers[0]));
    *word ^= 2U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, rig.outputs.snapshot.workphase);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

void test_SWR_CORE_004_a_damaged_workphase_or_order_aborts_what_was_armed_once(void)
{
    expect_aborted_once(&rig.controller.procedure.workphase.state_inverse);
    expect_aborted_once(&rig.controller.procedure.arming.state_inverse);
}

void test_SWR_EVENT_002_events_beyond_the_most_of_a_cycle_are_counted(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    for (uint32_t i = 0U; i < CONTROLLER_COMMANDS; i++) {
        rig.commands[i].kind = (uint32_t)COMMAND_WORKPHASE;
        rig.commands[i].as.workphase.workphase = (uint32_t)WORKPHASE_MOVE_TO_TARGET;
    }
    damage_everything();
    rig_box(&rig, "scanner on");
    rig_box(&rig, "estop pull");
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig.controller.axes[i].sealed.encoder.reading ^= 0x40000000;
        rig.controller.axes[i].sealed.encoder.jumps = 1U;
    }
    controller_seal(&rig.controller);
    rig.elapsed_us = 2000U;
    rig.command_count = CONTROLLER_COMMANDS;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(CONTROLLER_EVENTS, rig.outputs.event_count);
    TEST_ASSERT_GREATER_THAN_UINT32(0U, rig.outputs.snapshot.events_lost);
    TEST_ASSERT_EQUAL_UINT32(rig.outputs.snapshot.events,
                             rig.outputs.events[CONTROLLER_EVENTS - 1U].number + 1U);
}

void test_SWR_CORE_002_equal_inputs_give_equal_outputs(void)
{
    static rig_t twin;
    rig_start_targeted(&rig);
    twin = rig;
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    (void)rig_workphase(&twin, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_press(&twin);
    for (uint32_t i = 0U; i < 2000U; i++) {
        rig_cycle(&rig);
        rig_cycle(&twin);
        TEST_ASSERT_EQUAL_MEMORY(&rig.outputs, &twin.outputs, sizeof rig.outputs);
    }
}

/* A cycle of the rig, and the same one into outputs that hold something else. */
static void expect_rewritten(void)
{
    static controller_t controller;
    static controller_outputs_t outputs;
    controller = rig.controller;
    (void)memset(&outputs, 0xA5, sizeof outputs);
    rig_cycle(&rig);
    controller_step(&controller, &rig.robot, &rig.inputs, &outputs);
    TEST_ASSERT_EQUAL_MEMORY(&rig.outputs, &outputs, sizeof outputs);
}

void test_SWR_CORE_002_outputs_do_not_depend_on_what_was_in_them(void)
{
    rig_start_moving(&rig);
    expect_rewritten();
    rig.robot.axes[0].home_ticks++;
    expect_rewritten();
    expect_rewritten();
}

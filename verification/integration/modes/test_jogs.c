/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a jog does nothing with the needle, with an axis that is not homed, or for a
 * sender that is not entitled, that it must not do. On the simulated box, whose true positions are
 * looked at.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"
#include "safety/needle.h"

#include "integration/support/jog_world.inc"

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_JOG_002_an_axis_that_shares_a_limit_with_one_not_homed_goes_a_short_way_only(void)
{
    start_manual();
    go(NEURO_AXIS_HEAD, -1000);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_FEET]);
    expect_jog(NEURO_AXIS_HEAD, -1158, STATUS_JOG_TOO_FAR);
    expect_jog(NEURO_AXIS_HEAD, -1157, STATUS_OK);
    expect_jog(NEURO_AXIS_LATERAL, -2000, STATUS_OK);
}

static void expect_needle(bool is_in)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const bool is_across = robot_neuro.axes[i].needle_motion == (uint32_t)NEEDLE_ACROSS;
        expect_jog(
            i, position(i) + (((i == NEURO_AXIS_FEET) || (i == NEURO_AXIS_INSERTION)) ? 20 : -20),
            (is_in && is_across) ? STATUS_NEEDLE_IN : STATUS_OK);
    }
}

void test_SWR_JOG_001_no_axis_is_jogged_across_a_needle_that_is_in(void)
{
    start_manual();
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (robot_neuro.axes[i].limit_switch == (uint8_t)LIMIT_SWITCH_UPPER) {
            go(i, robot_neuro.axes[i].home_ticks - 100);
        }
    }
    go(NEURO_AXIS_INSERTION, 2000);
    shift(NEURO_AXIS_INSERTION, needle_out_ticks(&robot_neuro) - position(NEURO_AXIS_INSERTION));
    rig_cycle(&rig);
    expect_needle(false);
    shift(NEURO_AXIS_INSERTION, 1);
    rig_cycle(&rig);
    expect_needle(true);
}

void test_SWR_JOG_001_no_axis_is_jogged_across_a_needle_that_is_not_homed(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    expect_jog(NEURO_AXIS_LATERAL, -20, STATUS_NEEDLE_IN);
    rig_box(&rig, "switch insertion stuck");
    rig_cycles(&rig, 30U);
    expect_jog(NEURO_AXIS_LATERAL, -20, STATUS_NEEDLE_IN);
    expect_jog(NEURO_AXIS_ROTATION, -20, STATUS_OK);
}

/* The jogged axis reports it in every cycle, whether it is driven just then or not. */
void test_SWR_JOG_001_a_needle_that_comes_in_stops_the_jog_that_runs(void)
{
    start_manual();
    go(NEURO_AXIS_INSERTION, 2000);
    shift(NEURO_AXIS_INSERTION, needle_out_ticks(&robot_neuro) - position(NEURO_AXIS_INSERTION));
    expect_jog(NEURO_AXIS_LATERAL, -2000, STATUS_OK);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_FALSE(has_reason(NEURO_AXIS_LATERAL, PERMIT_REASON_NEEDLE_IN));
    shift(NEURO_AXIS_INSERTION, 100);
    for (uint32_t i = 0U; i < 500U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        TEST_ASSERT_TRUE(has_reason(NEURO_AXIS_LATERAL, PERMIT_REASON_NEEDLE_IN));
        TEST_ASSERT_FALSE(has_reason(NEURO_AXIS_PITCH, PERMIT_REASON_NEEDLE_IN));
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_FALSE(has_reason(NEURO_AXIS_LATERAL, PERMIT_REASON_NEEDLE_IN));
}

void test_SWR_JOG_002_an_axis_that_is_not_homed_is_jogged_a_short_way_only(void)
{
    static const int32_t most[ROBOT_AXIS_MAX] = {157, 157, 94, 6666, 44, 27, 27};
    rig_start_needle_homed(&rig);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (i != (uint32_t)NEURO_AXIS_INSERTION) {
            axis_lose_reference(&rig.controller.axes[i]);
            expect_jog(i, position(i) + most[i], STATUS_OK);
            expect_jog(i, position(i) - most[i], STATUS_OK);
            expect_jog(i, position(i) + most[i] + 1, STATUS_JOG_TOO_FAR);
            expect_jog(i, position(i) - most[i] - 1, STATUS_JOG_TOO_FAR);
        }
    }
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_INSERTION]);
    expect_jog(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) - most[NEURO_AXIS_INSERTION],
               STATUS_OK);
    expect_jog(NEURO_AXIS_INSERTION,
               position(NEURO_AXIS_INSERTION) - most[NEURO_AXIS_INSERTION] - 1, STATUS_JOG_TOO_FAR);
    expect_jog(NEURO_AXIS_YAW, INT32_MIN, STATUS_NEEDLE_IN);
    expect_jog(NEURO_AXIS_ROTATION, INT32_MIN, STATUS_JOG_TOO_FAR);
}

void test_SWR_JOG_002_however_often_the_pedal_is_pressed_the_jog_ends_where_it_was_accepted(void)
{
    rig_start_needle_homed(&rig);
    const int32_t end = position(NEURO_AXIS_HEAD) - 157;
    expect_jog(NEURO_AXIS_HEAD, end, STATUS_OK);
    for (uint32_t i = 0U; i < 5U; i++) {
        rig_press(&rig);
        rig_cycles(&rig, 200U);
        rig_release(&rig);
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(end, position(NEURO_AXIS_HEAD));
    }
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 2000U).kind);
    TEST_ASSERT_EQUAL_INT32(end, position(NEURO_AXIS_HEAD));
}

static void start_unhomed(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    rig_forget(&rig);
}

void test_SWR_JOG_003_a_needle_that_is_not_homed_is_jogged_outwards_only(void)
{
    start_unhomed();
    expect_jog(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) + 1, STATUS_NEEDLE_IN);
    const double before = rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks;
    go(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) - 1500);
    TEST_ASSERT_DOUBLE_WITHIN(10.0, before - 1500.0,
                              rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks);
}

void test_SWR_JOG_003_a_needle_that_is_not_homed_is_never_driven_inwards(void)
{
    start_unhomed();
    expect_jog(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) - 100, STATUS_OK);
    rig.controller.mode.request.sealed.way.end_ticks = 5000;
    controller_seal(&rig.controller);
    rig_press(&rig);
    for (uint32_t i = 0U; i < 1000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_TRUE(has_reason(NEURO_AXIS_INSERTION, PERMIT_REASON_NEEDLE_IN));
}

/* From 1 mm it is asked to come out by 2 mm. */
void test_SWR_JOG_003_a_needle_that_meets_its_switch_stops_there_and_the_jog_ends_by_name(void)
{
    start_unhomed();
    expect_jog(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) - 6666, STATUS_OK);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 20000U).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_OVERDUE));
    TEST_ASSERT_DOUBLE_WITHIN(60.0, 0.0, rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_ENABLED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].power);
}

void test_SWR_JOG_004_a_jog_drives_no_other_axis(void)
{
    start_manual();
    expect_jog(NEURO_AXIS_INSERTION, 20000, STATUS_OK);
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (i != (uint32_t)NEURO_AXIS_INSERTION) {
            shift(i, 5);
        }
    }
    while (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE) {
        rig_cycle(&rig);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            TEST_ASSERT_TRUE((i == (uint32_t)NEURO_AXIS_INSERTION) ||
                             (rig_sent(&rig, i).drive.mode == (uint32_t)CARD_DRIVE_OFF));
        }
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DONE));
}

static void expect_goal(uint32_t axis, int32_t goal_ticks)
{
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_INT32(goal_ticks, rig.outputs.snapshot.axes[axis].target_ticks);
}

static void expect_no_goal(uint32_t axis)
{
    rig_cycle(&rig);
    const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[axis];
    TEST_ASSERT_EQUAL_INT32(shown->setpoint_ticks, shown->target_ticks);
}

void test_SWR_CON_048_the_goal_of_a_jog_is_shown_while_it_is_armed(void)
{
    start_manual();
    expect_no_goal(NEURO_AXIS_INSERTION);
    expect_jog(NEURO_AXIS_INSERTION, 20000, STATUS_OK);
    expect_goal(NEURO_AXIS_INSERTION, 20000);
    expect_no_goal(NEURO_AXIS_YAW);
    rig_press(&rig);
    rig_cycles(&rig, 200U);
    TEST_ASSERT_LESS_THAN_INT32(20000,
                                rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].setpoint_ticks);
    expect_goal(NEURO_AXIS_INSERTION, 20000);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    expect_no_goal(NEURO_AXIS_INSERTION);
}

/* As it comes, from whom it says. */
static status_t send_as(uint32_t source, uint32_t kind, uint32_t argument)
{
    rig.commands[0] = commands_of_number((command_kind_t)(kind % COMMAND_KIND_COUNT), argument);
    rig.commands[0].source = source;
    rig.commands[0].peer = RIG_PAGE;
    rig.commands[0].kind = kind;
    rig.command_count = 1U;
    rig_cycle(&rig);
    return (status_t)rig.outputs.answers[0].status;
}

void test_SWR_CMD_005_a_source_sends_what_is_its_own_and_nothing_else(void)
{
    static const bool is_igtl[COMMAND_KIND_COUNT] = {
        [COMMAND_PROPOSE_REGISTRATION] = true,
        [COMMAND_PROPOSE_ENTRY] = true,
        [COMMAND_PROPOSE_TARGET] = true,
        [COMMAND_NEEDLE] = true,
    };
    static const bool is_http[COMMAND_KIND_COUNT] = {
        [COMMAND_TAKE] = true,         [COMMAND_RENEW] = true,
        [COMMAND_REQUEST] = true,      [COMMAND_HOME_AXIS] = true,
        [COMMAND_CLEAR_AXIS] = true,   [COMMAND_CONFIRM_AXIS] = true,
        [COMMAND_SET_HOME] = true,     [COMMAND_RESTORE] = true,
        [COMMAND_NOTE] = true,         [COMMAND_ENABLE_AXIS] = true,
        [COMMAND_DISABLE_AXIS] = true, [COMMAND_ACCEPT_NO_BLACK_BOX] = true,
    };
    for (uint32_t kind = (uint32_t)COMMAND_REGISTRATION; kind < COMMAND_KIND_COUNT; kind++) {
        start_manual();
        TEST_ASSERT_EQUAL(is_http[kind],
                          send_as(COMMAND_SOURCE_IGTL, kind, 0U) == STATUS_NOT_ALLOWED);
        start_manual();
        TEST_ASSERT_EQUAL(is_igtl[kind],
                          send_as(COMMAND_SOURCE_HTTP, kind, 0U) == STATUS_NOT_ALLOWED);
    }
    for (uint32_t phase = (uint32_t)WORKPHASE_START_UP; phase < WORKPHASE_COUNT; phase++) {
        const uint32_t kind = (uint32_t)COMMAND_WORKPHASE;
        start_manual();
        TEST_ASSERT_NOT_EQUAL(STATUS_NOT_ALLOWED, send_as(COMMAND_SOURCE_HTTP, kind, phase));
        start_manual();
        TEST_ASSERT_NOT_EQUAL(STATUS_NOT_ALLOWED, send_as(COMMAND_SOURCE_IGTL, kind, phase));
    }
}

void test_SWR_CMD_005_who_is_no_source_sends_nothing(void)
{
    start_manual();
    for (uint32_t kind = 0U; kind <= COMMAND_KIND_COUNT; kind++) {
        TEST_ASSERT_EQUAL(STATUS_NOT_ALLOWED,
                          send_as(COMMAND_SOURCE_COUNT, kind, (uint32_t)WORKPHASE_STOP));
    }
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_MANUAL, rig.outputs.snapshot.workphase);
}

void test_SWR_CMD_005_what_nobody_knows_is_refused_as_unknown(void)
{
    start_manual();
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND, send_as(COMMAND_SOURCE_HTTP, 0U, 0U));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND, send_as(COMMAND_SOURCE_HTTP, COMMAND_KIND_COUNT, 0U));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      send_as(COMMAND_SOURCE_HTTP, (uint32_t)COMMAND_WORKPHASE, 0U));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      send_as(COMMAND_SOURCE_HTTP, (uint32_t)COMMAND_WORKPHASE, WORKPHASE_COUNT));
}

/* A command of a connection, which takes authority with it. */
static uint32_t by_network(command_kind_t kind, uint32_t argument, int32_t value)
{
    command_t command = commands_of_number(kind, argument);
    command.source = (uint32_t)COMMAND_SOURCE_IGTL;
    command.peer = RIG_CONNECTION;
    if (kind == COMMAND_JOG) {
        command.as.jog.to_ticks = value;
    } else if (kind == COMMAND_JOG_BY) {
        command.as.jog_by.by_ticks = value;
    } else {
        TEST_ASSERT_EQUAL_INT32(0, value);
    }
    return rig_command(&rig, command).status;
}

void test_SWR_FLOW_006_a_jog_by_openigtlink_is_one_as_of_the_console(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_AUTHORITY, by_network(COMMAND_JOG, NEURO_AXIS_YAW, -200));
    rig_leave(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, by_network(COMMAND_JOG, NEURO_AXIS_YAW, -200));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, by_network(COMMAND_WORKPHASE, WORKPHASE_MANUAL, 0));
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, by_network(COMMAND_JOG, NEURO_AXIS_YAW, 4000));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, by_network(COMMAND_JOG, NEURO_AXIS_YAW, -200));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, by_network(COMMAND_JOG_BY, NEURO_AXIS_YAW, -50));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    TEST_ASSERT_INT32_WITHIN(2, -250, rig_position(&rig, NEURO_AXIS_YAW));
}

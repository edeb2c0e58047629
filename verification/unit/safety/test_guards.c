/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: one word of facts decides what bars a command, and the event of the workphase
 * chart; each fact by itself.
 */
#include "unity.h"

#include "interface/command.h"
#include "procedure/guards.h"

#define AXIS 3U

void setUp(void)
{
}

void tearDown(void)
{
}

static status_t bar(uint32_t facts, command_kind_t kind, uint32_t argument)
{
    return guards_bar(facts, (uint32_t)kind, argument);
}

static workphase_inputs_t inputs(uint32_t facts, mode_kind_t kind)
{
    return guards_inputs(facts, kind, (uint32_t)1U << AXIS, WORKPHASE_MANUAL);
}

void test_SWR_MEMORY_004_without_its_table_stop_and_authority_alone_are_obeyed(void)
{
    TEST_ASSERT_EQUAL(STATUS_MEMORY_DAMAGED,
                      bar(GUARD_BLIND, COMMAND_WORKPHASE, WORKPHASE_START_UP));
    TEST_ASSERT_EQUAL(STATUS_MEMORY_DAMAGED, bar(GUARD_BLIND, COMMAND_JOG, 0U));
    TEST_ASSERT_EQUAL(STATUS_MEMORY_DAMAGED, bar(GUARD_BLIND, COMMAND_RESTORE, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_BLIND, COMMAND_WORKPHASE, WORKPHASE_STOP));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_BLIND, COMMAND_TAKE, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_BLIND, COMMAND_REQUEST, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(~GUARD_BLIND & ~GUARD_UNFIT, COMMAND_JOG, 0U));
}

void test_SWR_LOOP_006_an_unfit_computer_bars_what_enables_axes(void)
{
    TEST_ASSERT_EQUAL(STATUS_COMPUTER_UNFIT,
                      bar(GUARD_UNFIT, COMMAND_WORKPHASE, WORKPHASE_START_UP));
    TEST_ASSERT_EQUAL(STATUS_COMPUTER_UNFIT, bar(GUARD_UNFIT, COMMAND_ENABLE_AXIS, AXIS));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_UNFIT, COMMAND_WORKPHASE, WORKPHASE_MANUAL));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_UNFIT, COMMAND_JOG, WORKPHASE_START_UP));
}

void test_SWR_NEXT_027_without_a_black_box_start_up_alone_is_barred(void)
{
    TEST_ASSERT_EQUAL(STATUS_NO_BLACK_BOX,
                      bar(GUARD_NO_BOX, COMMAND_WORKPHASE, WORKPHASE_START_UP));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_NO_BOX, COMMAND_WORKPHASE, WORKPHASE_MANUAL));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_NO_BOX, COMMAND_HOME_AXIS, AXIS));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_NO_BOX, COMMAND_ENABLE_AXIS, AXIS));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_NO_BOX, COMMAND_RETRACT, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_NO_BOX, COMMAND_ACCEPT_NO_BLACK_BOX, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(~GUARD_NO_BOX & ~GUARD_SPENT & ~GUARD_BLIND & ~GUARD_UNFIT,
                                     COMMAND_WORKPHASE, WORKPHASE_START_UP));
}

void test_SWR_NEXT_024_a_spent_account_bars_what_homes(void)
{
    TEST_ASSERT_EQUAL(STATUS_MOVED_IN_VAIN,
                      bar(GUARD_SPENT, COMMAND_WORKPHASE, WORKPHASE_START_UP));
    TEST_ASSERT_EQUAL(STATUS_MOVED_IN_VAIN, bar(GUARD_SPENT, COMMAND_HOME_AXIS, AXIS));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_SPENT, COMMAND_WORKPHASE, WORKPHASE_MANUAL));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_SPENT, COMMAND_RETRACT, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, bar(GUARD_SPENT, COMMAND_RESTORE, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK,
                      bar(~GUARD_SPENT & ~GUARD_BLIND & ~GUARD_UNFIT, COMMAND_HOME_AXIS, 0U));
}

void test_SWR_MODE_002_each_fact_reaches_the_workphase_chart(void)
{
    const uint32_t all = GUARD_HARDWARE_READY | GUARD_CLEAR | GUARD_LINKED | GUARD_HOMED |
                         GUARD_REGISTERED | GUARD_TARGET | GUARD_CONFIRMATION_DUE;
    const workphase_inputs_t every = inputs(all, MODE_TRAJECTORY);
    const workphase_inputs_t none = inputs(0U, MODE_TRAJECTORY);
    TEST_ASSERT_TRUE(every.is_hardware_ready && every.is_able && every.is_homed);
    TEST_ASSERT_TRUE(every.is_registered && every.has_target && every.is_confirmation_due);
    TEST_ASSERT_FALSE(none.is_hardware_ready || none.is_able || none.is_homed);
    TEST_ASSERT_FALSE(none.is_registered || none.has_target || none.is_confirmation_due);
    TEST_ASSERT_TRUE(inputs(0U, MODE_JOG).is_homed);
}

void test_SWR_MODE_002_a_disabled_axis_bars_the_orders_that_need_it(void)
{
    const uint32_t well = GUARD_CLEAR | GUARD_LINKED;
    TEST_ASSERT_FALSE(inputs(well | ((uint32_t)1U << AXIS), MODE_JOG).is_able);
    TEST_ASSERT_TRUE(inputs(well | ((uint32_t)2U << AXIS), MODE_JOG).is_able);
    TEST_ASSERT_FALSE(inputs(GUARD_CLEAR, MODE_JOG).is_able);
    TEST_ASSERT_FALSE(inputs(GUARD_LINKED, MODE_JOG).is_able);
}

void test_SWR_MODE_001_a_mode_is_allowed_in_its_workphases(void)
{
    TEST_ASSERT_TRUE(inputs(0U, MODE_JOG).is_motion_allowed_here);
    TEST_ASSERT_FALSE(inputs(0U, MODE_MOVE).is_motion_allowed_here);
}

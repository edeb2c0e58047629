/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an open switch is known in its own cycle, and motion stays forbidden after it
 * has closed again, until a reset while it is closed.
 */
#include "unity.h"

#include "charts/estop_latch_chart.h"
#include "limits/requirement_limits.h"
#include "safety/estop_latch.h"

static estop_latch_chart_t latch;

static void make_clear(void)
{
    estop_latch_step(&latch, false, LIMIT_CYCLE_US);
    estop_latch_reset(&latch);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_CLEAR, latch.state);
}

void setUp(void)
{
    estop_latch_init(&latch);
}

void tearDown(void)
{
}

void test_SWR_ESTOP_001_opening_the_switch_is_known_in_that_cycle(void)
{
    make_clear();
    estop_latch_step(&latch, true, LIMIT_CYCLE_US);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_PULLED, latch.state);
}

void test_SWR_ESTOP_001_opening_the_switch_again_is_known_while_latched(void)
{
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, latch.state);
    estop_latch_step(&latch, true, LIMIT_CYCLE_US);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_PULLED, latch.state);
}

void test_SWR_ESTOP_001_a_closed_switch_leaves_motion_free(void)
{
    make_clear();
    for (uint32_t i = 0U; i < 1000U; i++) {
        estop_latch_step(&latch, false, LIMIT_CYCLE_US);
        TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_CLEAR, latch.state);
    }
}

void test_SWR_ESTOP_002_the_system_starts_latched(void)
{
    estop_latch_step(&latch, false, LIMIT_CYCLE_US);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, latch.state);
}

void test_SWR_ESTOP_002_closing_the_switch_leaves_the_latch(void)
{
    make_clear();
    estop_latch_step(&latch, true, LIMIT_CYCLE_US);
    for (uint32_t i = 0U; i < 1000U; i++) {
        estop_latch_step(&latch, false, LIMIT_CYCLE_US);
        TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, latch.state);
    }
}

void test_SWR_ESTOP_002_a_reset_while_the_switch_is_open_is_refused(void)
{
    estop_latch_step(&latch, true, LIMIT_CYCLE_US);
    estop_latch_reset(&latch);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_PULLED, latch.state);
    estop_latch_step(&latch, false, LIMIT_CYCLE_US);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, latch.state);
}

void test_SWR_ESTOP_002_a_reset_while_the_switch_is_closed_clears_the_latch(void)
{
    make_clear();
    estop_latch_step(&latch, true, LIMIT_CYCLE_US);
    estop_latch_step(&latch, false, LIMIT_CYCLE_US);
    estop_latch_reset(&latch);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_CLEAR, latch.state);
}

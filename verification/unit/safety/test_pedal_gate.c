/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the gate is open only in a cycle in which both channels are closed, and only
 * after both were seen open; channels that differ shut it at once and, after a while, for good.
 */
#include "unity.h"

#include "charts/pedal_gate_chart.h"
#include "limits/requirement_limits.h"
#include "safety/pedal_gate.h"

#define CYCLE_US 1000U

static pedal_gate_t gate;

static void channels(bool is_a_closed, bool is_b_closed)
{
    pedal_gate_step(&gate, is_a_closed, is_b_closed, CYCLE_US);
}

static void release(void)
{
    channels(false, false);
}

static void press(void)
{
    channels(true, true);
}

/* The channels differ from now on, for `us` after the cycle that first saw it. */
static void differ_for(uint32_t us)
{
    pedal_gate_step(&gate, true, false, CYCLE_US);
    pedal_gate_step(&gate, true, false, us);
}

static bool is_fault(void)
{
    return gate.chart.state == PEDAL_GATE_STATE_FAULT;
}

static void make_fault(void)
{
    release();
    differ_for(LIMIT_PEDAL_DISCREPANCY_US);
    TEST_ASSERT_TRUE(is_fault());
}

void setUp(void)
{
    pedal_gate_init(&gate);
}

void tearDown(void)
{
}

void test_SWR_PEDAL_001_the_gate_is_shut_at_the_start(void)
{
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_001_the_gate_is_shut_while_the_pedal_is_released(void)
{
    release();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    release();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_001_the_gate_is_open_while_both_channels_are_closed(void)
{
    release();
    for (uint32_t i = 0U; i < 1000U; i++) {
        press();
        TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
    }
}

void test_SWR_PEDAL_002_releasing_both_channels_shuts_the_gate_in_that_cycle(void)
{
    release();
    press();
    release();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_002_releasing_one_channel_shuts_the_gate_in_that_cycle(void)
{
    release();
    press();
    channels(false, true);
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    release();
    press();
    TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
    channels(true, false);
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_003_a_pedal_held_since_the_start_does_not_open_the_gate(void)
{
    for (uint32_t i = 0U; i < 1000U; i++) {
        press();
        TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    }
    release();
    press();
    TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_003_one_channel_seen_released_is_not_enough(void)
{
    press();
    channels(true, false);
    press();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    channels(false, true);
    press();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_003_one_channel_lifted_for_a_moment_needs_a_full_release(void)
{
    release();
    press();
    channels(true, false);
    press();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    release();
    press();
    TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_003_arming_shuts_an_open_gate_until_the_pedal_was_released(void)
{
    release();
    press();
    pedal_gate_renew(&gate);
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    press();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    release();
    press();
    TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_003_arming_while_the_pedal_is_released_lets_the_next_press_open(void)
{
    release();
    pedal_gate_renew(&gate);
    press();
    TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_003_arming_while_the_pedal_goes_down_needs_a_release(void)
{
    release();
    channels(true, false);
    pedal_gate_renew(&gate);
    press();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_004_channels_that_differ_do_not_open_the_gate(void)
{
    release();
    channels(true, false);
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    release();
    channels(false, true);
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_004_a_short_difference_on_the_way_down_is_no_fault(void)
{
    release();
    differ_for(LIMIT_PEDAL_DISCREPANCY_US - 1U);
    TEST_ASSERT_FALSE(is_fault());
    pedal_gate_step(&gate, true, true, 0U);
    TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_004_a_long_difference_on_the_way_down_is_a_fault(void)
{
    release();
    differ_for(LIMIT_PEDAL_DISCREPANCY_US);
    TEST_ASSERT_TRUE(is_fault());
    press();
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_004_a_short_difference_on_the_way_up_is_no_fault(void)
{
    release();
    press();
    differ_for(LIMIT_PEDAL_DISCREPANCY_US - 1U);
    TEST_ASSERT_FALSE(is_fault());
    pedal_gate_step(&gate, false, false, 0U);
    press();
    TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_004_a_long_difference_on_the_way_up_is_a_fault(void)
{
    release();
    press();
    differ_for(LIMIT_PEDAL_DISCREPANCY_US);
    TEST_ASSERT_TRUE(is_fault());
}

void test_SWR_PEDAL_004_a_pedal_that_differs_since_the_start_becomes_a_fault(void)
{
    differ_for(LIMIT_PEDAL_DISCREPANCY_US - 1U);
    TEST_ASSERT_FALSE(is_fault());
    pedal_gate_step(&gate, true, false, 1U);
    TEST_ASSERT_TRUE(is_fault());
}

void test_SWR_PEDAL_004_two_short_differences_do_not_add_up(void)
{
    release();
    differ_for(LIMIT_PEDAL_DISCREPANCY_US - 1U);
    pedal_gate_step(&gate, false, false, 0U);
    differ_for(LIMIT_PEDAL_DISCREPANCY_US - 1U);
    TEST_ASSERT_FALSE(is_fault());
}

void test_SWR_PEDAL_004_arming_does_not_extend_the_time_of_a_difference(void)
{
    release();
    differ_for(LIMIT_PEDAL_DISCREPANCY_US - 1U);
    pedal_gate_renew(&gate);
    TEST_ASSERT_FALSE(is_fault());
    pedal_gate_step(&gate, true, false, 1U);
    TEST_ASSERT_TRUE(is_fault());
}

void test_SWR_PEDAL_007_releasing_and_pressing_does_not_clear_a_fault(void)
{
    make_fault();
    release();
    press();
    TEST_ASSERT_TRUE(is_fault());
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
}

void test_SWR_PEDAL_007_a_reset_with_a_closed_channel_is_refused(void)
{
    static const bool closed[3][2] = {{true, true}, {true, false}, {false, true}};

    make_fault();
    for (uint32_t i = 0U; i < 3U; i++) {
        channels(closed[i][0], closed[i][1]);
        pedal_gate_reset(&gate);
        TEST_ASSERT_TRUE(is_fault());
    }
}

void test_SWR_PEDAL_007_a_reset_with_the_pedal_released_clears_the_fault(void)
{
    make_fault();
    release();
    pedal_gate_reset(&gate);
    TEST_ASSERT_FALSE(is_fault());
    TEST_ASSERT_FALSE(pedal_gate_is_open(&gate));
    press();
    TEST_ASSERT_TRUE(pedal_gate_is_open(&gate));
}

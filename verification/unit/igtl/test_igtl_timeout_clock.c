/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a timeout of an answer runs by the cycles of a controller that runs, and by the
 * turns of the OpenIGTLink process while the controller is silent.
 */
#include "unity.h"

#include "igtl/server/igtl_timeout_clock.h"
#include "limits/requirement_limits.h"

#include <string.h>

static igtl_timeout_clock_t timeouts;
static uint32_t beats;

void setUp(void)
{
    (void)memset(&timeouts, 0, sizeof timeouts);
    beats = UINT32_MAX - 2U; /* It wraps in each test. */
    timeouts.beats = beats;
}

void tearDown(void)
{
}

static void turn(uint64_t elapsed_us, uint32_t cycles)
{
    beats += cycles;
    igtl_timeout_clock_step(&timeouts, elapsed_us, 1U, beats, false);
}

static void expect(uint64_t timeout_us, uint64_t listened_us)
{
    TEST_ASSERT_EQUAL_UINT64(timeout_us, igtl_timeout_clock_us(&timeouts));
    TEST_ASSERT_EQUAL_UINT64(listened_us, igtl_timeout_clock_listened_us(&timeouts));
}

void test_SWR_IGTL_100_with_a_cycle_each_ms_it_is_the_time_of_the_process(void)
{
    for (uint32_t i = 0U; i < 10U; i++) {
        turn(3000U, 3U);
    }
    expect(30000U, 30000U);
}

void test_SWR_IGTL_100_a_controller_with_fewer_cycles_has_longer(void)
{
    for (uint32_t i = 0U; i < 10U; i++) {
        turn(4000U, 1U);
    }
    expect(10000U, 40000U);
}

void test_SWR_IGTL_100_a_controller_without_cycles_is_waited_for_until_it_is_silent(void)
{
    turn(10000U, 0U);
    turn(10000U, 0U);
    expect(0U, 20000U);
}

void test_SWR_IGTL_100_a_pause_of_the_machine_counts_as_one_turn(void)
{
    turn(UINT64_C(5000000), 5U);
    expect(5000U, LIMIT_IGTL_TURN_US);
    turn(UINT64_C(5000000), 5000U);
    expect(5000U + LIMIT_IGTL_TURN_US, 2U * LIMIT_IGTL_TURN_US);
}

/* It catches up with its cycles: they count in the turns that follow, those of one turn at most. */
void test_SWR_IGTL_100_cycles_that_come_at_once_count_by_and_by(void)
{
    turn(1000U, 15U);
    expect(1000U, 1000U);
    turn(10000U, 0U);
    expect(11000U, 11000U);
    turn(10000U, 0U);
    expect(15000U, 21000U);
    turn(1000U, 1000U);
    turn(LIMIT_IGTL_TURN_US, 0U);
    expect(15000U + LIMIT_IGTL_TURN_US, 22000U + LIMIT_IGTL_TURN_US);
}

void test_SWR_IGTL_100_the_time_of_a_slow_board_is_slow(void)
{
    for (uint32_t i = 0U; i < 100U; i++) {
        igtl_timeout_clock_step(&timeouts, 3000U, 10U, beats, false);
        beats++;
    }
    expect(29700U, 30000U);
}

void test_SWR_IGTL_101_of_a_silent_controller_each_turn_counts(void)
{
    igtl_timeout_clock_step(&timeouts, 10000U, 1U, beats, true);
    expect(10000U, 10000U);
    igtl_timeout_clock_step(&timeouts, UINT64_C(5000000), 4U, beats, true);
    expect(15000U, 15000U);
}

/* The cycles before it fell silent have been counted. */
void test_SWR_IGTL_101_cycles_count_once(void)
{
    turn(1000U, 6U);
    igtl_timeout_clock_step(&timeouts, 5000U, 1U, beats, true);
    turn(5000U, 0U);
    expect(6000U, 11000U);
}

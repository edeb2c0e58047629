/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a press of the operator's button counts once, when it was held long enough after
 * the button was seen released, with nothing against it all the while.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "safety/confirm_button.h"

#include <string.h>

#define HOLD_CYCLES (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US)

static confirm_button_t button;

/* How often the button counted in `cycles`. */
static uint32_t cycles(uint32_t count, bool is_pressed, bool is_barred)
{
    uint32_t confirmed = 0U;
    for (uint32_t i = 0U; i < count; i++) {
        confirmed += confirm_button_step(&button, is_pressed, is_barred) ? 1U : 0U;
    }
    return confirmed;
}

static void release(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, cycles(1U, false, false));
}

void setUp(void)
{
    (void)memset(&button, 0, sizeof button);
}

void tearDown(void)
{
}

void test_SWR_REF_006_a_press_counts_in_the_cycle_in_which_it_was_held_long_enough(void)
{
    release();
    TEST_ASSERT_EQUAL_UINT32(0U, cycles(HOLD_CYCLES - 1U, true, false));
    TEST_ASSERT_TRUE(confirm_button_step(&button, true, false));
}

void test_SWR_REF_006_a_press_counts_once(void)
{
    release();
    TEST_ASSERT_EQUAL_UINT32(1U, cycles(100U * HOLD_CYCLES, true, false));
    release();
    TEST_ASSERT_EQUAL_UINT32(1U, cycles(HOLD_CYCLES, true, false));
}

void test_SWR_REF_006_a_button_that_was_never_seen_released_does_not_count(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, cycles(100U * HOLD_CYCLES, true, false));
}

void test_SWR_REF_006_two_short_presses_are_not_a_long_one(void)
{
    release();
    TEST_ASSERT_EQUAL_UINT32(0U, cycles(HOLD_CYCLES - 1U, true, false));
    release();
    TEST_ASSERT_EQUAL_UINT32(0U, cycles(HOLD_CYCLES - 1U, true, false));
}

void test_SWR_REF_006_a_press_that_something_stood_against_does_not_count(void)
{
    release();
    (void)cycles(HOLD_CYCLES / 2U, true, false);
    (void)cycles(1U, true, true);
    TEST_ASSERT_EQUAL_UINT32(0U, cycles(100U * HOLD_CYCLES, true, false));
}

void test_SWR_REF_006_a_release_counts_only_while_nothing_stands_against_it(void)
{
    (void)cycles(10U, false, true);
    TEST_ASSERT_EQUAL_UINT32(0U, cycles(100U * HOLD_CYCLES, true, false));
    release();
    TEST_ASSERT_EQUAL_UINT32(1U, cycles(HOLD_CYCLES, true, false));
}

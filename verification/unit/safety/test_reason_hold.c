/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: what flickers is shown as standing, everything else as it is.
 */
#include "safety/reason_hold.h"

#include "limits/requirement_limits.h"
#include "unity.h"

#include <string.h>

#define SWITCH (UINT32_C(1) << PERMIT_REASON_LIMIT_SWITCH)
#define LIMIT (UINT32_C(1) << PERMIT_REASON_SOFT_LIMIT)
#define PEDAL (UINT32_C(1) << PERMIT_REASON_PEDAL_RELEASED)
#define HOLD_CYCLES (LIMIT_REASON_HOLD_US / LIMIT_CYCLE_US)

static reason_hold_t hold;

void setUp(void)
{
    (void)memset(&hold, 0, sizeof hold);
}

void tearDown(void)
{
}

static uint32_t run(uint32_t reasons, uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        reason_hold_step(&hold, reasons, LIMIT_CYCLE_US);
    }
    return hold.shown;
}

void test_SWR_PERMIT_006_a_reason_that_goes_once_is_gone_at_once(void)
{
    TEST_ASSERT_EQUAL_HEX32(SWITCH | PEDAL, run(SWITCH | PEDAL, 1U));
    TEST_ASSERT_EQUAL_HEX32(PEDAL, run(PEDAL, 1U));
    TEST_ASSERT_EQUAL_HEX32(0U, run(0U, 1U));
}

void test_SWR_PERMIT_006_a_reason_that_comes_back_soon_stands_until_it_stays_away(void)
{
    (void)run(SWITCH, 1U);
    (void)run(0U, HOLD_CYCLES - 1U);
    (void)run(SWITCH, 1U);
    TEST_ASSERT_EQUAL_HEX32(SWITCH, run(0U, HOLD_CYCLES - 1U));
    TEST_ASSERT_EQUAL_HEX32(0U, run(0U, 1U));
}

void test_SWR_PERMIT_006_a_reason_that_comes_back_late_is_shown_as_it_is(void)
{
    (void)run(SWITCH, 1U);
    (void)run(0U, HOLD_CYCLES);
    (void)run(SWITCH, 1U);
    TEST_ASSERT_EQUAL_HEX32(0U, run(0U, 1U));
}

void test_SWR_PERMIT_006_one_reason_that_flickers_holds_no_other(void)
{
    for (uint32_t i = 0U; i < 10U; i++) {
        (void)run(SWITCH | LIMIT, 1U);
        TEST_ASSERT_BITS_HIGH(LIMIT, run(LIMIT, 1U));
    }
    TEST_ASSERT_EQUAL_HEX32(SWITCH, run(0U, 1U));
}

/* The operator sees at once that the pedal was pressed, however fast he is. */
void test_SWR_PERMIT_006_what_the_operator_does_is_shown_as_it_is(void)
{
    for (uint32_t i = 0U; i < 10U; i++) {
        TEST_ASSERT_EQUAL_HEX32(PEDAL, run(PEDAL, 1U));
        TEST_ASSERT_EQUAL_HEX32(0U, run(0U, 1U));
    }
}

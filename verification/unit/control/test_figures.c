/* SPDX-License-Identifier: Apache-2.0 */
/** @file Rule under test: each figure of the loop is that of the cycles that were counted, and the
 * worst wake-up of a second is forgotten with it. */
#include "control/figures.h"

#include "unity.h"

#include <string.h>

#define NS_PER_US 1000U

static figures_t counted;
static loop_figures_t reported;

void setUp(void)
{
    (void)memset(&counted, 0, sizeof counted);
    (void)memset(&reported, 0, sizeof reported);
}

void tearDown(void)
{
}

/* Wake-ups of 1 to 1000 us, and steps of twice as long. */
static void count_thousand(void)
{
    for (uint64_t us = 1U; us <= 1000U; us++) {
        const uint64_t took_ns[LOOP_STAGE_COUNT] = {
            [LOOP_STAGE_WAKE] = us * NS_PER_US, [LOOP_STAGE_STEP] = 2U * us * NS_PER_US};
        figures_add(&counted, took_ns);
    }
}

void test_SWR_LOOP_005_each_figure_is_of_the_cycles_that_were_counted(void)
{
    count_thousand();
    figures_publish(&counted, &reported);
    TEST_ASSERT_EQUAL_UINT64(1000U, reported.cycles);
    TEST_ASSERT_EQUAL_UINT32(500U, reported.wake_p50_us);
    TEST_ASSERT_EQUAL_UINT32(990U, reported.wake_p99_us);
    TEST_ASSERT_EQUAL_UINT32(999U, reported.wake_p999_us);
    TEST_ASSERT_EQUAL_UINT32(1000U, reported.wake_worst_us);
    TEST_ASSERT_EQUAL_UINT32(1980U, reported.step_p99_us);
    TEST_ASSERT_EQUAL_UINT32(2000U, reported.step_worst_us);
    TEST_ASSERT_EQUAL_UINT32(2000U, reported.stages[LOOP_STAGE_STEP].worst_us);
}

void test_SWR_LOOP_005_the_worst_of_a_second_is_of_that_second(void)
{
    count_thousand();
    figures_publish(&counted, &reported);
    TEST_ASSERT_EQUAL_UINT32(1000U, reported.second_worst_us);
    figures_publish(&counted, &reported);
    TEST_ASSERT_EQUAL_UINT32(0U, reported.second_worst_us);
    TEST_ASSERT_EQUAL_UINT32(1000U, reported.wake_worst_us);
}

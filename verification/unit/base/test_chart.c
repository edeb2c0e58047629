/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a compiled chart's trace keeps its last steps, and its queue ends in the safe
 * state rather than lose an event. */
#include "base/chart.h"
#include "unit/support/contract_trap.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_CHART_007_the_trace_keeps_the_last_steps_with_their_time(void)
{
    chart_trace_t trace = {.count = 0U};
    for (uint32_t i = 0U; i < (CHART_TRACE_LENGTH + 2U); i++) {
        chart_trace_add(&trace, 1000U * (uint64_t)i, i + 1U);
    }
    TEST_ASSERT_EQUAL_UINT32(CHART_TRACE_LENGTH + 2U, trace.count);
    for (uint32_t i = 2U; i < trace.count; i++) {
        const chart_step_t *const step = &trace.steps[i % CHART_TRACE_LENGTH];
        TEST_ASSERT_EQUAL_UINT32(i + 1U, step->transition);
        TEST_ASSERT_EQUAL_UINT64(1000U * (uint64_t)i, step->now_us);
    }
}

void test_SWR_CORE_003_an_event_that_does_not_fit_is_not_lost_silently(void)
{
    TEST_ASSERT_EQUAL_UINT32(1U, chart_queue_slot(1U, 2U));
    EXPECT_CONTRACT("chart", 1U, (void)chart_queue_slot(2U, 2U));
}

void test_SWR_CORE_003_a_macrostep_that_does_not_end_is_noticed(void)
{
    chart_require_settled(3U, 3U);
    EXPECT_CONTRACT("chart", 2U, chart_require_settled(2U, 3U));
}

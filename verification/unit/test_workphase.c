/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Workphases are entered only by the allow-list, stated here a second time as a table.
 */
#include "procedure/workphase.h"

#include "unity.h"

#include "charts/workphases_chart.h"

static workphases_chart_t chart;
static workphases_inputs_t inputs;

void setUp(void)
{
    workphases_chart_init(&chart);
    inputs.is_hardware_ready = true;
    inputs.is_able = true;
    inputs.is_homed = true;
    inputs.is_registered = true;
    inputs.has_target = true;
}

void tearDown(void)
{
}

/* Row: present workphase; column: requested. STOP and EMERGENCY are always allowed. */
static const char *const allowed[WORKPHASE_COUNT] = {
    /*                   USPCTMASE */
    /* UNDEFINED      */ ".S.....SE",
    /* START_UP       */ ".SPC..MSE",
    /* PLANNING       */ ".SPCT.MSE",
    /* CALIBRATION    */ ".SPCT.MSE",
    /* TARGETING      */ ".SPCTVMSE",
    /* MOVE_TO_TARGET */ ".SP.TVMSE",
    /* MANUAL         */ ".SPCT.MSE",
    /* STOP           */ ".SPCT.MSE",
    /* EMERGENCY      */ ".S.....SE",
};

/* The shortest way there. */
static void enter(workphase_t workphase)
{
    static const workphase_t way[] = {WORKPHASE_START_UP, WORKPHASE_PLANNING, WORKPHASE_TARGETING};
    uint32_t actions = 0U;
    workphases_chart_init(&chart);
    if (workphase == WORKPHASE_UNDEFINED) {
        return;
    }
    for (uint32_t i = 0U; i < (sizeof way / sizeof way[0]); i++) {
        TEST_ASSERT_EQUAL(STATUS_OK,
                          workphase_request(&chart, &inputs, (uint32_t)way[i], &actions));
    }
    if (workphase == WORKPHASE_START_UP) {
        workphases_chart_init(&chart);
    }
    TEST_ASSERT_EQUAL(STATUS_OK, workphase_request(&chart, &inputs, (uint32_t)workphase, &actions));
    TEST_ASSERT_EQUAL(workphase, workphase_present(&chart));
}

void test_SWR_PHASE_001_every_request_in_every_workphase_follows_the_allow_list(void)
{
    for (uint32_t from = 0U; from < WORKPHASE_COUNT; from++) {
        for (uint32_t to = 1U; to < WORKPHASE_COUNT; to++) {
            uint32_t actions = 0U;
            enter((workphase_t)from);
            const bool is_allowed = allowed[from][to] != '.';
            const status_t status = workphase_request(&chart, &inputs, to, &actions);
            TEST_ASSERT_EQUAL(is_allowed ? STATUS_OK : STATUS_WRONG_WORKPHASE, status);
            TEST_ASSERT_EQUAL_UINT32(is_allowed ? to : from, (uint32_t)workphase_present(&chart));
        }
    }
}

void test_SWR_PHASE_007_emergency_is_left_only_by_start_up_and_stop(void)
{
    uint32_t actions = 0U;
    for (uint32_t to = 1U; to < WORKPHASE_COUNT; to++) {
        enter(WORKPHASE_EMERGENCY);
        (void)workphase_request(&chart, &inputs, to, &actions);
        const bool has_left = workphase_present(&chart) != WORKPHASE_EMERGENCY;
        const bool may_leave =
            (to == (uint32_t)WORKPHASE_START_UP) || (to == (uint32_t)WORKPHASE_STOP);
        TEST_ASSERT_EQUAL(may_leave, has_left);
    }
}

void test_SWR_PHASE_002_a_workphase_outside_the_enumeration_is_unknown(void)
{
    uint32_t actions = 0U;
    enter(WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      workphase_request(&chart, &inputs, WORKPHASE_COUNT, &actions));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      workphase_request(&chart, &inputs, UINT32_MAX, &actions));
    TEST_ASSERT_EQUAL(WORKPHASE_PLANNING, workphase_present(&chart));
}

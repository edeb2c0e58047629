/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: where two axes are to the limit that they share, exact to the nanometre.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/robot_neuro.h"

TEST_SOURCE_FILE("fixed.c")

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_ROBOT_001_the_coupled_limit_is_that_of_the_geometry(void)
{
    const coupled_limit_t *const limit = &robot_neuro.coupled_limits[0];
    const int32_t *const geometry_nm = robot_neuro.geometry_nm;
    const int32_t home_nm = geometry_nm[NEURO_HOME_SEPARATION];
    TEST_ASSERT_EQUAL_UINT32(1U, robot_neuro.coupled_limit_count);
    TEST_ASSERT_EQUAL_STRING("separation", limit->name);
    TEST_ASSERT_EQUAL_UINT32(STATUS_SEPARATION_LIMIT, limit->refusal);
    TEST_ASSERT_EQUAL_UINT32(AXIS_HEAD, limit->first);
    TEST_ASSERT_EQUAL_UINT32(AXIS_FEET, limit->second);
    TEST_ASSERT_EQUAL_INT32(geometry_nm[NEURO_MINIMUM_SEPARATION] - home_nm, limit->minimum_nm);
    TEST_ASSERT_EQUAL_INT32(geometry_nm[NEURO_MAXIMUM_SEPARATION] - home_nm, limit->maximum_nm);
}

void test_SWR_COUPLE_002_the_first_axis_counts_upwards_and_the_second_downwards(void)
{
    const coupled_limit_t *const limit = &robot_neuro.coupled_limits[0];
    TEST_ASSERT_EQUAL_INT64(12700025, coupled_limit_nm(&robot_neuro, limit, 1000, 0));
    TEST_ASSERT_EQUAL_INT64(-12700025, coupled_limit_nm(&robot_neuro, limit, 0, 1000));
    TEST_ASSERT_EQUAL_INT64(0, coupled_limit_nm(&robot_neuro, limit, -7000, -7000));
}

void test_SWR_COUPLE_002_an_end_has_the_margin_to_both_ends_of_the_range(void)
{
    const coupled_limit_t *const limit = &robot_neuro.coupled_limits[0];
    const int64_t margin = (int64_t)LIMIT_COUPLED_MARGIN_NM;
    const int64_t least = (int64_t)limit->minimum_nm + margin;
    const int64_t most = (int64_t)limit->maximum_nm - margin;
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_BELOW, coupled_limit_side(limit, least - 1));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_INSIDE, coupled_limit_side(limit, least));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_INSIDE, coupled_limit_side(limit, most));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_ABOVE, coupled_limit_side(limit, most + 1));
}

static void expect_end(coupled_side_t side, const int32_t ticks[ROBOT_AXIS_MAX])
{
    const solution_t judged = coupled_limit_judge(&robot_neuro, ticks);
    TEST_ASSERT_EQUAL((side == COUPLED_LIMIT_INSIDE) ? STATUS_OK : STATUS_SEPARATION_LIMIT,
                      judged.status);
    TEST_ASSERT_EQUAL_UINT8(0U, judged.axis);
    TEST_ASSERT_EQUAL_UINT8((side == COUPLED_LIMIT_ABOVE) ? 1U : 0U, judged.is_maximum);
}

void test_SWR_COUPLE_002_positions_of_all_axes_are_judged_by_the_limit_of_two(void)
{
    const int32_t near_ticks[ROBOT_AXIS_MAX] = {-8000, 0, 0, 0, 0, 0, 0};
    const int32_t far_ticks[ROBOT_AXIS_MAX] = {0, -5000, 0, 0, 0, 0, 0};
    const int32_t legal_ticks[ROBOT_AXIS_MAX] = {-3000, 0, 0, 0, 0, 0, 0};
    expect_end(COUPLED_LIMIT_BELOW, near_ticks);
    expect_end(COUPLED_LIMIT_ABOVE, far_ticks);
    expect_end(COUPLED_LIMIT_INSIDE, legal_ticks);
}

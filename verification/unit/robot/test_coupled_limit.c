/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: where axes are to the limit that they share, exact to the nanometre.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "robot/robot_neuro.h"

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
    TEST_ASSERT_EQUAL_UINT32(1U, robot_neuro.coupled_limit_count);
    TEST_ASSERT_EQUAL_STRING("separation", limit->name);
    TEST_ASSERT_EQUAL_UINT8(STATUS_SEPARATION_LIMIT, limit->refusal);
    TEST_ASSERT_EQUAL_UINT8(AXIS_UNIT_MM, limit->unit);
    TEST_ASSERT_EQUAL_UINT8(0U, limit->is_curved);
    TEST_ASSERT_EQUAL_HEX32((1U << NEURO_AXIS_HEAD) | (1U << NEURO_AXIS_FEET), limit->axes);
    TEST_ASSERT_EQUAL_INT32(geometry_nm[NEURO_MINIMUM_SEPARATION], limit->minimum);
    TEST_ASSERT_EQUAL_INT32(geometry_nm[NEURO_MAXIMUM_SEPARATION], limit->maximum);
}

static int64_t separation_nm(int32_t head_ticks, int32_t feet_ticks)
{
    const int32_t ticks[ROBOT_AXIS_MAX] = {head_ticks, feet_ticks, 1, 2, 3, 4, 5};
    joints_t joints;
    joints_from_ticks(&robot_neuro, ticks, &joints);
    return kinematics_coupled(&robot_neuro, 0U, &joints);
}

void test_SWR_COUPLE_004_the_separation_is_how_far_the_head_is_above_the_feet(void)
{
    TEST_ASSERT_EQUAL_INT64(143000000 + 12700025, separation_nm(1000, 0));
    TEST_ASSERT_EQUAL_INT64(143000000 - 12700025, separation_nm(0, 1000));
    TEST_ASSERT_EQUAL_INT64(143000000, separation_nm(-7000, -7000));
}

void test_SWR_COUPLE_004_a_kind_that_nobody_knows_has_no_value(void)
{
    const joints_t joints = {{1, 2, 3}};
    robot_t unknown = robot_neuro;
    unknown.kind++;
    TEST_ASSERT_EQUAL_INT64(0, kinematics_coupled(&unknown, 0U, &joints));
}

void test_SWR_COUPLE_002_an_end_has_the_margin_to_both_ends_of_the_range(void)
{
    const coupled_limit_t *const limit = &robot_neuro.coupled_limits[0];
    const int64_t margin = (int64_t)LIMIT_COUPLED_MARGIN_NM;
    const int64_t least = (int64_t)limit->minimum + margin;
    const int64_t most = (int64_t)limit->maximum - margin;
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_BELOW, coupled_limit_side(limit, least - 1));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_INSIDE, coupled_limit_side(limit, least));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_INSIDE, coupled_limit_side(limit, most));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_ABOVE, coupled_limit_side(limit, most + 1));
}

static void expect_end(coupled_side_t side, const int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_t joints;
    joints_from_ticks(&robot_neuro, ticks, &joints);
    const solution_t judged = coupled_limit_judge(&robot_neuro, &joints);
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

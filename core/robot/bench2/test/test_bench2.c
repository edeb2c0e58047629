/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: forward gives the golden poses, solve and inverse give their joints back, and
 * what the bench cannot reach is refused by name. */
#include "base/rigid.h"
#include "limits/requirement_limits.h"
#include "robot/bench2/bench2.h"
#include "robot/bench2/test/golden_bench2.h"
#include "robot/joints.h"
#include "robot/robot_bench2.h"
#include "unity.h"

#include <stddef.h>

#define GOLDEN_COUNT (sizeof golden_bench2 / sizeof golden_bench2[0])

static joints_t joints;
static rigid_t pose;

void setUp(void)
{
    joints = (joints_t){{0}};
    bench2_forward(&robot_bench2, &robot_bench2.probe, &joints, &pose);
}

void tearDown(void)
{
}

static solution_t aim(point_t entry, point_t target, int32_t roll_bam)
{
    return bench2_inverse(&robot_bench2, &robot_bench2.probe,
                          &(needle_line_t){entry, target, roll_bam}, &joints);
}

/* The line to the home position, of 40 mm, with its entry shifted. */
static solution_t aim_from(int32_t x_nm, int32_t z_nm)
{
    const point_t target = pose.translation;
    return aim((point_t){target.x_nm + x_nm, target.y_nm + 40000000, target.z_nm + z_nm}, target,
               0);
}

void test_SWR_KIN_003_golden_joints_give_the_golden_poses(void)
{
    for (size_t i = 0U; i < GOLDEN_COUNT; i++) {
        joints.value[BENCH2_AXIS_SLIDE] = golden_bench2[i].slide_nm;
        joints.value[BENCH2_AXIS_NEEDLE] = golden_bench2[i].needle_nm;
        bench2_forward(&robot_bench2, &robot_bench2.probe, &joints, &pose);
        TEST_ASSERT_EQUAL_INT32(golden_bench2[i].point_nm[0], pose.translation.x_nm);
        TEST_ASSERT_EQUAL_INT32(golden_bench2[i].point_nm[1], pose.translation.y_nm);
        TEST_ASSERT_EQUAL_INT32(golden_bench2[i].point_nm[2], pose.translation.z_nm);
        TEST_ASSERT_EQUAL_INT(STATUS_OK, rigid_check(&pose));
    }
}

void test_SWR_KIN_002_golden_poses_give_the_golden_joints(void)
{
    for (size_t i = 0U; i < GOLDEN_COUNT; i++) {
        const int32_t *const point_nm = golden_bench2[i].point_nm;
        const point_t target = {point_nm[0], point_nm[1], point_nm[2]};
        pose.translation = target;
        TEST_ASSERT_EQUAL_INT(
            STATUS_OK,
            bench2_solve(&robot_bench2, &robot_bench2.probe, &pose, NULL, &joints).status);
        TEST_ASSERT_EQUAL_INT32(golden_bench2[i].slide_nm, joints.value[BENCH2_AXIS_SLIDE]);
        TEST_ASSERT_EQUAL_INT32(golden_bench2[i].needle_nm, joints.value[BENCH2_AXIS_NEEDLE]);
        joints = (joints_t){{0}};
        const point_t entry = {target.x_nm, target.y_nm + 40000000, target.z_nm};
        TEST_ASSERT_EQUAL_INT(STATUS_OK, aim(entry, target, 0).status);
        TEST_ASSERT_EQUAL_INT32(golden_bench2[i].slide_nm, joints.value[BENCH2_AXIS_SLIDE]);
        TEST_ASSERT_EQUAL_INT32(golden_bench2[i].needle_nm, joints.value[BENCH2_AXIS_NEEDLE]);
    }
}

void test_SWR_KIN_004_a_line_that_is_not_the_needles_is_refused(void)
{
    const point_t target = pose.translation;
    const int32_t most_nm = (int32_t)LIMIT_CLOSURE_NM;
    TEST_ASSERT_EQUAL_INT(STATUS_DEGENERATE_LINE, aim(target, target, 0).status);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, aim_from(most_nm, -most_nm).status);
    TEST_ASSERT_EQUAL_INT(STATUS_CLOSURE, aim_from(most_nm + 1, 0).status);
    TEST_ASSERT_EQUAL_INT(STATUS_CLOSURE, aim_from(-most_nm - 1, 0).status);
    TEST_ASSERT_EQUAL_INT(STATUS_CLOSURE, aim_from(0, most_nm + 1).status);
    const point_t below = {target.x_nm, target.y_nm - 40000000, target.z_nm};
    TEST_ASSERT_EQUAL_INT(STATUS_CLOSURE, aim(below, target, 0).status);
    const point_t beside = {target.x_nm, target.y_nm, target.z_nm + 40000000};
    TEST_ASSERT_EQUAL_INT(STATUS_CLOSURE, aim(beside, target, 0).status);
}

void test_SWR_KIN_004_a_target_beside_the_plane_or_turned_is_refused(void)
{
    point_t target = pose.translation;
    point_t entry = {target.x_nm, target.y_nm + 40000000, target.z_nm};
    TEST_ASSERT_EQUAL_INT(STATUS_CLOSURE,
                          aim(entry, target, (int32_t)LIMIT_CLOSURE_BAM + 1).status);
    target.z_nm += (int32_t)LIMIT_CLOSURE_NM + 1;
    entry.z_nm = target.z_nm;
    TEST_ASSERT_EQUAL_INT(STATUS_CLOSURE, aim(entry, target, 0).status);
}

void test_SWR_KIN_004_the_limit_that_is_missed_is_named(void)
{
    pose.translation.x_nm = 1000000;
    solution_t result = bench2_solve(&robot_bench2, &robot_bench2.probe, &pose, NULL, &joints);
    TEST_ASSERT_EQUAL_INT(STATUS_AXIS_LIMIT, result.status);
    TEST_ASSERT_EQUAL_UINT8(BENCH2_AXIS_SLIDE, result.axis);
    TEST_ASSERT_EQUAL_UINT8(1U, result.is_maximum);
    pose.translation = (point_t){0, 69000000, 50000000};
    result = bench2_solve(&robot_bench2, &robot_bench2.probe, &pose, NULL, &joints);
    TEST_ASSERT_EQUAL_UINT8(BENCH2_AXIS_NEEDLE, result.axis);
    TEST_ASSERT_EQUAL_UINT8(1U, result.is_maximum);
}

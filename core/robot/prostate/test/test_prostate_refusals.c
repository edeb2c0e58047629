/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the integer kinematics refuses by name what it cannot reach, and no number
 * breaks it. */
#include "base/rigid.h"
#include "robot/joints.h"
#include "robot/margin.h"
#include "robot/prostate/prostate.h"
#include "robot/prostate/test/prostate_reference.h"
#include "robot/robot_prostate.h"
#include "unity.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "robot/prostate/test/prostate_world.inc"

static void expect_refusal(status_t status, uint32_t axis, uint32_t is_maximum, solution_t actual)
{
    TEST_ASSERT_EQUAL_INT(status, actual.status);
    TEST_ASSERT_EQUAL_UINT8(axis, actual.axis);
    TEST_ASSERT_EQUAL_UINT8(is_maximum, actual.is_maximum);
}

void setUp(void)
{
    seed = 20180401U;
    robot = robot_prostate;
    (void)memset(&joints, 0, sizeof joints);
}

void tearDown(void)
{
}

void test_SWR_KIN_013_an_entry_changes_nothing_for_the_pose_fixes_every_joint(void)
{
    const rigid_t pose = needle_at(5.0, 160.0, 0.05, -0.03, 300.0);
    const point_t on_the_axis = behind(&pose, 60000000);
    point_t off_the_axis = on_the_axis;
    joints_t without;
    joints_t with;
    off_the_axis.y_nm += 3000000;
    TEST_ASSERT_EQUAL_INT(STATUS_OK,
                          prostate_solve(&robot, &robot.probe, &pose, NULL, &without).status);
    TEST_ASSERT_EQUAL_INT(STATUS_OK,
                          prostate_solve(&robot, &robot.probe, &pose, &on_the_axis, &with).status);
    TEST_ASSERT_EQUAL_INT32_ARRAY(without.value, with.value, robot.axis_count);
    TEST_ASSERT_EQUAL_INT(STATUS_OK,
                          prostate_solve(&robot, &robot.probe, &pose, &off_the_axis, &with).status);
    TEST_ASSERT_EQUAL_INT32_ARRAY(without.value, with.value, robot.axis_count);
}

void test_SWR_PLAN_020_no_entry_is_to_blame_for_a_refusal(void)
{
    const rigid_t pose = needle_at(0.0, 160.0, 0.0, 0.0, 259.0);
    const point_t entry = behind(&pose, 50000000);
    const solution_t result = prostate_solve(&robot, &robot.probe, &pose, &entry, &joints);
    expect_refusal(STATUS_AXIS_LIMIT, PROSTATE_AXIS_INSERTION, 0U, result);
    TEST_ASSERT_EQUAL_UINT8(0U, result.is_by_entry);
}

void test_SWR_KIN_004_entry_equal_to_target_is_a_degenerate_line(void)
{
    const point_t point = {0, 0, 50000000};
    expect_refusal(
        STATUS_DEGENERATE_LINE, 0U, 0U,
        prostate_inverse(&robot, &robot.probe, &(needle_line_t){point, point, 0}, &joints));
}

void test_SWR_KIN_011_a_needle_that_points_away_from_the_patient_is_refused(void)
{
    rigid_t pose = needle_at(0.0, 160.0, REFERENCE_PI, 0.0, -300.0);
    expect_refusal(STATUS_NEEDLE_BACKWARDS, 0U, 0U, solve(&pose));
    pose = needle_at(0.0, 160.0, 0.0, 76.0 * DEGREE, 300.0);
    expect_refusal(STATUS_NEEDLE_BACKWARDS, 0U, 0U, solve(&pose));
    const point_t entry = {0, 0, 50000000};
    point_t target = {0, 0, 0};
    expect_refusal(
        STATUS_NEEDLE_BACKWARDS, 0U, 0U,
        prostate_inverse(&robot, &robot.probe, &(needle_line_t){entry, target, 0}, &joints));
    target = (point_t){0, 10000000, 50000000};
    expect_refusal(
        STATUS_NEEDLE_BACKWARDS, 0U, 0U,
        prostate_inverse(&robot, &robot.probe, &(needle_line_t){entry, target, 0}, &joints));
}

void test_SWR_KIN_011_an_angle_beyond_its_limit_is_refused_by_its_name(void)
{
    rigid_t pose = needle_at(0.0, 160.0, 10.01 * DEGREE, 0.0, 300.0);
    expect_refusal(STATUS_ALPHA_LIMIT, 0U, 1U, solve(&pose));
    pose = needle_at(0.0, 160.0, -10.01 * DEGREE, 0.0, 300.0);
    expect_refusal(STATUS_ALPHA_LIMIT, 0U, 0U, solve(&pose));
    pose = needle_at(0.0, 160.0, 0.0, 10.01 * DEGREE, 300.0);
    expect_refusal(STATUS_BETA_LIMIT, 0U, 1U, solve(&pose));
    pose = needle_at(0.0, 160.0, 11.0 * DEGREE, -12.0 * DEGREE, 300.0);
    expect_refusal(STATUS_BETA_LIMIT, 0U, 0U, solve(&pose));
    pose = needle_at(0.0, 160.0, 75.0 * DEGREE, 0.0, 300.0);
    expect_refusal(STATUS_ALPHA_LIMIT, 0U, 1U, solve(&pose));
    pose = needle_at(0.0, 160.0, 9.99 * DEGREE, 0.0, 300.0);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, solve(&pose).status);
    pose = needle_at(0.0, 160.0, 0.0, 9.99 * DEGREE, 300.0);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, solve(&pose).status);
}

void test_SWR_KIN_011_a_height_out_of_reach_is_refused_for_its_stage(void)
{
    rigid_t pose = needle_at(0.0, 203.51, 0.0, 0.0, 300.0);
    expect_refusal(STATUS_FRONT_HEIGHT, 0U, 1U, solve(&pose));
    pose = needle_at(0.0, 79.49, 0.0, 0.0, 300.0);
    expect_refusal(STATUS_FRONT_HEIGHT, 0U, 0U, solve(&pose));
    /* The rear pivot of a needle that points down by 5 degrees stands 15.9 mm higher. */
    pose = needle_at(0.0, 190.0, 0.0, 5.0 * DEGREE, 300.0);
    expect_refusal(STATUS_REAR_HEIGHT, 0U, 1U, solve(&pose));
    pose = needle_at(0.0, 90.0, 0.0, -5.0 * DEGREE, 300.0);
    expect_refusal(STATUS_REAR_HEIGHT, 0U, 0U, solve(&pose));
}

void test_SWR_KIN_011_a_stage_too_narrow_or_too_wide_is_refused_by_its_name(void)
{
    /* 203.49 mm high is 87.1 mm wide, 130 mm 310.6 mm. */
    rigid_t pose = needle_at(0.0, 203.49, 0.0, -1.0 * DEGREE, 300.0);
    expect_refusal(STATUS_FRONT_SEPARATION, 0U, 0U, solve(&pose));
    pose = needle_at(0.0, 130.0, 0.0, 2.0 * DEGREE, 300.0);
    expect_refusal(STATUS_FRONT_SEPARATION, 0U, 1U, solve(&pose));
    pose = needle_at(0.0, 203.49 - (181.5 * tan(5.0 * DEGREE)), 0.0, 5.0 * DEGREE, 300.0);
    expect_refusal(STATUS_REAR_SEPARATION, 0U, 0U, solve(&pose));
    pose = needle_at(0.0, 130.0 + (181.5 * tan(5.0 * DEGREE)), 0.0, -5.0 * DEGREE, 300.0);
    expect_refusal(STATUS_REAR_SEPARATION, 0U, 1U, solve(&pose));
}

void test_SWR_KIN_011_an_axis_beyond_its_limit_is_named(void)
{
    rigid_t pose = needle_at(0.0, 160.0, 0.0, 0.0, 259.0);
    expect_refusal(STATUS_AXIS_LIMIT, PROSTATE_AXIS_INSERTION, 0U, solve(&pose));
    pose = needle_at(0.0, 160.0, 0.0, 0.0, 259.075 + 169.0);
    expect_refusal(STATUS_AXIS_LIMIT, PROSTATE_AXIS_INSERTION, 1U, solve(&pose));
    /* A needle of 2.3 m, more than a length has bits for. */
    pose = needle_at(0.0, 160.0, 0.0, 5.0 * DEGREE, 2300.0);
    expect_refusal(STATUS_AXIS_LIMIT, PROSTATE_AXIS_INSERTION, 1U, solve(&pose));
    pose = needle_at(80.0, 160.0, 0.0, 0.0, 300.0);
    const solution_t result = solve(&pose);
    TEST_ASSERT_EQUAL_INT(STATUS_AXIS_LIMIT, result.status);
    TEST_ASSERT_EQUAL_UINT8(1U, result.is_maximum);
}

void test_SWR_KIN_012_no_joint_values_break_forward_kinematics(void)
{
    for (int i = 0; i < POSES; i++) {
        rigid_t pose;
        for (uint32_t axis = 0U; axis < ROBOT_AXIS_MAX; axis++) {
            joints.value[axis] = (int32_t)random_word();
        }
        prostate_forward(&robot, &robot.probe, &joints, &pose);
        TEST_ASSERT_NOT_EQUAL_INT(STATUS_NOT_RIGID, rigid_check(&pose));
        for (uint32_t limit = 0U; limit <= PROSTATE_BETA; limit++) {
            const int64_t value = prostate_coupled(&robot, limit, &joints);
            TEST_ASSERT_TRUE((value > -INT64_C(0x100000000)) && (value < INT64_C(0x100000000)));
        }
    }
}

void test_SWR_KIN_012_no_pose_and_no_points_break_inverse_kinematics(void)
{
    for (int i = 0; i < (20 * POSES); i++) {
        int32_t words[12];
        rigid_t pose;
        for (uint32_t k = 0U; k < 12U; k++) {
            words[k] = ((random_word() % 8U) == 0U) ? INT32_MIN : (int32_t)random_word();
        }
        (void)memcpy(pose.rotation_q30, words, sizeof pose.rotation_q30);
        pose.rotation_q30[0][2] /= 8;
        pose.rotation_q30[1][2] /= 8;
        pose.translation = (point_t){words[9], words[10], words[11]};
        const point_t entry = {words[0], words[1], words[2]};
        const status_t solved = solve(&pose).status;
        const status_t found =
            prostate_inverse(&robot, &robot.probe,
                             &(needle_line_t){entry, pose.translation, words[3]}, &joints)
                .status;
        TEST_ASSERT_TRUE(solved != STATUS_OK);
        TEST_ASSERT_TRUE(found != STATUS_OK);
    }
}

void test_SWR_KIN_012_the_farthest_poses_are_refused(void)
{
    static const int32_t ends[3] = {INT32_MIN, 0, INT32_MAX};
    for (uint32_t i = 0U; i < 27U; i++) {
        rigid_t pose;
        rigid_set_identity(&pose);
        pose.translation = (point_t){ends[i % 3U], ends[(i / 3U) % 3U], ends[i / 9U]};
        TEST_ASSERT_NOT_EQUAL_INT(STATUS_OK, solve(&pose).status);
    }
}

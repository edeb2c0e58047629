/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the integer kinematics equals the mechanism, forward and inverse. */
#include "base/fixed.h"
#include "base/rigid.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"
#include "robot/prostate/prostate.h"
#include "robot/prostate/test/golden_prostate.h"
#include "robot/prostate/test/prostate_reference.h"
#include "robot/robot_prostate.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "robot/prostate/test/prostate_world.inc"

#define GOLDEN_COUNT (sizeof golden_prostate / sizeof golden_prostate[0])
#define BAM_PER_RAD (2147483648.0 / REFERENCE_PI)
#define MICROMETRE_MM 1.0e-3
#define RAD_10_MICRO 1.0e-5

/* From `low` to `high`. */
static double random_between(double low, double high)
{
    return low + ((high - low) * (random_word() / 4294967295.0));
}

static int32_t bam(double angle)
{
    return fixed_wrap_bam(llround(angle * BAM_PER_RAD));
}

static void set_joints(const double joint[ROBOT_AXIS_MAX], joints_t *result)
{
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        result->value[i] = (i == PROSTATE_AXIS_ROTATION) ? bam(joint[i]) : nm(joint[i]);
    }
}

static bool is_legal(const joints_t *values)
{
    bool result = true;
    for (uint32_t i = 0U; i < robot.coupled_limit_count; i++) {
        const int64_t value = prostate_coupled(&robot, i, values);
        result = result && (value >= robot.coupled_limits[i].minimum) &&
                 (value <= robot.coupled_limits[i].maximum);
    }
    return result;
}

/* Any ticks inside all limits; the rotation within the half turn that is asked for. */
static void set_random_legal_ticks(int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_t values;
    do {
        for (uint32_t i = 0U; i < robot.axis_count; i++) {
            const axis_config_t *const axis = &robot.axes[i];
            ticks[i] = (int32_t)lround(random_between(axis->minimum_ticks, axis->maximum_ticks));
        }
        ticks[PROSTATE_AXIS_ROTATION] /= 10;
        joints_from_ticks(&robot, ticks, &values);
    } while (!is_legal(&values));
}

static void expect_forward_equals_reference(const joints_t *values)
{
    double joint[ROBOT_AXIS_MAX];
    prostate_reference_t expected;
    rigid_t pose;
    double distance_mm;
    double angle_rad;
    reference_joints(values, joint);
    reference_forward(&robot, joint, &expected);
    reference_to_zframe(&robot, &expected);
    prostate_forward(&robot, &robot.probe, values, &pose);
    reference_difference(&expected, &pose, &distance_mm, &angle_rad);
    TEST_ASSERT_TRUE(distance_mm <= MICROMETRE_MM);
    TEST_ASSERT_TRUE(angle_rad <= RAD_10_MICRO);
}

static void expect_same_pose(const rigid_t *expected, const joints_t *values)
{
    rigid_t pose;
    int32_t distance_nm;
    int32_t angle_bam;
    prostate_forward(&robot, &robot.probe, values, &pose);
    rigid_difference(expected, &pose, &distance_nm, &angle_bam);
    TEST_ASSERT_LESS_OR_EQUAL_INT32((int32_t)LIMIT_CLOSURE_NM, distance_nm);
    TEST_ASSERT_LESS_OR_EQUAL_INT32((int32_t)LIMIT_CLOSURE_BAM, angle_bam);
}

static rigid_t pose_of(const joints_t *values)
{
    rigid_t pose;
    prostate_forward(&robot, &robot.probe, values, &pose);
    return pose;
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

void test_SWR_KIN_001_forward_equals_the_reference_at_random_joints(void)
{
    for (int i = 0; i < POSES; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        set_random_legal_ticks(ticks);
        joints_from_ticks(&robot, ticks, &joints);
        joints.value[PROSTATE_AXIS_FRONT_LEFT] += (int32_t)(random_word() % 4000U) - 2000;
        joints.value[PROSTATE_AXIS_ROTATION] = (int32_t)random_word();
        expect_forward_equals_reference(&joints);
    }
}

void test_SWR_KIN_001_forward_equals_the_reference_with_another_needle(void)
{
    robot.probe.length_nm[PROSTATE_PROBE_NEEDLE_TIP] = nm(224.0);
    robot.geometry_nm[PROSTATE_PIVOT_DEPTH] = nm(15.0);
    robot.probe.length_nm[PROSTATE_PROBE_NEEDLE_HEIGHT] = nm(-5.0);
    for (int i = 0; i < POSES; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        set_random_legal_ticks(ticks);
        joints_from_ticks(&robot, ticks, &joints);
        expect_forward_equals_reference(&joints);
    }
}

void test_SWR_KIN_001_beyond_its_reach_a_stage_stands_at_the_end_of_it(void)
{
    rigid_t pose;
    joints.value[PROSTATE_AXIS_FRONT_LEFT] = 500000000;
    joints.value[PROSTATE_AXIS_FRONT_RIGHT] = -500000000;
    joints.value[PROSTATE_AXIS_REAR_LEFT] = 500000000;
    joints.value[PROSTATE_AXIS_REAR_RIGHT] = -500000000;
    prostate_forward(&robot, &robot.probe, &joints, &pose);
    TEST_ASSERT_INT32_WITHIN(2, nm(12.0 + 67.5 - 167.4), pose.translation.y_nm);
    /* Narrower than its top it does not sink again, as the root of listing 3 would have it. */
    joints.value[PROSTATE_AXIS_FRONT_LEFT] = nm(20.0);
    joints.value[PROSTATE_AXIS_FRONT_RIGHT] = nm(-20.0);
    joints.value[PROSTATE_AXIS_REAR_LEFT] = nm(20.0);
    joints.value[PROSTATE_AXIS_REAR_RIGHT] = nm(-20.0);
    prostate_forward(&robot, &robot.probe, &joints, &pose);
    TEST_ASSERT_INT32_WITHIN(2, nm(124.0 + 12.0 + 67.5 - 167.4), pose.translation.y_nm);
}

static void expect_closure(const int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_t start;
    joints_from_ticks(&robot, ticks, &start);
    const rigid_t pose = pose_of(&start);
    const point_t entry = behind(&pose, 500000000);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, rigid_check(&pose));
    TEST_ASSERT_EQUAL_INT(STATUS_OK, solve(&pose).status);
    expect_same_pose(&pose, &joints);
    TEST_ASSERT_EQUAL_INT(STATUS_OK,
                          prostate_inverse(&robot, &robot.probe,
                                           &(needle_line_t){entry, pose.translation,
                                                            start.value[PROSTATE_AXIS_ROTATION]},
                                           &joints)
                              .status);
    expect_same_pose(&pose, &joints);
}

/* Away from the ends by more than a pose in whole nm and q30 may lose. */
static void keep_off_the_ends(void)
{
    for (uint32_t i = 0U; i < robot.coupled_limit_count; i++) {
        robot.coupled_limits[i].minimum -= 7000;
        robot.coupled_limits[i].maximum += 7000;
    }
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        robot.axes[i].minimum_ticks -= 2;
        robot.axes[i].maximum_ticks += 2;
    }
}

void test_SWR_KIN_002_forward_of_inverse_closes_at_random_joints(void)
{
    for (int i = 0; i < POSES; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        robot = robot_prostate;
        set_random_legal_ticks(ticks);
        keep_off_the_ends();
        expect_closure(ticks);
    }
}

void test_SWR_KIN_002_forward_of_inverse_closes_with_another_needle(void)
{
    for (int i = 0; i < POSES; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        robot = robot_prostate;
        set_random_legal_ticks(ticks);
        keep_off_the_ends();
        robot.probe.length_nm[PROSTATE_PROBE_NEEDLE_TIP] = nm(224.0);
        robot.geometry_nm[PROSTATE_PIVOT_DEPTH] = nm(15.0);
        robot.probe.length_nm[PROSTATE_PROBE_NEEDLE_HEIGHT] = nm(5.0);
        expect_closure(ticks);
    }
}

void test_SWR_KIN_002_inverse_returns_the_ticks_it_came_from(void)
{
    for (int i = 0; i < POSES; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        int32_t back[ROBOT_AXIS_MAX];
        joints_t start;
        robot = robot_prostate;
        set_random_legal_ticks(ticks);
        keep_off_the_ends();
        joints_from_ticks(&robot, ticks, &start);
        const rigid_t pose = pose_of(&start);
        TEST_ASSERT_EQUAL_INT(STATUS_OK, solve(&pose).status);
        joints_to_ticks(&robot, &joints, back);
        for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
            TEST_ASSERT_INT32_WITHIN(1, ticks[axis], back[axis]);
        }
    }
}

static void use_needle_of(const golden_prostate_t *golden)
{
    robot.probe.length_nm[PROSTATE_PROBE_NEEDLE_TIP] = nm(golden->needle_tip_mm);
    robot.geometry_nm[PROSTATE_PIVOT_DEPTH] = nm(golden->pivot_depth_mm);
    robot.probe.length_nm[PROSTATE_PROBE_NEEDLE_HEIGHT] = nm(golden->needle_height_mm);
}

static void expect_golden(const golden_prostate_t *golden, const rigid_t *pose)
{
    const int32_t tip_nm[3] = {pose->translation.x_nm, pose->translation.y_nm,
                               pose->translation.z_nm};
    for (uint32_t row = 0U; row < 3U; row++) {
        for (uint32_t column = 0U; column < 3U; column++) {
            const double entry = pose->rotation_q30[row][column] / (double)FIXED_ONE_Q30;
            TEST_ASSERT_TRUE_MESSAGE(fabs(entry - golden->pose[(row * 4U) + column]) <= 1.0e-7,
                                     golden->name);
        }
        TEST_ASSERT_INT32_WITHIN_MESSAGE(20, nm(golden->pose[(row * 4U) + 3U]),
                                         tip_nm[row] + robot.geometry_nm[PROSTATE_ZFRAME_X + row],
                                         golden->name);
    }
}

void test_SWR_KIN_003_golden_joints_give_the_golden_poses(void)
{
    for (size_t i = 0U; i < GOLDEN_COUNT; i++) {
        const golden_prostate_t *const golden = &golden_prostate[i];
        use_needle_of(golden);
        set_joints(golden->joints, &joints);
        const rigid_t pose = pose_of(&joints);
        expect_golden(golden, &pose);
        TEST_ASSERT_INT32_WITHIN_MESSAGE(100, bam(golden->angles[0]),
                                         (int32_t)prostate_coupled(&robot, PROSTATE_ALPHA, &joints),
                                         golden->name);
        TEST_ASSERT_INT32_WITHIN_MESSAGE(100, bam(golden->angles[1]),
                                         (int32_t)prostate_coupled(&robot, PROSTATE_BETA, &joints),
                                         golden->name);
    }
}

void test_SWR_KIN_003_golden_poses_give_the_golden_joints(void)
{
    /* One of them has an alpha of 10 degrees, or a bam more. */
    keep_off_the_ends();
    for (size_t i = 0U; i < GOLDEN_COUNT; i++) {
        const golden_prostate_t *const golden = &golden_prostate[i];
        joints_t expected;
        use_needle_of(golden);
        set_joints(golden->joints, &expected);
        const rigid_t pose = pose_of(&expected);
        TEST_ASSERT_EQUAL_INT_MESSAGE(STATUS_OK, solve(&pose).status, golden->name);
        for (uint32_t axis = 0U; axis < robot.axis_count; axis++) {
            TEST_ASSERT_INT32_WITHIN_MESSAGE(100, expected.value[axis], joints.value[axis],
                                             golden->name);
        }
    }
}

void test_SWR_KIN_010_the_needle_turns_about_the_pivots_by_its_own_length(void)
{
    /* Listing 3 takes the link, 124 mm, for the needle: 11.8 mm less at 5 degrees. */
    const rigid_t pose = needle_at(0.0, 160.0, 5.0 * DEGREE, 0.0, 259.075);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, solve(&pose).status);
    TEST_ASSERT_INT32_WITHIN(20, 0, joints.value[PROSTATE_AXIS_INSERTION]);
    TEST_ASSERT_INT32_WITHIN(20, -joints.value[PROSTATE_AXIS_FRONT_LEFT],
                             joints.value[PROSTATE_AXIS_FRONT_RIGHT]);
}

void test_SWR_KIN_010_a_higher_rear_stage_points_the_needle_down(void)
{
    /* Listing 3 has the other sign. */
    set_joints((const double[ROBOT_AXIS_MAX]){150.0, -150.0, 140.0, -140.0}, &joints);
    const rigid_t pose = pose_of(&joints);
    TEST_ASSERT_TRUE(prostate_coupled(&robot, PROSTATE_BETA, &joints) > 0);
    TEST_ASSERT_TRUE(pose.rotation_q30[1][2] < 0);
    TEST_ASSERT_TRUE(pose.translation.y_nm < nm(140.426 - 167.4));
}

void test_SWR_KIN_010_depth_of_the_pivot_and_height_of_the_needle_count_both_ways(void)
{
    /* Listing 3 subtracts the depth forwards only, and the depth comes back 15 mm off. */
    robot.geometry_nm[PROSTATE_PIVOT_DEPTH] = nm(15.0);
    robot.probe.length_nm[PROSTATE_PROBE_NEEDLE_HEIGHT] = nm(5.0);
    set_joints((const double[ROBOT_AXIS_MAX]){150.0, -150.0, 150.0, -150.0, 40.0}, &joints);
    const joints_t start = joints;
    const rigid_t pose = pose_of(&joints);
    TEST_ASSERT_INT32_WITHIN(5, nm(140.426185 + 5.0 - 167.4), pose.translation.y_nm);
    TEST_ASSERT_INT32_WITHIN(5, nm(259.075 + 40.0 - 15.0 - 239.71), pose.translation.z_nm);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, solve(&pose).status);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_INT32_WITHIN(20, start.value[i], joints.value[i]);
    }
}

void test_SWR_KIN_010_both_pivots_lie_on_the_line_of_the_needle(void)
{
    /* In Listing 3 the two are not the distance of the stages apart. */
    for (int i = 0; i < POSES; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        double joint[ROBOT_AXIS_MAX];
        double front[3];
        double direction[3];
        double alpha;
        double beta;
        set_random_legal_ticks(ticks);
        joints_from_ticks(&robot, ticks, &joints);
        const rigid_t pose = pose_of(&joints);
        reference_joints(&joints, joint);
        reference_line(&robot, joint, front, direction);
        reference_angles(direction, &alpha, &beta);
        for (int row = 0; row < 3; row++) {
            const double entry = pose.rotation_q30[row][2] / (double)FIXED_ONE_Q30;
            TEST_ASSERT_TRUE(fabs(entry - direction[row]) < 1.0e-7);
        }
        TEST_ASSERT_TRUE(fabs(alpha * BAM_PER_RAD -
                              (double)prostate_coupled(&robot, PROSTATE_ALPHA, &joints)) < 100.0);
        TEST_ASSERT_TRUE(fabs(beta * BAM_PER_RAD -
                              (double)prostate_coupled(&robot, PROSTATE_BETA, &joints)) < 100.0);
    }
}

void test_SWR_KIN_010_the_carriages_of_a_stage_are_their_separation_apart(void)
{
    set_joints((const double[ROBOT_AXIS_MAX]){150.0, -140.0, 130.0, -120.0}, &joints);
    TEST_ASSERT_EQUAL_INT64(290000000, prostate_coupled(&robot, PROSTATE_FRONT_GAP, &joints));
    TEST_ASSERT_EQUAL_INT64(250000000, prostate_coupled(&robot, PROSTATE_REAR_GAP, &joints));
}

void test_SWR_KIN_013_the_roll_of_a_pose_is_the_shorter_turn_from_zero(void)
{
    set_joints((const double[ROBOT_AXIS_MAX]){150.0, -150.0, 145.0, -155.0, 20.0, 28.4986674476},
               &joints);
    const rigid_t pose = pose_of(&joints);
    int32_t ticks[ROBOT_AXIS_MAX];
    TEST_ASSERT_EQUAL_INT(STATUS_OK, solve(&pose).status);
    joints_to_ticks(&robot, &joints, ticks);
    /* 28.499 rad less four and a half turns and a bit. */
    TEST_ASSERT_INT32_WITHIN(1, (int32_t)lround((28.4986674476 - (10.0 * REFERENCE_PI)) * 265.27),
                             ticks[PROSTATE_AXIS_ROTATION]);
    expect_same_pose(&pose, &joints);
}

void test_SWR_ROBOT_030_no_motor_with_a_lead_turns_more_than_150_times_a_minute(void)
{
    for (uint32_t i = 0U; i <= PROSTATE_AXIS_INSERTION; i++) {
        const int64_t counts_per_minute = (int64_t)robot.axes[i].full_speed_ticks_per_s * 60;
        TEST_ASSERT_TRUE(counts_per_minute <= ((int64_t)LIMIT_MOTOR_TURNS_PER_MINUTE * 5000));
        TEST_ASSERT_TRUE(robot.axes[i].speed_ticks_per_s < robot.axes[i].full_speed_ticks_per_s);
    }
}

void test_SWR_ROBOT_031_the_rear_left_carriage_is_taken_where_it_is_parked_before_others_home(void)
{
    const axis_config_t *const parked = &robot.axes[PROSTATE_AXIS_REAR_LEFT];
    TEST_ASSERT_EQUAL_UINT8(HOME_IN_PLACE, parked->home_method);
    TEST_ASSERT_EQUAL_UINT8(LIMIT_SWITCH_NONE, parked->limit_switch);
    TEST_ASSERT_EQUAL_INT64((int64_t)LIMIT_PARKED_NM, joints_value(parked, parked->home_ticks));
    for (uint32_t i = 0U; i < PROSTATE_AXIS_REAR_LEFT; i++) {
        TEST_ASSERT_TRUE(parked->home_stage < robot.axes[i].home_stage);
    }
    TEST_ASSERT_TRUE(parked->home_stage < robot.axes[PROSTATE_AXIS_REAR_RIGHT].home_stage);
}

/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the integer kinematics equals the mechanism, forward and inverse, and refuses
 * what it cannot reach. */
#include "base/crc.h"
#include "base/fixed.h"
#include "base/rigid.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"
#include "robot/margin.h"
#include "robot/neuro/neuro.h"
#include "robot/robot_neuro.h"
#include "unit/support/contract_trap.h"
#include "robot/neuro/test/golden_neuro.h"
#include "robot/neuro/test/neuro_reference.h"
#include "unit/support/scenes.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#define NM_PER_MM 1.0e6
#define MICROMETRE_MM 1.0e-3
#define RAD_10_MICRO 1.0e-5
#define BAM_PER_RAD (2147483648.0 / 3.14159265358979323846)

static uint64_t seed;
static robot_t robot;
static joints_t joints;

static uint32_t random_below(uint32_t range)
{
    seed = (seed * UINT64_C(6364136223846793005)) + UINT64_C(1442695040888963407);
    return (uint32_t)((seed >> 33U) % range);
}

static int32_t nm(double millimetres)
{
    return (int32_t)lround(millimetres * NM_PER_MM);
}

static point_t point_of(const double millimetres[3])
{
    return (point_t){nm(millimetres[0]), nm(millimetres[1]), nm(millimetres[2])};
}

static bool is_separation_legal(const int32_t ticks[ROBOT_AXIS_MAX])
{
    const int64_t separation = robot.geometry_nm[NEURO_HOME_SEPARATION] +
                               joints_value(&robot.axes[NEURO_AXIS_HEAD], ticks[NEURO_AXIS_HEAD]) -
                               joints_value(&robot.axes[NEURO_AXIS_FEET], ticks[NEURO_AXIS_FEET]);
    return separation >= robot.geometry_nm[NEURO_MINIMUM_SEPARATION] &&
           separation <= robot.geometry_nm[NEURO_MAXIMUM_SEPARATION];
}

static void set_random_legal_ticks(int32_t ticks[ROBOT_AXIS_MAX])
{
    do {
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            const int32_t minimum = robot.axes[i].minimum_ticks;
            const uint32_t range = (uint32_t)(robot.axes[i].maximum_ticks - minimum) + 1U;
            ticks[i] = minimum + (int32_t)random_below(range);
        }
    } while (!is_separation_legal(ticks));
}

/* Step `step` of four equal ones from the lower to the upper limit. */
static int32_t grid_ticks(uint32_t axis, uint32_t step)
{
    const int32_t minimum = robot.axes[axis].minimum_ticks;
    return minimum + (((robot.axes[axis].maximum_ticks - minimum) * (int32_t)step) / 4);
}

static void joints_of_reference(const double joint[ROBOT_AXIS_MAX], joints_t *result)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const bool is_angle = robot.axes[i].unit == AXIS_UNIT_RAD;
        result->value[i] =
            is_angle ? fixed_wrap_bam(llround(joint[i] * BAM_PER_RAD)) : nm(joint[i]);
    }
}

static void expect_forward_equals_reference(const joints_t *values)
{
    double joint[ROBOT_AXIS_MAX];
    neuro_reference_pose_t expected;
    rigid_t pose;
    double distance_mm;
    double angle_rad;
    neuro_reference_joints(&robot, values, joint);
    neuro_reference_forward(&robot, joint, &expected);
    neuro_forward(&robot, &robot.probe, values, &pose);
    neuro_reference_difference(&expected, &pose, &distance_mm, &angle_rad);
    TEST_ASSERT_TRUE(distance_mm <= MICROMETRE_MM);
    TEST_ASSERT_TRUE(angle_rad <= RAD_10_MICRO);
}

static void expect_same_pose(const rigid_t *expected, const joints_t *values)
{
    rigid_t pose;
    int32_t distance_nm;
    int32_t angle_bam;
    neuro_forward(&robot, &robot.probe, values, &pose);
    rigid_difference(expected, &pose, &distance_nm, &angle_bam);
    TEST_ASSERT_LESS_OR_EQUAL_INT32((int32_t)LIMIT_CLOSURE_NM, distance_nm);
    TEST_ASSERT_LESS_OR_EQUAL_INT32((int32_t)LIMIT_CLOSURE_BAM, angle_bam);
}

/* Forward, then back by each inverse, then forward again. */
static void expect_closure(const int32_t ticks[ROBOT_AXIS_MAX])
{
    double joint[ROBOT_AXIS_MAX];
    double entry_mm[3];
    joints_t start;
    joints_t back;
    rigid_t pose;
    joints_from_ticks(&robot, ticks, &start);
    neuro_forward(&robot, &robot.probe, &start, &pose);
    neuro_reference_joints(&robot, &start, joint);
    neuro_reference_entry(&robot, joint, entry_mm);
    const point_t entry = point_of(entry_mm);
    TEST_ASSERT_EQUAL(STATUS_OK, neuro_inverse(&robot, &robot.probe,
                                               &(needle_line_t){entry, pose.translation,
                                                                start.value[NEURO_AXIS_ROTATION]},
                                               &back)
                                     .status);
    expect_same_pose(&pose, &back);
    TEST_ASSERT_EQUAL(STATUS_OK, neuro_inverse_at_depth(&robot, &robot.probe, &pose,
                                                        start.value[NEURO_AXIS_INSERTION], &back)
                                     .status);
    expect_same_pose(&pose, &back);
}

static void expect_refusal(solution_t expected, solution_t actual)
{
    TEST_ASSERT_EQUAL(expected.status, actual.status);
    TEST_ASSERT_EQUAL_UINT8(expected.axis, actual.axis);
    TEST_ASSERT_EQUAL_UINT8(expected.is_maximum, actual.is_maximum);
}

/* The pose at these positions, in ticks, whether they are legal or not. */
static rigid_t pose_at(const int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_t values;
    rigid_t pose;
    joints_from_ticks(&robot, ticks, &values);
    neuro_forward(&robot, &robot.probe, &values, &pose);
    return pose;
}

/* In the middle of everything: separation 110 mm. */
static const int32_t middle[ROBOT_AXIS_MAX] = {-3937, -1339, -1000, 60000, 500, 70, -600};

void setUp(void)
{
    seed = 20180401U;
    robot = robot_neuro;
    memset(&joints, 0, sizeof joints);
}

void tearDown(void)
{
}

void test_SWR_KIN_001_forward_equals_the_reference_on_a_grid_over_the_workspace(void)
{
    uint32_t poses = 0U;
    for (uint32_t cell = 0U; cell < 78125U; cell += 3U) {
        int32_t ticks[ROBOT_AXIS_MAX];
        uint32_t rest = cell;
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            ticks[i] = grid_ticks(i, rest % 5U);
            rest /= 5U;
        }
        if (is_separation_legal(ticks)) {
            joints_from_ticks(&robot, ticks, &joints);
            expect_forward_equals_reference(&joints);
            poses++;
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(5000U, poses);
}

void test_SWR_KIN_001_forward_equals_the_reference_at_random_joints(void)
{
    for (int i = 0; i < 10000; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        set_random_legal_ticks(ticks);
        joints_from_ticks(&robot, ticks, &joints);
        joints.value[NEURO_AXIS_HEAD] += (int32_t)random_below(10000U) - 5000;
        joints.value[NEURO_AXIS_PITCH] += (int32_t)random_below(100000U);
        expect_forward_equals_reference(&joints);
    }
}

void test_SWR_KIN_001_beyond_the_linkage_the_height_is_taken_at_the_end_of_reach(void)
{
    rigid_t pose;
    joints.value[NEURO_AXIS_HEAD] = 100000000;
    neuro_forward(&robot, &robot.probe, &joints, &pose);
    TEST_ASSERT_INT32_WITHIN(2, 209890000 - 20192820, pose.translation.y_nm);
    joints.value[NEURO_AXIS_HEAD] = -500000000;
    neuro_forward(&robot, &robot.probe, &joints, &pose);
    TEST_ASSERT_INT32_WITHIN(2, 209890000 - 20192820, pose.translation.y_nm);
}

void test_SWR_KIN_002_forward_of_inverse_closes_on_a_grid_over_the_workspace(void)
{
    uint32_t poses = 0U;
    for (uint32_t cell = 0U; cell < 78125U; cell += 3U) {
        int32_t ticks[ROBOT_AXIS_MAX];
        uint32_t rest = cell;
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            ticks[i] = grid_ticks(i, rest % 5U);
            rest /= 5U;
        }
        if (is_separation_legal(ticks)) {
            /* Only half a turn to each side is ever asked for. */
            ticks[NEURO_AXIS_ROTATION] /= 2;
            expect_closure(ticks);
            poses++;
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(5000U, poses);
}

void test_SWR_KIN_002_forward_of_inverse_closes_at_random_joints(void)
{
    for (int i = 0; i < 10000; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        set_random_legal_ticks(ticks);
        expect_closure(ticks);
    }
}

void test_SWR_KIN_002_inverse_returns_the_joints_it_came_from(void)
{
    for (int i = 0; i < 5000; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        int32_t back[ROBOT_AXIS_MAX];
        set_random_legal_ticks(ticks);
        ticks[NEURO_AXIS_ROTATION] /= 2;
        const rigid_t pose = pose_at(ticks);
        joints_t start;
        joints_from_ticks(&robot, ticks, &start);
        TEST_ASSERT_EQUAL(STATUS_OK,
                          neuro_inverse_at_depth(&robot, &robot.probe, &pose,
                                                 start.value[NEURO_AXIS_INSERTION], &joints)
                              .status);
        joints_to_ticks(&robot, &joints, back);
        TEST_ASSERT_EQUAL_INT32_ARRAY(ticks, back, robot_neuro.axis_count);
    }
}

static void use_probe(const double probe_mm[4])
{
    robot.probe.length_nm[NEURO_PROBE_TREATMENT_TO_TIP] = nm(probe_mm[0]);
    robot.probe.length_nm[NEURO_PROBE_ROBOT_TO_ENTRY] = nm(probe_mm[1]);
    robot.probe.length_nm[NEURO_PROBE_CANNULA_TO_TREATMENT] = nm(probe_mm[2]);
    robot.probe.length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT] = nm(probe_mm[3]);
}

void test_SWR_KIN_003_golden_joints_give_the_golden_poses(void)
{
    for (size_t i = 0U; i < sizeof golden_neuro / sizeof golden_neuro[0]; i++) {
        const golden_neuro_t *golden = &golden_neuro[i];
        rigid_t pose;
        use_probe(golden->probe_mm);
        joints_of_reference(golden->joints, &joints);
        neuro_forward(&robot, &robot.probe, &joints, &pose);
        for (uint32_t row = 0U; row < 3U; row++) {
            for (uint32_t column = 0U; column < 3U; column++) {
                const double entry = pose.rotation_q30[row][column] / (double)FIXED_ONE_Q30;
                TEST_ASSERT_TRUE_MESSAGE(fabs(entry - golden->pose[row * 4U + column]) <= 1.0e-7,
                                         golden->name);
            }
        }
        TEST_ASSERT_INT32_WITHIN_MESSAGE(20, nm(golden->pose[3]), pose.translation.x_nm,
                                         golden->name);
        TEST_ASSERT_INT32_WITHIN_MESSAGE(20, nm(golden->pose[7]), pose.translation.y_nm,
                                         golden->name);
        TEST_ASSERT_INT32_WITHIN_MESSAGE(20, nm(golden->pose[11]), pose.translation.z_nm,
                                         golden->name);
    }
}

void test_SWR_KIN_003_golden_entries_and_targets_give_the_golden_joints(void)
{
    for (size_t i = 0U; i < sizeof golden_neuro / sizeof golden_neuro[0]; i++) {
        const golden_neuro_t *golden = &golden_neuro[i];
        const point_t entry = point_of(golden->entry_mm);
        const point_t target = point_of(golden->target_mm);
        joints_t expected;
        use_probe(golden->probe_mm);
        joints_of_reference(golden->joints, &expected);
        TEST_ASSERT_EQUAL_MESSAGE(
            STATUS_OK,
            neuro_inverse(&robot, &robot.probe,
                          &(needle_line_t){entry, target, expected.value[NEURO_AXIS_ROTATION]},
                          &joints)
                .status,
            golden->name);
        for (uint32_t axis = 0U; axis < robot_neuro.axis_count; axis++) {
            const bool is_angle = robot.axes[axis].unit == AXIS_UNIT_RAD;
            TEST_ASSERT_INT32_WITHIN_MESSAGE(is_angle ? 100 : 50, expected.value[axis],
                                             joints.value[axis], golden->name);
        }
    }
}

void test_SWR_KIN_003_golden_poses_and_depths_give_the_golden_joints(void)
{
    for (size_t i = 0U; i < sizeof golden_neuro / sizeof golden_neuro[0]; i++) {
        const golden_neuro_t *golden = &golden_neuro[i];
        joints_t expected;
        rigid_t pose;
        use_probe(golden->probe_mm);
        joints_of_reference(golden->joints, &expected);
        neuro_forward(&robot, &robot.probe, &expected, &pose);
        TEST_ASSERT_EQUAL_MESSAGE(STATUS_OK,
                                  neuro_inverse_at_depth(&robot, &robot.probe, &pose,
                                                         nm(golden->joints[NEURO_AXIS_INSERTION]),
                                                         &joints)
                                      .status,
                                  golden->name);
        for (uint32_t axis = 0U; axis < robot_neuro.axis_count; axis++) {
            TEST_ASSERT_INT32_WITHIN_MESSAGE(50, expected.value[axis], joints.value[axis],
                                             golden->name);
        }
    }
}

void test_SWR_KIN_004_entry_equal_to_target_is_a_degenerate_line(void)
{
    const point_t point = {0, 200000000, 50000000};
    expect_refusal((solution_t){.status = STATUS_DEGENERATE_LINE},
                   neuro_inverse(&robot, &robot.probe, &(needle_line_t){point, point, 0}, &joints));
}

void test_SWR_KIN_004_a_needle_along_the_lateral_axis_is_singular(void)
{
    const point_t entry = {-50000000, 200000000, 50000000};
    const point_t target = {0, 200000000, 50000000};
    rigid_t pose;
    rigid_set_identity(&pose);
    pose.rotation_q30[0][0] = 0;
    pose.rotation_q30[0][2] = FIXED_ONE_Q30;
    pose.rotation_q30[2][0] = -FIXED_ONE_Q30;
    pose.rotation_q30[2][2] = 0;
    const solution_t expected = {.status = STATUS_SINGULAR_PITCH};
    expect_refusal(
        expected, neuro_inverse(&robot, &robot.probe, &(needle_line_t){entry, target, 0}, &joints));
    expect_refusal(expected, neuro_inverse_at_depth(&robot, &robot.probe, &pose, 0, &joints));
    expect_refusal(expected, neuro_solve(&robot, &robot.probe, &pose, NULL, &joints));
}

void test_SWR_KIN_004_a_target_too_high_is_an_unreachable_height(void)
{
    const point_t entry = {0, 400000000, 50000000};
    const point_t target = {0, 350000000, 50000000};
    expect_refusal(
        (solution_t){.status = STATUS_UNREACHABLE_HEIGHT, .is_maximum = 1U},
        neuro_inverse(&robot, &robot.probe, &(needle_line_t){entry, target, 0}, &joints));
}

void test_SWR_KIN_004_a_target_too_low_is_an_unreachable_height(void)
{
    const point_t entry = {0, 150000000, 50000000};
    const point_t target = {0, 100000000, 50000000};
    expect_refusal(
        (solution_t){.status = STATUS_UNREACHABLE_HEIGHT},
        neuro_inverse(&robot, &robot.probe, &(needle_line_t){entry, target, 0}, &joints));
}

static void expect_limit(uint8_t axis, bool is_maximum)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    const axis_config_t *config = &robot.axes[axis];
    memcpy(ticks, middle, sizeof ticks);
    ticks[axis] = is_maximum ? config->maximum_ticks : config->minimum_ticks;
    /* The other carriage follows, so that the separation stays. */
    ticks[NEURO_AXIS_FEET] +=
        (axis == (uint8_t)NEURO_AXIS_HEAD) ? (ticks[NEURO_AXIS_HEAD] - middle[NEURO_AXIS_HEAD]) : 0;
    ticks[NEURO_AXIS_HEAD] +=
        (axis == (uint8_t)NEURO_AXIS_FEET) ? (ticks[NEURO_AXIS_FEET] - middle[NEURO_AXIS_FEET]) : 0;
    /* The other carriage may not be what stops it. */
    robot.axes[NEURO_AXIS_HEAD].minimum_ticks -= (axis == (uint8_t)NEURO_AXIS_FEET) ? 20000 : 0;
    robot.axes[NEURO_AXIS_HEAD].maximum_ticks += (axis == (uint8_t)NEURO_AXIS_FEET) ? 20000 : 0;
    robot.axes[NEURO_AXIS_FEET].minimum_ticks -= (axis == (uint8_t)NEURO_AXIS_HEAD) ? 20000 : 0;
    robot.axes[NEURO_AXIS_FEET].maximum_ticks += (axis == (uint8_t)NEURO_AXIS_HEAD) ? 20000 : 0;
    rigid_t pose = pose_at(ticks);
    int64_t depth = joints_value(&robot.axes[NEURO_AXIS_INSERTION], ticks[NEURO_AXIS_INSERTION]);
    TEST_ASSERT_EQUAL(
        STATUS_OK,
        neuro_inverse_at_depth(&robot, &robot.probe, &pose, (int32_t)depth, &joints).status);
    ticks[axis] += is_maximum ? 1 : -1;
    pose = pose_at(ticks);
    depth = joints_value(&robot.axes[NEURO_AXIS_INSERTION], ticks[NEURO_AXIS_INSERTION]);
    expect_refusal(
        (solution_t){.status = STATUS_AXIS_LIMIT, .axis = axis, .is_maximum = is_maximum ? 1U : 0U},
        neuro_inverse_at_depth(&robot, &robot.probe, &pose, (int32_t)depth, &joints));
}

void test_SWR_KIN_004_one_tick_beyond_a_limit_names_the_axis_and_the_end(void)
{
    for (uint8_t axis = 0U; axis < robot_neuro.axis_count; axis++) {
        robot = robot_neuro;
        /* Half a turn is more than the pose can distinguish, so the range is made shorter. */
        robot.axes[NEURO_AXIS_ROTATION].minimum_ticks = -3000;
        robot.axes[NEURO_AXIS_ROTATION].maximum_ticks = 3000;
        const robot_t shortened = robot;
        expect_limit(axis, false);
        robot = shortened;
        expect_limit(axis, true);
    }
}

void test_SWR_KIN_004_carriages_too_close_or_too_far_apart_are_refused_by_separation(void)
{
    const int32_t depth = 18000000;
    int32_t ticks[ROBOT_AXIS_MAX];
    memcpy(ticks, middle, sizeof ticks);
    ticks[NEURO_AXIS_HEAD] = ticks[NEURO_AXIS_FEET] - 5360;
    rigid_t pose = pose_at(ticks);
    expect_refusal((solution_t){.status = STATUS_SEPARATION_LIMIT},
                   neuro_inverse_at_depth(&robot, &robot.probe, &pose, depth, &joints));
    ticks[NEURO_AXIS_HEAD] = ticks[NEURO_AXIS_FEET] + 240;
    pose = pose_at(ticks);
    expect_refusal((solution_t){.status = STATUS_SEPARATION_LIMIT, .is_maximum = 1U},
                   neuro_inverse_at_depth(&robot, &robot.probe, &pose, depth, &joints));
    ticks[NEURO_AXIS_HEAD] = ticks[NEURO_AXIS_FEET] + 230;
    pose = pose_at(ticks);
    TEST_ASSERT_EQUAL(STATUS_OK,
                      neuro_inverse_at_depth(&robot, &robot.probe, &pose, depth, &joints).status);
}

void test_SWR_KIN_004_points_at_the_end_of_the_numbers_are_refused(void)
{
    const int32_t ends[3] = {INT32_MIN, 0, INT32_MAX};
    rigid_t pose;
    for (uint32_t i = 0U; i < 729U; i++) {
        const point_t entry = {ends[i % 3U], ends[(i / 3U) % 3U], ends[(i / 9U) % 3U]};
        const point_t target = {ends[(i / 27U) % 3U], ends[(i / 81U) % 3U], ends[(i / 243U) % 3U]};
        TEST_ASSERT_NOT_EQUAL(STATUS_OK, neuro_inverse(&robot, &robot.probe,
                                                       &(needle_line_t){entry, target, 0}, &joints)
                                             .status);
        pose = pose_at(middle);
        pose.translation = target;
        TEST_ASSERT_NOT_EQUAL(STATUS_OK,
                              neuro_solve(&robot, &robot.probe, &pose, &entry, &joints).status);
        TEST_ASSERT_NOT_EQUAL(
            STATUS_OK,
            neuro_inverse_at_depth(&robot, &robot.probe, &pose, INT32_MAX, &joints).status);
    }
}

void test_SWR_KIN_004_numbers_that_are_no_rotation_do_no_harm(void)
{
    for (int i = 0; i < 2000; i++) {
        rigid_t pose;
        point_t entry;
        uint32_t words[15];
        for (uint32_t j = 0U; j < 15U; j++) {
            words[j] =
                (random_below(4U) == 0U) ? 0x80000000U : ((random_below(65536U) << 16U) | 0xFFFFU);
        }
        memcpy(&pose, words, sizeof pose);
        memcpy(&entry, &words[12], sizeof entry);
        TEST_ASSERT_LESS_OR_EQUAL(STATUS_SEPARATION_LIMIT,
                                  neuro_solve(&robot, &robot.probe, &pose, &entry, &joints).status);
        TEST_ASSERT_LESS_OR_EQUAL(
            STATUS_SEPARATION_LIMIT,
            neuro_inverse(&robot, &robot.probe,
                          &(needle_line_t){entry, pose.translation, INT32_MIN}, &joints)
                .status);
        memcpy(&joints, words, sizeof joints);
        neuro_forward(&robot, &robot.probe, &joints, &pose);
    }
}

static uint32_t sweep_checksum(void)
{
    uint32_t words[64];
    uint8_t bytes[256];
    uint32_t checksum = 0U;
    for (uint32_t i = 0U; i < 3000U; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        solution_t result;
        memset(words, 0, sizeof words);
        set_random_legal_ticks(ticks);
        rigid_t pose = pose_at(ticks);
        memcpy(&words[1], &pose, sizeof pose);
        memset(&joints, 0, sizeof joints);
        result = neuro_solve(&robot, &robot.probe, &pose, NULL, &joints);
        memcpy(&words[20], &joints, sizeof joints);
        words[30] = (uint32_t)result.status;
        memset(&joints, 0, sizeof joints);
        result = neuro_inverse_at_depth(&robot, &robot.probe, &pose,
                                        (int32_t)random_below(45000000U), &joints);
        memcpy(&words[40], &joints, sizeof joints);
        words[50] = (uint32_t)result.status;
        words[51] = result.axis;
        words[0] = checksum;
        for (uint32_t j = 0U; j < 256U; j++) {
            bytes[j] = (uint8_t)(words[j / 4U] >> (8U * (j % 4U)));
        }
        checksum = crc32c(bytes, sizeof bytes);
    }
    return checksum;
}

void test_SWR_KIN_005_a_sweep_gives_the_same_bits_on_every_processor_and_compiler(void)
{
    TEST_ASSERT_EQUAL_HEX32(0x2F45A5E0U, sweep_checksum());
}

/* The entry point of the probe at these positions, moved sideways (off the needle's axis). */
static point_t entry_at(const int32_t ticks[ROBOT_AXIS_MAX], double sideways_mm)
{
    double joint[ROBOT_AXIS_MAX];
    double entry_mm[3];
    joints_t values;
    neuro_reference_pose_t pose;
    joints_from_ticks(&robot, ticks, &values);
    neuro_reference_joints(&robot, &values, joint);
    neuro_reference_entry(&robot, joint, entry_mm);
    neuro_reference_forward(&robot, joint, &pose);
    for (int i = 0; i < 3; i++) {
        entry_mm[i] += sideways_mm * pose.rotation[i][0];
    }
    return point_of(entry_mm);
}

void test_SWR_PLAN_001_an_entry_on_the_axis_decides_the_depth(void)
{
    for (int i = 0; i < 2000; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        int32_t solved[ROBOT_AXIS_MAX];
        set_random_legal_ticks(ticks);
        ticks[NEURO_AXIS_ROTATION] /= 2;
        const rigid_t pose = pose_at(ticks);
        const point_t entry = entry_at(ticks, ((i % 2) == 0) ? 0.0 : 0.09);
        TEST_ASSERT_EQUAL(STATUS_OK,
                          neuro_solve(&robot, &robot.probe, &pose, &entry, &joints).status);
        joints_to_ticks(&robot, &joints, solved);
        TEST_ASSERT_EQUAL_INT32_ARRAY(ticks, solved, robot_neuro.axis_count);
    }
}

void test_SWR_PLAN_001_an_entry_is_on_the_axis_up_to_the_limit(void)
{
    joints_t free_joints;
    const rigid_t pose = pose_at(middle);
    const double limit_mm = LIMIT_ENTRY_ON_AXIS_NM / NM_PER_MM;
    const point_t inside = entry_at(middle, limit_mm - 0.00001);
    const point_t outside = entry_at(middle, limit_mm + 0.00001);
    TEST_ASSERT_EQUAL(STATUS_OK,
                      neuro_solve(&robot, &robot.probe, &pose, NULL, &free_joints).status);
    TEST_ASSERT_EQUAL(STATUS_OK, neuro_solve(&robot, &robot.probe, &pose, &inside, &joints).status);
    TEST_ASSERT_INT32_WITHIN(100, 17999964, joints.value[NEURO_AXIS_INSERTION]);
    TEST_ASSERT_EQUAL(STATUS_OK,
                      neuro_solve(&robot, &robot.probe, &pose, &outside, &joints).status);
    TEST_ASSERT_EQUAL_INT32(free_joints.value[NEURO_AXIS_INSERTION],
                            joints.value[NEURO_AXIS_INSERTION]);
    TEST_ASSERT_NOT_EQUAL_INT32(17999964, joints.value[NEURO_AXIS_INSERTION]);
}

void test_SWR_PLAN_001_an_entry_off_the_axis_by_0_11_mm_is_ignored(void)
{
    joints_t free_joints;
    const rigid_t pose = pose_at(middle);
    const point_t entry = entry_at(middle, 0.11);
    (void)neuro_solve(&robot, &robot.probe, &pose, NULL, &free_joints);
    TEST_ASSERT_EQUAL(STATUS_OK, neuro_solve(&robot, &robot.probe, &pose, &entry, &joints).status);
    TEST_ASSERT_EQUAL_INT32_ARRAY(free_joints.value, joints.value, robot_neuro.axis_count);
}

void test_SWR_PLAN_001_an_entry_that_asks_for_an_illegal_depth_is_refused(void)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    memcpy(ticks, middle, sizeof ticks);
    const rigid_t pose = pose_at(ticks);
    ticks[NEURO_AXIS_INSERTION] = -20000;
    const rigid_t retracted = pose_at(ticks);
    point_t entry = entry_at(middle, 0.0);
    entry.x_nm += pose.translation.x_nm - retracted.translation.x_nm;
    entry.y_nm += pose.translation.y_nm - retracted.translation.y_nm;
    entry.z_nm += pose.translation.z_nm - retracted.translation.z_nm;
    expect_refusal(
        (solution_t){.status = STATUS_AXIS_LIMIT, .axis = NEURO_AXIS_INSERTION, .is_maximum = 0U},
        neuro_solve(&robot, &robot.probe, &pose, &entry, &joints));
}

void test_SWR_PLAN_020_it_is_told_whether_an_entry_decided_the_depth(void)
{
    const rigid_t pose = pose_at(middle);
    const point_t inside = entry_at(middle, 0.09);
    const point_t outside = entry_at(middle, 0.11);
    TEST_ASSERT_EQUAL_UINT8(1U,
                            neuro_solve(&robot, &robot.probe, &pose, &inside, &joints).is_by_entry);
    TEST_ASSERT_EQUAL_UINT8(
        0U, neuro_solve(&robot, &robot.probe, &pose, &outside, &joints).is_by_entry);
    TEST_ASSERT_EQUAL_UINT8(0U,
                            neuro_solve(&robot, &robot.probe, &pose, NULL, &joints).is_by_entry);
}

/* A place may be reached at another depth, an angle not. */
void test_SWR_PLAN_020_an_angle_out_of_reach_is_not_the_fault_of_an_entry(void)
{
    static const uint32_t missed[] = {NEURO_AXIS_LATERAL, NEURO_AXIS_INSERTION, NEURO_AXIS_PITCH,
                                      NEURO_AXIS_YAW};
    for (uint32_t i = 0U; i < (sizeof missed / sizeof missed[0]); i++) {
        const uint32_t axis = missed[i];
        int32_t ticks[ROBOT_AXIS_MAX];
        memcpy(ticks, middle, sizeof ticks);
        ticks[axis] = robot_neuro.axes[axis].maximum_ticks + 5;
        const rigid_t pose = pose_at(ticks);
        const point_t entry = entry_at(ticks, 0.0);
        const solution_t result = neuro_solve(&robot, &robot.probe, &pose, &entry, &joints);
        expect_refusal(
            (solution_t){.status = STATUS_AXIS_LIMIT, .axis = (uint8_t)axis, .is_maximum = 1U},
            result);
        TEST_ASSERT_EQUAL_UINT8((i < 2U) ? 1U : 0U, result.is_by_entry);
    }
}

/* The reference's margins of the free depth of a target. */
typedef struct {
    double chosen;  /* Margin at the depth that was chosen. */
    double largest; /* Largest margin of all depths. */
    double above;   /* Largest margin of the depths beyond the chosen one. */
    bool is_legal;  /* Every joint is inside its limits at the depth with the largest margin. */
} depths_t;

static depths_t depths_of(const rigid_t *target, int32_t chosen_nm)
{
    depths_t depths = {-INFINITY, -INFINITY, -INFINITY, false};
    neuro_reference_pose_t pose;
    double joint[ROBOT_AXIS_MAX];
    neuro_reference_of(target, &pose);
    for (int depth = 0; depth <= 40; depth++) {
        if (neuro_reference_inverse(&robot, &pose, depth, joint)) {
            const double margin = neuro_reference_depth_margin(&robot, joint);
            if (margin > depths.largest) {
                depths.largest = margin;
                depths.is_legal = neuro_reference_margin(&robot, joint) > 1.0e-6;
            }
            depths.chosen = (depth * 1000000 == chosen_nm) ? margin : depths.chosen;
            depths.above =
                (depth * 1000000 > chosen_nm) ? fmax(margin, depths.above) : depths.above;
        }
    }
    return depths;
}

#define ENOUGH (LIMIT_DEPTH_MARGIN_PERCENT / 100.0)

void test_SWR_PLAN_014_the_free_depth_is_the_largest_whole_millimetre_with_room(void)
{
    uint32_t solved = 0U;
    for (int i = 0; i < 3000; i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        set_random_legal_ticks(ticks);
        const rigid_t target = pose_at(ticks);
        const solution_t result = neuro_solve(&robot, &robot.probe, &target, NULL, &joints);
        const depths_t depths = depths_of(&target, joints.value[NEURO_AXIS_INSERTION]);
        if ((result.status == STATUS_OK) && (depths.largest > (ENOUGH + 1.0e-6))) {
            TEST_ASSERT_TRUE(depths.chosen >= (ENOUGH - 1.0e-6));
            TEST_ASSERT_TRUE(depths.above <= (ENOUGH + 1.0e-6));
            expect_same_pose(&target, &joints);
            solved++;
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(2000U, solved);
}

void test_SWR_PLAN_014_the_needle_goes_38_mm_alone_where_the_base_has_room(void)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    memcpy(ticks, middle, sizeof ticks);
    ticks[NEURO_AXIS_INSERTION] = robot.axes[NEURO_AXIS_INSERTION].maximum_ticks;
    const rigid_t pose = pose_at(ticks);
    TEST_ASSERT_EQUAL(STATUS_OK, neuro_solve(&robot, &robot.probe, &pose, NULL, &joints).status);
    TEST_ASSERT_EQUAL_INT32(38000000, joints.value[NEURO_AXIS_INSERTION]);
}

void test_SWR_PLAN_002_without_that_room_the_depth_has_the_largest_margin_of_all(void)
{
    uint32_t solved = 0U;
    for (uint32_t i = 0U; i < SCENES(20000U); i++) {
        int32_t ticks[ROBOT_AXIS_MAX];
        set_random_legal_ticks(ticks);
        ticks[NEURO_AXIS_LATERAL] /= 40;
        const rigid_t target = pose_at(ticks);
        const solution_t result = neuro_solve(&robot, &robot.probe, &target, NULL, &joints);
        const depths_t depths = depths_of(&target, joints.value[NEURO_AXIS_INSERTION]);
        if ((result.status == STATUS_OK) && (depths.largest < (ENOUGH - 1.0e-6))) {
            TEST_ASSERT_TRUE(depths.chosen >= (depths.largest - 1.0e-6));
            expect_same_pose(&target, &joints);
            solved++;
        } else if (result.status != STATUS_OK) {
            TEST_ASSERT_FALSE(depths.is_legal);
        } else {
            /* There is room. */
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(500U), solved);
}

void test_SWR_PLAN_002_a_joint_that_no_depth_moves_does_not_decide_it(void)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    memcpy(ticks, middle, sizeof ticks);
    const rigid_t before = pose_at(ticks);
    TEST_ASSERT_EQUAL(STATUS_OK, neuro_solve(&robot, &robot.probe, &before, NULL, &joints).status);
    const int32_t depth_nm = joints.value[NEURO_AXIS_INSERTION];
    /* The margin of the yaw is 0 at every depth now. */
    robot.axes[NEURO_AXIS_YAW].minimum_ticks = ticks[NEURO_AXIS_YAW];
    TEST_ASSERT_EQUAL(STATUS_OK, neuro_solve(&robot, &robot.probe, &before, NULL, &joints).status);
    TEST_ASSERT_EQUAL_INT32(depth_nm, joints.value[NEURO_AXIS_INSERTION]);
}

void test_SWR_PLAN_002_a_margin_is_the_part_of_the_range_to_the_nearer_limit(void)
{
    joint_limits_t limits;
    margin_t margin;
    neuro_limits(&robot, &limits);
    margin_init(&margin);
    const int64_t range =
        limits.limit[NEURO_AXIS_LATERAL].maximum - limits.limit[NEURO_AXIS_LATERAL].minimum;
    margin_add(&margin, &limits, NEURO_AXIS_LATERAL, -range / 4);
    TEST_ASSERT_TRUE(fabs((double)margin.margin_q56 / 72057594037927936.0 - 0.25) < 1.0e-7);
    expect_refusal(
        (solution_t){.status = STATUS_AXIS_LIMIT, .axis = NEURO_AXIS_LATERAL, .is_maximum = 1U},
        margin_limit(&margin, &limits));
    margin_add(&margin, &limits, NEURO_AXIS_LATERAL, -range / 2);
    TEST_ASSERT_TRUE(fabs((double)margin.margin_q56 / 72057594037927936.0 - 0.25) < 1.0e-7);
    margin_add(&margin, &limits, NEURO_LIMIT_SEPARATION, 75000000);
    TEST_ASSERT_EQUAL_INT64(0, margin.margin_q56);
    expect_refusal((solution_t){.status = STATUS_SEPARATION_LIMIT}, margin_limit(&margin, &limits));
    margin_add(&margin, &limits, NEURO_LIMIT_HEIGHT, INT64_C(8000000000));
    expect_refusal((solution_t){.status = STATUS_UNREACHABLE_HEIGHT, .is_maximum = 1U},
                   margin_limit(&margin, &limits));
}

void test_SWR_PLAN_003_without_a_legal_depth_the_nearest_limit_is_named(void)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    memcpy(ticks, middle, sizeof ticks);
    ticks[NEURO_AXIS_YAW] = 100;
    rigid_t pose = pose_at(ticks);
    expect_refusal(
        (solution_t){.status = STATUS_AXIS_LIMIT, .axis = NEURO_AXIS_YAW, .is_maximum = 1U},
        neuro_solve(&robot, &robot.probe, &pose, NULL, &joints));
    memcpy(ticks, middle, sizeof ticks);
    ticks[NEURO_AXIS_PITCH] = 0;
    ticks[NEURO_AXIS_LATERAL] = -4000;
    pose = pose_at(ticks);
    expect_refusal(
        (solution_t){.status = STATUS_AXIS_LIMIT, .axis = NEURO_AXIS_LATERAL, .is_maximum = 0U},
        neuro_solve(&robot, &robot.probe, &pose, NULL, &joints));
}

void test_SWR_PLAN_003_the_depth_that_misses_by_least_decides_which_limit_is_named(void)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    memcpy(ticks, middle, sizeof ticks);
    ticks[NEURO_AXIS_YAW] = 0;
    /* Straight down: the height needed grows by 1 mm with each mm of depth. */
    rigid_t pose = pose_at(ticks);
    pose.translation.y_nm += 30000000;
    expect_refusal((solution_t){.status = STATUS_SEPARATION_LIMIT},
                   neuro_solve(&robot, &robot.probe, &pose, NULL, &joints));
    pose.translation.y_nm += 10000000;
    expect_refusal((solution_t){.status = STATUS_UNREACHABLE_HEIGHT, .is_maximum = 1U},
                   neuro_solve(&robot, &robot.probe, &pose, NULL, &joints));
    pose.translation.y_nm -= 200000000;
    expect_refusal((solution_t){.status = STATUS_UNREACHABLE_HEIGHT},
                   neuro_solve(&robot, &robot.probe, &pose, NULL, &joints));
}

void test_SWR_PLAN_004_the_difference_of_poses_is_their_distance_and_largest_angle(void)
{
    rigid_t a;
    rigid_t b;
    int32_t distance_nm;
    int32_t angle_bam;
    const fixed_direction_t turn = fixed_direction(123456);
    rigid_set_identity(&a);
    rigid_set_identity(&b);
    rigid_difference(&a, &b, &distance_nm, &angle_bam);
    TEST_ASSERT_EQUAL_INT32(0, distance_nm);
    TEST_ASSERT_EQUAL_INT32(0, angle_bam);
    b.translation = (point_t){300, -400, 1200};
    b.rotation_q30[0][0] = turn.cosine_q30;
    b.rotation_q30[0][1] = -turn.sine_q30;
    b.rotation_q30[1][0] = turn.sine_q30;
    b.rotation_q30[1][1] = turn.cosine_q30;
    rigid_difference(&a, &b, &distance_nm, &angle_bam);
    TEST_ASSERT_EQUAL_INT32(1300, distance_nm);
    TEST_ASSERT_INT32_WITHIN(6, 123456, angle_bam);
}

void test_SWR_PLAN_004_opposite_axes_and_the_farthest_points_differ_by_the_largest_numbers(void)
{
    rigid_t a;
    rigid_t b;
    int32_t distance_nm;
    int32_t angle_bam;
    rigid_set_identity(&a);
    rigid_set_identity(&b);
    b.rotation_q30[0][0] = -FIXED_ONE_Q30;
    b.rotation_q30[1][1] = -FIXED_ONE_Q30;
    a.translation.x_nm = INT32_MAX;
    b.translation.x_nm = INT32_MIN;
    rigid_difference(&a, &b, &distance_nm, &angle_bam);
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, distance_nm);
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, angle_bam);
}

void test_SWR_FIX_003_ticks_and_joints_of_the_farthest_positions_do_not_wrap(void)
{
    static const int32_t farthest[ROBOT_AXIS_MAX] = {INT32_MAX, INT32_MIN, 1, -1, 8073, 0, 0};
    int32_t ticks[ROBOT_AXIS_MAX];
    joints_from_ticks(&robot, farthest, &joints);
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, joints.value[NEURO_AXIS_HEAD]);
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, joints.value[NEURO_AXIS_FEET]);
    TEST_ASSERT_EQUAL_INT32(21169, joints.value[NEURO_AXIS_LATERAL]);
    TEST_ASSERT_EQUAL_INT32(-300, joints.value[NEURO_AXIS_INSERTION]);
    /* 6.280047 rad is 0.003138 rad short of a turn. */
    TEST_ASSERT_INT32_WITHIN(2000, -2145000, joints.value[NEURO_AXIS_ROTATION]);
    joints_to_ticks(&robot, &joints, ticks);
    TEST_ASSERT_EQUAL_INT32(169093, ticks[NEURO_AXIS_HEAD]);
    TEST_ASSERT_EQUAL_INT32(-169093, ticks[NEURO_AXIS_FEET]);
    TEST_ASSERT_EQUAL_INT32(-4, ticks[NEURO_AXIS_ROTATION]);
}

void test_SWR_CORE_003_a_robot_whose_limits_cross_breaks_contract_100(void)
{
    joint_limits_t limits;
    robot.axes[NEURO_AXIS_YAW].minimum_ticks = robot.axes[NEURO_AXIS_YAW].maximum_ticks;
    EXPECT_CONTRACT("margin", 100U, neuro_limits(&robot, &limits));
}

void test_SWR_ROBOT_002_the_robot_table_names_its_robot_and_the_file_it_came_from(void)
{
    TEST_ASSERT_EQUAL_STRING("neuro", robot_neuro.name);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, robot_neuro.axis_count);
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, robot_neuro.crc);
}

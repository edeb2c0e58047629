/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the integer kinematics equals the mechanism, forward and inverse, and refuses
 * what it cannot reach. */
#include "robot/neuro/neuro.h"
#include "unit/support/contract_trap.h"
#include "robot/neuro/test/golden_neuro.h"
#include "robot/neuro/test/neuro_reference.h"
#include "unity.h"
#include "base/crc.h"
#include "base/fixed.h"
#include "robot/neuro/test/neuro_world.inc"

#define MICROMETRE_MM 1.0e-3
#define RAD_10_MICRO 1.0e-5
#define BAM_PER_RAD (2147483648.0 / 3.14159265358979323846)

void setUp(void)
{
    begin_neuro();
}

void tearDown(void)
{
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

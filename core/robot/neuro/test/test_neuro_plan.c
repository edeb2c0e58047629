/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a plan chooses the depth with the largest margin, and names the limit that is
 * nearest if no depth is legal.
 */
#include "robot/neuro/neuro.h"
#include "unit/support/contract_trap.h"
#include "robot/neuro/test/neuro_reference.h"
#include "unit/support/scenes.h"
#include "unity.h"
#include "base/fixed.h"
#include "robot/neuro/test/neuro_world.inc"

#define ENOUGH (LIMIT_DEPTH_MARGIN_PERCENT / 100.0)

void setUp(void)
{
    begin_neuro();
}

void tearDown(void)
{
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

void test_SWR_PLAN_020_it_is_reported_whether_an_entry_decided_the_depth(void)
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

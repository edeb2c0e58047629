/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The plan takes only what is rigid and in range, confirms each target by the way back, and keeps
 * proposals apart.
 */
#include "procedure/plan.h"

#include "unity.h"

#include "base/fixed.h"
#include "base/rigid.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "robot/neuro/neuro.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "unit/support/contract_trap.h"

#include <string.h>

#include "unit/procedure/plan_world.inc"

void setUp(void)
{
    plan_init(&plan, &robot_neuro);
    rigid_set_identity(&identity);
}

/* The plan is whole after any test. */
void tearDown(void)
{
    TEST_ASSERT_FALSE_MESSAGE(plan_is_damaged(&plan), "It changed without being sealed.");
}

void test_SWR_MEMORY_001_every_byte_of_a_plan_is_under_its_seal(void)
{
    for (size_t i = 0U; i < sizeof plan; i++) {
        ((uint8_t *)&plan)[i] ^= 0x10U;
        TEST_ASSERT_TRUE(plan_is_damaged(&plan));
        ((uint8_t *)&plan)[i] ^= 0x10U;
    }
}

void test_SWR_PLAN_004_a_target_without_registration_is_refused(void)
{
    const rigid_t pose = needle_down(5000000, 190000000, 60000000);
    TEST_ASSERT_EQUAL(STATUS_NOT_REGISTERED,
                      plan_set_target(&plan, &robot_neuro, at_home, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
}

void test_SWR_PLAN_004_a_target_that_is_not_rigid_is_refused(void)
{
    rigid_t pose = needle_down(5000000, 190000000, 60000000);
    pose.rotation_q30[0][0] = 0;
    TEST_ASSERT_EQUAL(STATUS_NOT_RIGID,
                      plan_set_target(&plan, &robot_neuro, at_home, &pose).status);
}

void test_SWR_PLAN_004_the_way_back_must_return_position_and_direction(void)
{
    const int32_t home_ticks[ROBOT_AXIS_MAX] = {0, 0, 0, 33333, 0, 0, 0};
    joints_t joints;
    rigid_t pose;
    joints_from_ticks(&robot_neuro, home_ticks, &joints);
    neuro_forward(&robot_neuro, &robot_neuro.probe, &joints, &pose);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_confirm(&plan, &robot_neuro, &joints, &pose));
    joints.value[NEURO_AXIS_LATERAL] += (int32_t)LIMIT_CLOSURE_NM - 10;
    TEST_ASSERT_EQUAL(STATUS_OK, plan_confirm(&plan, &robot_neuro, &joints, &pose));
    joints.value[NEURO_AXIS_LATERAL] += 20;
    TEST_ASSERT_EQUAL(STATUS_CLOSURE, plan_confirm(&plan, &robot_neuro, &joints, &pose));
    joints.value[NEURO_AXIS_LATERAL] -= (int32_t)LIMIT_CLOSURE_NM + 10;
    joints.value[NEURO_AXIS_ROTATION] += (int32_t)LIMIT_CLOSURE_BAM + 100;
    TEST_ASSERT_EQUAL(STATUS_CLOSURE, plan_confirm(&plan, &robot_neuro, &joints, &pose));
}

void test_SWR_PLAN_003_after_a_refused_target_there_is_none(void)
{
    const rigid_t near = needle_down(5000000, 190000000, 60000000);
    const rigid_t far = needle_down(300000000, 190000000, 60000000);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_register(&plan, &robot_neuro, &identity, &nobody));
    TEST_ASSERT_EQUAL(STATUS_OK, plan_set_target(&plan, &robot_neuro, at_home, &near).status);
    TEST_ASSERT_EQUAL_UINT32(1U, plan.has_target);
    TEST_ASSERT_EQUAL(STATUS_AXIS_LIMIT,
                      plan_set_target(&plan, &robot_neuro, at_home, &far).status);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
}

void test_SWR_REG_002_an_accepted_registration_replaces_the_proposed_one(void)
{
    rigid_t shifted = identity;
    shifted.translation.x_nm = 10000000;
    TEST_ASSERT_EQUAL(STATUS_OK,
                      plan_propose_registration(&plan, &robot_neuro, &shifted, &proposer));
    TEST_ASSERT_EQUAL(STATUS_OK, plan_register(&plan, &robot_neuro, &identity, &nobody));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_proposed_registration);
}

void test_SWR_REG_001_a_registration_beyond_its_range_is_refused_and_the_old_one_kept(void)
{
    rigid_t far = identity;
    far.translation.z_nm = (int32_t)LIMIT_REGISTRATION_MAX_NM + 1;
    TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE, plan_register(&plan, &robot_neuro, &far, &nobody));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.is_registered);
    far.translation.z_nm = (int32_t)LIMIT_REGISTRATION_MAX_NM;
    TEST_ASSERT_EQUAL(STATUS_OK, plan_register(&plan, &robot_neuro, &far, &nobody));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.is_registered);
}

void test_SWR_REG_001_a_registration_is_stored_exactly_orthonormal(void)
{
    rigid_t skewed = identity;
    skewed.rotation_q30[0][1] = 50000;
    TEST_ASSERT_EQUAL(STATUS_OK, plan_register(&plan, &robot_neuro, &skewed, &nobody));
    const int64_t dot = (((int64_t)plan.scanner_zframe.rotation_q30[0][0] *
                          plan.scanner_zframe.rotation_q30[0][1]) +
                         ((int64_t)plan.scanner_zframe.rotation_q30[1][0] *
                          plan.scanner_zframe.rotation_q30[1][1]) +
                         ((int64_t)plan.scanner_zframe.rotation_q30[2][0] *
                          plan.scanner_zframe.rotation_q30[2][1])) /
                        FIXED_ONE_Q30;
    TEST_ASSERT_INT64_WITHIN(4, 0, dot);
}

void test_SWR_IGTL_009_a_point_whose_matrix_is_not_rigid_is_no_proposal(void)
{
    rigid_t mirrored = pose_at(0, 246000000, 50000000);
    mirrored.rotation_q30[2][2] = -FIXED_ONE_Q30;
    TEST_ASSERT_EQUAL(STATUS_NOT_RIGID,
                      plan_propose_entry(&plan, &robot_neuro, &mirrored, &proposer));
    TEST_ASSERT_EQUAL(STATUS_NOT_RIGID,
                      plan_propose_target(&plan, &robot_neuro, &mirrored, &proposer));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_proposed_entry + plan.has_proposed_target);
}

void test_SWR_IGTL_009_points_out_of_range_are_no_proposals(void)
{
    const rigid_t far = pose_at(0, -(int32_t)LIMIT_REGISTRATION_MAX_NM - 1, 0);
    TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE,
                      plan_propose_entry(&plan, &robot_neuro, &far, &proposer));
    TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE,
                      plan_propose_target(&plan, &robot_neuro, &far, &proposer));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_proposed_entry + plan.has_proposed_target);
}

void test_SWR_IGTL_009_entry_and_target_together_give_the_desired_pose(void)
{
    const rigid_t entry = pose_at(0, 246000000, 50000000);
    const rigid_t target = pose_at(0, 200000000, 50000000);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_propose_target(&plan, &robot_neuro, &target, &proposer));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.is_proposal_reachable);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_propose_entry(&plan, &robot_neuro, &entry, &proposer));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.is_proposal_reachable);
    TEST_ASSERT_INT32_WITHIN(38000, target.translation.y_nm, plan.scanner_desired.translation.y_nm);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
}

/* Where the needle of the ProstateRobot is along the bore, neither turned nor tilted. */
static rigid_t point_along_the_bore(void)
{
    int32_t ticks[ROBOT_AXIS_MAX];
    joints_t joints;
    rigid_t pose;
    (void)memcpy(ticks, robot_prostate.poses[POSE_DRAPING].ticks, sizeof ticks);
    ticks[PROSTATE_AXIS_INSERTION] = 50000;
    joints_from_ticks(&robot_prostate, ticks, &joints);
    kinematics_forward(&robot_prostate, &robot_prostate.probe, &joints, &pose);
    return pose_at(pose.translation.x_nm, pose.translation.y_nm, pose.translation.z_nm);
}

void test_SWR_IGTL_111_a_bare_target_is_weighed_along_the_bore_where_the_robot_has_that(void)
{
    const rigid_t target = point_along_the_bore();
    plan_init(&plan, &robot_prostate);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_propose_target(&plan, &robot_prostate, &target, &proposer));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.is_proposal_reachable);
    TEST_ASSERT_INT32_WITHIN(1000, FIXED_ONE_Q30, plan.scanner_desired.rotation_q30[2][2]);
    TEST_ASSERT_INT32_WITHIN(40000, target.translation.z_nm, plan.scanner_desired.translation.z_nm);
    const rigid_t entry =
        pose_at(5000000, target.translation.y_nm, target.translation.z_nm - 100000000);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_propose_entry(&plan, &robot_prostate, &entry, &proposer));
    TEST_ASSERT_INT32_WITHIN(2000000, -(FIXED_ONE_Q30 / 20),
                             plan.scanner_desired.rotation_q30[0][2]); /* It decides. */
    TEST_ASSERT_EQUAL(STATUS_OK, plan_withdraw(&plan, &robot_prostate, PLAN_PROPOSED_ENTRY));
    TEST_ASSERT_INT32_WITHIN(1000, FIXED_ONE_Q30, plan.scanner_desired.rotation_q30[2][2]);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
}

void test_SWR_IGTL_009_a_proposed_registration_moves_the_desired_pose_only(void)
{
    const rigid_t entry = pose_at(10000000, 246000000, 50000000);
    const rigid_t target = pose_at(10000000, 200000000, 50000000);
    rigid_t shifted = identity;
    shifted.translation.x_nm = 10000000;
    TEST_ASSERT_EQUAL(STATUS_OK,
                      plan_propose_registration(&plan, &robot_neuro, &shifted, &proposer));
    (void)plan_propose_entry(&plan, &robot_neuro, &entry, &proposer);
    (void)plan_propose_target(&plan, &robot_neuro, &target, &proposer);
    /* Lateral = 0 - 18.32 mm in the proposed z-frame: 47.24 ticks a mm. */
    TEST_ASSERT_INT32_WITHIN(1, -865, plan.desired_ticks[NEURO_AXIS_LATERAL]);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.is_registered);
}

void test_SWR_IGTL_009_a_proposed_registration_mixes_no_frames_once_one_is_in_force(void)
{
    const rigid_t entry = pose_at(0, 246000000, 50000000);
    const rigid_t target = pose_at(0, 200000000, 50000000);
    rigid_t shifted = identity;
    shifted.translation.x_nm = 10000000;
    TEST_ASSERT_EQUAL(STATUS_OK, plan_register(&plan, &robot_neuro, &identity, &nobody));
    (void)plan_propose_entry(&plan, &robot_neuro, &entry, &proposer);
    (void)plan_propose_target(&plan, &robot_neuro, &target, &proposer);
    const int32_t before = plan.desired_ticks[NEURO_AXIS_LATERAL];
    TEST_ASSERT_EQUAL(STATUS_OK,
                      plan_propose_registration(&plan, &robot_neuro, &shifted, &proposer));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.is_proposal_reachable);
    TEST_ASSERT_EQUAL_INT32(before, plan.desired_ticks[NEURO_AXIS_LATERAL]);
}

void test_SWR_PLAN_021_without_one_of_its_points_the_desired_pose_is_gone(void)
{
    const rigid_t entry = pose_at(0, 246000000, 50000000);
    const rigid_t target = pose_at(0, 200000000, 50000000);
    (void)plan_propose_target(&plan, &robot_neuro, &target, &proposer);
    (void)plan_propose_entry(&plan, &robot_neuro, &entry, &proposer);
    TEST_ASSERT_EQUAL_UINT32(1U, plan.is_proposal_reachable);
    (void)plan_withdraw(&plan, &robot_neuro, PLAN_PROPOSED_ENTRY);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.is_proposal_reachable);
}

void test_SWR_MOTION_024_a_seen_needle_is_checked_and_kept_until_another_target_is_sent(void)
{
    rigid_t wrong = identity;
    wrong.rotation_q30[0][0] = 0;
    TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, plan_see_needle(&plan, &wrong));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_seen_needle);
    rigid_t skewed = identity;
    skewed.rotation_q30[0][1] = 50000;
    skewed.translation.y_nm = 7000000;
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_see_needle(&plan, &skewed));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.has_seen_needle);
    TEST_ASSERT_EQUAL_INT32(7000000, plan.scanner_seen_needle.translation.y_nm);
    TEST_ASSERT_LESS_THAN_INT32(50000, plan.scanner_seen_needle.rotation_q30[0][1]);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_seen_needle);
}

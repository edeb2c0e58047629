/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * An entry point counts for the target that was accepted with it; a proposed one decides nothing.
 */
#include "procedure/plan.h"

#include "unity.h"

#include "base/rigid.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"
#include "robot/neuro/neuro.h"
#include "robot/robot_neuro.h"
#include "unit/support/contract_trap.h"

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

/* |target - entry| = d + 36 mm on a needle straight down. */
static rigid_t entry_for(int32_t depth_nm)
{
    return pose_at(5000000, target_y_nm + 36000000 + depth_nm, 60000000);
}

static int32_t depth_nm(void)
{
    return joints_of(&robot_neuro.axes[NEURO_AXIS_INSERTION],
                     plan.target_ticks[NEURO_AXIS_INSERTION]);
}

void test_SWR_PLAN_017_a_proposed_entry_decides_nothing_until_it_is_accepted(void)
{
    const rigid_t entry = entry_for(20000000);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    TEST_ASSERT_EQUAL(STATUS_NOT_PROPOSED, plan_accept_entry(&plan));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_entry);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    const int32_t free_nm = depth_nm();
    TEST_ASSERT_EQUAL(STATUS_OK, plan_propose_entry(&plan, &robot_neuro, &entry, &proposer));
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    TEST_ASSERT_EQUAL_INT32(free_nm, depth_nm());
    TEST_ASSERT_EQUAL(STATUS_OK, plan_accept_entry(&plan));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.has_proposed_entry);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    TEST_ASSERT_INT32_WITHIN(400, 20000000, depth_nm());
    TEST_ASSERT_NOT_EQUAL_INT32(free_nm, depth_nm());
}

void test_SWR_PLAN_017_an_accepted_entry_stays_when_another_is_proposed(void)
{
    const rigid_t first = entry_for(20000000);
    const rigid_t second = entry_for(10000000);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    (void)plan_propose_entry(&plan, &robot_neuro, &first, &proposer);
    (void)plan_accept_entry(&plan);
    (void)plan_propose_entry(&plan, &robot_neuro, &second, &proposer);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    TEST_ASSERT_INT32_WITHIN(400, 20000000, depth_nm());
}

void test_SWR_PLAN_017_an_entry_is_checked_as_a_proposal_is(void)
{
    const rigid_t entry = entry_for(20000000);
    rigid_t wrong = entry;
    wrong.rotation_q30[1][1] = 0;
    TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, plan_set_entry(&plan, &wrong));
    wrong = entry;
    wrong.translation.x_nm = (int32_t)LIMIT_REGISTRATION_MAX_NM + 1;
    TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE, plan_set_entry(&plan, &wrong));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_entry);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_set_entry(&plan, &entry));
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    TEST_ASSERT_INT32_WITHIN(400, 20000000, depth_nm());
}

/* The target straight below an entry point that was sent. */
static void aim(int32_t depth)
{
    const rigid_t entry = entry_for(depth);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    (void)plan_set_entry(&plan, &entry);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
}

void test_SWR_ALIGN_003_a_target_that_was_accepted_with_its_entry_point_can_be_aligned_with(void)
{
    const rigid_t entry = entry_for(20000000);
    TEST_ASSERT_EQUAL(STATUS_NO_TARGET, plan_judge_entry(&plan));
    aim(20000000);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_judge_entry(&plan));
    (void)plan_propose_entry(&plan, &robot_neuro, &entry, &proposer);
    (void)plan_withdraw(&plan, &robot_neuro, PLAN_PROPOSED_ENTRY);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_judge_entry(&plan));
    plan_forget_target(&plan);
    TEST_ASSERT_EQUAL(STATUS_NO_TARGET, plan_judge_entry(&plan));
}

void test_SWR_ALIGN_003_an_entry_point_that_is_only_proposed_or_came_later_does_not_count(void)
{
    const rigid_t entry = entry_for(20000000);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    (void)plan_propose_entry(&plan, &robot_neuro, &entry, &proposer);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    TEST_ASSERT_EQUAL(STATUS_NO_ENTRY_POINT, plan_judge_entry(&plan));
    (void)plan_accept_entry(&plan);
    TEST_ASSERT_EQUAL(STATUS_NO_ENTRY_POINT, plan_judge_entry(&plan));
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_judge_entry(&plan));
}

void test_SWR_ALIGN_003_another_entry_point_or_none_is_not_that_of_the_target(void)
{
    const rigid_t other = entry_for(21000000);
    aim(20000000);
    (void)plan_set_entry(&plan, &other);
    TEST_ASSERT_EQUAL(STATUS_NO_ENTRY_POINT, plan_judge_entry(&plan));
    aim(20000000);
    (void)plan_propose_entry(&plan, &robot_neuro, &other, &proposer);
    (void)plan_accept_entry(&plan);
    TEST_ASSERT_EQUAL(STATUS_NO_ENTRY_POINT, plan_judge_entry(&plan));
    aim(20000000);
    (void)plan_withdraw(&plan, &robot_neuro, PLAN_ENTRY);
    TEST_ASSERT_EQUAL(STATUS_NO_ENTRY_POINT, plan_judge_entry(&plan));
}

/* On the needle's line, within 0.1 mm, and before the target. */
void test_SWR_ALIGN_003_the_entry_point_lies_on_the_line_of_the_needle(void)
{
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    for (int32_t axis = 0; axis < 3; axis++) {
        rigid_t entry = entry_for(20000000);
        int32_t *const place[3] = {&entry.translation.x_nm, &entry.translation.z_nm,
                                   &entry.translation.y_nm};
        const bool is_along = axis == 2;
        *place[axis] += (int32_t)LIMIT_ENTRY_ON_AXIS_NM;
        (void)plan_set_entry(&plan, &entry);
        TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
        TEST_ASSERT_EQUAL(STATUS_OK, plan_judge_entry(&plan));
        *place[axis] += 1;
        (void)plan_set_entry(&plan, &entry);
        TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
        TEST_ASSERT_EQUAL(is_along ? STATUS_OK : STATUS_NO_ENTRY_POINT, plan_judge_entry(&plan));
    }
}

void test_SWR_ALIGN_003_an_entry_point_beyond_the_target_is_none(void)
{
    const rigid_t entry = entry_for(-72000000);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    (void)plan_set_entry(&plan, &entry);
    TEST_ASSERT_EQUAL(STATUS_ENTRY_POINT, set_target().status);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.is_entry_of_target);
}

void test_SWR_REG_002_a_registration_forgets_the_entry_and_the_seen_needle(void)
{
    const rigid_t entry = entry_for(20000000);
    (void)plan_set_entry(&plan, &entry);
    (void)plan_see_needle(&plan, &entry);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_register(&plan, &robot_neuro, &identity, &nobody));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_entry + plan.has_seen_needle);
}

void test_SWR_LINK_003_with_the_target_entry_and_seen_needle_are_forgotten(void)
{
    const rigid_t entry = entry_for(20000000);
    (void)plan_set_entry(&plan, &entry);
    (void)plan_see_needle(&plan, &entry);
    plan_forget_target(&plan);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_entry + plan.has_seen_needle);
}

void test_SWR_PLAN_018_proposals_and_their_withdrawal_leave_the_target_as_it_is(void)
{
    const rigid_t entry = entry_for(10000000);
    rigid_t shifted = identity;
    shifted.translation.x_nm = 10000000;
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    const plan_t before = plan;
    (void)plan_propose_registration(&plan, &robot_neuro, &shifted, &proposer);
    (void)plan_propose_entry(&plan, &robot_neuro, &entry, &proposer);
    (void)plan_propose_target(&plan, &robot_neuro, &entry, &proposer);
    for (uint32_t i = PLAN_PROPOSED_REGISTRATION; i <= PLAN_PROPOSED_TARGET; i++) {
        TEST_ASSERT_EQUAL(STATUS_OK, plan_withdraw(&plan, &robot_neuro, (plan_part_t)i));
    }
    TEST_ASSERT_EQUAL_UINT32(1U, plan.has_target);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_entry);
    TEST_ASSERT_EQUAL_MEMORY(&before.scanner_target, &plan.scanner_target, sizeof(rigid_t));
    TEST_ASSERT_EQUAL_MEMORY(&before.scanner_zframe, &plan.scanner_zframe, sizeof(rigid_t));
    TEST_ASSERT_EQUAL_INT32_ARRAY(before.target_ticks, plan.target_ticks, ROBOT_AXIS_MAX);
}

void test_SWR_PLAN_019_an_entry_that_comes_or_goes_leaves_the_target_as_it_is(void)
{
    const rigid_t illegal = entry_for(-6000000);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
    const plan_t before = plan;
    TEST_ASSERT_EQUAL(STATUS_OK, plan_set_entry(&plan, &illegal));
    TEST_ASSERT_EQUAL(STATUS_OK, plan_withdraw(&plan, &robot_neuro, PLAN_ENTRY));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.has_target);
    TEST_ASSERT_EQUAL_INT32_ARRAY(before.target_ticks, plan.target_ticks, ROBOT_AXIS_MAX);
}

void test_SWR_PLAN_020_a_target_refused_because_of_an_entry_says_so(void)
{
    const rigid_t illegal = entry_for(45000000);
    const rigid_t pose = needle_down(5000000, target_y_nm, 60000000);
    joints_t joints;
    const solution_t inner =
        neuro_solve(&robot_neuro, &robot_neuro.probe, &pose, &illegal.translation, &joints);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    (void)plan_set_entry(&plan, &illegal);
    const solution_t result = set_target();
    TEST_ASSERT_EQUAL(STATUS_AXIS_LIMIT, inner.status);
    TEST_ASSERT_EQUAL(STATUS_ENTRY_POINT, result.status);
    TEST_ASSERT_EQUAL_UINT8(inner.axis, result.axis);
    TEST_ASSERT_EQUAL_UINT8(1U, inner.is_maximum);
    TEST_ASSERT_EQUAL_UINT8(1U, result.is_maximum);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_withdraw(&plan, &robot_neuro, PLAN_ENTRY));
    TEST_ASSERT_EQUAL(STATUS_OK, set_target().status);
}

void test_SWR_PLAN_020_an_entry_elsewhere_is_not_blamed(void)
{
    const rigid_t elsewhere = pose_at(15000000, 246000000, 60000000);
    const rigid_t far = needle_down(300000000, target_y_nm, 60000000);
    (void)plan_register(&plan, &robot_neuro, &identity, &nobody);
    (void)plan_set_entry(&plan, &elsewhere);
    TEST_ASSERT_EQUAL(STATUS_AXIS_LIMIT,
                      plan_set_target(&plan, &robot_neuro, at_home, &far).status);
}

void test_SWR_PLAN_021_only_what_is_there_can_be_withdrawn(void)
{
    const rigid_t pose = entry_for(10000000);
    for (uint32_t i = PLAN_ENTRY; i <= PLAN_PROPOSED_TARGET; i++) {
        TEST_ASSERT_EQUAL(STATUS_NOT_PROPOSED, plan_withdraw(&plan, &robot_neuro, (plan_part_t)i));
    }
    (void)plan_set_entry(&plan, &pose);
    (void)plan_propose_registration(&plan, &robot_neuro, &identity, &proposer);
    (void)plan_propose_entry(&plan, &robot_neuro, &pose, &proposer);
    (void)plan_propose_target(&plan, &robot_neuro, &pose, &proposer);
    uint32_t *const flags[] = {&plan.has_entry, &plan.has_proposed_registration,
                               &plan.has_proposed_entry, &plan.has_proposed_target};
    for (uint32_t i = PLAN_ENTRY; i <= PLAN_PROPOSED_TARGET; i++) {
        TEST_ASSERT_EQUAL(STATUS_OK, plan_withdraw(&plan, &robot_neuro, (plan_part_t)i));
        for (uint32_t other = PLAN_ENTRY; other <= PLAN_PROPOSED_TARGET; other++) {
            TEST_ASSERT_EQUAL_UINT32((other > i) ? 1U : 0U, *flags[other]);
        }
        TEST_ASSERT_EQUAL(STATUS_NOT_PROPOSED, plan_withdraw(&plan, &robot_neuro, (plan_part_t)i));
    }
}

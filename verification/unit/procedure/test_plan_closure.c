/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the planner asks forward kinematics back, and arms nothing that it contradicts.
 * The kinematics is a mock here, so that it can be wrong.
 */
#include "unity.h"

#include "base/crc.h"
#include "base/fixed.h"
#include "base/rigid.h"
#include "limits/requirement_limits.h"
#include "mock_joints.h"
#include "mock_kinematics.h"
#include "procedure/plan.h"
#include "robot/bare_direction.h"
#include "robot/probe.h"
#include "robot/robot_neuro.h"

#include <string.h>

/* The two carriages apart: here the coupled limit is looked at by itself. */
static robot_t lone;
static int32_t planned_ticks[ROBOT_AXIS_MAX];
static int32_t present_ticks[ROBOT_AXIS_MAX];
static plan_t plan;
static const plan_origin_t nobody = {.ignores_rotation = false};
static int32_t wrong_by_nm;
static uint8_t is_by_entry;

static solution_t solve(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                        const point_t *entry, joints_t *joints, int calls)
{
    (void)robot;
    (void)probe;
    (void)pose;
    (void)entry;
    (void)calls;
    *joints = (joints_t){0};
    return (solution_t){.status = STATUS_OK, .is_by_entry = is_by_entry};
}

static void go_forward(const robot_t *robot, const probe_t *probe, const joints_t *joints,
                       rigid_t *pose, int calls)
{
    (void)robot;
    (void)probe;
    (void)joints;
    (void)calls;
    rigid_set_identity(pose);
    pose->translation.x_nm = wrong_by_nm;
}

/* As core/robot/joints.c, to the nanometre. */
static int64_t value_of(const axis_config_t *axis, int32_t ticks, int calls)
{
    (void)calls;
    return fixed_shift_rounded(ticks * axis->unit_per_tick_q16, 16U);
}

/* As core/robot/joints.c. */
static int32_t joint_of(const axis_config_t *axis, int32_t ticks, int calls)
{
    return fixed_saturate(value_of(axis, ticks, calls));
}

static void to_ticks(const robot_t *robot, const joints_t *joints, int32_t ticks[ROBOT_AXIS_MAX],
                     int calls)
{
    (void)robot;
    (void)joints;
    (void)calls;
    (void)memcpy(ticks, planned_ticks, sizeof planned_ticks);
}

static void from_ticks(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX], joints_t *joints,
                       int calls)
{
    *joints = (joints_t){0};
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        joints->value[i] = joint_of(&robot->axes[i], ticks[i], calls);
    }
}

static int64_t separation_of(const robot_t *robot, uint32_t index, const joints_t *joints,
                             int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL_UINT32(0U, index);
    return ((int64_t)joints->value[NEURO_AXIS_HEAD] - joints->value[NEURO_AXIS_FEET]) +
           robot->geometry_nm[NEURO_HOME_SEPARATION];
}

/* Highest, 0, where the head is 50 mm out; 10 mm less 10 mm from there. */
static int64_t hill_of(const robot_t *robot, uint32_t index, const joints_t *joints, int calls)
{
    (void)robot;
    (void)index;
    (void)calls;
    const int64_t off_nm = (int64_t)joints->value[NEURO_AXIS_HEAD] + 50000000;
    return -(off_nm * off_nm) / 10000000;
}

void setUp(void)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const config = &robot_neuro.axes[i];
        planned_ticks[i] = (config->target_minimum_ticks / 2) + (config->target_maximum_ticks / 2);
    }
    lone = robot_neuro;
    lone.coupled_limit_count = 0U;
    (void)memset(present_ticks, 0, sizeof present_ticks);
    plan_init(&plan, &robot_neuro);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_register(&plan, &robot_neuro, &identity, &nobody));
    kinematics_solve_Stub(solve);
    kinematics_forward_Stub(go_forward);
    joints_value_Stub(value_of);
    joints_of_Stub(joint_of);
    joints_to_ticks_Stub(to_ticks);
    joints_from_ticks_Stub(from_ticks);
    kinematics_coupled_Stub(separation_of);
}

void tearDown(void)
{
}

static status_t set_target(int32_t nm)
{
    rigid_t pose;
    rigid_set_identity(&pose);
    wrong_by_nm = nm;
    return plan_set_target(&plan, &lone, present_ticks, &pose).status;
}

void test_SWR_PLAN_004_a_plan_that_forward_kinematics_contradicts_is_refused(void)
{
    TEST_ASSERT_EQUAL(STATUS_CLOSURE, set_target((int32_t)LIMIT_CLOSURE_NM + 1));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
}

void test_SWR_PLAN_004_a_plan_within_the_closure_is_taken(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, set_target((int32_t)LIMIT_CLOSURE_NM));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.has_target);
}

/* Both ends of each axis, inside by nothing and outside by one. */
void test_SWR_AXIS_020_a_plan_ends_inside_of_every_switch(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const config = &robot_neuro.axes[i];
        const int32_t middle_ticks = planned_ticks[i];
        planned_ticks[i] = config->target_minimum_ticks;
        TEST_ASSERT_EQUAL(STATUS_OK, set_target(0));
        planned_ticks[i] = config->target_maximum_ticks;
        TEST_ASSERT_EQUAL(STATUS_OK, set_target(0));
        planned_ticks[i] = config->target_minimum_ticks - 1;
        TEST_ASSERT_EQUAL(STATUS_SWITCH_ZONE, set_target(0));
        planned_ticks[i] = config->target_maximum_ticks + 1;
        TEST_ASSERT_EQUAL(STATUS_SWITCH_ZONE, set_target(0));
        TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
        planned_ticks[i] = middle_ticks;
    }
}

/* The margin of 0.2 mm and half a tick of each axis inside, and the next tick. */
void test_SWR_COUPLE_002_a_plan_ends_inside_of_the_coupled_limit(void)
{
    rigid_t pose;
    rigid_set_identity(&pose);
    wrong_by_nm = 0;
    planned_ticks[NEURO_AXIS_FEET] = 0;
    planned_ticks[NEURO_AXIS_HEAD] = -5338;
    TEST_ASSERT_EQUAL(STATUS_OK, plan_set_target(&plan, &robot_neuro, present_ticks, &pose).status);
    planned_ticks[NEURO_AXIS_HEAD] = -5339;
    solution_t result = plan_set_target(&plan, &robot_neuro, present_ticks, &pose);
    TEST_ASSERT_EQUAL(STATUS_SEPARATION_LIMIT, result.status);
    TEST_ASSERT_EQUAL_UINT8(0U, result.is_maximum);
    planned_ticks[NEURO_AXIS_HEAD] = -1000;
    planned_ticks[NEURO_AXIS_FEET] = -1220;
    TEST_ASSERT_EQUAL(STATUS_OK, plan_set_target(&plan, &robot_neuro, present_ticks, &pose).status);
    planned_ticks[NEURO_AXIS_FEET] = -1221;
    result = plan_set_target(&plan, &robot_neuro, present_ticks, &pose);
    TEST_ASSERT_EQUAL(STATUS_SEPARATION_LIMIT, result.status);
    TEST_ASSERT_EQUAL_UINT8(1U, result.is_maximum);
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
    planned_ticks[NEURO_AXIS_LATERAL] = 0;
    TEST_ASSERT_EQUAL(STATUS_SWITCH_ZONE,
                      plan_set_target(&plan, &robot_neuro, present_ticks, &pose).status);
}

/* From 60 to 40 mm over the hill. */
static void go_over_the_hill(int32_t top_nm)
{
    lone = robot_neuro;
    lone.coupled_limits[0].is_curved = 1U;
    lone.coupled_limits[0].minimum = -1000000000;
    lone.coupled_limits[0].maximum = top_nm;
    present_ticks[NEURO_AXIS_HEAD] = -4724;
    planned_ticks[NEURO_AXIS_HEAD] = -3150;
    kinematics_coupled_Stub(hill_of);
}

void test_SWR_PLAN_015_a_target_is_refused_whose_way_leaves_a_limit_that_both_ends_keep(void)
{
    go_over_the_hill(-1000000);
    TEST_ASSERT_EQUAL(STATUS_SEPARATION_LIMIT, set_target(0));
    TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
    go_over_the_hill(1000000);
    TEST_ASSERT_EQUAL(STATUS_OK, set_target(0));
    TEST_ASSERT_EQUAL_UINT32(1U, plan.has_target);
    go_over_the_hill(-1000000);
    present_ticks[NEURO_AXIS_HEAD] = -3000;
    TEST_ASSERT_EQUAL(STATUS_OK, set_target(0));
}

void test_SWR_PLAN_016_the_way_is_judged_again_from_where_the_axes_are_then(void)
{
    go_over_the_hill(-1000000);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_judge_way(&plan, &lone, present_ticks).status);
    present_ticks[NEURO_AXIS_HEAD] = -3000;
    TEST_ASSERT_EQUAL(STATUS_OK, set_target(0));
    TEST_ASSERT_EQUAL(STATUS_OK, plan_judge_way(&plan, &lone, present_ticks).status);
    present_ticks[NEURO_AXIS_HEAD] = -4724;
    const solution_t judged = plan_judge_way(&plan, &lone, present_ticks);
    TEST_ASSERT_EQUAL(STATUS_SEPARATION_LIMIT, judged.status);
    TEST_ASSERT_EQUAL_UINT8(1U, judged.is_maximum);
    TEST_ASSERT_EQUAL_UINT32(1U, plan.has_target);
}

/* The way back, a switch, a coupled limit, the way there. */
void test_SWR_PLAN_020_whatever_refuses_a_depth_that_an_entry_decided_is_reported_as_that(void)
{
    rigid_t pose;
    int32_t middle[ROBOT_AXIS_MAX];
    (void)memcpy(middle, planned_ticks, sizeof middle);
    rigid_set_identity(&pose);
    for (is_by_entry = 0U; is_by_entry <= 1U; is_by_entry++) {
        const bool is_by = is_by_entry != 0U;
        (void)memcpy(planned_ticks, middle, sizeof middle);
        present_ticks[NEURO_AXIS_HEAD] = 0;
        kinematics_coupled_Stub(separation_of);
        wrong_by_nm = (int32_t)LIMIT_CLOSURE_NM + 1000;
        solution_t result = plan_set_target(&plan, &robot_neuro, present_ticks, &pose);
        TEST_ASSERT_EQUAL(is_by ? STATUS_ENTRY_POINT : STATUS_CLOSURE, result.status);
        wrong_by_nm = 0;
        planned_ticks[NEURO_AXIS_YAW] = robot_neuro.axes[NEURO_AXIS_YAW].target_maximum_ticks + 1;
        result = plan_set_target(&plan, &robot_neuro, present_ticks, &pose);
        TEST_ASSERT_EQUAL(is_by ? STATUS_ENTRY_POINT : STATUS_SWITCH_ZONE, result.status);
        TEST_ASSERT_EQUAL_UINT8(NEURO_AXIS_YAW, result.axis);
        planned_ticks[NEURO_AXIS_YAW] = middle[NEURO_AXIS_YAW];
        planned_ticks[NEURO_AXIS_HEAD] = -1000;
        planned_ticks[NEURO_AXIS_FEET] = -1221;
        result = plan_set_target(&plan, &robot_neuro, present_ticks, &pose);
        TEST_ASSERT_EQUAL(is_by ? STATUS_ENTRY_POINT : STATUS_SEPARATION_LIMIT, result.status);
        TEST_ASSERT_EQUAL_UINT8(1U, result.is_maximum);
        planned_ticks[NEURO_AXIS_FEET] = 0;
        go_over_the_hill(-1000000);
        TEST_ASSERT_EQUAL(is_by ? STATUS_ENTRY_POINT : STATUS_SEPARATION_LIMIT, set_target(0));
        TEST_ASSERT_EQUAL_UINT32(0U, plan.has_target);
    }
    is_by_entry = 0U;
}

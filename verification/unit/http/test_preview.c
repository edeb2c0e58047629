/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a preview says what control would say of a target, and how much room is left. */
#include "unity.h"

#include "base/fixed.h"
#include "base/rigid.h"
#include "http/view/preview.h"
#include "procedure/plan.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "unit/support/contract_trap.h"

#include <string.h>

static snapshot_t snapshot;
static plan_t plan;
static const plan_origin_t nobody = {.ignores_rotation = false};
static int32_t ticks[ROBOT_AXIS_MAX];

void setUp(void)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    (void)memset(&snapshot, 0, sizeof snapshot);
    snapshot.is_registered = 1U;
    snapshot.has_probe = 1U;
    (void)memcpy(snapshot.probe_nm, robot_neuro.probe.length_nm, sizeof snapshot.probe_nm);
    snapshot.scanner_zframe = identity;
    plan_init(&plan, &robot_neuro);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_register(&plan, &robot_neuro, &identity, &nobody));
}

void tearDown(void)
{
}

/* The needle straight down. */
static rigid_t needle_at(int32_t x_nm, int32_t y_nm, int32_t z_nm)
{
    const rigid_t pose = {
        .rotation_q30 = {{-FIXED_ONE_Q30, 0, 0}, {0, 0, -FIXED_ONE_Q30}, {0, -FIXED_ONE_Q30, 0}},
        .translation = {x_nm, y_nm, z_nm}};
    return pose;
}

static preview_t preview_of(const rigid_t *pose)
{
    return preview_target(&robot_neuro, &snapshot, pose);
}

void test_SWR_HTTP_033_a_preview_is_what_control_would_accept(void)
{
    const rigid_t pose = needle_at(5000000, 190000000, 60000000);
    const preview_t preview = preview_of(&pose);
    TEST_ASSERT_EQUAL(STATUS_OK, preview.solution.status);
    TEST_ASSERT_EQUAL(STATUS_OK, plan_set_target(&plan, &robot_neuro, ticks, &pose).status);
    TEST_ASSERT_EQUAL_MEMORY(plan.target_ticks, preview.ticks, sizeof preview.ticks);
    TEST_ASSERT_EQUAL_MEMORY(&plan.scanner_target, &preview.reached, sizeof preview.reached);
}

void test_SWR_HTTP_033_the_entry_point_decides_in_a_preview_too(void)
{
    const rigid_t pose = needle_at(0, 200000000, 50000000);
    rigid_t entry = pose;
    entry.translation.y_nm += 46000000;
    const preview_t without = preview_of(&pose);
    snapshot.has_entry = 1U;
    snapshot.entry = entry.translation;
    TEST_ASSERT_EQUAL(STATUS_OK, plan_set_entry(&plan, &entry));
    TEST_ASSERT_EQUAL(STATUS_OK, plan_set_target(&plan, &robot_neuro, ticks, &pose).status);
    const preview_t preview = preview_of(&pose);
    TEST_ASSERT_EQUAL_MEMORY(plan.target_ticks, preview.ticks, sizeof preview.ticks);
    TEST_ASSERT_NOT_EQUAL_INT32(without.ticks[NEURO_AXIS_INSERTION],
                                preview.ticks[NEURO_AXIS_INSERTION]);
}

void test_SWR_HTTP_033_the_axis_with_the_least_room_is_named(void)
{
    const rigid_t pose = needle_at(5000000, 190000000, 60000000);
    const preview_t preview = preview_of(&pose);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *axis = &robot_neuro.axes[i];
        const axis_config_t *least = &robot_neuro.axes[preview.tightest];
        const double range = (double)axis->maximum_ticks - (double)axis->minimum_ticks;
        const double least_range = (double)least->maximum_ticks - (double)least->minimum_ticks;
        const int32_t room = preview_room_ticks(axis, preview.ticks[i]);
        const int32_t least_room = preview_room_ticks(least, preview.ticks[preview.tightest]);
        TEST_ASSERT_TRUE(room >= 0);
        TEST_ASSERT_TRUE(((double)least_room / least_range) <= ((double)room / range));
    }
}

void test_SWR_HTTP_033_a_target_out_of_reach_names_axis_and_limit(void)
{
    const rigid_t pose = needle_at(400000000, 190000000, 60000000);
    const preview_t preview = preview_of(&pose);
    const solution_t solution = plan_set_target(&plan, &robot_neuro, ticks, &pose);
    TEST_ASSERT_NOT_EQUAL(STATUS_OK, preview.solution.status);
    TEST_ASSERT_EQUAL(solution.status, preview.solution.status);
    TEST_ASSERT_EQUAL_UINT32(solution.axis, preview.solution.axis);
    TEST_ASSERT_EQUAL_UINT32(solution.is_maximum, preview.solution.is_maximum);
}

void test_SWR_HTTP_033_without_a_registration_there_is_none(void)
{
    const rigid_t pose = needle_at(5000000, 190000000, 60000000);
    rigid_t aimed;
    snapshot.is_registered = 0U;
    TEST_ASSERT_EQUAL(STATUS_NOT_REGISTERED, preview_of(&pose).solution.status);
    TEST_ASSERT_EQUAL(STATUS_NOT_REGISTERED,
                      preview_aim(&robot_neuro, &snapshot, &pose.translation, &aimed).status);
}

void test_SWR_HTTP_033_a_point_is_aimed_at_from_the_entry_point(void)
{
    const point_t target = {0, 200000000, 50000000};
    rigid_t aimed;
    TEST_ASSERT_EQUAL(STATUS_NOT_PROPOSED,
                      preview_aim(&robot_neuro, &snapshot, &target, &aimed).status);
    snapshot.has_entry = 1U;
    snapshot.entry = target;
    snapshot.entry.y_nm += 46000000;
    TEST_ASSERT_EQUAL(STATUS_OK, preview_aim(&robot_neuro, &snapshot, &target, &aimed).status);
    TEST_ASSERT_INT32_WITHIN(1000, target.y_nm, aimed.translation.y_nm);
    const preview_t preview = preview_of(&aimed);
    TEST_ASSERT_EQUAL(STATUS_OK, preview.solution.status);
    TEST_ASSERT_INT32_WITHIN(60000, target.y_nm, preview.reached.translation.y_nm);
    snapshot.entry = target;
    TEST_ASSERT_EQUAL(STATUS_DEGENERATE_LINE,
                      preview_aim(&robot_neuro, &snapshot, &target, &aimed).status);
}

void test_SWR_HTTP_084_a_bare_point_is_reached_along_the_bore_where_the_robot_has_that(void)
{
    int32_t low[ROBOT_AXIS_MAX];
    joints_t joints;
    rigid_t there;
    rigid_t aimed;
    (void)memcpy(low, robot_prostate.poses[POSE_DRAPING].ticks, sizeof low);
    low[PROSTATE_AXIS_INSERTION] = 50000;
    joints_from_ticks(&robot_prostate, low, &joints);
    kinematics_forward(&robot_prostate, &robot_prostate.probe, &joints, &there);
    const point_t target = there.translation;
    (void)memcpy(snapshot.probe_nm, robot_prostate.probe.length_nm, sizeof snapshot.probe_nm);
    for (uint32_t i = 0U; i < robot_prostate.axis_count; i++) {
        snapshot.axes[i].position_ticks = low[i];
    }
    TEST_ASSERT_EQUAL(STATUS_OK, preview_aim(&robot_prostate, &snapshot, &target, &aimed).status);
    TEST_ASSERT_INT32_WITHIN(1000, FIXED_ONE_Q30, aimed.rotation_q30[0][0]);
    TEST_ASSERT_INT32_WITHIN(1000, FIXED_ONE_Q30, aimed.rotation_q30[1][1]);
    TEST_ASSERT_INT32_WITHIN(1000, FIXED_ONE_Q30, aimed.rotation_q30[2][2]);
    TEST_ASSERT_INT32_WITHIN(1000, target.x_nm, aimed.translation.x_nm);
    TEST_ASSERT_INT32_WITHIN(1000, target.y_nm, aimed.translation.y_nm);
    TEST_ASSERT_INT32_WITHIN(1000, target.z_nm, aimed.translation.z_nm);
    const preview_t preview = preview_target(&robot_prostate, &snapshot, &aimed);
    TEST_ASSERT_EQUAL(STATUS_OK, preview.solution.status);
    snapshot.has_entry = 1U; /* It decides where there is one. */
    snapshot.entry = (point_t){5000000, target.y_nm, target.z_nm - 100000000};
    TEST_ASSERT_EQUAL(STATUS_OK, preview_aim(&robot_prostate, &snapshot, &target, &aimed).status);
    TEST_ASSERT_INT32_WITHIN(2000000, -(FIXED_ONE_Q30 / 20), aimed.rotation_q30[0][2]);
}

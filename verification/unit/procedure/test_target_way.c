/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a way to the target that would leave a limit is known before a move is asked
 * for, and so is the way round it.
 */
#include "procedure/target_way.h"

#include "base/seal.h"
#include "robot/coupled_path.h"
#include "robot/robot_damage.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "unit/support/refused_pair.h"
#include "unit/support/scenes.h"
#include "unity.h"

#include <stddef.h>
#include <string.h>

#define PAIRS SCENES(20U)
#define TRIES 100000U

static robot_t robot;
static target_way_t way;
static uint32_t random_state;
static refused_pair_t pair;

void setUp(void)
{
    robot = robot_prostate;
    (void)memset(&way, 0, sizeof way);
    random_state = 2463534242U;
    pair = (refused_pair_t){.from_ticks = {300129, -321160, 144661, -113624, 200, 0},
                            .to_ticks = {276974, -383369, 208027, -225566, 61173, -4617}};
}

void tearDown(void)
{
}

static void look_once(void)
{
    target_way_look(&way, &robot, pair.from_ticks, pair.to_ticks);
}

static void look(void)
{
    for (uint32_t i = 0U; i < 3U; i++) {
        look_once();
    }
}

static status_t judge(const int32_t from[ROBOT_AXIS_MAX], const int32_t to[ROBOT_AXIS_MAX])
{
    return coupled_path_judge(&robot, from, to).status;
}

void test_SWR_NEXT_023_round_each_refused_way_of_random_places_leads_one_by_the_pose(void)
{
    const int32_t *const pose = robot.poses[TARGET_WAY_POSE].ticks;
    for (uint32_t i = 0U; i < PAIRS; i++) {
        TEST_ASSERT_TRUE(refused_pair_draw(&pair, &robot, &random_state, TRIES));
        look();
        TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_BY_POSE, way.kind);
        TEST_ASSERT_EQUAL(STATUS_OK, judge(pair.from_ticks, pose));
        TEST_ASSERT_EQUAL(STATUS_OK, judge(pose, pair.to_ticks));
        (void)memcpy(pair.from_ticks, pose, sizeof pair.from_ticks);
        look();
        TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_DIRECT, way.kind);
    }
}

void test_SWR_NEXT_023_a_robot_without_a_curved_limit_goes_straight(void)
{
    robot = robot_neuro;
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_DIRECT, way.kind);
    TEST_ASSERT_FALSE(refused_pair_draw(&pair, &robot, &random_state, 10U));
}

void test_SWR_NEXT_023_a_pose_that_cannot_be_reached_leads_nowhere(void)
{
    pose_t *const pose = &robot.poses[TARGET_WAY_POSE];
    (void)memcpy(pose->ticks, pair.to_ticks, sizeof pair.to_ticks);
    pose->seal = seal_of(SEAL_START, (const uint8_t *)pose, offsetof(pose_t, seal));
    TEST_ASSERT_FALSE(robot_is_pose_damaged(&robot, (uint32_t)TARGET_WAY_POSE));
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_NONE, way.kind);
}

void test_SWR_NEXT_023_without_the_pose_there_is_no_way_round(void)
{
    robot.pose_mask = 0U;
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_NONE, way.kind);
}

void test_SWR_NEXT_023_a_damaged_pose_leads_nowhere(void)
{
    robot.poses[TARGET_WAY_POSE].ticks[0] ^= 1;
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_NONE, way.kind);
}

/* In this narrow range nothing but its own ends keeps the limit. */
static void narrow(void)
{
    for (uint32_t i = 0U; i < robot.coupled_limit_count; i++) {
        robot.coupled_limits[i].maximum = robot.coupled_limits[i].minimum;
    }
}

void test_SWR_NEXT_023_a_way_to_or_from_the_pose_that_leaves_a_limit_is_none(void)
{
    narrow();
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_NONE, way.kind);
}

void test_SWR_NEXT_023_from_the_pose_itself_none_leads_round(void)
{
    (void)memcpy(pair.from_ticks, robot.poses[TARGET_WAY_POSE].ticks, sizeof pair.from_ticks);
    narrow();
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_NONE, way.kind);
}

void test_SWR_NEXT_023_what_is_known_is_looked_at_again_only_for_another_way(void)
{
    look();
    narrow();
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_BY_POSE, way.kind);
    pair.from_ticks[1]++;
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_NONE, way.kind);
    robot = robot_prostate;
    pair.to_ticks[4]++;
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_BY_POSE, way.kind);
}

void test_SWR_NEXT_023_what_is_damaged_is_looked_at_again(void)
{
    look();
    way.kind = (uint32_t)TARGET_WAY_DIRECT;
    look();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_BY_POSE, way.kind);
}

void test_SWR_NEXT_023_one_way_is_judged_at_a_time_and_the_direct_one_first(void)
{
    look_once();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_TO_POSE, way.kind);
    look_once();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_FROM_POSE, way.kind);
    look_once();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_BY_POSE, way.kind);
}

void test_SWR_NEXT_023_a_way_that_was_judged_is_not_judged_again(void)
{
    target_way_take(&way, &robot, pair.from_ticks, pair.to_ticks);
    look_once();
    TEST_ASSERT_EQUAL_UINT32(TARGET_WAY_DIRECT, way.kind);
}

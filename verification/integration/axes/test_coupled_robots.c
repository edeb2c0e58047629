/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the coupled limits of every robot of this build hold together with the rest of
 * it. Homed it stands inside them, no joints are without a value, and the margin that ends keep
 * holds what its axes may run on, so that the permit blocks no motion to a legal end.
 */
#include "robot/app/robots.h"

#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/app/robot_names.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/kinematics.h"

#include <string.h>

#define POSES 20000U
#define MOST_VALUE (INT64_C(1) << 48)

static uint32_t seed;

void setUp(void)
{
    seed = 1U;
}

void tearDown(void)
{
}

static uint32_t draw(uint32_t below)
{
    seed = (seed * 1664525U) + 1013904223U;
    return (uint32_t)(((uint64_t)(seed >> 8U) * below) >> 24U);
}

/* The robot whose name is next in the list of words. */
static const robot_t *next(const char **words)
{
    char name[12] = "";
    *words += strspn(*words, ", ");
    const size_t length = strcspn(*words, ", ");
    (void)memcpy(name, *words, length);
    *words += length;
    return (strcmp(name, "or") == 0) ? next(words) : robots_find(name);
}

static void for_each_robot(void (*judge)(const robot_t *robot))
{
    const char *words = robot_names_list();
    uint32_t limits = 0U;
    while (*words != '\0') {
        const robot_t *const robot = next(&words);
        TEST_ASSERT_NOT_NULL(robot);
        judge(robot);
        limits += robot->coupled_limit_count;
    }
    TEST_ASSERT_GREATER_THAN_UINT32(0U, limits);
}

static int64_t distance(int64_t a, int64_t b)
{
    return (a > b) ? (a - b) : (b - a);
}

static int64_t margin_of(const coupled_limit_t *limit)
{
    return (limit->unit == (uint8_t)AXIS_UNIT_MM) ? (int64_t)LIMIT_COUPLED_MARGIN_NM
                                                  : (int64_t)LIMIT_COUPLED_MARGIN_BAM;
}

/* Where homing leaves it. */
static void find_home(const robot_t *robot, joints_t *joints)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    const bool has_pose = (robot->pose_mask & ((uint32_t)1U << (uint32_t)POSE_HOME)) != 0U;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        ticks[i] = has_pose ? robot->poses[POSE_HOME].ticks[i] : robot->axes[i].home_ticks;
    }
    joints_from_ticks(robot, ticks, joints);
}

static void expect_home_inside(const robot_t *robot)
{
    joints_t joints;
    find_home(robot, &joints);
    TEST_ASSERT_EQUAL_INT32(STATUS_OK, coupled_limit_judge(robot, &joints).status);
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        TEST_ASSERT_NOT_EQUAL_HEX32(0U, limit->axes);
        TEST_ASSERT_EQUAL_HEX32(0U, limit->axes >> robot->axis_count);
    }
}

void test_SWR_COUPLE_004_every_robot_stands_inside_its_coupled_limits_when_it_is_homed(void)
{
    for_each_robot(expect_home_inside);
}

/* The same as the compiler of robots has computed another way. */
static void expect_poses_inside(const robot_t *robot)
{
    for (uint32_t pose = 0U; pose < POSE_NAME_COUNT; pose++) {
        joints_t joints;
        joints_from_ticks(robot, robot->poses[pose].ticks, &joints);
        if (((robot->pose_mask >> pose) & 1U) != 0U) {
            TEST_ASSERT_EQUAL_INT32(STATUS_OK, coupled_limit_judge(robot, &joints).status);
        }
    }
}

void test_SWR_COUPLE_004_the_poses_of_every_robot_lie_inside_its_coupled_limits(void)
{
    for_each_robot(expect_poses_inside);
}

/* The ends of 32 bits, and what is about 0. */
static void expect_values(const robot_t *robot)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MIN + 1, -1, 0, 1, INT32_MAX};
    const uint32_t count = (uint32_t)(sizeof ends / sizeof ends[0]);
    for (uint32_t pose = 0U; pose < POSES; pose++) {
        joints_t joints = {{0}};
        for (uint32_t i = 0U; i < robot->axis_count; i++) {
            const uint32_t any = (draw(65536U) << 16U) | draw(65536U);
            joints.value[i] = (draw(2U) == 0U) ? ends[draw(count)] : (int32_t)any;
        }
        for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
            const int64_t value = kinematics_coupled(robot, i, &joints);
            TEST_ASSERT_TRUE((value < MOST_VALUE) && (value > -MOST_VALUE));
            joints_t others = joints;
            for (uint32_t k = 0U; k < robot->axis_count; k++) {
                others.value[k] =
                    coupled_limit_has(&robot->coupled_limits[i], k) ? joints.value[k] : 0;
            }
            TEST_ASSERT_EQUAL_INT64(value, kinematics_coupled(robot, i, &others));
        }
    }
}

void test_SWR_COUPLE_004_no_joints_are_without_a_value_and_other_axes_do_not_count(void)
{
    for_each_robot(expect_values);
}

/* As coupled_guard.c, at the full speed of every motor. */
static int32_t way_ticks(const axis_config_t *config)
{
    const int64_t way = (int64_t)config->full_speed_ticks_per_s * (int64_t)LIMIT_COUPLED_STOP_US;
    return (int32_t)((way + 999999) / 1000000) + 1;
}

/* Each of the corners to which the axes of a limit may run on. */
static void expect_corners(const robot_t *robot, uint32_t index, const int32_t ticks[])
{
    const coupled_limit_t *const limit = &robot->coupled_limits[index];
    int32_t moved[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    joints_from_ticks(robot, ticks, &joints);
    const int64_t value = kinematics_coupled(robot, index, &joints);
    for (uint32_t corner = 0U; corner < ((uint32_t)1U << robot->axis_count); corner++) {
        if ((corner & ~limit->axes) == 0U) {
            for (uint32_t i = 0U; i < robot->axis_count; i++) {
                const int32_t way = way_ticks(&robot->axes[i]);
                moved[i] = ticks[i] + ((((corner >> i) & 1U) != 0U) ? way : -way);
            }
            joints_from_ticks(robot, moved, &joints);
            TEST_ASSERT_LESS_OR_EQUAL_INT64_MESSAGE(
                margin_of(limit), distance(value, kinematics_coupled(robot, index, &joints)),
                limit->name);
        }
    }
}

static void expect_margin(const robot_t *robot)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    uint32_t legal = 0U;
    for (uint32_t pose = 0U; (robot->coupled_limit_count > 0U) && (pose < POSES); pose++) {
        joints_t joints;
        for (uint32_t i = 0U; i < robot->axis_count; i++) {
            const axis_config_t *const config = &robot->axes[i];
            ticks[i] = config->minimum_ticks +
                       (int32_t)draw((uint32_t)(config->maximum_ticks - config->minimum_ticks));
        }
        joints_from_ticks(robot, ticks, &joints);
        if (coupled_limit_judge(robot, &joints).status == STATUS_OK) {
            legal++;
            for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
                expect_corners(robot, i, ticks);
            }
        }
    }
    TEST_ASSERT_TRUE((robot->coupled_limit_count == 0U) || (legal > 100U));
}

void test_SWR_COUPLE_005_the_margin_of_ends_holds_what_all_axes_may_run_on(void)
{
    for_each_robot(expect_margin);
}

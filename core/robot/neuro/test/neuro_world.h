/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The NeuroRobot in a test: its joints, random legal ones, and poses of them.
 */
#ifndef BORESIGHT_NEURO_WORLD_H
#define BORESIGHT_NEURO_WORLD_H

#include "base/rigid.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"
#include "robot/margin.h"
#include "robot/neuro/neuro.h"
#include "robot/robot_neuro.h"
#include "robot/neuro/test/neuro_reference.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#define NM_PER_MM 1.0e6

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

static void begin_neuro(void)
{
    seed = 20180401U;
    robot = robot_neuro;
    memset(&joints, 0, sizeof joints);
}

#endif

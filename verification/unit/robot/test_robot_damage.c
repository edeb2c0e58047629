/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a table of the robot that is not as it was compiled is found, and in which part.
 */
#include "base/seal.h"
#include "robot/robot_damage.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "unity.h"

#include <stdbool.h>
#include <stddef.h>

static robot_t robot;

void setUp(void)
{
    robot = robot_neuro;
}

void tearDown(void)
{
}

void test_SWR_MEMORY_004_the_table_of_this_build_fits_its_seals(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, robot_damage(&robot_neuro));
}

void test_SWR_MEMORY_004_the_structures_have_no_field_outside_the_seals_and_no_padding(void)
{
    TEST_ASSERT_LESS_OR_EQUAL_size_t(offsetof(robot_t, seal) + 8U, offsetof(robot_t, axes));
    TEST_ASSERT_EQUAL_size_t(offsetof(robot_t, start_ticks),
                             offsetof(robot_t, axes) + sizeof robot.axes + sizeof robot.poses +
                                 sizeof robot.force);
    TEST_ASSERT_EQUAL_size_t(offsetof(force_config_t, seal) + 4U, sizeof(force_config_t));
    TEST_ASSERT_EQUAL_size_t(offsetof(pose_t, seal) + 4U, sizeof(pose_t));
    TEST_ASSERT_LESS_OR_EQUAL_size_t(offsetof(axis_config_t, seal) + 8U, sizeof(axis_config_t));
}

void test_SWR_MEMORY_004_every_byte_belongs_to_a_part_whose_damage_is_named(void)
{
    for (size_t i = 0U; i < sizeof robot; i++) {
        /* Padding of the compiler after a seal is no part of the table. */
        const bool is_head = i < (offsetof(robot_t, seal) + 4U);
        uint32_t expected = is_head ? ((uint32_t)1U << ROBOT_PART_GEOMETRY) : 0U;
        if ((i >= offsetof(robot_t, axes)) && (i < offsetof(robot_t, poses))) {
            const size_t row = (i - offsetof(robot_t, axes)) / sizeof(axis_config_t);
            const size_t place = (i - offsetof(robot_t, axes)) % sizeof(axis_config_t);
            const bool is_used = place < (offsetof(axis_config_t, seal) + 4U);
            expected = (is_used && (row < robot.axis_count)) ? ((uint32_t)1U << row) : 0U;
        }
        ((uint8_t *)&robot)[i] ^= (uint8_t)(1U << (i % 8U));
        TEST_ASSERT_EQUAL_HEX32(expected, robot_damage(&robot));
        ((uint8_t *)&robot)[i] = ((const uint8_t *)&robot_neuro)[i];
    }
}

void test_SWR_MEMORY_004_a_pose_belongs_to_the_geometry_if_there_is_one(void)
{
    pose_t *const pose = &robot.poses[POSE_HOME];
    robot.pose_mask = (uint32_t)1U << POSE_HOME;
    robot.seal = seal_of(SEAL_START, (const uint8_t *)&robot, offsetof(robot_t, seal));
    pose->seal = seal_of(SEAL_START, (const uint8_t *)pose, offsetof(pose_t, seal));
    TEST_ASSERT_EQUAL_HEX32(0U, robot_damage(&robot));
    pose->ticks[NEURO_AXIS_YAW] ^= 4;
    TEST_ASSERT_EQUAL_HEX32((uint32_t)1U << ROBOT_PART_GEOMETRY, robot_damage(&robot));
}

void test_SWR_FORCE_576_every_byte_of_the_force_sensor_is_under_its_seal(void)
{
    uint8_t *const bytes = (uint8_t *)&robot.force;
    robot = robot_prostate;
    TEST_ASSERT_FALSE(robot_is_force_damaged(&robot));
    for (size_t i = 0U; i < sizeof robot.force; i++) {
        bytes[i] ^= (uint8_t)(1U << (i % 8U));
        TEST_ASSERT_TRUE(robot_is_force_damaged(&robot));
        TEST_ASSERT_EQUAL_HEX32(0U, robot_damage(&robot));
        bytes[i] = ((const uint8_t *)&robot_prostate.force)[i];
    }
}

void test_SWR_FORCE_576_a_sensor_that_a_robot_has_not_is_damage(void)
{
    TEST_ASSERT_FALSE(robot_is_force_damaged(&robot));
    robot.force.is_there = 1U;
    TEST_ASSERT_TRUE(robot_is_force_damaged(&robot));
}

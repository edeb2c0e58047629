/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a robot has a direction of its needle for a bare point, or has none. */
#include "unity.h"

#include "robot/bare_direction.h"

#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_IGTL_111_each_part_of_a_direction_counts(void)
{
    robot_t robot = robot_neuro;
    TEST_ASSERT_FALSE(bare_direction_is_there(&robot));
    for (uint32_t i = 0U; i < 3U; i++) {
        robot.bare_direction[i] = -1;
        TEST_ASSERT_TRUE(bare_direction_is_there(&robot));
        robot.bare_direction[i] = 0;
    }
}

void test_SWR_IGTL_111_the_needle_of_the_prostate_robot_comes_along_the_bore(void)
{
    const point_t target = {1000, -2000, INT32_MIN + 1};
    const point_t before = bare_direction_before(&robot_prostate, &target);
    TEST_ASSERT_TRUE(bare_direction_is_there(&robot_prostate));
    TEST_ASSERT_EQUAL_INT32(1000, before.x_nm);
    TEST_ASSERT_EQUAL_INT32(-2000, before.y_nm);
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, before.z_nm); /* It saturates. */
}

/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: what a robot names in each slot of the box. */
#include "unity.h"

#include "robot/robot_cards.h"
#include "robot/robot_neuro.h"

#define NOBODYS_SLOT 9U

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_ROBOT_013_each_axis_has_its_card_where_the_table_says(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const axis = &robot_neuro.axes[i];
        TEST_ASSERT_EQUAL_UINT32(i, robot_cards_axis(&robot_neuro, axis->slot));
        TEST_ASSERT_EQUAL_UINT32(axis->card_type, robot_cards_type(&robot_neuro, axis->slot));
    }
}

void test_SWR_ROBOT_013_a_slot_that_is_not_named_has_no_card(void)
{
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_MAX, robot_cards_axis(&robot_neuro, NOBODYS_SLOT));
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_NONE, robot_cards_type(&robot_neuro, NOBODYS_SLOT));
}

void test_SWR_ROBOT_013_a_table_with_too_many_axes_is_not_read_beyond_its_end(void)
{
    robot_t robot = robot_neuro;
    robot.axis_count = UINT32_MAX;
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_MAX, robot_cards_axis(&robot, NOBODYS_SLOT));
}

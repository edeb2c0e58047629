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

void test_SWR_LINK_009_a_card_without_an_axis_is_a_sensor(void)
{
    robot_t robot = robot_neuro;
    robot_cards_t cards;
    robot.sensor_slots = (uint32_t)1U << NOBODYS_SLOT;
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_MAX, robot_cards_axis(&robot, NOBODYS_SLOT));
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_SENSOR, robot_cards_type(&robot, NOBODYS_SLOT));
    robot_cards_find(&cards, &robot, robot.axis_count);
    TEST_ASSERT_EQUAL_HEX32(0x200U, cards.sensor_slots);
    TEST_ASSERT_EQUAL_HEX32(0x2FEU, cards.named_slots);
}

void test_SWR_MEMORY_006_wild_slots_are_made_slots_of_the_box(void)
{
    robot_cards_t cards;
    robot_cards_find(&cards, &robot_neuro, robot_neuro.axis_count);
    cards.slots[0] = CARD_SLOT_COUNT;
    cards.sensor_slots = UINT32_MAX;
    cards.named_slots = UINT32_MAX;
    robot_cards_bound(&cards);
    TEST_ASSERT_EQUAL_UINT32(0U, cards.slots[0]);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axes[1].slot, cards.slots[1]);
    TEST_ASSERT_EQUAL_HEX32(0x3FFU, cards.sensor_slots);
    TEST_ASSERT_EQUAL_HEX32(0x3FFU, cards.named_slots);
}

void test_SWR_ROBOT_013_a_table_with_too_many_axes_is_not_read_beyond_its_end(void)
{
    robot_t robot = robot_neuro;
    robot.axis_count = UINT32_MAX;
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_MAX, robot_cards_axis(&robot, NOBODYS_SLOT));
}

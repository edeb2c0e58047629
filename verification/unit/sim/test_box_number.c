/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: an order whose number is out of range is refused with the range. */
#include "unity.h"

#include "robot/robot_neuro.h"
#include "sim/box.h"

#include <string.h>

static box_t box;
static char reply[BOX_REPLY_SIZE];

void setUp(void)
{
    box_init(&box, &robot_neuro, 1U);
}

void tearDown(void)
{
}

static void expect_refused(const char *line, const char *reason)
{
    TEST_ASSERT_FALSE_MESSAGE(box_command(&box, line, reply, sizeof reply), line);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reply, reason), reply);
}

void test_SWR_BOX_320_a_number_out_of_range_is_refused_with_the_range(void)
{
    static const char *const wrong[][2] = {
        {"force hand 4096", "takes a number from 0 to 4095; the orders are"},
        {"force needle -1", "takes a number from 0 to 4095; the orders are"},
        {"force hand hard", "takes a number from 0 to 4095; the orders are"},
        {"push 201", "takes a number from -200 to 200 mm; the orders are"},
        {"push -201", "takes a number from -200 to 200 mm; the orders are"},
        {"keep 0", "takes a number from 1 to 4294967295; the orders are"},
        {"pedal hold 4294967296", "takes a number from 1 to 4294967295; the orders are"},
        {"button drop 0", "takes a number from 1 to 4294967295; the orders are"},
    };

    for (uint32_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        expect_refused(wrong[i][0], wrong[i][1]);
    }
}

void test_SWR_BOX_320_another_mistake_is_not_ascribed_to_the_number(void)
{
    expect_refused("force foot 1", "is unknown; the orders are");
    expect_refused("push 10 now", "is unknown; the orders are");
    expect_refused("pedal keep 7", "is unknown; the orders are");
    expect_refused("keep", "is unknown; the orders are");
    expect_refused("push 10 now or never", "is unknown; the orders are");
}

void test_SWR_BOX_320_both_ends_of_each_range_are_taken(void)
{
    static const char *const right[] = {
        "force hand 0", "force needle 4095", "push -200", "push 200", "keep 1", "keep 4294967295"};

    for (uint32_t i = 0U; i < (sizeof right / sizeof right[0]); i++) {
        TEST_ASSERT_TRUE_MESSAGE(box_command(&box, right[i], reply, sizeof reply), reply);
    }
}

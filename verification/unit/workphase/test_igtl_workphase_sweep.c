/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a client commands a sweep by the word, an axis and that it is free; it is
 * informed that it is armed, and how it has ended.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_dialect.h"
#include "robot/robot_neuro.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <string.h>

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
    (void)memcpy(robot.axes, robot_neuro.axes, sizeof robot.axes);
}

void tearDown(void)
{
}

void test_SWR_SWEEP_013_an_axis_and_that_it_is_free_become_a_command(void)
{
    say(0U, "Text", "SWEEP rotation FREE");
    expect_command(COMMAND_SWEEP, NEURO_AXIS_ROTATION);
    TEST_ASSERT_EQUAL_UINT32(1U, command.as.sweep.is_free);
    say(0U, "Text", "SWEEP rotation");
    expect_command(COMMAND_SWEEP, NEURO_AXIS_ROTATION);
    TEST_ASSERT_EQUAL_UINT32(0U, command.as.sweep.is_free);
    expect_no_command();
}

void test_SWR_SWEEP_013_it_is_reported_that_it_is_armed_and_how_it_has_ended(void)
{
    say(0U, "CMD_5", "SWEEP rotation FREE");
    EXPECT(0U, "STRING ACK_5 SWEEP rotation FREE");
    expect_command(COMMAND_SWEEP, NEURO_AXIS_ROTATION);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_SWEEP 1 ");
    TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT_BEGIN(0U, "STATUS SWEEP 1 ");
    say(0U, "Text", "SWEEP rotation");
    expect_command(COMMAND_SWEEP, NEURO_AXIS_ROTATION);
    answer_to(&command, ANSWER_REFUSED, STATUS_NOT_FREE, 1U);
    EXPECT_BEGIN(0U, "STATUS SWEEP ");
}

void test_SWR_SWEEP_013_what_is_no_sweep_or_another_ones_is_refused(void)
{
    static const char *const texts[] = {"SWEEP", "SWEEP ", "SWEEP nose FREE", "SWEEP rotation free",
                                        "SWEEP rotation FREE FREE"};
    for (uint32_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        say(0U, "Text", texts[i]);
        expect_no_command();
        EXPECT_BEGIN(0U, "STATUS SWEEP ");
    }
}

void test_SWR_SWEEP_013_only_who_commands_commands_a_sweep(void)
{
    enter(0U, "CMD_1", "MANUAL");
    pass_us(0U);
    say(1U, "Text", "SWEEP rotation FREE");
    EXPECT_BEGIN(1U, "STATUS SWEEP 5 NO_AUTHORITY|");
    expect_no_command();
}

void test_SWR_SWEEP_013_another_word_is_another_word(void)
{
    say(0U, "CMD_1", "SWEEPS rotation FREE");
    EXPECT(0U, "STRING ACK_1 SWEEPS rotation FREE");
    EXPECT_BEGIN(0U, "STATUS SWEEPS");
    expect_no_command();
}

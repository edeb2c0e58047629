/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a client jogs an axis by one word, to a position or by a way; it is informed
 * that it is armed, and how it has ended.
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

void test_SWR_FLOW_005_an_axis_and_its_position_become_a_jog(void)
{
    say(0U, "Text", "JOG yaw -20 deg");
    expect_command(COMMAND_JOG, NEURO_AXIS_YAW);
    TEST_ASSERT_EQUAL_INT32(-278, command.as.jog.to_ticks);
    say(0U, "JOG", " head   -2.5  mm ");
    expect_command(COMMAND_JOG, NEURO_AXIS_HEAD);
    TEST_ASSERT_EQUAL_INT32(-197, command.as.jog.to_ticks);
    say(0U, "Text", "JOG_BY insertion 1 mm");
    expect_command(COMMAND_JOG_BY, NEURO_AXIS_INSERTION);
    TEST_ASSERT_EQUAL_INT32(3333, command.as.jog_by.by_ticks);
    expect_no_command();
}

void test_SWR_FLOW_005_it_is_reported_that_it_is_armed_and_how_it_has_ended(void)
{
    say(0U, "CMD_5", "JOG yaw -20 deg");
    EXPECT(0U, "STRING ACK_5 JOG yaw -20 deg");
    expect_command(COMMAND_JOG, NEURO_AXIS_YAW);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_JOG 1 ");
    TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT_BEGIN(0U, "STATUS JOG 1 ");
    say(0U, "Text", "JOG_BY yaw 1 deg");
    expect_command(COMMAND_JOG_BY, NEURO_AXIS_YAW);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_JOG_BY 1 ");
    TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
    answer_to(&command, ANSWER_ABORTED, STATUS_FAULT_PRESENT, 1U);
    EXPECT_BEGIN(0U, "STATUS JOG_BY 18 ");
    TEST_ASSERT_FALSE(workphase_dialect_has_order(&dialect, 0U));
    say(0U, "Text", "JOG_BY yaw 90 deg");
    expect_command(COMMAND_JOG_BY, NEURO_AXIS_YAW);
    answer_to(&command, ANSWER_REFUSED, STATUS_AXIS_LIMIT, 1U);
    EXPECT_BEGIN(0U, "STATUS JOG_BY 10 ");
    EXPECT(0U, "");
}

void test_SWR_FLOW_005_a_text_that_is_no_jog_is_refused_by_name(void)
{
    expect_refusal("JOG", "UNKNOWN_COMMAND");
    expect_refusal("JOG nose 5", "UNKNOWN_COMMAND");
    expect_refusal("JOG 20 yaw", "UNKNOWN_COMMAND");
    expect_refusal("JOG yaw 5 deg 2", "UNKNOWN_COMMAND");
    expect_refusal("JOG yaw", "OUT_OF_RANGE");
    expect_refusal("JOG yaw nan deg", "OUT_OF_RANGE");
    expect_refusal("JOG yaw 0x5 deg", "OUT_OF_RANGE");
    expect_refusal("JOG yaw 1e999 deg", "OUT_OF_RANGE");
    expect_refusal("JOG yaw 99999999999 deg", "OUT_OF_RANGE");
}

void test_SWR_FLOW_005_only_who_commands_jogs(void)
{
    enter(0U, "CMD_1", "MANUAL");
    pass_us(0U);
    say(1U, "Text", "JOG yaw 5 deg");
    EXPECT_BEGIN(1U, "STATUS JOG 5 NO_AUTHORITY|");
    expect_no_command();
}

void test_SWR_IGTL_074_a_jog_needs_the_unit_of_its_axis(void)
{
    static const char *const texts[] = {"JOG yaw 5", "JOG yaw 5 mm", "JOG head 5 deg",
                                        "JOG yaw 5 degrees"};

    for (size_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        say(0U, "Text", texts[i]);
        EXPECT(0U, "STATUS JOG 10 WRONG_UNIT|WRONG_UNIT: Send each number with its unit: "
                   "JOG AXIS 5 mm, or JOG AXIS 5 deg.");
    }
}

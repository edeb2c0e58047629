/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a client commands speeds by one word, with axes, speeds and seconds; it is
 * informed that they are armed, and how they have ended.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_dialect.h"
#include "robot/robot_neuro.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <string.h>

#define YAW (1UL << NEURO_AXIS_YAW)

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
    (void)memcpy(robot.axes, robot_neuro.axes, sizeof robot.axes);
}

void tearDown(void)
{
}

void test_SWR_VEL_014_axes_speeds_and_seconds_become_a_command(void)
{
    say(0U, "Text", "VELOCITY yaw -59.9745 deg/s head 2.5 mm/s 1.25 s");
    expect_command(COMMAND_VELOCITY, YAW | (1UL << NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL_INT32(-833, command.as.velocity.speeds_ticks_per_s[NEURO_AXIS_YAW]);
    TEST_ASSERT_EQUAL_INT32(197, command.as.velocity.speeds_ticks_per_s[NEURO_AXIS_HEAD]);
    TEST_ASSERT_EQUAL_INT32(0, command.as.velocity.speeds_ticks_per_s[NEURO_AXIS_FEET]);
    TEST_ASSERT_EQUAL_UINT32(1250U, command.as.velocity.time_ms);
    expect_no_command();
}

void test_SWR_VEL_014_the_word_may_be_the_name_of_the_string(void)
{
    say(0U, "VELOCITY", "  yaw  -1.2e1  deg/s 2  s ");
    expect_command(COMMAND_VELOCITY, YAW);
    TEST_ASSERT_EQUAL_INT32(-167, command.as.velocity.speeds_ticks_per_s[NEURO_AXIS_YAW]);
    TEST_ASSERT_EQUAL_UINT32(2000U, command.as.velocity.time_ms);
}

void test_SWR_VEL_014_it_is_reported_that_they_are_armed_and_how_they_have_ended(void)
{
    say(0U, "CMD_5", "VELOCITY yaw 5 deg/s 2 s");
    EXPECT(0U, "STRING ACK_5 VELOCITY yaw 5 deg/s 2 s");
    expect_command(COMMAND_VELOCITY, YAW);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_VELOCITY 1 ");
    TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT_BEGIN(0U, "STATUS VELOCITY 1 ");
    TEST_ASSERT_FALSE(workphase_dialect_has_order(&dialect, 0U));
    say(0U, "Text", "VELOCITY yaw 5 deg/s 2 s");
    expect_command(COMMAND_VELOCITY, YAW);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_VELOCITY 1 ");
    answer_to(&command, ANSWER_ABORTED, STATUS_AXIS_LIMIT, 1U);
    EXPECT_BEGIN(0U, "STATUS VELOCITY 10 ");
    say(0U, "Text", "VELOCITY yaw 500 deg/s 2 s");
    expect_command(COMMAND_VELOCITY, YAW);
    answer_to(&command, ANSWER_REFUSED, STATUS_TOO_FAST, 1U);
    EXPECT_BEGIN(0U, "STATUS VELOCITY 10 ");
    EXPECT(0U, "");
}

void test_SWR_VEL_014_a_text_that_is_no_speed_is_refused_by_name(void)
{
    char text[400];
    (void)memset(text, ' ', sizeof text);
    (void)memcpy(text, "VELOCITY", 8U);
    text[sizeof text - 1U] = '\0';
    expect_refusal("VELOCITY", "UNKNOWN_COMMAND");
    expect_refusal("VELOCITY nose 5 2", "UNKNOWN_COMMAND");
    expect_refusal("VELOCITY yaw nan deg/s 2 s", "OUT_OF_RANGE");
    expect_refusal("VELOCITY yaw 0x5 deg/s 2 s", "OUT_OF_RANGE");
    expect_refusal("VELOCITY yaw 5 deg/s yaw 5 deg/s 2 s", "OUT_OF_RANGE");
    expect_refusal("VELOCITY yaw 99999999999 deg/s 2 s", "OUT_OF_RANGE");
    expect_refusal("VELOCITY yaw 5 deg/s -2 s", "OUT_OF_RANGE");
    expect_refusal("VELOCITY yaw 5 deg/s 0 s", "OUT_OF_RANGE");
    expect_refusal("VELOCITY yaw 5 deg/s 2s", "OUT_OF_RANGE");
    expect_refusal("VELOCITY yaw 5 deg/s", "UNKNOWN_COMMAND");
    expect_refusal("VELOCITY yaw 5 deg/s . s", "OUT_OF_RANGE");
    expect_refusal("VELOCITY yaw 5 deg/s 1e999 s", "OUT_OF_RANGE");
    expect_refusal(text, "OUT_OF_RANGE");
}

void test_SWR_VEL_014_another_word_is_another_word(void)
{
    say(0U, "CMD_1", "VELOCITYX yaw 5 2");
    EXPECT(0U, "STRING ACK_1 VELOCITYX yaw 5 2");
    EXPECT_BEGIN(0U, "STATUS VELOCITYX yaw 5 2 12 ");
    expect_no_command();
}

void test_SWR_VEL_014_only_who_commands_commands_speeds(void)
{
    enter(0U, "CMD_1", "MANUAL");
    pass_us(0U);
    say(1U, "Text", "VELOCITY yaw 5 deg/s 2 s");
    EXPECT_BEGIN(1U, "STATUS VELOCITY 5 NO_AUTHORITY|");
    expect_no_command();
}

void test_SWR_IGTL_074_speeds_and_time_need_their_units(void)
{
    static const char *const texts[] = {"VELOCITY yaw 5 2",          "VELOCITY yaw 5",
                                        "VELOCITY yaw 5 mm/s 2 s",   "VELOCITY yaw 5 deg 2 s",
                                        "VELOCITY yaw 5 deg/s 2",    "VELOCITY head 5 deg/s 2 s",
                                        "VELOCITY yaw 5 deg/s 2 ms", "VELOCITY yaw 5 deg/s 2 s 1"};

    for (size_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        say(0U, "Text", texts[i]);
        EXPECT(0U, "STATUS VELOCITY 10 WRONG_UNIT|WRONG_UNIT: Send each number with its unit: "
                   "VELOCITY AXIS 5 mm/s AXIS 5 deg/s 1.5 s.");
    }
}

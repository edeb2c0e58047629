/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: needle tips of images, retractions and entry points go to the controller, and
 * their results back under the names by which they came.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_dialect.h"
#include "limits/requirement_limits.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2021);
    snapshot.workphase = (uint32_t)WORKPHASE_MOVE_TO_TARGET;
}

void tearDown(void)
{
}

void test_SWR_IGTL_034_a_tip_is_echoed_passed_on_and_answered(void)
{
    place(0U, "NPOS_112233445566", 1.0F);
    EXPECT(0U, "TRANSFORM ACK_112233445566 1.000 2.000 3.000");
    pass_us(0U);
    expect_command(COMMAND_NEEDLE, 0U);
    TEST_ASSERT_EQUAL_INT32(1000000, command.as.seen_pose.pose.translation.x_nm);
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_034_in_2013_a_tip_is_never_taken_for_an_arrival(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
    snapshot.workphase = (uint32_t)WORKPHASE_MOVE_TO_TARGET;
    place(0U, "NPOS_1", 1.0F);
    EXPECT(0U, "TRANSFORM ACK_1 1.000 2.000 3.000");
    pass_us(0U);
    expect_command(COMMAND_NEEDLE, 0U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS NPOS 1 MOVE_TO_TARGET|");
    place(0U, "NPOS_2", NAN);
    EXPECT_BEGIN(0U, "TRANSFORM ACK_2 ");
    EXPECT_BEGIN(0U, "STATUS NPOS 10 NOT_FINITE|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_034_a_refused_tip_says_why(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_TARGETING;
    place(0U, "NPOS_1", 1.0F);
    pass_us(0U);
    expect_command(COMMAND_NEEDLE, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    EXPECT(0U, "TRANSFORM ACK_1 1.000 2.000 3.000");
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 13 TARGETING|WRONG_WORKPHASE: ");
    place(0U, "NPOS_2", NAN);
    EXPECT_BEGIN(0U, "TRANSFORM ACK_2 ");
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 10 NOT_FINITE|");
    pass_us(1000000U);
    expect_no_command();
}

void test_SWR_IGTL_034_of_many_tips_the_newest_is_passed_on_in_its_time(void)
{
    place(0U, "NPOS_1", 1.0F);
    pass_us(0U);
    expect_command(COMMAND_NEEDLE, 0U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    for (uint32_t i = 0U; i < 10U; i++) {
        place(0U, "NPOS_2", (float)i);
        pass_us(0U);
    }
    expect_no_command();
    pass_us(LIMIT_IGTL_TIP_INTERVAL_US - 1U);
    expect_no_command();
    pass_us(1U);
    expect_command(COMMAND_NEEDLE, 1U); /* The first was for the log. */
    TEST_ASSERT_EQUAL_INT32(9000000, command.as.seen_pose.pose.translation.x_nm);
    pass_us(1000000U);
    expect_no_command();
    EXPECT_BEGIN(0U, "TRANSFORM ACK_1 ");
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 1 ");
    for (uint32_t i = 0U; i < 10U; i++) {
        EXPECT_BEGIN(0U, "TRANSFORM ACK_2 ");
    }
}

void test_SWR_IGTL_034_a_tip_waits_while_too_much_is_on_its_way(void)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS_PER_PEER; i++) {
        place(0U, "TGT_1", 1.0F);
        expect_command(COMMAND_TARGET, 0U);
    }
    place(0U, "NPOS_1", 1.0F);
    pass_us(0U);
    expect_no_command();
    answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    pass_us(0U);
    expect_command(COMMAND_NEEDLE, 0U);
}

void test_SWR_IGTL_050_tips_of_many_leave_room_for_commands(void)
{
    command_t tips[LIMIT_IGTL_TIPS_AT_A_TIME];

    for (uint32_t peer = 0U; peer < IGTL_PEERS; peer++) {
        place(peer, "NPOS_1", (float)peer);
    }
    pass_us(0U);
    for (uint32_t i = 0U; i < LIMIT_IGTL_TIPS_AT_A_TIME; i++) {
        expect_command(COMMAND_NEEDLE, 0U);
        tips[i] = command;
    }
    expect_no_command();
    for (uint32_t i = 0U; i < LIMIT_IGTL_TIPS_AT_A_TIME; i++) {
        answer_to(&tips[i], ANSWER_ACCEPTED, STATUS_OK, 1U);
    }
    pass_us(0U); /* It is the turn of the others. */
    expect_command(COMMAND_NEEDLE, 0U);
    TEST_ASSERT_EQUAL_UINT32(NUMBER + LIMIT_IGTL_TIPS_AT_A_TIME, command.peer);
}

void test_SWR_IGTL_050_of_the_tips_of_a_second_one_is_for_the_log(void)
{
    place(0U, "NPOS_1", 1.0F);
    pass_us(0U);
    expect_command(COMMAND_NEEDLE, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    for (uint32_t i = 1U; i < (LIMIT_IGTL_TIP_NOTE_US / LIMIT_IGTL_TIP_INTERVAL_US); i++) {
        place(0U, "NPOS_2", 1.0F);
        pass_us(LIMIT_IGTL_TIP_INTERVAL_US);
        expect_command(COMMAND_NEEDLE, 1U);
        answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    }
    place(0U, "NPOS_3", 1.0F);
    pass_us(LIMIT_IGTL_TIP_INTERVAL_US);
    expect_command(COMMAND_NEEDLE, 0U);
}

void test_SWR_IGTL_034_a_tip_overtaken_by_a_command_is_not_spoken_of(void)
{
    command_t tip;

    place(0U, "NPOS_1", 1.0F);
    pass_us(0U);
    expect_command(COMMAND_NEEDLE, 0U);
    tip = command;
    place(0U, "NPOS_2", 2.0F);
    say(0U, "CMD_S", "STOP");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    answer_to(&tip, ANSWER_REFUSED, STATUS_DISCARDED, 1U);
    accept(1U);
    pass_us(LIMIT_IGTL_TIP_INTERVAL_US);
    expect_no_command();
    EXPECT_BEGIN(0U, "TRANSFORM ACK_1 ");
    EXPECT_BEGIN(0U, "TRANSFORM ACK_2 ");
    EXPECT(0U, "STRING ACK_S STOP");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 STOP|");
    EXPECT(0U, "STATUS STOP 1 STOP|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_034_a_tip_takes_nothing_and_is_denied_to_others(void)
{
    place(1U, "NPOS_1", 1.0F);
    TEST_ASSERT_FALSE(workphase_dialect_is_controlled_by(&dialect, 1U));
    enter(0U, "CMD_1", "PLANNING");
    place(2U, "NPOS_1", 1.0F);
    EXPECT_BEGIN(2U, "TRANSFORM ACK_1 ");
    EXPECT_BEGIN(2U, "STATUS MOVE_TO_TARGET 5 NO_AUTHORITY|");
}

void test_SWR_IGTL_034_a_tip_that_waits_is_denied_once_another_commands(void)
{
    place(1U, "NPOS_1", 1.0F);
    EXPECT_BEGIN(1U, "TRANSFORM ACK_1 ");
    enter(0U, "CMD_1", "PLANNING");
    pass_us(0U);
    EXPECT_BEGIN(1U, "STATUS MOVE_TO_TARGET 5 NO_AUTHORITY|");
    EXPECT(1U, "");
    expect_no_command();
    pass_us(LIMIT_IGTL_TIP_INTERVAL_US);
    EXPECT(1U, "");
}

void test_SWR_IGTL_035_a_retraction_is_acknowledged_when_accepted_and_reported_when_out(void)
{
    static const char *const words[] = {"RETRACT_NEEDLE", "RETRACT_PROBE"};

    for (uint32_t i = 0U; i < 2U; i++) {
        char line[64];

        say(0U, words[i], "");
        EXPECT(0U, "");
        expect_command(COMMAND_RETRACT, 0U);
        answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
        (void)snprintf(line, sizeof line, "STATUS ACK_%s 1 MOVE_TO_TARGET|", words[i]);
        EXPECT(0U, line);
        TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
        answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
        (void)snprintf(line, sizeof line, "STATUS %s 1 MOVE_TO_TARGET|", words[i]);
        EXPECT(0U, line);
        EXPECT(0U, "");
        TEST_ASSERT_FALSE(workphase_dialect_has_order(&dialect, 0U));
    }
}

void test_SWR_IGTL_035_a_needle_that_is_out_already_is_retracted_at_once(void)
{
    say(0U, "Text", "RETRACT_NEEDLE");
    expect_command(COMMAND_RETRACT, 0U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS ACK_RETRACT_NEEDLE 1 MOVE_TO_TARGET|");
    EXPECT(0U, "STATUS RETRACT_NEEDLE 1 MOVE_TO_TARGET|");
}

void test_SWR_IGTL_035_a_retraction_that_fails_says_why(void)
{
    say(0U, "CMD_7", "RETRACT_NEEDLE");
    EXPECT(0U, "STRING ACK_7 RETRACT_NEEDLE");
    expect_command(COMMAND_RETRACT, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    EXPECT_BEGIN(0U, "STATUS RETRACT_NEEDLE 13 MOVE_TO_TARGET|WRONG_WORKPHASE: ");
    say(0U, "RETRACT_NEEDLE", "");
    expect_command(COMMAND_RETRACT, 0U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_RETRACT_NEEDLE 1 ");
    answer_to(&command, ANSWER_ABORTED, STATUS_EXPIRED, 1U);
    EXPECT_BEGIN(0U, "STATUS RETRACT_NEEDLE 7 MOVE_TO_TARGET|EXPIRED: ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_035_the_commander_of_a_retraction_ends_it_by_leaving(void)
{
    say(0U, "RETRACT_NEEDLE", "");
    expect_command(COMMAND_RETRACT, 0U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    workphase_dialect_disconnected(&dialect, 0U);
    pass_us(0U);
    expect_released(0U);
}

void test_SWR_IGTL_030_a_retraction_silences_the_move_that_it_ends(void)
{
    command_t move;

    say(0U, "CMD_M", "MOVE_TO_TARGET");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    accept(0U);
    move = command;
    say(0U, "RETRACT_NEEDLE", "");
    expect_command(COMMAND_RETRACT, 0U);
    answer_to(&move, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT(0U, "STRING ACK_M MOVE_TO_TARGET");
    EXPECT_BEGIN(0U, "STATUS CURRENT_STATUS 1 ");
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 1 ");
    EXPECT_BEGIN(0U, "TRANSFORM CURRENT_POSITION ");
    EXPECT_BEGIN(0U, "STATUS ACK_RETRACT_NEEDLE 1 ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_035_an_entry_point_is_echoed_passed_on_and_answered(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_TARGETING;
    place(0U, "ENTRY_77", 1.0F);
    EXPECT(0U, "TRANSFORM ACK_77 1.000 2.000 3.000");
    expect_command(COMMAND_ENTRY, 0U);
    TEST_ASSERT_EQUAL_INT32(3000000, command.as.seen_pose.pose.translation.z_nm);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS ENTRY 1 TARGETING|0.000, 0.000, 0.000 mm");
    place(0U, "ENTRY_78", 1.0F);
    EXPECT_BEGIN(0U, "TRANSFORM ACK_78 ");
    expect_command(COMMAND_ENTRY, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    EXPECT_BEGIN(0U, "STATUS ENTRY 13 TARGETING|WRONG_WORKPHASE: ");
}

void test_SWR_IGTL_035_a_target_refused_for_its_entry_point_says_so(void)
{
    place(0U, "TGT_1", 1.0F);
    expect_command(COMMAND_TARGET, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_ENTRY_POINT, 1U);
    EXPECT_BEGIN(0U, "TRANSFORM ACK_1 ");
    EXPECT_BEGIN(0U, "STATUS TARGET 10 MOVE_TO_TARGET|ENTRY_POINT: ");
}

void test_SWR_IGTL_035_entry_points_are_accepted_and_withdrawn(void)
{
    say(0U, "ACCEPT_ENTRY", "");
    expect_command(COMMAND_ACCEPT_ENTRY, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_NOT_PROPOSED, 1U);
    EXPECT_BEGIN(0U, "STATUS ACCEPT_ENTRY 13 MOVE_TO_TARGET|NOT_PROPOSED: ");
    say(0U, "Text", "ACCEPT_ENTRY");
    expect_command(COMMAND_ACCEPT_ENTRY, 0U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS ACCEPT_ENTRY 1 MOVE_TO_TARGET|0.000, 0.000, 0.000 mm");
    say(0U, "WITHDRAW_ENTRY", "");
    expect_command(COMMAND_WITHDRAW, (uint32_t)COMMAND_ENTRY);
    pass_us(IGTL_ANSWER_TIMEOUT_US);
    EXPECT_BEGIN(0U, "STATUS WITHDRAW_ENTRY 7 NO_ANSWER|");
}

void test_SWR_IGTL_035_every_subject_is_reported_when_control_does_not_answer(void)
{
    place(0U, "CLB_1", 1.0F);
    place(0U, "TGT_1", 1.0F);
    place(0U, "ENTRY_1", 1.0F);
    say(0U, "ACCEPT_ENTRY", "");
    for (uint32_t i = 0U; i < 3U; i++) {
        EXPECT_BEGIN(0U, "TRANSFORM ACK_1 ");
    }
    pass_us(IGTL_ANSWER_TIMEOUT_US);
    EXPECT_BEGIN(0U, "STATUS CALIBRATION 7 ");
    EXPECT_BEGIN(0U, "STATUS TARGET 7 ");
    EXPECT_BEGIN(0U, "STATUS ENTRY 7 ");
    EXPECT_BEGIN(0U, "STATUS ACCEPT_ENTRY 7 ");
    place(1U, "NPOS_1", 1.0F);
    say(0U, "RETRACT_NEEDLE", "");
    EXPECT_BEGIN(0U, "STATUS RETRACT_NEEDLE 6 BUSY|"); /* Four are on their way. */
    say(0U, "ACCEPT_ENTRY", "");
    EXPECT_BEGIN(0U, "STATUS ACCEPT_ENTRY 6 BUSY|");
}

void test_SWR_IGTL_035_silence_after_a_tip_or_a_retraction_is_reported(void)
{
    place(0U, "NPOS_1", 1.0F);
    EXPECT_BEGIN(0U, "TRANSFORM ACK_1 ");
    pass_us(0U);
    say(0U, "RETRACT_PROBE", "");
    pass_us(IGTL_ANSWER_TIMEOUT_US);
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 7 ");
    EXPECT_BEGIN(0U, "STATUS RETRACT_PROBE 7 ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_035_only_the_commander_does(void)
{
    enter(0U, "CMD_1", "PLANNING");
    say(1U, "RETRACT_NEEDLE", "");
    EXPECT_BEGIN(1U, "STATUS RETRACT_NEEDLE 5 NO_AUTHORITY|");
    say(1U, "ACCEPT_ENTRY", "");
    EXPECT_BEGIN(1U, "STATUS ACCEPT_ENTRY 5 NO_AUTHORITY|");
    say(1U, "PROBE", "10 5 5 41");
    EXPECT_BEGIN(1U, "STATUS PROBE 5 NO_AUTHORITY|");
    place(1U, "ENTRY_1", 1.0F);
    EXPECT_BEGIN(1U, "TRANSFORM ACK_1 ");
    EXPECT_BEGIN(1U, "STATUS ENTRY 5 NO_AUTHORITY|");
    expect_no_command();
}

void test_SWR_IGTL_035_the_prefix_of_an_entry_point_is_that_of_the_port(void)
{
    const igtl_introduction_t other = {1U, language, "EP", &outboxes[0]};
    const igtl_introduction_t none = {2U, language, "", &outboxes[1]};

    workphase_dialect_connected(&dialect, 0U, &other);
    workphase_dialect_connected(&dialect, 1U, &none);
    place(0U, "EP12345678901234567", 1.0F);
    EXPECT(0U, "TRANSFORM ACK_1234567890123456 1.000 2.000 3.000");
    expect_command(COMMAND_ENTRY, 0U);
    place(0U, "ENTRY_1", 1.0F);
    EXPECT_BEGIN(0U, "STATUS ENTRY_1 12 ");
    place(1U, "ENTRY_1", 1.0F);
    EXPECT_BEGIN(1U, "STATUS ENTRY_1 12 ");
    expect_no_command();
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: needle tips of images, retractions and entry points go to the controller and
 * their results back under the names by which they came; lengths of needles are only compared.
 */
#include "base/crc.h"
#include "base/fixed.h"
#include "base/rigid.h"
#include "charts/arming_chart.h"
#include "common/axis_terms.h"
#include "common/list_terms.h"
#include "igtl/dialect/igtl_units.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_questions.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_answer.h"
#include "igtl/lists/workphase_array.h"
#include "igtl/workphase/workphase_dialect.h"
#include "igtl/workphase/workphase_draping.h"
#include "igtl/lists/workphase_lists.h"
#include "igtl/workphase/workphase_needle.h"
#include "igtl/workphase/workphase_peer.h"
#include "igtl/workphase/workphase_queries.h"
#include "igtl/lists/workphase_program.h"
#include "igtl/workphase/workphase_receive.h"
#include "igtl/lists/workphase_text.h"
#include "igtl/lists/workphase_trajectory.h"
#include "igtl/workphase/workphase_notifications.h"
#include "igtl/workphase/workphase_commands.h"
#include "interface/app/names.h"
#include "interface/mode_list.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_crc64.h"
#include "igtl/wire/igtl_packet.h"
#include "igtl/wire/igtl_outbox.h"
#include "mode/lists/program_step.h"
#include "mode/lists/trajectory_row.h"
#include "limits/requirement_limits.h"
#include "robot/robot_cards.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <math.h>
#include <string.h>

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

void test_SWR_IGTL_066_a_name_is_no_order_when_the_text_says_something_else(void)
{
    static const char *const names[] = {"ALIGN", "INSERT", "ACCEPT_ENTRY", "WITHDRAW_ENTRY"};

    for (uint32_t i = 0U; i < 4U; i++) {
        char line[64];

        say(0U, names[i], "NO");
        (void)snprintf(line, sizeof line, "STATUS %s 12 UNKNOWN_COMMAND|", names[i]);
        EXPECT_BEGIN(0U, line);
        expect_no_command();
    }
    say(0U, "INSERT", "INSERT");
    expect_command(COMMAND_INSERT, 0U);
    say(0U, "ALIGN", "");
    expect_command(COMMAND_ALIGN, 0U);
}

/* As a retraction is. */
void test_SWR_ALIGN_007_align_and_insert_are_words_that_are_acknowledged_and_reported_at_their_end(
    void)
{
    static const struct {
        const char *word;
        command_kind_t kind;
    } acts[] = {{"ALIGN", COMMAND_ALIGN}, {"INSERT", COMMAND_INSERT}};

    for (uint32_t i = 0U; i < 2U; i++) {
        char line[64];

        say(0U, "Text", acts[i].word);
        expect_command((uint32_t)acts[i].kind, 0U);
        answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
        (void)snprintf(line, sizeof line, "STATUS ACK_%s 1 MOVE_TO_TARGET|", acts[i].word);
        EXPECT(0U, line);
        TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
        answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
        (void)snprintf(line, sizeof line, "STATUS %s 1 MOVE_TO_TARGET|", acts[i].word);
        EXPECT(0U, line);
        EXPECT(0U, "");
        TEST_ASSERT_FALSE(workphase_dialect_has_order(&dialect, 0U));
        say(0U, acts[i].word, "");
        expect_command((uint32_t)acts[i].kind, 0U);
        answer_to(&command, ANSWER_REFUSED, STATUS_NO_ENTRY_POINT, 1U);
        (void)snprintf(line, sizeof line,
                       "STATUS %s 13 MOVE_TO_TARGET|NO_ENTRY_POINT: ", acts[i].word);
        EXPECT_BEGIN(0U, line);
    }
}

void test_SWR_POSE_006_a_pose_is_a_word_and_its_name(void)
{
    char text[32];

    for (uint32_t i = 0U; i < POSE_NAME_COUNT; i++) {
        (void)snprintf(text, sizeof text, "POSE %s", pose_name_name((int32_t)i));
        say(0U, "Text", text);
        expect_command(COMMAND_POSE, i);
        answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
        EXPECT_BEGIN(0U, "STATUS ACK_POSE 1 ");
        answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
        EXPECT_BEGIN(0U, "STATUS POSE 1 ");
        EXPECT(0U, "");
    }
    say(0U, "Text", "POSE TUCK");
    expect_no_command();
    EXPECT_BEGIN(0U, "STATUS POSE 12 ");
    say(0U, "POSE", "DRAPING ALL");
    expect_no_command();
    EXPECT_BEGIN(0U, "STATUS POSE 12 ");
    say(0U, "Text", "POSE DRAPING");
    expect_command(COMMAND_POSE, (uint32_t)POSE_DRAPING);
    answer_to(&command, ANSWER_REFUSED, STATUS_NEEDLE_IN, 1U);
    EXPECT_BEGIN(0U, "STATUS POSE 13 MOVE_TO_TARGET|NEEDLE_IN: ");
}

/* From START_UP, to where MANUAL has been entered and the pose is asked for. */
static void drape(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_START_UP;
    say(0U, "CMD_7", "DRAPING");
    EXPECT(0U, "STRING ACK_7 DRAPING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MANUAL);
    snapshot.workphase = (uint32_t)WORKPHASE_MANUAL;
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "");
    expect_command(COMMAND_POSE, (uint32_t)POSE_DRAPING);
}

void test_SWR_IGTL_090_draping_enters_manual_and_goes_to_its_pose(void)
{
    drape();
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT(0U, "STATUS DRAPING 1 MANUAL|");
    TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT(0U, "");
    say(0U, "CMD_8", "DRAPING");
    EXPECT(0U, "STRING ACK_8 DRAPING");
    expect_command(COMMAND_POSE, (uint32_t)POSE_DRAPING);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS DRAPING 1 MANUAL|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_090_draping_that_is_refused_or_ends_early_says_so(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_UNDEFINED;
    say(0U, "CMD_6", "DRAPING");
    EXPECT(0U, "STRING ACK_6 DRAPING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MANUAL);
    answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    EXPECT_BEGIN(0U, "STATUS DRAPING 13 UNDEFINED|WRONG_WORKPHASE: ");
    expect_no_command();
    drape();
    answer_to(&command, ANSWER_REFUSED, STATUS_NEEDLE_IN, 1U);
    EXPECT_BEGIN(0U, "STATUS DRAPING 13 MANUAL|NEEDLE_IN: ");
    say(0U, "Text", "DRAPING");
    expect_command(COMMAND_POSE, (uint32_t)POSE_DRAPING);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT(0U, "STATUS DRAPING 1 MANUAL|");
    answer_to(&command, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    EXPECT_BEGIN(0U, "STATUS DRAPING 13 MANUAL|DISCARDED: ");
}

void test_SWR_IGTL_090_draping_without_an_answer_or_a_place_is_reported_by_its_name(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_START_UP;
    say(0U, "Text", "DRAPING");
    pass_us(IGTL_ANSWER_TIMEOUT_US);
    EXPECT_BEGIN(0U, "STATUS DRAPING 7 NO_ANSWER|");
    for (uint32_t i = 0U; i < IGTL_REQUESTS_PER_PEER; i++) {
        say(0U, "Text", "DRAPING");
    }
    say(0U, "Text", "DRAPING");
    EXPECT_BEGIN(0U, "STATUS DRAPING 6 BUSY|");
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

/* The needle of the robot is 259.075 mm long. */
static void say_length(const char *text)
{
    robot.reported_lengths[1] = (reported_length_t){"needle_length", 1, 2U};
    snapshot.has_probe = 1U;
    snapshot.probe_nm[1] = 259075000;
    say(0U, "NEEDLE_LENGTH", text);
    EXPECT_BEGIN(0U, "STRING ACK_NEEDLE_LENGTH ");
}

void test_SWR_IGTL_036_the_length_of_the_robots_needle_is_confirmed(void)
{
    static const char *const right[] = {"259.075", "259.175", "258.975", "259.1"};

    for (uint32_t i = 0U; i < 4U; i++) {
        say_length(right[i]);
        EXPECT(0U, "STATUS NEEDLE_LENGTH 1 NEEDLE_LENGTH|The robot is set to a needle of 259.075 "
                   "mm.");
    }
}

void test_SWR_IGTL_036_another_length_is_refused_with_that_of_the_robot(void)
{
    static const char *const wrong[] = {"259.18", "258.97", "150",        "",         "nan",
                                        "inf",    "1e999",  "259.075 mm", "-259.075", "needle"};

    for (uint32_t i = 0U; i < 10U; i++) {
        say_length(wrong[i]);
        EXPECT(0U,
               "STATUS NEEDLE_LENGTH 10 CONFIG_ERROR|CONFIG_ERROR: The robot is set to a needle "
               "of 259.075 mm.");
    }
    TEST_ASSERT_EQUAL_INT32(259075000, snapshot.probe_nm[1]);
    TEST_ASSERT_FALSE(workphase_dialect_is_controlled_by(&dialect, 0U));
    expect_no_command();
}

void test_SWR_IGTL_036_a_needle_that_is_not_known_is_compared_with_none(void)
{
    robot.reported_lengths[1] = (reported_length_t){"needle_length", 259075000, 2U};
    snapshot.has_probe = 0U;
    say(0U, "NEEDLE_LENGTH", "259.075");
    EXPECT_BEGIN(0U, "STRING ACK_NEEDLE_LENGTH ");
    EXPECT_BEGIN(0U, "STATUS NEEDLE_LENGTH 13 NO_PROBE|");
    moment.snapshot = NULL;
    say(0U, "NEEDLE_LENGTH", "259.075");
    EXPECT_BEGIN(0U, "STRING ACK_NEEDLE_LENGTH ");
    EXPECT_BEGIN(0U, "STATUS NEEDLE_LENGTH 7 NO_ANSWER|");
}

void test_SWR_IGTL_036_a_robot_without_a_length_does_not_know_the_question(void)
{
    say(0U, "NEEDLE_LENGTH", "150");
    EXPECT(0U, "STRING ACK_NEEDLE_LENGTH 150");
    EXPECT_BEGIN(0U, "STATUS NEEDLE_LENGTH 12 UNKNOWN_COMMAND|");
}

#define LENGTHS "treatment_to_tip 10 robot_to_entry 5 cannula_to_treatment 5 robot_to_treatment 41"

static const int32_t file_nm[] = {10000000, 5000000, 5000000, 41000000};

static void carry_probe(void)
{
    static const char *const names[] = {"treatment_to_tip", "robot_to_entry",
                                        "cannula_to_treatment", "robot_to_treatment"};

    robot.probe_length_count = 4U;
    for (uint32_t i = 0U; i < 4U; i++) {
        (void)snprintf(robot.probe_names[i], sizeof robot.probe_names[i], "%s", names[i]);
        robot.probe.length_nm[i] = file_nm[i];
    }
}

/* A probe that is sent arrives as lengths in nm. */
static void expect_probe(uint32_t count, const int32_t *length_nm)
{
    pass_us(0U);
    expect_command(COMMAND_PROBE, count);
    for (uint32_t i = 0U; i < count; i++) {
        TEST_ASSERT_EQUAL_INT32(length_nm[i], command.as.probe.lengths_nm[i]);
    }
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
}

void test_SWR_PROBE_006_lengths_are_passed_on_and_the_result_is_reported(void)
{
    static const int32_t first_nm[] = {10000000, 5250000, -5, 41000000};

    carry_probe();
    say(0U, "PROBE",
        "robot_to_entry 5.25  treatment_to_tip 10 cannula_to_treatment -0.000005 "
        "robot_to_treatment 4.1e1 ");
    expect_probe(4U, first_nm);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS PROBE 1 MOVE_TO_TARGET|");
    say(0U, "CMD_1", "PROBE " LENGTHS);
    EXPECT(0U, "STRING ACK_1 PROBE " LENGTHS);
    expect_probe(1U + 3U, file_nm);
    answer_to(&command, ANSWER_REFUSED, STATUS_PROBE_ORDER, 1U);
    EXPECT_BEGIN(0U, "STATUS PROBE 10 MOVE_TO_TARGET|PROBE_ORDER: ");
}

void test_SWR_IGTL_073_lengths_without_names_are_refused_with_the_form_that_is_taken(void)
{
    static const char *const wrong[] = {
        "10 5 5 41",
        "10",
        "",
        "treatment_to_tip 10",
        LENGTHS " treatment_to_tip 10",
        "needle_tip 10 robot_to_entry 5 cannula_to_treatment 5 robot_to_treatment 41"};

    carry_probe();
    for (uint32_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        say(0U, "PROBE", wrong[i]);
        EXPECT(0U,
               "STATUS PROBE 10 PROBE_LENGTH|PROBE_LENGTH: Send each length by its name, in mm: "
               "PROBE " LENGTHS);
        expect_no_command();
    }
}

void test_SWR_PROBE_006_what_is_no_length_is_refused_and_not_passed_on(void)
{
    static const char *const wrong[] = {"nan", "10,5", "2000.1", "-2000.1",
                                        "inf", "1e99", "ten",    ""};

    carry_probe();
    for (uint32_t i = 0U; i < 8U; i++) {
        char text[80];
        (void)snprintf(text, sizeof text, "treatment_to_tip %s", wrong[i]);
        say(0U, "PROBE", text);
        EXPECT_BEGIN(0U, "STATUS PROBE 10 OUT_OF_RANGE|");
        expect_no_command();
    }
    say(0U, "PROBES", "10 5 5 41");
    EXPECT_BEGIN(0U, "STATUS PROBES 12 UNKNOWN_COMMAND|");
    say(0U, "CMD_1", "PROBES 10");
    EXPECT_BEGIN(0U, "STRING ACK_1 ");
    EXPECT_BEGIN(0U, "STATUS PROBES 10 12 UNKNOWN_COMMAND|");
    expect_no_command();
}

void test_SWR_PROBE_006_of_too_many_at_a_time_the_last_is_refused(void)
{
    carry_probe();
    for (uint32_t i = 0U; i < IGTL_REQUESTS_PER_PEER; i++) {
        say(0U, "PROBE", LENGTHS);
    }
    EXPECT(0U, "");
    say(0U, "PROBE", LENGTHS);
    EXPECT_BEGIN(0U, "STATUS PROBE 6 BUSY|");
}

static void expect_membranes(uint32_t count, const int32_t *depths_um)
{
    pass_us(0U);
    expect_command(COMMAND_MEMBRANES, count);
    for (uint32_t i = 0U; i < count; i++) {
        TEST_ASSERT_EQUAL_INT32(depths_um[i], command.as.membranes.depths_um[i]);
    }
}

void test_SWR_PUNCT_619_depths_are_passed_on_and_the_result_is_reported(void)
{
    static const int32_t depths_um[] = {12500, 30000, 41001};

    say(0U, "MEMBRANES", "12.5  30 41.0006 ");
    expect_membranes(3U, depths_um);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS MEMBRANES 1 MOVE_TO_TARGET|");
    say(0U, "CMD_1", "MEMBRANES 12.5");
    EXPECT(0U, "STRING ACK_1 MEMBRANES 12.5");
    expect_membranes(1U, depths_um);
    answer_to(&command, ANSWER_REFUSED, STATUS_MEMBRANE_DEPTH, 1U);
    EXPECT_BEGIN(0U, "STATUS MEMBRANES 10 MOVE_TO_TARGET|MEMBRANE_DEPTH: ");
    say(0U, "MEMBRANES", "");
    expect_membranes(0U, depths_um);
}

void test_SWR_PUNCT_619_no_list_of_depths_is_refused_and_not_passed_on(void)
{
    static const char *const wrong[] = {"nan", "10,5", "10 mm", "2000.1", "1 2 3 4 5 6 7 8 9"};

    for (uint32_t i = 0U; i < 5U; i++) {
        say(0U, "MEMBRANES", wrong[i]);
        EXPECT_BEGIN(0U, "STATUS MEMBRANES 10 OUT_OF_RANGE|");
        expect_no_command();
    }
}

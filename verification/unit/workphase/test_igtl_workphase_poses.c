/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a pose, draping, and the two parts of a move to the target are words that are
 * acknowledged, and reported at their end under their own names.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_dialect.h"
#include "interface/app/names.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <stdio.h>

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2021);
    snapshot.workphase = (uint32_t)WORKPHASE_MOVE_TO_TARGET;
}

void tearDown(void)
{
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

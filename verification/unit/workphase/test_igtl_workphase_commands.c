/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: every command is acknowledged at once; a peer that may not command is informed;
 * a peer that disappears with a motion armed stops it.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_dialect.h"
#include "igtl/workphase/workphase_commands.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_outbox.h"
#include "limits/requirement_limits.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
}

void tearDown(void)
{
}

void test_SWR_IGTL_006_command_is_acknowledged_before_anything_else_happens(void)
{
    say(0U, "CMD_0001", "START_UP");
    EXPECT(0U, "STRING ACK_0001 START_UP");
    EXPECT(0U, "");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_START_UP);
    expect_no_command();
}

void test_SWR_IGTL_006_longest_id_comes_back_byte_by_byte(void)
{
    say(0U, "CMD_ABCDEFGHIJKLMNOP", "STOP");
    EXPECT(0U, "STRING ACK_ABCDEFGHIJKLMNOP STOP");
}

void test_SWR_IGTL_008_unknown_texts_and_names_are_answered(void)
{
    say(0U, "CMD_1", "DANCE");
    EXPECT(0U, "STRING ACK_1 DANCE");
    EXPECT_BEGIN(0U, "STATUS DANCE 12 ");
    say(0U, "CMD_2", "UNDEFINED");
    EXPECT(0U, "STRING ACK_2 UNDEFINED");
    EXPECT_BEGIN(0U, "STATUS UNDEFINED 12 ");
    say(0U, "ALPHA", "0.5");
    EXPECT_BEGIN(0U, "STATUS ALPHA 12 ");
    place(0U, "REGISTRATION", 1.0F);
    EXPECT_BEGIN(0U, "STATUS REGISTRATION 12 ");
    expect_no_command();
}

void test_SWR_IGTL_091_ablation_is_refused_by_name_with_what_there_is_instead(void)
{
    say(0U, "CMD_1", "ABLATION");
    EXPECT(0U, "STRING ACK_1 ABLATION");
    EXPECT(
        0U,
        "STATUS ABLATION 12 UNKNOWN_COMMAND|UNKNOWN_COMMAND: No published list of workphases has "
        "ABLATION; send a treatment program and PROGRAM RUN.");
    expect_no_command();
}

void test_SWR_IGTL_008_silent_controller_is_reported_in_time(void)
{
    say(0U, "CMD_1", "START_UP");
    EXPECT(0U, "STRING ACK_1 START_UP");
    pass_us(IGTL_ANSWER_TIMEOUT_US - 1U);
    EXPECT(0U, "");
    pass_us(1U);
    EXPECT_BEGIN(0U, "STATUS START_UP 7 NO_ANSWER|");
    pass_us(1000000U);
    EXPECT(0U, "");
}

/* As many as one peer may have on their way, and their acknowledgements read. */
static void flood(uint32_t peer)
{
    char name[] = "CMD_A";

    for (uint32_t i = 0U; i < IGTL_REQUESTS_PER_PEER; i++) {
        say(peer, name, "PLANNING");
        name[4]++;
        (void)igtl_peer_next(&outboxes[peer]);
    }
}

void test_SWR_IGTL_008_too_many_commands_at_a_time_are_refused(void)
{
    flood(0U);
    say(0U, "CMD_2", "PLANNING");
    EXPECT(0U, "STRING ACK_2 PLANNING");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
    EXPECT_BEGIN(0U, "STATUS PLANNING 6 BUSY|");
}

void test_SWR_IGTL_008_too_many_poses_at_a_time_are_refused(void)
{
    flood(0U);
    place(0U, "TGT_2", 1.0F);
    EXPECT(0U, "TRANSFORM ACK_2 1.000 2.000 3.000");
    EXPECT_BEGIN(0U, "STATUS TARGET 6 BUSY|");
}

void test_SWR_IGTL_008_a_point_is_answered_as_unknown(void)
{
    const igtl_message_t point = igtl_peer_query(IGTL_KIND_POINT, "F-1");

    workphase_dialect_receive(&dialect, 0U, &point, &moment);
    EXPECT_BEGIN(0U, "STATUS F-1 12 UNKNOWN_COMMAND|");
    expect_no_command();
}

void test_SWR_IGTL_008_command_refused_as_too_many_may_be_sent_again(void)
{
    flood(0U);
    say(0U, "CMD_2", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    answer_to(&command, ANSWER_REFUSED, STATUS_BUSY, 1U); /* CMD_A found the lane full. */
    while (igtl_requests_take(&dialect.requests, &command)) {
        accept(1U);
    }
    say(0U, "CMD_2", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    accept(1U);
    say(0U, "CMD_A", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    accept(1U);
    say(0U, "CMD_B", "PLANNING");
    expect_no_command();
}

void test_SWR_IGTL_006_stop_and_emergency_find_a_place_in_any_flood(void)
{
    flood(0U);
    for (uint32_t round = 0U; round < 20U; round++) {
        for (uint32_t peer = 0U; peer < IGTL_PEERS; peer++) {
            say(peer, "CMD_S", "STOP");
            EXPECT(peer, "STRING ACK_S STOP");
            say(peer, "CMD_E", "EMERGENCY");
            EXPECT(peer, "STRING ACK_E EMERGENCY");
            EXPECT(peer, "");
        }
        workphase_dialect_disconnected(&dialect, 7U);
        connect_peer(7U);
    }
    while (igtl_requests_take(&dialect.requests, &command)) {
        TEST_ASSERT_NOT_NULL(igtl_requests_find(&dialect.requests, command.id));
    }
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY,
                             command.as.workphase.workphase); /* The last that came. */
}

/* Ports share the dialect: their peers, and those that have gone, share the places for STOP. */
void test_SWR_IGTL_049_stop_finds_a_place_when_all_peers_of_all_ports_wait_for_one(void)
{
    const uint32_t last = IGTL_SLOTS - 1U;

    for (uint32_t peer = 0U; peer < last; peer++) {
        const igtl_introduction_t introduction = {NUMBER + peer, language, "", &outboxes[0]};

        workphase_dialect_connected(&dialect, peer, &introduction);
        for (uint32_t i = 0U; i <= IGTL_REQUESTS_PER_PEER; i++) {
            say(peer, "CMD_S", "STOP");
            say(peer, "CMD_E", "EMERGENCY");
        }
        igtl_outbox_init(&outboxes[0]);
    }
    const igtl_introduction_t introduction = {NUMBER + last, language, "", &outboxes[1]};
    workphase_dialect_connected(&dialect, last, &introduction);
    say(last, "CMD_1", "EMERGENCY");
    say(last, "CMD_2", "STOP");
    EXPECT(1U, "STRING ACK_1 EMERGENCY");
    EXPECT(1U, "STRING ACK_2 STOP");
    EXPECT(1U, "");
    while (igtl_requests_take(&dialect.requests, &command)) {
        TEST_ASSERT_NOT_NULL(igtl_requests_find(&dialect.requests, command.id));
    }
    TEST_ASSERT_EQUAL_UINT32(NUMBER + last, command.peer);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, command.as.workphase.workphase);
}

void test_SWR_IGTL_006_stop_that_was_not_passed_on_is_kept_until_it_is(void)
{
    say(1U, "CMD_S", "STOP");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    igtl_requests_keep(&dialect.requests, &command);
    pass_us(60000000U);
    pass_us(60000000U);
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    accept(1U);
    expect_no_command();
}

void test_SWR_IGTL_008_stop_with_an_id_used_before_is_executed(void)
{
    say(0U, "CMD_1", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    for (uint32_t i = 0U; i < 2U; i++) {
        say(0U, "CMD_1", "STOP");
        expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
        say(0U, "CMD_1", "EMERGENCY");
        expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_EMERGENCY);
    }
    say(0U, "CMD_1", "MANUAL"); /* Another text is another command. */
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MANUAL);
    say(0U, "CMD_1", "PLANNING");
    expect_no_command();
}

void test_SWR_IGTL_008_only_the_first_peer_commands(void)
{
    say(0U, "CMD_1", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    accept(1U);
    say(1U, "CMD_1", "MANUAL");
    EXPECT(1U, "STRING ACK_1 MANUAL");
    EXPECT(1U, "STATUS CURRENT_STATUS 1 MANUAL|");
    EXPECT(1U, "STATUS MANUAL 5 NO_AUTHORITY|NO_AUTHORITY: Another one commands the robot, or "
               "nobody yet.");
    place(1U, "TGT_1", 0.0F);
    EXPECT(1U, "TRANSFORM ACK_1 0.000 2.000 3.000");
    EXPECT_BEGIN(1U, "STATUS TARGET 5 NO_AUTHORITY|");
    expect_no_command();
    workphase_dialect_disconnected(&dialect, 0U);
    say(1U, "CMD_2", "MANUAL");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MANUAL);
}

static void have_a_page_command(void)
{
    snapshot.authority = (uint32_t)AUTHORITY_STATE_HELD;
    snapshot.holder = (uint32_t)COMMAND_SOURCE_HTTP;
    snapshot.holder_peer = 77U;
    snapshot.held_since_cycle = UINT32_MAX;
    snapshot.cycle = 12345U;
    moment.holder = "page of anna";
}

void test_SWR_IGTL_055_who_is_refused_learns_who_commands_and_for_how_long(void)
{
    enter(0U, "CMD_1", "PLANNING");
    moment.holder = "brp 127.0.0.1:53212";
    snapshot.cycle = 2999U;
    say(1U, "CMD_1", "MANUAL");
    (void)igtl_peer_next(&outboxes[1]);
    (void)igtl_peer_next(&outboxes[1]);
    EXPECT(1U, "STATUS MANUAL 5 NO_AUTHORITY|NO_AUTHORITY: brp 127.0.0.1:53212 has commanded the "
               "robot for 2 s.");
}

void test_SWR_IGTL_055_who_is_refused_by_the_controller_learns_it_too(void)
{
    have_a_page_command();
    say(1U, "CMD_1", "MANUAL");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MANUAL);
    answer_to(&command, ANSWER_REFUSED, STATUS_NO_AUTHORITY, 1U);
    (void)igtl_peer_next(&outboxes[1]);
    (void)igtl_peer_next(&outboxes[1]);
    EXPECT(1U, "STATUS MANUAL 5 UNDEFINED|NO_AUTHORITY: page of anna has commanded the robot for "
               "12 s.");
}

void test_SWR_IGTL_055_an_order_that_another_one_took_away_ends_with_his_name(void)
{
    start_move();
    have_a_page_command();
    answer_to(&command, ANSWER_ABORTED, STATUS_NO_AUTHORITY, 1U);
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 5 MOVE_TO_TARGET|NO_AUTHORITY: page of anna has ");
}

void test_SWR_IGTL_008_stop_is_everyones(void)
{
    say(0U, "CMD_1", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    accept(1U);
    pass_us(0U);
    TEST_ASSERT_TRUE(workphase_dialect_is_controlled_by(&dialect, 0U));
    TEST_ASSERT_FALSE(workphase_dialect_is_controlled_by(&dialect, 1U));
    say(1U, "CMD_1", "STOP");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    accept(1U);
    EXPECT(1U, "STRING ACK_1 STOP");
    EXPECT(1U, "STATUS CURRENT_STATUS 1 STOP|");
    EXPECT(1U, "STATUS STOP 1 STOP|");
    say(1U, "CMD_2", "MANUAL"); /* It does not control for that. */
    expect_no_command();
}

void test_SWR_IGTL_007_repeated_command_is_acknowledged_but_not_executed(void)
{
    say(0U, "CMD_1", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    say(0U, "CMD_1", "PLANNING");
    expect_no_command();
    EXPECT(0U, "STRING ACK_1 PLANNING");
    EXPECT(0U, "STRING ACK_1 PLANNING");
    for (char id = 'A'; id < ('A' + (char)WORKPHASE_IDS); id++) {
        const char name[] = {'C', 'M', 'D', '_', id, '\0'};

        say(0U, name, "PLANNING");
        expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
        accept(1U);
    }
    say(0U, "CMD_1", "PLANNING"); /* Forgotten by now. */
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
}

void test_SWR_AUTH_011_who_is_lost_gives_up_what_he_had(void)
{
    start_move();
    workphase_dialect_disconnected(&dialect, 0U);
    workphase_dialect_disconnected(&dialect, 1U);
    pass_us(0U);
    expect_released(0U);
    pass_us(0U);
    expect_no_command();
    TEST_ASSERT_FALSE(workphase_dialect_is_controlled_by(&dialect, 0U));
}

void test_SWR_AUTH_011_who_is_lost_before_the_answer_gives_it_up_after_it(void)
{
    say(0U, "CMD_1", "MOVE_TO_TARGET");
    workphase_dialect_disconnected(&dialect, 0U);
    pass_us(0U);
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    expect_no_command();
    accept(0U);
    pass_us(0U);
    expect_released(0U);
}

void test_SWR_AUTH_011_a_release_that_was_not_taken_is_sent_again(void)
{
    static const status_t refusals[] = {STATUS_BUSY, STATUS_DISCARDED};

    enter(0U, "CMD_1", "PLANNING");
    workphase_dialect_disconnected(&dialect, 0U);
    for (uint32_t i = 0U; i < 2U; i++) {
        pass_us(0U);
        expect_command(COMMAND_RELEASE, 0U);
        pass_us(0U);
        expect_no_command(); /* Once, while it is not answered. */
        answer_to(&command, ANSWER_REFUSED, refusals[i], 1U);
    }
    pass_us(0U);
    expect_released(0U);
}

void test_SWR_AUTH_011_a_release_finds_a_place_in_any_flood(void)
{
    enter(7U, "CMD_1", "PLANNING");
    workphase_dialect_disconnected(&dialect, 7U);
    for (uint32_t i = 0U; i < IGTL_REQUESTS_COMMON; i++) {
        command_t other = {.kind = (uint32_t)COMMAND_REGISTRATION};
        TEST_ASSERT_NOT_NULL(igtl_requests_add(&dialect.requests, i / 4U, &other, 0U));
    }
    pass_us(0U);
    for (uint32_t i = 0U; i < IGTL_REQUESTS_COMMON; i++) {
        expect_command(COMMAND_REGISTRATION, 0U);
    }
    expect_released(7U);
}

void test_SWR_AUTH_011_what_a_page_has_is_not_touched(void)
{
    snapshot.authority = (uint32_t)AUTHORITY_STATE_HELD;
    snapshot.holder = (uint32_t)COMMAND_SOURCE_HTTP;
    snapshot.holder_peer = 77U;
    pass_us(0U);
    expect_no_command();
    moment.snapshot = NULL;
    pass_us(0U);
    expect_no_command();
}

void test_SWR_IGTL_052_what_an_earlier_run_had_is_given_up_at_the_start(void)
{
    snapshot.authority = (uint32_t)AUTHORITY_STATE_HELD; /* By a connection of the same number. */
    snapshot.holder_peer = NUMBER;
    dialect.is_new = true;
    pass_us(0U);
    expect_command(COMMAND_RELEASE, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, command.peer);
    answer_to(&command, ANSWER_REFUSED, STATUS_DISCARDED, 1U); /* By a stop. */
    pass_us(0U);
    expect_command(COMMAND_RELEASE, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, command.peer);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    pass_us(0U);
    expect_no_command();
}

void test_SWR_IGTL_052_it_is_given_up_at_the_start_without_a_snapshot(void)
{
    moment.snapshot = NULL;
    dialect.is_new = true;
    pass_us(0U);
    expect_command(COMMAND_RELEASE, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, command.peer);
}

void test_SWR_EVENT_005_a_command_carries_the_number_of_its_connection(void)
{
    say(0U, "CMD_1", "CALIBRATION");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_CALIBRATION);
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
    place(0U, "CLB_2", 1.0F);
    expect_command(COMMAND_REGISTRATION, 0U);
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
    say(2U, "CMD_3", "STOP");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(NUMBER + 2U, command.peer);
}

void test_SWR_IGTL_011_new_peer_in_the_same_place_gets_nothing_of_the_old_one(void)
{
    say(0U, "CMD_1", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    workphase_dialect_disconnected(&dialect, 0U);
    igtl_outbox_init(&outboxes[0]);
    connect_peer(0U);
    accept(1U);
    pass_us(LIMIT_IGTL_EXTRA_DELAY_US);
    EXPECT(0U, "");
}

void test_SWR_IGTL_010_bad_numbers_never_become_a_command(void)
{
    igtl_message_t message = igtl_peer_transform("TGT_1", NAN, 0.0F, 0.0F);

    workphase_dialect_receive(&dialect, 0U, &message, &moment);
    EXPECT_BEGIN(0U, "TRANSFORM ACK_1 ");
    EXPECT_BEGIN(0U, "STATUS TARGET 10 NOT_FINITE|");
    message = igtl_peer_transform("CLB_1", 1.0F, 0.0F, 0.0F);
    message.numbers[0] = 0x40000000U; /* 2.0 */
    workphase_dialect_receive(&dialect, 0U, &message, &moment);
    (void)igtl_peer_next(&outboxes[0]);
    EXPECT_BEGIN(0U, "STATUS CALIBRATION 10 NOT_RIGID|");
    expect_no_command();
}

void test_SWR_IGTL_007_answers_of_others_are_left_alone(void)
{
    const answer_t answer = {.id = 101U};
    const answer_t none = {.id = 0U};

    TEST_ASSERT_FALSE(workphase_dialect_answer(&dialect, &answer, &moment));
    TEST_ASSERT_FALSE(workphase_dialect_answer(&dialect, &none, &moment));
}

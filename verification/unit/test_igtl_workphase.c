/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: every command is acknowledged at once and its sequence follows the answers of
 * the controller; who may not command is told so; who disappears with a motion armed stops it.
 */
#include "base/fixed.h"
#include "base/rigid.h"
#include "charts/arming_chart.h"
#include "dialect/igtl_border.h"
#include "message/igtl_codec.h"
#include "message/igtl_crc64.h"
#include "message/igtl_packet.h"
#include "dialect/igtl_dialect.h"
#include "dialect/igtl_requests.h"
#include "message/igtl_outbox.h"
#include "dialect/workphase_answer.h"
#include "dialect/workphase_dialect.h"
#include "dialect/workphase_peer.h"
#include "dialect/workphase_poll.h"
#include "interface/app/names.h"
#include "interface/command.h"
#include "interface/snapshot.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/igtl_peer.h"
#include "unity.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#define EXPECT(peer, expected) TEST_ASSERT_EQUAL_STRING((expected), igtl_peer_next(&outboxes[peer]))

static const robot_t robot = {.axis_count = 7U, .axes = {[3] = {.name = "insertion"}}};
#define NUMBER 21U /* Of the first connection. */

static workphase_dialect_t dialect;
static igtl_outbox_t outboxes[IGTL_PEERS];

static snapshot_t snapshot;
static igtl_moment_t moment;
static command_t command;

static void connect_peer(uint32_t peer)
{
    const igtl_introduction_t introduction = {NUMBER + peer, IGTL_LANGUAGE_BRP_2013, "ENTRY_",
                                              &outboxes[peer]};

    workphase_dialect_connected(&dialect, peer, &introduction);
}

void setUp(void)
{
    (void)memset(&snapshot, 0, sizeof snapshot);
    snapshot.axis_count = 7U;
    (void)memset(&command, 0, sizeof command);
    rigid_set_identity(&snapshot.scanner_treatment);
    rigid_set_identity(&snapshot.scanner_target);
    snapshot.scanner_treatment.translation.x_nm = 5000000;
    moment = (igtl_moment_t){.now_us = 1000000U, .snapshot = &snapshot};
    workphase_dialect_init(&dialect, &robot, 100U);
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        igtl_outbox_init(&outboxes[i]);
        connect_peer(i);
    }
}

void tearDown(void)
{
}

static void say(uint32_t peer, const char *name, const char *text)
{
    const igtl_message_t message = igtl_peer_string(name, text);

    workphase_dialect_receive(&dialect, peer, &message, &moment);
}

static void place(uint32_t peer, const char *name, float x)
{
    const igtl_message_t message = igtl_peer_transform(name, x, 2.0F, 3.0F);

    workphase_dialect_receive(&dialect, peer, &message, &moment);
}

static void expect_command(command_kind_t kind, uint32_t argument)
{
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    TEST_ASSERT_EQUAL_UINT32(kind, command.kind);
    TEST_ASSERT_EQUAL_UINT32(argument, command.argument);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_SOURCE_IGTL, command.source);
}

static void expect_no_command(void)
{
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

static void answer_to(const command_t *asked, answer_kind_t kind, status_t status,
                      uint32_t is_final)
{
    answer_t answer = {.id = asked->id,
                       .source = asked->source,
                       .command = asked->kind,
                       .argument = asked->argument,
                       .kind = (uint32_t)kind,
                       .status = (uint32_t)status,
                       .is_final = is_final,
                       .workphase = snapshot.workphase,
                       .axis = 3U,
                       .is_maximum = 1U,
                       .pose = snapshot.scanner_target};

    TEST_ASSERT_TRUE(workphase_dialect_answer(&dialect, &answer, &moment));
}

/* The controller goes into the workphase that was asked for. */
static void accept(uint32_t is_final)
{
    snapshot.workphase = command.argument;
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, is_final);
}

static void pass_us(uint64_t time_us)
{
    moment.now_us += time_us;
    moment.patience_us += time_us;
    workphase_dialect_step(&dialect, &moment);
}

static void start_move(void)
{
    say(0U, "CMD_M", "MOVE_TO_TARGET");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    accept(0U);
    EXPECT(0U, "STRING ACK_M MOVE_TO_TARGET");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET|");
    EXPECT(0U, "");
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

void test_SWR_IGTL_007_start_up_is_reported_when_the_axes_are_homed(void)
{
    command_t start_up;

    say(0U, "CMD_1", "START_UP");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_START_UP);
    start_up = command;
    accept(0U);
    EXPECT(0U, "STRING ACK_1 START_UP");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 START_UP|");
    EXPECT(0U, "");
    pass_us(30000000U);
    EXPECT(0U, "");
    answer_to(&start_up, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT(0U, "STATUS START_UP 1 START_UP|");
}

void test_SWR_IGTL_007_messages_of_2021_come_a_little_later(void)
{
    say(0U, "CMD_1", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    accept(1U);
    EXPECT(0U, "STRING ACK_1 PLANNING");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
    pass_us(LIMIT_IGTL_EXTRA_DELAY_US - 1U);
    EXPECT(0U, "");
    pass_us(1U);
    EXPECT(0U, "STATUS PLANNING 1 PLANNING|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_007_messages_of_2021_are_withheld_from_a_client_of_2013(void)
{
    say(0U, "CMD_1", "CALIBRATION");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_CALIBRATION);
    accept(1U);
    EXPECT(0U, "STRING ACK_1 CALIBRATION");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 CALIBRATION|");
    place(0U, "CLB_2", 1.0F);
    EXPECT(0U, "TRANSFORM ACK_2 1.000 2.000 3.000");
    pass_us(LIMIT_IGTL_EXTRA_DELAY_US);
    EXPECT(0U, "");
}

void test_SWR_IGTL_007_poll_gets_the_deferred_message_first(void)
{
    say(0U, "CMD_1", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    accept(1U);
    say(0U, "CURRENT_STATUS", "");
    EXPECT(0U, "STRING ACK_1 PLANNING");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
    EXPECT(0U, "STATUS PLANNING 1 PLANNING|");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
}

void test_SWR_IGTL_007_registration_is_echoed_and_reported(void)
{
    place(0U, "CLB_7", 1.0F);
    EXPECT(0U, "TRANSFORM ACK_7 1.000 2.000 3.000");
    expect_command(COMMAND_REGISTRATION, 0U);
    TEST_ASSERT_EQUAL_INT32(1000000, command.pose.translation.x_nm);
    snapshot.workphase = (uint32_t)WORKPHASE_CALIBRATION;
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS CALIBRATION 1 CALIBRATION|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_007_target_comes_back_reachable(void)
{
    snapshot.scanner_target.translation.y_nm = -4000000;
    place(0U, "TGT_7", 1.0F);
    expect_command(COMMAND_TARGET, 0U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "TRANSFORM ACK_7 1.000 2.000 3.000");
    EXPECT(0U, "STATUS TARGET 1 UNDEFINED|");
    EXPECT(0U, "TRANSFORM TARGET 0.000 -4.000 0.000");
    EXPECT(0U, "");
    pass_us(LIMIT_IGTL_EXTRA_DELAY_US);
    EXPECT(0U, "TRANSFORM REACHABLE_TARGET 0.000 -4.000 0.000");
}

void test_SWR_IGTL_007_other_workphases_report_at_once(void)
{
    static const workphase_t phases[] = {WORKPHASE_TARGETING, WORKPHASE_MANUAL, WORKPHASE_STOP,
                                         WORKPHASE_EMERGENCY};

    for (uint32_t i = 0U; i < 4U; i++) {
        const char *name = workphase_name((int32_t)phases[i]);
        const char *ids[] = {"CMD_1", "CMD_2", "CMD_3", "CMD_4"};

        say(0U, ids[i], name);
        expect_command(COMMAND_WORKPHASE, (uint32_t)phases[i]);
        accept(1U);
        TEST_ASSERT_EQUAL_STRING_LEN("STRING ACK_", igtl_peer_next(&outboxes[0]), 11U);
        TEST_ASSERT_EQUAL_STRING_LEN("STATUS CURRENT_STATUS 1 ", igtl_peer_next(&outboxes[0]), 24U);
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outboxes[0]), name));
        EXPECT(0U, "");
    }
}

void test_SWR_IGTL_007_move_streams_positions_while_it_moves(void)
{
    start_move();
    pass_us(500000U);
    EXPECT(0U, ""); /* Waiting for the pedal. */
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    pass_us(0U);
    EXPECT(0U, "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000");
    pass_us(IGTL_STREAM_US - 1U);
    EXPECT(0U, "");
    pass_us(1U);
    EXPECT(0U, "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000");
    EXPECT(1U, "");
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT(0U, "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET|");
    EXPECT(0U, "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000");
    pass_us(IGTL_STREAM_US);
    EXPECT(0U, "");
}

void test_SWR_IGTL_007_stop_has_its_own_sequence_before_the_end_of_the_move(void)
{
    command_t move;

    start_move();
    move = command;
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    say(0U, "CMD_S", "STOP");
    pass_us(1000U);
    EXPECT(0U, "STRING ACK_S STOP");
    EXPECT(0U, ""); /* No position in between. */
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    answer_to(&move, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    accept(1U);
    EXPECT(0U, "STATUS CURRENT_STATUS 1 STOP|");
    EXPECT(0U, "STATUS STOP 1 STOP|");
    EXPECT(0U, "");
    pass_us(LIMIT_IGTL_EXTRA_DELAY_US);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS MOVE_TO_TARGET 13 ", igtl_peer_next(&outboxes[0]), 25U);
}

void test_SWR_IGTL_008_discarded_and_expired_moves_are_reported(void)
{
    start_move();
    snapshot.workphase = (uint32_t)WORKPHASE_EMERGENCY;
    answer_to(&command, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    TEST_ASSERT_EQUAL_STRING_LEN(
        "STATUS MOVE_TO_TARGET 13 EMERGENCY|DISCARDED: ", igtl_peer_next(&outboxes[0]), 46U);
    say(0U, "CMD_2", "MOVE_TO_TARGET");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    accept(0U);
    answer_to(&command, ANSWER_ABORTED, STATUS_EXPIRED, 1U);
    EXPECT(0U, "STRING ACK_2 MOVE_TO_TARGET");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET|");
    TEST_ASSERT_EQUAL_STRING_LEN(
        "STATUS MOVE_TO_TARGET 7 MOVE_TO_TARGET|EXPIRED: ", igtl_peer_next(&outboxes[0]), 48U);
}

void test_SWR_IGTL_008_refused_workphase_says_where_it_stays_and_why(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_PLANNING;
    say(0U, "CMD_1", "TARGETING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_TARGETING);
    answer_to(&command, ANSWER_REFUSED, STATUS_NOT_REGISTERED, 1U);
    EXPECT(0U, "STRING ACK_1 TARGETING");
    EXPECT(0U, "STATUS CURRENT_STATUS 13 PLANNING|NOT_REGISTERED: There is no registration; send "
               "one in CALIBRATION.");
    EXPECT(0U, "STATUS TARGETING 13 PLANNING|NOT_REGISTERED: There is no registration; send one in "
               "CALIBRATION.");
    EXPECT(0U, "");
}

void test_SWR_IGTL_008_unreachable_target_names_axis_and_limit(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_TARGETING;
    place(0U, "TGT_1", 1.0F);
    expect_command(COMMAND_TARGET, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_AXIS_LIMIT, 1U);
    EXPECT(0U, "TRANSFORM ACK_1 1.000 2.000 3.000");
    EXPECT(0U, "STATUS TARGET 10 TARGETING|AXIS_LIMIT: An axis would leave its soft limits. "
               "(insertion, upper limit)");
    EXPECT(0U, "");
}

void test_SWR_IGTL_008_a_target_at_a_switch_names_its_axis(void)
{
    char text[IGTL_REASON_SIZE];
    const answer_t at_switch = {.status = (uint32_t)STATUS_SWITCH_ZONE, .axis = AXIS_LATERAL};

    igtl_reason_text(&robot_neuro, &at_switch, text);
    TEST_ASSERT_NOT_NULL(strstr(text, "SWITCH_ZONE"));
    TEST_ASSERT_NOT_NULL(strstr(text, "(lateral)"));
}

void test_SWR_IGTL_008_each_reason_has_its_code(void)
{
    TEST_ASSERT_EQUAL_UINT32(1U, igtl_reason_code(STATUS_OK));
    TEST_ASSERT_EQUAL_UINT32(12U, igtl_reason_code(STATUS_UNKNOWN_COMMAND));
    TEST_ASSERT_EQUAL_UINT32(6U, igtl_reason_code(STATUS_BUSY));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_WRONG_WORKPHASE));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_HARDWARE_NOT_READY));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_CONFIRM_POSITIONS));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_NOT_RIGID));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_SEPARATION_LIMIT));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_SWITCH_ZONE));
    TEST_ASSERT_EQUAL_UINT32(7U, igtl_reason_code(STATUS_EXPIRED));
    TEST_ASSERT_EQUAL_UINT32(7U, igtl_reason_code(STATUS_NO_ANSWER));
}

void test_SWR_IGTL_008_unknown_texts_and_names_are_answered(void)
{
    say(0U, "CMD_1", "DANCE");
    EXPECT(0U, "STRING ACK_1 DANCE");
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS DANCE 12 ", igtl_peer_next(&outboxes[0]), 16U);
    say(0U, "CMD_2", "UNDEFINED");
    EXPECT(0U, "STRING ACK_2 UNDEFINED");
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS UNDEFINED 12 ", igtl_peer_next(&outboxes[0]), 20U);
    say(0U, "RETRACT_NEEDLE", "");
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS RETRACT_NEEDLE 12 ", igtl_peer_next(&outboxes[0]), 25U);
    place(0U, "REGISTRATION", 1.0F);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS REGISTRATION 12 ", igtl_peer_next(&outboxes[0]), 23U);
    expect_no_command();
}

void test_SWR_IGTL_008_silent_controller_is_reported_in_time(void)
{
    say(0U, "CMD_1", "START_UP");
    EXPECT(0U, "STRING ACK_1 START_UP");
    pass_us(IGTL_ANSWER_TIMEOUT_US - 1U);
    EXPECT(0U, "");
    pass_us(1U);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS START_UP 7 NO_ANSWER|", igtl_peer_next(&outboxes[0]), 28U);
    pass_us(1000000U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_008_lost_controller_is_reported_to_who_waits(void)
{
    start_move();
    workphase_dialect_control_lost(&dialect, &moment);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS MOVE_TO_TARGET 7 NO_ANSWER|", igtl_peer_next(&outboxes[0]),
                                 34U);
    workphase_dialect_control_lost(&dialect, &moment);
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
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS PLANNING 6 BUSY|", igtl_peer_next(&outboxes[0]), 23U);
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
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, command.argument); /* The last that came. */
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
    EXPECT(1U,
           "STATUS MANUAL 5 ACCESS_DENIED|ACCESS_DENIED: Another connection controls the robot.");
    place(1U, "TGT_1", 0.0F);
    EXPECT(1U, "TRANSFORM ACK_1 0.000 2.000 3.000");
    EXPECT(1U,
           "STATUS TARGET 5 ACCESS_DENIED|ACCESS_DENIED: Another connection controls the robot.");
    expect_no_command();
    workphase_dialect_disconnected(&dialect, 0U);
    say(1U, "CMD_2", "MANUAL");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MANUAL);
}

void test_SWR_IGTL_008_stop_is_everyones(void)
{
    say(0U, "CMD_1", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
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

void test_SWR_IGTL_011_losing_the_peer_of_an_armed_move_stops_it(void)
{
    start_move();
    workphase_dialect_disconnected(&dialect, 0U);
    pass_us(0U);
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    answer_to(&command, ANSWER_REFUSED, STATUS_BUSY, 1U);
    pass_us(0U);
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    accept(1U);
    pass_us(0U);
    expect_no_command();
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

void test_SWR_EVENT_005_the_stop_for_a_lost_peer_carries_no_number(void)
{
    start_move();
    workphase_dialect_disconnected(&dialect, 0U);
    pass_us(0U);
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(0U, command.peer);
}

void test_SWR_IGTL_011_losing_a_peer_without_an_armed_move_stops_nothing(void)
{
    start_move();
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    workphase_dialect_disconnected(&dialect, 0U);
    workphase_dialect_disconnected(&dialect, 1U);
    pass_us(0U);
    expect_no_command();
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
    TEST_ASSERT_EQUAL_STRING_LEN("TRANSFORM ACK_1 ", igtl_peer_next(&outboxes[0]), 16U);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS TARGET 10 NOT_FINITE|", igtl_peer_next(&outboxes[0]), 28U);
    message = igtl_peer_transform("CLB_1", 1.0F, 0.0F, 0.0F);
    message.numbers[0] = 0x40000000U; /* 2.0 */
    workphase_dialect_receive(&dialect, 0U, &message, &moment);
    (void)igtl_peer_next(&outboxes[0]);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS CALIBRATION 10 NOT_RIGID|", igtl_peer_next(&outboxes[0]),
                                 32U);
    expect_no_command();
}

void test_SWR_IGTL_013_polls_by_query_are_answered(void)
{
    igtl_message_t message = igtl_peer_query(IGTL_KIND_GET_TRANSFORM, "CURRENT_POSITION");

    snapshot.workphase = (uint32_t)WORKPHASE_MANUAL;
    workphase_dialect_receive(&dialect, 3U, &message, &moment);
    EXPECT(3U, "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000");
    message = igtl_peer_query(IGTL_KIND_GET_STATUS, "");
    workphase_dialect_receive(&dialect, 3U, &message, &moment);
    EXPECT(3U, "STATUS CURRENT_STATUS 1 MANUAL|");
    message = igtl_peer_query(IGTL_KIND_GET_STATUS, "WEATHER");
    workphase_dialect_receive(&dialect, 3U, &message, &moment);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS WEATHER 4 NOT_FOUND|", igtl_peer_next(&outboxes[3]), 27U);
    message = igtl_peer_query(IGTL_KIND_GET_TRANSFORM, "TARGET");
    workphase_dialect_receive(&dialect, 3U, &message, &moment);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS TARGET 4 NOT_FOUND|", igtl_peer_next(&outboxes[3]), 26U);
    snapshot.has_target = 1U;
    workphase_dialect_receive(&dialect, 3U, &message, &moment);
    EXPECT(3U, "TRANSFORM TARGET 0.000 0.000 0.000");
}

void test_SWR_IGTL_013_polls_by_text_are_answered(void)
{
    say(2U, "CURRENT_POSITION", "");
    EXPECT(2U, "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000");
    EXPECT(2U, "STRING IS_IN_TARGETING_POS 0");
    EXPECT(2U, "STRING HAS_REACHED_TARGET 0");
    snapshot.has_target = 1U;
    snapshot.scanner_treatment.translation = (point_t){0, 0, 7000000};
    say(2U, "x", "IS_IN_TARGETING_POS");
    EXPECT(2U, "STRING IS_IN_TARGETING_POS 1"); /* On the line, not at its end. */
    say(2U, "HAS_REACHED_TARGET", "");
    EXPECT(2U, "STRING HAS_REACHED_TARGET 0");
    snapshot.scanner_treatment.translation.z_nm = 0;
    say(2U, "HAS_REACHED_TARGET", "");
    EXPECT(2U, "STRING HAS_REACHED_TARGET 1");
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    say(2U, "HAS_REACHED_TARGET", "");
    EXPECT(2U, "STRING HAS_REACHED_TARGET 0");
    say(2U, "CMD_1", "CURRENT_STATUS");
    EXPECT(2U, "STRING ACK_1 CURRENT_STATUS");
    EXPECT(2U, "STATUS CURRENT_STATUS 1 UNDEFINED|");
    EXPECT(2U, "");
}

static void expect_poll(const char *question, bool is_affirmed)
{
    char answer[48];

    (void)snprintf(answer, sizeof answer, "STRING %s %u", question, is_affirmed ? 1U : 0U);
    say(2U, question, "");
    EXPECT(2U, answer);
}

void test_SWR_IGTL_017_near_enough_is_aligned_and_reached(void)
{
    snapshot.has_target = 1U;
    snapshot.scanner_treatment.translation = (point_t){LIMIT_REACHED_WAY_NM, 0, 0};
    expect_poll("IS_IN_TARGETING_POS", true);
    expect_poll("HAS_REACHED_TARGET", true);
    snapshot.scanner_treatment.translation.x_nm++;
    expect_poll("IS_IN_TARGETING_POS", false);
    expect_poll("HAS_REACHED_TARGET", false);
    snapshot.scanner_treatment.translation = (point_t){0, 0, LIMIT_REACHED_WAY_NM + 1};
    expect_poll("IS_IN_TARGETING_POS", true);
    expect_poll("HAS_REACHED_TARGET", false);
}

void test_SWR_IGTL_017_nothing_is_reached_while_it_moves(void)
{
    snapshot.has_target = 1U;
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    snapshot.scanner_treatment.translation = (point_t){0, 0, 0};
    expect_poll("IS_IN_TARGETING_POS", true);
    expect_poll("HAS_REACHED_TARGET", false);
}

void test_SWR_IGTL_013_polls_before_the_first_snapshot_say_so(void)
{
    moment.snapshot = NULL;
    say(0U, "CURRENT_POSITION", "");
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS CURRENT_POSITION 7 NO_ANSWER|",
                                 igtl_peer_next(&outboxes[0]), 36U);
    EXPECT(0U, "STRING IS_IN_TARGETING_POS 0");
    EXPECT(0U, "STRING HAS_REACHED_TARGET 0");
    say(0U, "CURRENT_STATUS", "");
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS CURRENT_STATUS 10 UNDEFINED|",
                                 igtl_peer_next(&outboxes[0]), 35U);
}

void test_SWR_IGTL_013_greeting_of_slicer_gets_no_answer(void)
{
    const igtl_message_t message = igtl_peer_query(IGTL_KIND_STATUS, "");

    workphase_dialect_receive(&dialect, 0U, &message, &moment);
    EXPECT(0U, "");
}

void test_SWR_IGTL_007_answers_of_others_are_left_alone(void)
{
    const answer_t answer = {.id = 101U};
    const answer_t none = {.id = 0U};

    TEST_ASSERT_FALSE(workphase_dialect_answer(&dialect, &answer, &moment));
    TEST_ASSERT_FALSE(workphase_dialect_answer(&dialect, &none, &moment));
}

void test_SWR_IGTL_014_a_pose_that_is_not_known_is_answered_by_its_reason(void)
{
    snapshot.has_target = 1U;
    snapshot.scanner_target = snapshot.scanner_treatment;
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    say(0U, "CURRENT_POSITION", "");
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS CURRENT_POSITION 13 NOT_HOMED|",
                                 igtl_peer_next(&outboxes[0]), 37U);
    EXPECT(0U, "STRING IS_IN_TARGETING_POS 0");
    EXPECT(0U, "STRING HAS_REACHED_TARGET 0");
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    const igtl_message_t query = igtl_peer_query(IGTL_KIND_GET_TRANSFORM, "CURRENT_POSITION");
    workphase_dialect_receive(&dialect, 0U, &query, &moment);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS CURRENT_POSITION 13 NOT_REGISTERED|",
                                 igtl_peer_next(&outboxes[0]), 42U);
    snapshot.pose_status = (uint32_t)STATUS_OK;
    say(0U, "HAS_REACHED_TARGET", "");
    EXPECT(0U, "STRING HAS_REACHED_TARGET 1");
}

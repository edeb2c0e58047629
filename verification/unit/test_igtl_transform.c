/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: bare transforms become proposals and nothing else; every peer is shown the
 * present state once, and again what changes.
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
#include "dialect/transform_dialect.h"
#include "interface/app/names.h"
#include "interface/command.h"
#include "interface/snapshot.h"
#include "robot/robot.h"
#include "unit/support/igtl_peer.h"
#include "unity.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#define EXPECT(peer, expected) TEST_ASSERT_EQUAL_STRING((expected), igtl_peer_next(&outboxes[peer]))

static const robot_t robot = {
    .axis_count = 1U,
    .axes = {{.unit = (uint8_t)AXIS_UNIT_MM, .unit_per_tick_q16 = INT64_C(655360000)}}};
#define NUMBER 21U /* Of the first connection. */

static transform_dialect_t dialect;
static igtl_outbox_t outboxes[2];
static snapshot_t snapshot;
static igtl_moment_t moment;
static command_t command;

void setUp(void)
{
    (void)memset(&snapshot, 0, sizeof snapshot);
    snapshot.axis_count = 7U;
    rigid_set_identity(&snapshot.scanner_treatment);
    moment = (igtl_moment_t){.now_us = 1000000U, .snapshot = &snapshot};
    transform_dialect_init(&dialect, &robot, 101U);
    igtl_outbox_init(&outboxes[0]);
    igtl_outbox_init(&outboxes[1]);
    transform_dialect_connected(
        &dialect, 0U,
        &(igtl_introduction_t){NUMBER + 0U, IGTL_LANGUAGE_CRTK, "ENTRY_", &outboxes[0]});
}

void tearDown(void)
{
}

static void place(const char *name, float x)
{
    const igtl_message_t message = igtl_peer_transform(name, x, 2.0F, 3.0F);

    transform_dialect_receive(&dialect, 0U, &message, &moment);
}

static void pass_us(uint64_t time_us)
{
    moment.now_us += time_us;
    moment.patience_us += time_us;
    transform_dialect_step(&dialect, &moment);
}

static void answer(answer_kind_t kind, status_t status)
{
    const answer_t given = {.id = command.id,
                            .command = command.kind,
                            .kind = (uint32_t)kind,
                            .status = (uint32_t)status,
                            .is_final = 1U};

    TEST_ASSERT_TRUE(transform_dialect_answer(&dialect, &given, &moment));
}

static void expect_measured(uint32_t peer)
{
    TEST_ASSERT_EQUAL_STRING_LEN("TRANSFORM measured_cp ", igtl_peer_next(&outboxes[peer]), 22U);
    TEST_ASSERT_EQUAL_STRING_LEN("STRING measured_jp ", igtl_peer_next(&outboxes[peer]), 19U);
    TEST_ASSERT_EQUAL_STRING_LEN("STRING measured_jv ", igtl_peer_next(&outboxes[peer]), 19U);
    EXPECT(peer, "");
}

void test_SWR_IGTL_009_transforms_become_proposals(void)
{
    static const struct {
        const char *name;
        command_kind_t kind;
    } cases[] = {{"REGISTRATION", COMMAND_PROPOSE_REGISTRATION},
                 {"ENTRY_POINT", COMMAND_PROPOSE_ENTRY},
                 {"TARGET_POINT", COMMAND_PROPOSE_TARGET}};

    for (uint32_t i = 0U; i < 3U; i++) {
        place(cases[i].name, 1.0F);
        TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
        TEST_ASSERT_EQUAL_UINT32(cases[i].kind, command.kind);
        TEST_ASSERT_EQUAL_INT32(1000000, command.pose.translation.x_nm);
    }
    EXPECT(0U, "");
}

void test_SWR_EVENT_005_a_proposal_carries_the_number_of_its_connection(void)
{
    place("ENTRY_POINT", 1.0F);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
}

void test_SWR_IGTL_009_no_message_becomes_any_other_command(void)
{
    static const char *const names[] = {"CMD_1",         "TGT_1",  "CLB_1",        "CURRENT_POSE",
                                        "target_point",  "TARGET", "ENTRY_POINTS", "",
                                        "MOVE_TO_TARGET"};

    for (uint32_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        const igtl_message_t text = igtl_peer_string(names[i], "MOVE_TO_TARGET");

        place(names[i], 1.0F);
        transform_dialect_receive(&dialect, 0U, &text, &moment);
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outboxes[0]), " 12 UNKNOWN_COMMAND|"));
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outboxes[0]), " 12 UNKNOWN_COMMAND|"));
    }
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

void test_SWR_IGTL_010_bad_numbers_never_become_a_proposal(void)
{
    place("TARGET_POINT", NAN);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS TARGET_POINT 10 NOT_FINITE|", igtl_peer_next(&outboxes[0]),
                                 34U);
    place("TARGET_POINT", 1e9F);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS TARGET_POINT 10 OUT_OF_RANGE|",
                                 igtl_peer_next(&outboxes[0]), 36U);
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

void test_SWR_IGTL_008_refused_proposal_is_answered(void)
{
    place("ENTRY_POINT", 1.0F);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    answer(ANSWER_REFUSED, STATUS_SEPARATION_LIMIT);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS ENTRY_POINT 10 SEPARATION_LIMIT|",
                                 igtl_peer_next(&outboxes[0]), 39U);
}

void test_SWR_IGTL_008_silence_of_the_controller_is_answered(void)
{
    pass_us(0U);
    expect_measured(0U);
    place("REGISTRATION", 1.0F);
    pass_us(IGTL_ANSWER_TIMEOUT_US);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS REGISTRATION 7 NO_ANSWER|", igtl_peer_next(&outboxes[0]),
                                 32U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_008_flood_of_proposals_is_answered_busy(void)
{
    for (uint32_t i = 0U; i < 4U; i++) {
        place("TARGET_POINT", 1.0F);
    }
    EXPECT(0U, "");
    place("TARGET_POINT", 1.0F);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS TARGET_POINT 6 BUSY|", igtl_peer_next(&outboxes[0]), 27U);
}

void test_SWR_IGTL_012_new_peer_is_shown_everything_there_is(void)
{
    snapshot.is_registered = 1U;
    snapshot.scanner_zframe.translation.x_nm = 1000000;
    snapshot.has_proposed_entry = 1U;
    snapshot.proposed_entry.y_nm = 2000000;
    snapshot.has_proposed_target = 1U;
    snapshot.proposed_target.z_nm = 3000000;
    snapshot.is_proposal_reachable = 1U;
    snapshot.desired_ticks[0] = 100;
    snapshot.axes[0].position_ticks = 50;
    pass_us(0U);
    EXPECT(0U, "TRANSFORM scanner_to_robot_reg 1.000 0.000 0.000");
    EXPECT(0U, "POINT entry_point 0.000 2.000 0.000");
    EXPECT(0U, "POINT target_point 0.000 0.000 3.000");
    EXPECT(0U, "TRANSFORM desired_cp 0.000 0.000 0.000");
    EXPECT(0U, "STRING desired_jp 1.000000,");
    EXPECT(0U, "TRANSFORM measured_cp 0.000 0.000 0.000");
    EXPECT(0U, "STRING measured_jp 0.500000,");
    EXPECT(0U, "STRING measured_jv 0.000000,");
    EXPECT(0U, "");
    transform_dialect_connected(
        &dialect, 1U,
        &(igtl_introduction_t){NUMBER + 1U, IGTL_LANGUAGE_CRTK, "ENTRY_", &outboxes[1]});
    pass_us(0U);
    EXPECT(0U, "");
    EXPECT(1U, "TRANSFORM scanner_to_robot_reg 1.000 0.000 0.000");
}

void test_SWR_IGTL_012_nothing_is_sent_while_nothing_changes(void)
{
    pass_us(0U);
    expect_measured(0U);
    pass_us(10U * IGTL_STREAM_US);
    EXPECT(0U, "");
}

void test_SWR_IGTL_012_change_is_sent_at_the_pace_of_the_stream(void)
{
    pass_us(0U);
    expect_measured(0U);
    snapshot.axes[0].position_ticks = 1;
    pass_us(IGTL_STREAM_US - 1U);
    EXPECT(0U, "");
    pass_us(1U);
    expect_measured(0U);
}

void test_SWR_IGTL_012_motion_is_streamed(void)
{
    pass_us(0U);
    expect_measured(0U);
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    for (uint32_t i = 0U; i < 5U; i++) {
        pass_us(IGTL_STREAM_US);
        expect_measured(0U);
    }
}

void test_SWR_IGTL_012_measured_pose_follows_every_target_point(void)
{
    pass_us(0U);
    expect_measured(0U);
    place("TARGET_POINT", 1.0F);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    answer(ANSWER_ACCEPTED, STATUS_OK);
    pass_us(0U);
    expect_measured(0U);
}

void test_SWR_IGTL_012_proposed_registration_is_shown_until_there_is_one(void)
{
    pass_us(0U);
    expect_measured(0U);
    snapshot.has_proposed_registration = 1U;
    snapshot.proposed_registration.translation.x_nm = 4000000;
    pass_us(0U);
    EXPECT(0U, "TRANSFORM scanner_to_robot_reg 4.000 0.000 0.000");
    snapshot.is_registered = 1U;
    pass_us(0U);
    EXPECT(0U, "TRANSFORM scanner_to_robot_reg 0.000 0.000 0.000");
}

void test_SWR_IGTL_013_start_up_and_queries_show_everything_again(void)
{
    const igtl_message_t start_up = igtl_peer_string("start_up", "START_UP");
    const igtl_message_t query = igtl_peer_query(IGTL_KIND_GET_TRANSFORM, "measured_cp");

    pass_us(0U);
    expect_measured(0U);
    transform_dialect_receive(&dialect, 0U, &start_up, &moment);
    pass_us(0U);
    expect_measured(0U);
    transform_dialect_receive(&dialect, 0U, &query, &moment);
    pass_us(0U);
    expect_measured(0U);
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

void test_SWR_IGTL_012_nothing_is_sent_before_the_first_snapshot(void)
{
    moment.snapshot = NULL;
    pass_us(IGTL_STREAM_US);
    EXPECT(0U, "");
}

void test_SWR_IGTL_011_answer_for_a_peer_that_has_gone_is_dropped(void)
{
    place("TARGET_POINT", 1.0F);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    transform_dialect_disconnected(&dialect, 0U);
    answer(ANSWER_REFUSED, STATUS_BUSY);
    pass_us(0U);
    EXPECT(0U, "");
}

static void expect_refused_pose(const char *name, const char *reason)
{
    char begin[60];
    const int length = snprintf(begin, sizeof begin, "STATUS %s 13 %s|", name, reason);

    TEST_ASSERT_EQUAL_STRING_LEN(begin, igtl_peer_next(&outboxes[0]), (size_t)length);
}

void test_SWR_IGTL_014_no_pose_is_streamed_before_it_is_known(void)
{
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    snapshot.is_proposal_reachable = 1U;
    pass_us(0U);
    expect_refused_pose("desired_cp", "NOT_HOMED");
    expect_refused_pose("measured_cp", "NOT_HOMED");
    EXPECT(0U, "STRING measured_jp 0.000000,");
    EXPECT(0U, "STRING measured_jv 0.000000,");
    snapshot.axes[0].position_ticks = 1;
    pass_us(IGTL_STREAM_US);
    EXPECT(0U, "STRING measured_jp 0.010000,"); /* The reason was told. */
    EXPECT(0U, "STRING measured_jv 0.000000,");
    EXPECT(0U, "");
}

void test_SWR_IGTL_014_a_pose_that_becomes_known_or_unknown_is_told_at_once(void)
{
    pass_us(0U);
    expect_measured(0U);
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    pass_us(IGTL_STREAM_US);
    expect_refused_pose("measured_cp", "NOT_REGISTERED");
    EXPECT(0U, "STRING measured_jp 0.000000,");
    EXPECT(0U, "STRING measured_jv 0.000000,");
    snapshot.pose_status = (uint32_t)STATUS_OK;
    pass_us(IGTL_STREAM_US);
    expect_measured(0U);
}

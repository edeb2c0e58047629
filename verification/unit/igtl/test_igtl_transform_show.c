/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: every peer is shown the present state once and again what changes, each question
 * has its answer, and nothing is shown that is not known.
 */
#include "base/rigid.h"
#include "charts/arming_chart.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/dialect/transform_dialect.h"
#include "igtl/wire/igtl_codec.h"
#include "unit/support/transform_world.h"
#include "unity.h"

#include <stdio.h>
#include <string.h>

void setUp(void)
{
    world_start();
}

void tearDown(void)
{
}

static void expect_refused_pose(const char *name, const char *reason)
{
    char begin[60];
    const int length = snprintf(begin, sizeof begin, "STATUS %s 13 %s|", name, reason);

    TEST_ASSERT_EQUAL_STRING_LEN(begin, igtl_peer_next(&outboxes[0]), (size_t)length);
}

void test_SWR_IGTL_045_what_is_withdrawn_is_shown_as_nothing(void)
{
    snapshot.has_proposed_registration = 1U;
    snapshot.has_proposed_entry = 1U;
    snapshot.has_proposed_target = 1U;
    snapshot.is_proposal_reachable = 1U;
    pass_us(0U);
    for (uint32_t i = 0U; i < 8U; i++) {
        (void)igtl_peer_next(&outboxes[0]);
    }
    EXPECT(0U, "");
    snapshot.has_proposed_registration = 0U;
    snapshot.has_proposed_entry = 0U;
    snapshot.has_proposed_target = 0U;
    snapshot.is_proposal_reachable = 0U;
    pass_us(0U);
    EXPECT(0U, "STATUS scanner_to_robot_reg 4 NOT_FOUND|NOT_FOUND: There is nothing of this name.");
    EXPECT(0U, "POINT entry_point nothing");
    EXPECT(0U, "POINT target_point nothing");
    EXPECT(0U, "STATUS desired_cp 4 NOT_FOUND|NOT_FOUND: There is nothing of this name.");
    EXPECT(0U, "STATUS desired_jp 4 NOT_FOUND|NOT_FOUND: There is nothing of this name.");
    EXPECT(0U, "");
}

void test_SWR_IGTL_012_a_proposed_entry_is_shown_before_the_one_that_decides_depths(void)
{
    snapshot.has_entry = 1U;
    snapshot.entry.x_nm = 2000000;
    pass_us(0U);
    EXPECT(0U, "POINT entry_point 2.000 0.000 0.000");
    expect_measured(0U);
    snapshot.has_proposed_entry = 1U;
    snapshot.proposed_entry.x_nm = 1000000;
    pass_us(0U);
    EXPECT(0U, "POINT entry_point 1.000 0.000 0.000");
    snapshot.entry.x_nm = 3000000;
    pass_us(0U);
    EXPECT(0U, "");
    snapshot.has_proposed_entry = 0U;
    pass_us(0U);
    EXPECT(0U, "POINT entry_point 3.000 0.000 0.000");
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

void test_SWR_IGTL_013_start_up_shows_everything_again(void)
{
    static const char *const names[] = {"start_up", "any"};

    pass_us(0U);
    expect_measured(0U);
    for (uint32_t i = 0U; i < 2U; i++) {
        const igtl_message_t start_up = igtl_peer_string(names[i], "START_UP");

        transform_dialect_receive(&dialect, 0U, &start_up, &moment);
        pass_us(0U);
        expect_measured(0U);
    }
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

static void ask(igtl_kind_t kind, const char *name)
{
    const igtl_message_t question = igtl_peer_query(kind, name);

    transform_dialect_receive(&dialect, 0U, &question, &moment);
}

void test_SWR_IGTL_040_a_transform_is_answered_by_its_name(void)
{
    snapshot.scanner_treatment.translation.x_nm = 1000000;
    snapshot.is_proposal_reachable = 1U;
    snapshot.scanner_desired.translation.y_nm = 2000000;
    snapshot.is_registered = 1U;
    snapshot.scanner_zframe.translation.z_nm = 3000000;
    ask(IGTL_KIND_GET_TRANSFORM, "measured_cp");
    EXPECT(0U, "TRANSFORM measured_cp 1.000 0.000 0.000");
    ask(IGTL_KIND_GET_TRANSFORM, "desired_cp");
    EXPECT(0U, "TRANSFORM desired_cp 0.000 2.000 0.000");
    ask(IGTL_KIND_GET_TRANSFORM, "scanner_to_robot_reg");
    EXPECT(0U, "TRANSFORM scanner_to_robot_reg 0.000 0.000 3.000");
    ask(IGTL_KIND_GET_TRANSFORM, "");
    EXPECT(0U, "TRANSFORM measured_cp 1.000 0.000 0.000");
    EXPECT(0U, "");
}

void test_SWR_IGTL_040_a_transform_that_there_is_not_is_answered(void)
{
    static const char *const names[] = {"desired_cp", "scanner_to_robot_reg", "TARGET"};

    for (uint32_t i = 0U; i < 3U; i++) {
        ask(IGTL_KIND_GET_TRANSFORM, names[i]);
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outboxes[0]), names[i]));
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_line, " 4 NOT_FOUND|"));
    }
    EXPECT(0U, "");
}

void test_SWR_IGTL_014_a_question_for_a_pose_that_is_not_known_is_answered_by_its_reason(void)
{
    snapshot.is_proposal_reachable = 1U;
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    for (uint32_t i = 0U; i < 2U; i++) {
        ask(IGTL_KIND_GET_TRANSFORM, "measured_cp");
        expect_refused_pose("measured_cp", "NOT_REGISTERED");
        ask(IGTL_KIND_GET_TRANSFORM, "");
        expect_refused_pose("measured_cp", "NOT_REGISTERED");
        ask(IGTL_KIND_GET_TRANSFORM, "desired_cp");
        expect_refused_pose("desired_cp", "NOT_REGISTERED");
    }
    EXPECT(0U, "");
}

void test_SWR_IGTL_040_a_point_is_answered_by_its_name_and_all_without_one(void)
{
    snapshot.has_proposed_entry = 1U;
    snapshot.proposed_entry.x_nm = 1000000;
    ask(IGTL_KIND_GET_POINT, "entry_point");
    EXPECT(0U, "POINT entry_point 1.000 0.000 0.000");
    ask(IGTL_KIND_GET_POINT, "target_point");
    EXPECT(0U, "POINT target_point nothing");
    ask(IGTL_KIND_GET_POINT, "");
    EXPECT(0U, "POINT entry_point 1.000 0.000 0.000");
    EXPECT(0U, "POINT target_point nothing");
    ask(IGTL_KIND_GET_POINT, "exit_point");
    EXPECT(0U, "STATUS exit_point 4 NOT_FOUND|NOT_FOUND: There is nothing of this name.");
    EXPECT(0U, "");
}

void test_SWR_IGTL_040_a_question_for_a_status_is_a_ping(void)
{
    ask(IGTL_KIND_GET_STATUS, "any");
    EXPECT(0U, "STATUS any 1 |");
    moment.snapshot = NULL;
    ask(IGTL_KIND_GET_STATUS, "");
    EXPECT(0U, "STATUS  1 |");
    EXPECT(0U, "");
}

void test_SWR_IGTL_040_before_the_first_snapshot_a_question_is_answered_by_that(void)
{
    moment.snapshot = NULL;
    ask(IGTL_KIND_GET_TRANSFORM, "measured_cp");
    EXPECT_BEGIN(0U, "STATUS measured_cp 7 NO_ANSWER|");
    ask(IGTL_KIND_GET_POINT, "");
    EXPECT_BEGIN(0U, "STATUS  7 NO_ANSWER|");
}

void test_SWR_IGTL_041_common_questions_are_answered_here_too(void)
{
    ask(IGTL_KIND_GET_CAPABILITY, "");
    EXPECT_BEGIN(0U, "CAPABILITY  TRANSFORM ");
    ask(IGTL_KIND_STATUS, "hello");
    ask(IGTL_KIND_OTHER, "unknown");
    EXPECT(0U, "");
}

void test_SWR_IGTL_042_the_needle_is_tracked_here_too(void)
{
    igtl_message_t start = igtl_peer_query(IGTL_KIND_STT_TDATA, "needle");

    (void)strcpy(start.type, "STT_TDATA");
    pass_us(0U);
    expect_measured(0U);
    transform_dialect_receive(&dialect, 0U, &start, &moment);
    EXPECT(0U, "RTS_TDATA needle 0");
    pass_us(0U);
    EXPECT(0U, "TDATA needle 0.000 0.000 0.000");
    EXPECT(0U, "");
    transform_dialect_disconnected(&dialect, 0U);
    pass_us(1000000U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_039_lengths_of_the_robot_are_sent_to_a_client_that_joins_or_asks(void)
{
    static const robot_t measured = {
        .axis_count = 1U,
        .axes = {{.unit = (uint8_t)AXIS_UNIT_MM, .unit_per_tick_q16 = INT64_C(655360000)}},
        .reported_lengths = {{.name = "treatment_to_tip", .length_nm = 10000000},
                             {.name = "robot_treatment_home", .length_nm = -41250000}}};
    const igtl_message_t start_up = igtl_peer_string("start_up", "START_UP");

    dialect.robot = &measured;
    for (uint32_t i = 0U; i < 2U; i++) {
        pass_us(0U);
        EXPECT(0U, "STRING treatment_to_tip 10.000000");
        EXPECT(0U, "STRING robot_treatment_home -41.250000");
        expect_measured(0U);
        pass_us(0U);
        EXPECT(0U, "");
        transform_dialect_receive(&dialect, 0U, &start_up, &moment);
    }
}

void test_SWR_PROBE_007_lengths_of_the_present_probe_are_reported_whenever_it_changes(void)
{
    static const robot_t carrying = {
        .axis_count = 1U,
        .axes = {{.unit = (uint8_t)AXIS_UNIT_MM, .unit_per_tick_q16 = INT64_C(655360000)}},
        .reported_lengths = {{.name = "needle_length", .length_nm = 1, .probe = 2U},
                             {.name = "link", .length_nm = 60000000}}};

    dialect.robot = &carrying;
    snapshot.has_probe = 1U;
    snapshot.probe_nm[1] = 10000000;
    pass_us(0U);
    EXPECT(0U, "STRING needle_length 10.000000");
    EXPECT(0U, "STRING link 60.000000");
    expect_measured(0U);
    snapshot.probe_nm[1] = 12500000;
    pass_us(0U);
    EXPECT(0U, "STRING needle_length 12.500000");
    EXPECT(0U, "STRING link 60.000000");
    EXPECT(0U, "");
    snapshot.has_probe = 0U;
    pass_us(0U);
    EXPECT(0U, "STRING link 60.000000");
    EXPECT(0U, "");
}

void test_SWR_PROBE_007_without_a_probe_joints_are_known_and_no_pose(void)
{
    pass_us(0U);
    expect_measured(0U);
    snapshot.pose_status = (uint32_t)STATUS_NO_PROBE;
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS measured_cp 13 NO_PROBE|");
    EXPECT_BEGIN(0U, "STRING measured_jp ");
    EXPECT_BEGIN(0U, "STRING measured_jv ");
}

void test_SWR_PLAN_023_that_a_rotation_is_ignored_is_reported_with_the_registration(void)
{
    pass_us(0U);
    expect_measured(0U);
    snapshot.is_registered = 1U;
    rigid_set_identity(&snapshot.scanner_zframe);
    snapshot.is_rotation_ignored = 1U;
    pass_us(0U);
    EXPECT_BEGIN(0U, "TRANSFORM scanner_to_robot_reg ");
    EXPECT(0U, "STRING ignore_rotation 1");
    EXPECT(0U, "");
    snapshot.is_rotation_ignored = 0U;
    pass_us(0U);
    EXPECT_BEGIN(0U, "TRANSFORM scanner_to_robot_reg ");
    EXPECT(0U, "STRING ignore_rotation 0");
    EXPECT(0U, "");
}

static void expect_silence_reported(uint32_t peer)
{
    EXPECT_BEGIN(peer, "STATUS measured_cp 7 NO_ANSWER|");
    EXPECT_BEGIN(peer, "STATUS measured_jp 7 NO_ANSWER|");
    EXPECT_BEGIN(peer, "STATUS measured_jv 7 NO_ANSWER|");
    EXPECT(peer, "");
}

void test_SWR_IGTL_051_before_the_first_snapshot_nothing_is_known(void)
{
    moment.snapshot = NULL;
    pass_us(IGTL_STREAM_US);
    expect_silence_reported(0U);
    pass_us(IGTL_STREAM_US);
    EXPECT(0U, "");
}

void test_SWR_IGTL_051_a_controller_that_falls_silent_is_reported_once_and_its_return_at_once(void)
{
    pass_us(0U);
    expect_measured(0U);
    moment.snapshot = NULL;
    pass_us(0U);
    expect_silence_reported(0U);
    pass_us(IGTL_STREAM_US);
    EXPECT(0U, "");
    moment.snapshot = &snapshot;
    pass_us(0U);
    expect_measured(0U);
}

void test_SWR_IGTL_037_neither_poses_nor_joints_are_streamed_before_they_are_known(void)
{
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    snapshot.is_proposal_reachable = 1U;
    pass_us(0U);
    expect_refused_pose("desired_cp", "NOT_HOMED");
    expect_refused_pose("desired_jp", "NOT_HOMED");
    expect_refused_pose("measured_cp", "NOT_HOMED");
    expect_refused_pose("measured_jp", "NOT_HOMED");
    expect_refused_pose("measured_jv", "NOT_HOMED");
    EXPECT(0U, "");
    snapshot.axes[0].position_ticks = 1;
    snapshot.desired_ticks[0] = 1;
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    pass_us(IGTL_STREAM_US);
    EXPECT(0U, ""); /* The reasons were sent. */
}

void test_SWR_IGTL_037_the_client_that_proposes_is_sent_the_reasons_again(void)
{
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    for (uint32_t i = 0U; i < 2U; i++) {
        pass_us(0U);
        expect_refused_pose("measured_cp", "NOT_HOMED");
        expect_refused_pose("measured_jp", "NOT_HOMED");
        expect_refused_pose("measured_jv", "NOT_HOMED");
        EXPECT(0U, "");
        place("TARGET_POINT", 1.0F);
        TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
        answer(ANSWER_ACCEPTED, STATUS_OK);
    }
}

void test_SWR_IGTL_037_joints_need_no_registration(void)
{
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    snapshot.is_proposal_reachable = 1U;
    snapshot.axes[0].position_ticks = 50;
    pass_us(0U);
    expect_refused_pose("desired_cp", "NOT_REGISTERED");
    expect_refused_pose("desired_jp", "NOT_REGISTERED");
    expect_refused_pose("measured_cp", "NOT_REGISTERED");
    EXPECT(0U, "STRING measured_jp 0.500000,");
    EXPECT(0U, "STRING measured_jv 0.000000,");
    EXPECT(0U, "");
}

void test_SWR_IGTL_037_a_lost_reference_is_reported_in_the_same_turn(void)
{
    pass_us(0U);
    expect_measured(0U);
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    pass_us(1000U); /* The next pose would be due much later. */
    expect_refused_pose("measured_cp", "NOT_HOMED");
    expect_refused_pose("measured_jp", "NOT_HOMED");
    expect_refused_pose("measured_jv", "NOT_HOMED");
    snapshot.pose_status = (uint32_t)STATUS_OK;
    pass_us(1000U);
    expect_measured(0U);
}

void test_SWR_IGTL_014_a_pose_that_becomes_known_or_unknown_is_reported_at_once(void)
{
    pass_us(0U);
    expect_measured(0U);
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    pass_us(1000U);
    expect_refused_pose("measured_cp", "NOT_REGISTERED");
    EXPECT(0U, "STRING measured_jp 0.000000,");
    EXPECT(0U, "STRING measured_jv 0.000000,");
    snapshot.pose_status = (uint32_t)STATUS_OK;
    pass_us(1000U);
    expect_measured(0U);
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a question is answered with the present value, and a pose that is not known by
 * its reason.
 */
#include "base/rigid.h"
#include "charts/arming_chart.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_dialect.h"
#include "igtl/wire/igtl_codec.h"
#include "limits/requirement_limits.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <stdio.h>
#include <string.h>

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
}

void tearDown(void)
{
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
    EXPECT(3U, "STATUS WEATHER 1 |");
    moment.snapshot = NULL;
    workphase_dialect_receive(&dialect, 3U, &message, &moment);
    EXPECT(3U, "STATUS WEATHER 1 |");
    moment.snapshot = &snapshot;
    message = igtl_peer_query(IGTL_KIND_GET_TRANSFORM, "TARGET");
    workphase_dialect_receive(&dialect, 3U, &message, &moment);
    EXPECT_BEGIN(3U, "STATUS TARGET 4 NOT_FOUND|");
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
    EXPECT_BEGIN(0U, "STATUS CURRENT_POSITION 7 NO_ANSWER|");
    EXPECT(0U, "STRING IS_IN_TARGETING_POS 0");
    EXPECT(0U, "STRING HAS_REACHED_TARGET 0");
    say(0U, "CURRENT_STATUS", "");
    EXPECT_BEGIN(0U, "STATUS CURRENT_STATUS 10 UNDEFINED|");
}

void test_SWR_IGTL_013_greeting_of_slicer_gets_no_answer(void)
{
    const igtl_message_t message = igtl_peer_query(IGTL_KIND_STATUS, "");

    workphase_dialect_receive(&dialect, 0U, &message, &moment);
    EXPECT(0U, "");
}

void test_SWR_IGTL_014_a_pose_that_is_not_known_is_answered_by_its_reason(void)
{
    snapshot.has_target = 1U;
    snapshot.scanner_target = snapshot.scanner_treatment;
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    say(0U, "CURRENT_POSITION", "");
    EXPECT_BEGIN(0U, "STATUS CURRENT_POSITION 13 NOT_HOMED|");
    EXPECT(0U, "STRING IS_IN_TARGETING_POS 0");
    EXPECT(0U, "STRING HAS_REACHED_TARGET 0");
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    const igtl_message_t query = igtl_peer_query(IGTL_KIND_GET_TRANSFORM, "CURRENT_POSITION");
    workphase_dialect_receive(&dialect, 0U, &query, &moment);
    EXPECT_BEGIN(0U, "STATUS CURRENT_POSITION 13 NOT_REGISTERED|");
    snapshot.pose_status = (uint32_t)STATUS_OK;
    say(0U, "HAS_REACHED_TARGET", "");
    EXPECT(0U, "STRING HAS_REACHED_TARGET 1");
}

void test_SWR_IGTL_041_common_questions_are_answered_here_too(void)
{
    igtl_message_t question = igtl_peer_query(IGTL_KIND_GET_OTHER, "T1");

    workphase_dialect_receive(&dialect, 0U, &question, &moment);
    EXPECT_BEGIN(0U, "STATUS T1 4 NOT_FOUND|");
    question.kind = IGTL_KIND_GET_CAPABILITY;
    workphase_dialect_receive(&dialect, 0U, &question, &moment);
    EXPECT_BEGIN(0U, "CAPABILITY T1 NDARRAY TRANSFORM ");
    EXPECT(0U, "");
    expect_no_command();
}

void test_SWR_IGTL_042_nothing_is_tracked_between_a_command_and_its_answer(void)
{
    igtl_message_t start = igtl_peer_query(IGTL_KIND_STT_TDATA, "probe");

    (void)strcpy(start.type, "STT_TDATA");
    workphase_dialect_receive(&dialect, 0U, &start, &moment);
    EXPECT(0U, "RTS_TDATA probe 0");
    pass_us(LIMIT_IGTL_TRACKING_LEAST_US);
    EXPECT(0U, "TDATA probe 5.000 0.000 0.000");
    say(0U, "CMD_1", "MANUAL");
    pass_us(LIMIT_IGTL_TRACKING_LEAST_US);
    EXPECT(0U, "STRING ACK_1 MANUAL");
    EXPECT(0U, "");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MANUAL);
    accept(1U);
    pass_us(LIMIT_IGTL_TRACKING_LEAST_US);
    EXPECT(0U, "STATUS CURRENT_STATUS 1 MANUAL|");
    EXPECT(0U, "STATUS MANUAL 1 MANUAL|");
    EXPECT(0U, "TDATA probe 5.000 0.000 0.000");
    EXPECT(0U, "");
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: on a port of the protocol of 2013 each command has its sequence of messages, in
 * order, and those added in 2021 come a little later.
 */
#include "charts/arming_chart.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <string.h>

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
}

void tearDown(void)
{
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
    TEST_ASSERT_EQUAL_INT32(1000000, command.as.registration.pose.translation.x_nm);
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
        EXPECT_BEGIN(0U, "STRING ACK_");
        EXPECT_BEGIN(0U, "STATUS CURRENT_STATUS 1 ");
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

/* The controller's answers to a command that ends the order `ended`. */
static void end_by_command(const command_t *ended, uint32_t is_final)
{
    const command_t newer = command;

    snapshot.order = (uint32_t)ARMING_STATE_NONE;
    answer_to(ended, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    command = newer;
    accept(is_final);
}

void test_SWR_IGTL_030_the_first_of_two_commands_ends_the_order_in_silence(void)
{
    command_t move;
    command_t targeting;

    start_move();
    move = command;
    say(0U, "CMD_A", "TARGETING");
    say(0U, "CMD_B", "CALIBRATION");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_TARGETING);
    targeting = command;
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_CALIBRATION);
    answer_to(&move, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    snapshot.workphase = (uint32_t)WORKPHASE_TARGETING;
    answer_to(&targeting, ANSWER_ACCEPTED, STATUS_OK, 1U);
    answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    EXPECT(0U, "STRING ACK_A TARGETING");
    EXPECT(0U, "STRING ACK_B CALIBRATION");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 TARGETING|");
    EXPECT(0U, "STATUS TARGETING 1 TARGETING|");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 CALIBRATION|");
    EXPECT_BEGIN(0U, "STATUS CALIBRATION 13 TARGETING|WRONG_WORKPHASE: ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_030_stop_of_the_commander_is_followed_by_silence(void)
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
    end_by_command(&move, 1U);
    EXPECT(0U, "STATUS CURRENT_STATUS 1 STOP|");
    EXPECT(0U, "STATUS STOP 1 STOP|");
    pass_us(10000000U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_030_whatever_workphase_follows_nothing_is_said_of_the_order(void)
{
    static const char *const phases[] = {"EMERGENCY", "PLANNING", "TARGETING", "MANUAL",
                                         "START_UP"};

    for (uint32_t i = 0U; i < 5U; i++) {
        command_t move;

        world_start(IGTL_LANGUAGE_BRP_2013);
        start_move();
        move = command;
        say(0U, "CMD_S", phases[i]);
        TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
        end_by_command(&move, (i == 4U) ? 0U : 1U);
        pass_us(LIMIT_IGTL_EXTRA_DELAY_US);
        for (const char *line = igtl_peer_next(&outboxes[0]); line[0] != '\0';
             line = igtl_peer_next(&outboxes[0])) {
            TEST_ASSERT_NULL(strstr(line, "MOVE_TO_TARGET"));
        }
    }
}

void test_SWR_IGTL_030_an_order_ended_by_someone_else_is_reported_after_a_refused_command(void)
{
    command_t move;
    command_t planning;

    start_move();
    move = command;
    say(0U, "CMD_P", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    planning = command;
    snapshot.workphase = (uint32_t)WORKPHASE_EMERGENCY; /* The e-stop came first. */
    answer_to(&move, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    EXPECT(0U, "STRING ACK_P PLANNING");
    EXPECT(0U, "");
    answer_to(&planning, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
    EXPECT_BEGIN(0U, "STATUS PLANNING 13 EMERGENCY|WRONG_WORKPHASE: ");
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 13 EMERGENCY|DISCARDED: ");
    EXPECT(0U, "");
}

void test_SWR_IGTL_030_a_refused_command_does_not_silence_the_order(void)
{
    command_t move;

    start_move();
    move = command;
    say(0U, "CMD_C", "CALIBRATION");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_CALIBRATION);
    answer_to(&command, ANSWER_REFUSED, STATUS_WRONG_WORKPHASE, 1U);
    EXPECT(0U, "STRING ACK_C CALIBRATION");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 CALIBRATION|");
    EXPECT_BEGIN(0U, "STATUS CALIBRATION 13 ");
    answer_to(&move, ANSWER_ABORTED, STATUS_DISCARDED, 1U); /* A stop of someone else. */
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 13 ");
}

void test_SWR_IGTL_030_an_end_is_reported_when_the_command_after_it_is_never_answered(void)
{
    command_t move;

    start_move();
    move = command;
    say(0U, "CMD_P", "PLANNING");
    EXPECT(0U, "STRING ACK_P PLANNING");
    answer_to(&move, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT(0U, "");
    pass_us(IGTL_ANSWER_TIMEOUT_US);
    EXPECT_BEGIN(0U, "STATUS PLANNING 7 NO_ANSWER|");
    EXPECT(0U, "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET|");
}

void test_SWR_IGTL_007_a_message_of_2021_does_not_follow_a_newer_command(void)
{
    command_t planning;

    say(0U, "CMD_P", "PLANNING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    planning = command;
    say(0U, "CMD_S", "STOP");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    answer_to(&planning, ANSWER_ACCEPTED, STATUS_OK, 1U);
    accept(1U);
    EXPECT(0U, "STRING ACK_P PLANNING");
    EXPECT(0U, "STRING ACK_S STOP");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 STOP|");
    EXPECT(0U, "STATUS STOP 1 STOP|");
    pass_us(LIMIT_IGTL_EXTRA_DELAY_US);
    EXPECT(0U, "");
}

void test_SWR_IGTL_007_start_up_of_a_homed_robot_is_done_at_once(void)
{
    command_t start_up;

    snapshot.is_homed = 1U;
    say(0U, "CMD_1", "START_UP");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_START_UP);
    start_up = command;
    accept(0U);
    answer_to(&start_up, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT(0U, "STRING ACK_1 START_UP");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 START_UP|");
    EXPECT(0U, "STATUS START_UP 1 START_UP|");
    pass_us(LIMIT_IGTL_EXTRA_DELAY_US);
    EXPECT(0U, "");
}

void test_SWR_IGTL_014_a_move_that_ends_without_a_known_pose_sends_none(void)
{
    start_move();
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT(0U, "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET|");
    EXPECT_BEGIN(0U, "STATUS CURRENT_POSITION 13 NOT_HOMED|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_008_discarded_and_expired_moves_are_reported(void)
{
    start_move();
    snapshot.workphase = (uint32_t)WORKPHASE_EMERGENCY;
    answer_to(&command, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 13 EMERGENCY|DISCARDED: ");
    say(0U, "CMD_2", "MOVE_TO_TARGET");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    accept(0U);
    answer_to(&command, ANSWER_ABORTED, STATUS_EXPIRED, 1U);
    EXPECT(0U, "STRING ACK_2 MOVE_TO_TARGET");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET|");
    EXPECT_BEGIN(0U, "STATUS MOVE_TO_TARGET 7 MOVE_TO_TARGET|EXPIRED: ");
}

void test_SWR_IGTL_008_refused_workphase_is_announced_then_denied_with_its_reason(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_PLANNING;
    say(0U, "CMD_1", "TARGETING");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_TARGETING);
    answer_to(&command, ANSWER_REFUSED, STATUS_NOT_REGISTERED, 1U);
    EXPECT(0U, "STRING ACK_1 TARGETING");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 TARGETING|"); /* As deployed servers do. */
    EXPECT(0U, "STATUS TARGETING 13 PLANNING|NOT_REGISTERED: There is no registration; send one in "
               "CALIBRATION.");
    EXPECT(0U, "");
    say(0U, "CURRENT_STATUS", "");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 PLANNING|");
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

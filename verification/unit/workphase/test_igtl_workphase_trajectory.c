/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the commanding client sends a trajectory row by row, is informed of each, and
 * has the list run that it has sent.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_dialect.h"
#include "mode/lists/trajectory_row.h"
#include "limits/requirement_limits.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <string.h>

#define ROW "TRAJECTORY ROW 0 1500 ms 1 -2 3 4 5 6 7 ticks -10 20 30 40 50 60 70 ticks/s"

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
    robot.axis_count = 7U;
}

void tearDown(void)
{
}

/* Says it, and control does it. */
static void done(const char *text, command_kind_t kind, uint32_t argument)
{
    say(0U, "Text", text);
    expect_command(kind, argument);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 1 ");
}

static uint32_t send_list(void)
{
    trajectory_row_t row = {.time_ms = 1500U,
                            .ticks = {1, -2, 3, 4, 5, 6, 7},
                            .speeds_ticks_per_s = {-10, 20, 30, 40, 50, 60, 70}};
    uint32_t sum = trajectory_list_crc(0U, &row);

    done("TRAJECTORY BEGIN 2", COMMAND_LIST_BEGIN, 2U);
    done(ROW, COMMAND_LIST_ROW, 0U);
    TEST_ASSERT_EQUAL_UINT32(1500U, command.as.row.time_ms);
    TEST_ASSERT_EQUAL_MEMORY(row.ticks, command.as.row.ticks, sizeof row.ticks);
    TEST_ASSERT_EQUAL_MEMORY(row.speeds_ticks_per_s, command.as.row.speeds_ticks_per_s,
                             sizeof row.speeds_ticks_per_s);
    done("TRAJECTORY ROW 1 1600 ms 1 1 1 1 1 1 1 ticks 0 0 0 0 0 0 0 ticks/s", COMMAND_LIST_ROW,
         1U);
    row = (trajectory_row_t){.time_ms = 1600U, .ticks = {1, 1, 1, 1, 1, 1, 1}};
    sum = trajectory_list_crc(sum, &row);
    done("TRAJECTORY END", COMMAND_LIST_END, sum);
    return sum;
}

void test_SWR_TRAJ_019_rows_become_commands_and_end_and_run_name_them_by_their_sum(void)
{
    const uint32_t sum = send_list();

    say(0U, "CMD_5", "TRAJECTORY RUN");
    EXPECT(0U, "STRING ACK_5 TRAJECTORY RUN");
    expect_command(COMMAND_RUN_TRAJECTORY, sum);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_TRAJECTORY 1 ");
    TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 1 ");
    TEST_ASSERT_FALSE(workphase_dialect_has_order(&dialect, 0U));
}

void test_SWR_TRAJ_019_each_list_has_a_sum_of_its_own(void)
{
    const uint32_t sum = send_list();

    TEST_ASSERT_EQUAL_HEX32(sum, send_list());
}

void test_SWR_TRAJ_019_a_row_that_control_refuses_is_reported(void)
{
    done("TRAJECTORY BEGIN 2", COMMAND_LIST_BEGIN, 2U);
    say(0U, "Text", ROW);
    expect_command(COMMAND_LIST_ROW, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_TRAJECTORY_SPEED, 1U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 10 ");
    EXPECT(0U, "");
}

/* They are sent again; the sum is that of those which were passed on. */
void test_SWR_TRAJ_019_more_rows_than_have_room_are_refused_as_busy(void)
{
    done("TRAJECTORY BEGIN 9", COMMAND_LIST_BEGIN, 9U);
    for (uint32_t i = 0U; i < IGTL_REQUESTS_PER_PEER; i++) {
        say(0U, "Text", ROW);
        EXPECT(0U, "");
    }
    const uint32_t sum = dialect.peers[0].sums[0];
    say(0U, "Text", ROW);
    const char *const reported = igtl_peer_next(&outboxes[0]);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, "|BUSY: "), reported);
    TEST_ASSERT_EQUAL_HEX32(sum, dialect.peers[0].sums[0]);
}

void test_SWR_PROG_015_a_list_is_named_by_the_checksum_that_its_client_says(void)
{
    const uint32_t sum = send_list();

    say(0U, "Text", "TRAJECTORY END 4294967295");
    expect_command(COMMAND_LIST_END, UINT32_MAX);
    answer_to(&command, ANSWER_REFUSED, STATUS_TRAJECTORY_ORDER, 1U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 10 ");
    say(0U, "Text", "TRAJECTORY RUN 7");
    expect_command(COMMAND_RUN_TRAJECTORY, 7U);
    answer_to(&command, ANSWER_REFUSED, STATUS_TRAJECTORY_SUM, 1U);
    say(0U, "Text", "TRAJECTORY RUN");
    expect_command(COMMAND_RUN_TRAJECTORY, sum);
}

void test_SWR_TRAJ_019_a_text_that_is_none_is_refused_by_name(void)
{
    char text[LIMIT_TRAJECTORY_TEXT_BYTES + 30U];
    (void)memset(text, ' ', sizeof text);
    (void)memcpy(text, "TRAJECTORY END", 14U);
    text[sizeof text - 1U] = '\0';
    expect_refusal("TRAJECTORY", "UNKNOWN_COMMAND");
    expect_refusal("TRAJECTORY STAY", "UNKNOWN_COMMAND");
    expect_refusal("TRAJECTORY BEGIN", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY BEGIN -1", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY BEGIN 1x", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY BEGIN 1 2", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY BEGIN 99999999999", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY BEGIN +", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY END 1 2", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY END -1", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY RUN 4294967296", "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY ROW 0 -1500 ms 1 2 3 4 5 6 7 ticks 0 0 0 0 0 0 0 ticks/s",
                   "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY ROW 0 1500 ms 1 2 3 4 5 6 7 ticks 0 0 0 0 0 0 ticks/s",
                   "OUT_OF_RANGE");
    expect_refusal("TRAJECTORY ROW 0 1500 ms 1 2 3 4 5 6 7 ticks 0 0 0 0 0 0 0 0 ticks/s",
                   "WRONG_UNIT");
    expect_refusal("TRAJECTORY ROW 0 1500 ms 1.5 2 3 4 5 6 7 ticks 0 0 0 0 0 0 0 ticks/s",
                   "OUT_OF_RANGE");
    expect_refusal(text, "OUT_OF_RANGE");
}

void test_SWR_TRAJ_019_another_word_is_another_word(void)
{
    say(0U, "CMD_1", "TRAJECTORYX END");
    EXPECT(0U, "STRING ACK_1 TRAJECTORYX END");
    EXPECT_BEGIN(0U, "STATUS TRAJECTORYX END 12 ");
    expect_no_command();
}

void test_SWR_TRAJ_019_only_who_commands_sends_one(void)
{
    enter(0U, "CMD_1", "MANUAL");
    pass_us(0U);
    say(1U, "Text", "TRAJECTORY BEGIN 2");
    EXPECT_BEGIN(1U, "STATUS TRAJECTORY 5 NO_AUTHORITY|");
    expect_no_command();
}

void test_SWR_IGTL_075_a_row_needs_its_units(void)
{
    static const char *const texts[] = {
        "TRAJECTORY ROW 0 1500 1 2 3 4 5 6 7 0 0 0 0 0 0 0",
        "TRAJECTORY ROW 0 1500 s 1 2 3 4 5 6 7 ticks 0 0 0 0 0 0 0 ticks/s",
        "TRAJECTORY ROW 0 1500 ms 1 2 3 4 5 6 7 mm 0 0 0 0 0 0 0 ticks/s",
        "TRAJECTORY ROW 0 1500 ms 1 2 3 4 5 6 7 ticks 0 0 0 0 0 0 0"};

    for (size_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        say(0U, "Text", texts[i]);
        EXPECT_BEGIN(0U, "STATUS TRAJECTORY 10 WRONG_UNIT|WRONG_UNIT: Send each number with its "
                         "unit: TRAJECTORY ROW 0 1500 ms, a position");
    }
}

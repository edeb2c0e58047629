/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the commanding client sends a trajectory as one array; it is read whole, passed
 * on row by row, and answered once.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_dialect.h"
#include "igtl/wire/igtl_codec.h"
#include "mode/lists/trajectory_row.h"
#include "limits/requirement_limits.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <math.h>
#include <string.h>

#define AXES 7U
#define COLUMNS (1U + (2U * AXES))
#define HEADER 6U

static uint8_t content[HEADER + (8U * COLUMNS * (LIMIT_TRAJECTORY_ROWS + 1U))];
static igtl_message_t array;

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
    (void)memset(content, 0, sizeof content);
}

void tearDown(void)
{
}

static void put_at(uint32_t row, uint32_t column, double value)
{
    write_double(value, &content[HEADER + (8U * ((row * COLUMNS) + column))]);
}

/* Array of `rows` rows 100 ms after each other; every number shows its place. */
static void make(uint32_t rows)
{
    array = (igtl_message_t){.kind = IGTL_KIND_ARRAY,
                             .name = "TRAJECTORY",
                             .content = content,
                             .rows = rows,
                             .columns = COLUMNS,
                             .number_bytes = 8U};
    for (uint32_t row = 0U; row < rows; row++) {
        put_at(row, 0U, 100.0 * (double)row);
        for (uint32_t i = 0U; i < AXES; i++) {
            put_at(row, 1U + i, (double)row + (10.0 * (double)i));
            put_at(row, 1U + AXES + i, -(double)(row + i));
        }
    }
}

static trajectory_row_t row_of(uint32_t row)
{
    trajectory_row_t made = {.time_ms = 100U * row};

    for (uint32_t i = 0U; i < AXES; i++) {
        made.ticks[i] = (int32_t)(row + (10U * i));
        made.speeds_ticks_per_s[i] = -(int32_t)(row + i);
    }
    return made;
}

static uint32_t sum_of(uint32_t rows)
{
    uint32_t sum = 0U;

    for (uint32_t i = 0U; i < rows; i++) {
        const trajectory_row_t row = row_of(i);

        sum = trajectory_list_crc(sum, &row);
    }
    return sum;
}

static void hand_in(uint32_t peer)
{
    workphase_dialect_receive(&dialect, peer, &array, &moment);
    pass_us(0U);
}

/* How many commands are on their way; the first is kept. */
static uint32_t waiting(void)
{
    uint32_t count = 0U;
    command_t other;

    while (igtl_requests_take(&dialect.requests, (count == 0U) ? &command : &other)) {
        count++;
    }
    return count;
}

static void taken(command_kind_t kind, uint32_t argument)
{
    expect_command(kind, argument);
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    pass_us(0U);
}

static void pass_all(uint32_t rows)
{
    taken(COMMAND_LIST_BEGIN, rows);
    for (uint32_t i = 0U; i < rows; i++) {
        const trajectory_row_t row = row_of(i);

        EXPECT(0U, "");
        taken(COMMAND_LIST_ROW, i);
        TEST_ASSERT_EQUAL_UINT32(row.time_ms, command.as.row.time_ms);
        TEST_ASSERT_EQUAL_MEMORY(row.ticks, command.as.row.ticks, sizeof row.ticks);
        TEST_ASSERT_EQUAL_MEMORY(row.speeds_ticks_per_s, command.as.row.speeds_ticks_per_s,
                                 sizeof row.speeds_ticks_per_s);
    }
    taken(COMMAND_LIST_END, sum_of(rows));
}

void test_SWR_TRAJ_022_an_array_becomes_the_commands_of_its_rows_and_one_answer(void)
{
    make(5U);
    hand_in(0U);
    pass_all(5U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 1 ");
    EXPECT(0U, "");
    expect_no_command();
}

void test_SWR_TRAJ_022_the_list_that_was_sent_is_the_one_that_is_run(void)
{
    make(2U);
    hand_in(0U);
    pass_all(2U);
    say(0U, "Text", "TRAJECTORY RUN");
    expect_command(COMMAND_RUN_TRAJECTORY, sum_of(2U));
}

void test_SWR_TRAJ_022_the_longest_list_goes_on_with_few_on_their_way(void)
{
    make(LIMIT_TRAJECTORY_ROWS);
    hand_in(0U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_TRAJECTORY_ARRAY_AT_ONCE, waiting());
    pass_us(0U);
    expect_no_command();
    TEST_ASSERT_EQUAL_UINT32(COMMAND_LIST_BEGIN, command.kind);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    pass_us(0U);
    expect_command(COMMAND_LIST_ROW, LIMIT_TRAJECTORY_ARRAY_AT_ONCE - 1U);
    TEST_ASSERT_EQUAL_HEX32(sum_of(LIMIT_TRAJECTORY_ROWS), dialect.array.crc);
}

void test_SWR_TRAJ_022_only_who_commands_sends_one(void)
{
    make(2U);
    enter(0U, "CMD_1", "MANUAL");
    pass_us(0U);
    hand_in(1U);
    EXPECT_BEGIN(1U, "STATUS TRAJECTORY 5 NO_AUTHORITY|");
    expect_no_command();
}

void test_SWR_TRAJ_022_an_array_of_another_name_is_none(void)
{
    make(2U);
    array.name[0] = 'P';
    hand_in(0U);
    EXPECT_BEGIN(0U, "STATUS PRAJECTORY 12 UNKNOWN_COMMAND|");
    expect_no_command();
}

static void expect_refused(const char *line)
{
    hand_in(0U);
    EXPECT_BEGIN(0U, line);
    EXPECT(0U, "");
    expect_no_command();
}

void test_SWR_TRAJ_023_numbers_that_no_row_has_are_refused_by_name(void)
{
    static const struct {
        uint32_t column;
        double number;
        const char *reported;
    } cases[] = {{0U, -1.0, "STATUS TRAJECTORY 10 OUT_OF_RANGE|"},
                 {0U, 0.5, "STATUS TRAJECTORY 10 OUT_OF_RANGE|"},
                 {1U, 2147483648.0, "STATUS TRAJECTORY 10 OUT_OF_RANGE|"},
                 {AXES, 12.25, "STATUS TRAJECTORY 10 OUT_OF_RANGE|"},
                 {AXES, NAN, "STATUS TRAJECTORY 10 NOT_FINITE|"},
                 {COLUMNS - 1U, -INFINITY, "STATUS TRAJECTORY 10 NOT_FINITE|"},
                 {COLUMNS - 1U, 1e300, "STATUS TRAJECTORY 10 OUT_OF_RANGE|"},
                 {COLUMNS - 1U, 5e-324, "STATUS TRAJECTORY 10 OUT_OF_RANGE|"}};

    for (uint32_t i = 0U; i < (sizeof cases / sizeof cases[0]); i++) {
        make(3U);
        put_at(2U, cases[i].column, cases[i].number);
        expect_refused(cases[i].reported);
    }
}

void test_SWR_TRAJ_023_another_shape_is_refused(void)
{
    make(0U);
    expect_refused("STATUS TRAJECTORY 10 OUT_OF_RANGE|");
    make(LIMIT_TRAJECTORY_ROWS + 1U);
    expect_refused("STATUS TRAJECTORY 10 OUT_OF_RANGE|");
    make(2U);
    array.columns = COLUMNS - 1U;
    expect_refused("STATUS TRAJECTORY 10 OUT_OF_RANGE|");
    array.columns = COLUMNS + 1U;
    expect_refused("STATUS TRAJECTORY 10 OUT_OF_RANGE|");
}

void test_SWR_TRAJ_024_another_list_waits_for_this_one(void)
{
    make(2U);
    hand_in(0U);
    hand_in(0U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 6 BUSY|");
    say(0U, "Text", "TRAJECTORY BEGIN 2");
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 6 BUSY|");
    pass_all(2U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 1 ");
    hand_in(0U);
    pass_all(2U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 1 ");
}

void test_SWR_TRAJ_024_the_answer_to_another_list_is_not_taken_for_that_to_an_array(void)
{
    say(0U, "Text", "TRAJECTORY END");
    make(2U);
    hand_in(0U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 6 BUSY|");
    taken(COMMAND_LIST_END, 0U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 1 ");
    hand_in(0U);
    pass_all(2U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 1 ");
}

void test_SWR_TRAJ_024_an_array_without_room_for_its_begin_is_refused(void)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS_PER_PEER; i++) {
        say(0U, "Text", "POSE PARK");
    }
    make(2U);
    hand_in(0U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 6 BUSY|");
    TEST_ASSERT_EQUAL_UINT32(IGTL_REQUESTS_PER_PEER, waiting());
    TEST_ASSERT_FALSE(dialect.array.is_busy);
}

/* Those that were behind it on their way are refused as well, and not reported. */
void test_SWR_TRAJ_024_a_refused_row_is_reported_once_and_ends_it(void)
{
    command_t last;

    make(4U);
    hand_in(0U);
    taken(COMMAND_LIST_BEGIN, 4U);
    expect_command(COMMAND_LIST_ROW, 0U);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &last));
    answer_to(&command, ANSWER_REFUSED, STATUS_TRAJECTORY_SPEED, 1U);
    pass_us(0U);
    EXPECT(0U, "");
    hand_in(0U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 6 BUSY|");
    answer_to(&last, ANSWER_REFUSED, STATUS_TRAJECTORY_ORDER, 1U);
    while (igtl_requests_take(&dialect.requests, &command)) {
        answer_to(&command, ANSWER_REFUSED, STATUS_TRAJECTORY_ORDER, 1U);
    }
    pass_us(0U);
    const char *const reported = igtl_peer_next(&outboxes[0]);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, "STATUS TRAJECTORY 10 "), reported);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, "|TRAJECTORY_SPEED: "), reported);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, " Row 0."), reported);
    EXPECT(0U, "");
    hand_in(0U);
    pass_all(4U);
}

void test_SWR_TRAJ_024_silence_of_control_is_informed_once_and_ends_it(void)
{
    make(4U);
    hand_in(0U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_TRAJECTORY_ARRAY_AT_ONCE, waiting());
    pass_us(IGTL_ANSWER_TIMEOUT_US);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 7 NO_ANSWER|");
    EXPECT(0U, "");
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    pass_us(0U);
    EXPECT(0U, "");
    expect_no_command();
}

void test_SWR_TRAJ_024_who_does_not_command_any_more_goes_not_on(void)
{
    make(4U);
    hand_in(0U);
    taken(COMMAND_LIST_BEGIN, 4U);
    (void)waiting();
    snapshot.authority = (uint32_t)AUTHORITY_STATE_HELD;
    snapshot.holder = (uint32_t)COMMAND_SOURCE_IGTL;
    snapshot.holder_peer = NUMBER + 1U;
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 5 NO_AUTHORITY|");
    EXPECT(0U, "");
    expect_no_command();
}

void test_SWR_TRAJ_024_the_rest_goes_with_its_connection(void)
{
    make(4U);
    hand_in(0U);
    taken(COMMAND_LIST_BEGIN, 4U);
    workphase_dialect_disconnected(&dialect, 0U);
    (void)waiting();
    connect_peer(0U);
    pass_us(0U);
    while (igtl_requests_take(&dialect.requests, &command)) {
        TEST_ASSERT_EQUAL_UINT32(COMMAND_RELEASE, command.kind);
        answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    }
    hand_in(0U);
    taken(COMMAND_LIST_BEGIN, 4U);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the commanding client sends a treatment program step by step or as one array, in
 * the units of the axes, has the one run that is meant, and is informed of its progress.
 */
#include "common/axis_terms.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_dialect.h"
#include "interface/mode_list.h"
#include "igtl/wire/igtl_codec.h"
#include "mode/lists/program_step.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define HEADER 6U
#define COLUMNS 4U

/* 12 mm and -90 degrees, 30 s with the gate; 8.5 mm and 0 degrees, 250 ms without. */
#define FIRST "PROGRAM STEP 0 12 mm -90 deg 30 s GATE"
#define SECOND "PROGRAM STEP 1 8.5 mm 0 deg 0.25 s"

static uint8_t content[HEADER + (8U * COLUMNS * (LIMIT_PROGRAM_STEPS + 1U))];
static igtl_message_t array;
static program_step_t steps[2];

static int32_t ticks_of(uint32_t axis, double way)
{
    int32_t ticks = 0;
    TEST_ASSERT_TRUE(axis_terms_ticks(&robot.axes[axis], way, &ticks));
    return ticks;
}

static uint32_t turning(void)
{
    return program_step_turning_axis(&robot);
}

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2013);
    robot = robot_neuro;
    (void)memset(content, 0, sizeof content);
    steps[0] = (program_step_t){.depth_ticks = ticks_of(robot.needle_axis, 12.0),
                                .angle_ticks = ticks_of(turning(), -90.0),
                                .dwell_ms = 30000U,
                                .is_gated = 1U};
    steps[1] = (program_step_t){.depth_ticks = ticks_of(robot.needle_axis, 8.5), .dwell_ms = 250U};
}

void tearDown(void)
{
}

static uint32_t sum_of_both(void)
{
    return program_list_crc(program_list_crc(0U, &steps[0]), &steps[1]);
}

static void expect_step(uint32_t index)
{
    const program_step_t *step = &steps[index];

    expect_command(COMMAND_PROGRAM_STEP, index);
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
    TEST_ASSERT_EQUAL_UINT32(step->dwell_ms, command.as.step.dwell_ms);
    TEST_ASSERT_EQUAL_UINT32(step->is_gated, command.as.step.is_gated);
    TEST_ASSERT_EQUAL_INT32(step->depth_ticks, command.as.step.ticks[robot.needle_axis]);
    TEST_ASSERT_EQUAL_INT32(step->angle_ticks, command.as.step.ticks[turning()]);
}

static void taken(void)
{
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
}

static void send_program(void)
{
    say(0U, "Text", "PROGRAM BEGIN 2");
    expect_command(COMMAND_PROGRAM_BEGIN, 2U);
    taken();
    EXPECT_BEGIN(0U, "STATUS PROGRAM 1 ");
    say(0U, "Text", FIRST);
    expect_step(0U);
    taken();
    EXPECT_BEGIN(0U, "STATUS PROGRAM 1 ");
    say(0U, "Text", SECOND);
    expect_step(1U);
    taken();
    EXPECT_BEGIN(0U, "STATUS PROGRAM 1 ");
    say(0U, "Text", "PROGRAM END");
    expect_command(COMMAND_PROGRAM_END, sum_of_both());
    taken();
}

void test_SWR_PROG_013_steps_become_commands_and_the_end_reports_their_checksum(void)
{
    char line[64];

    send_program();
    (void)snprintf(line, sizeof line, "Checksum %u.", (unsigned)sum_of_both());
    const char *const reported = igtl_peer_next(&outboxes[0]);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS PROGRAM 1 ", reported, 17U);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, line), reported);
}

void test_SWR_PROG_013_a_step_that_control_refuses_is_reported_by_name(void)
{
    say(0U, "CMD_7", FIRST);
    EXPECT(0U, "STRING ACK_7 " FIRST);
    expect_step(0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_PROGRAM_DEPTH, 1U);
    const char *const reported = igtl_peer_next(&outboxes[0]);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS PROGRAM 10 ", reported, 18U);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, "|PROGRAM_DEPTH: "), reported);
}

void test_SWR_PROG_013_a_text_that_is_no_step_is_refused_by_name(void)
{
    expect_refusal("PROGRAM", "UNKNOWN_COMMAND");
    expect_refusal("PROGRAM ROW 0 12 90 30", "UNKNOWN_COMMAND");
    expect_refusal("PROGRAM BEGIN", "OUT_OF_RANGE");
    expect_refusal("PROGRAM BEGIN -1", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 12 mm 90 deg", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 12 mm 90 deg 30 s gate", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 12 mm 90 deg 30 s GATE 1", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 1e99 mm 90 deg 30 s", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 12 mm 1e99 deg 30 s", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 nan mm 90 deg 30 s", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 12 mm 90 deg -1 s", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 12 mm 90 deg 1000001 s", "OUT_OF_RANGE");
    expect_refusal("PROGRAM STEP 0 12 mm 90 deg 0 s GATE", "PROGRAM_DWELL");
    expect_refusal("PROGRAM STEP 0 12 mm 90 deg 0.0004 s GATE", "PROGRAM_DWELL");
    expect_refusal("PROGRAM END 1x", "OUT_OF_RANGE");
}

/* No axis turns its needle: a step has no angle. */
void test_SWR_PROG_013_a_robot_that_turns_no_needle_has_no_angle(void)
{
    robot.axes[turning()].needle_motion = 0U;
    say(0U, "Text", "PROGRAM STEP 0 12 mm 30 s");
    expect_command(COMMAND_PROGRAM_STEP, 0U);
    TEST_ASSERT_EQUAL_UINT32(30000U, command.as.step.dwell_ms);
    TEST_ASSERT_EQUAL_INT32(steps[0].depth_ticks, command.as.step.ticks[robot.needle_axis]);
    say(0U, "Text", "PROGRAM STEP 0 12 mm 90 deg 30 s");
    EXPECT(0U, "STATUS PROGRAM 10 WRONG_UNIT|WRONG_UNIT: Send each number with its unit: "
               "PROGRAM STEP 0 12 mm 30 s.");
    expect_no_command();
}

void test_SWR_PROG_013_only_who_commands_sends_one(void)
{
    enter(0U, "CMD_1", "TARGETING");
    pass_us(0U);
    say(1U, "Text", "PROGRAM BEGIN 2");
    EXPECT_BEGIN(1U, "STATUS PROGRAM 5 NO_AUTHORITY|");
    expect_no_command();
}

void test_SWR_PROG_015_the_program_that_was_sent_is_run_or_the_one_that_is_named(void)
{
    send_program();
    EXPECT_BEGIN(0U, "STATUS PROGRAM 1 ");
    say(0U, "Text", "PROGRAM RUN 2864434397");
    expect_command(COMMAND_RUN_PROGRAM, 2864434397U);
    answer_to(&command, ANSWER_REFUSED, STATUS_PROGRAM_OTHER, 1U);
    EXPECT_BEGIN(0U, "STATUS PROGRAM 10 ");
    say(0U, "Text", "TRAJECTORY END"); /* Each kind has a checksum of its own. */
    expect_command(COMMAND_LIST_END, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_TRAJECTORY_ORDER, 1U);
    EXPECT_BEGIN(0U, "STATUS TRAJECTORY 10 ");
    say(0U, "Text", "PROGRAM RUN");
    expect_command(COMMAND_RUN_PROGRAM, sum_of_both());
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_PROGRAM 1 ");
    TEST_ASSERT_TRUE(workphase_dialect_has_order(&dialect, 0U));
    answer_to(&command, ANSWER_ABORTED, STATUS_PROGRAM_STOPPED, 1U);
    const char *const reported = igtl_peer_next(&outboxes[0]);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, "|PROGRAM_STOPPED: "), reported);
    TEST_ASSERT_FALSE(workphase_dialect_has_order(&dialect, 0U));
}

static void run_program(void)
{
    send_program();
    EXPECT_BEGIN(0U, "STATUS PROGRAM 1 ");
    snapshot.program_step = 2U; /* Step of the run before. */
    snapshot.program_steps = 2U;
    snapshot.program_crc = sum_of_both();
    say(0U, "Text", "PROGRAM RUN");
    expect_command(COMMAND_RUN_PROGRAM, sum_of_both());
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 0U);
    EXPECT_BEGIN(0U, "STATUS ACK_PROGRAM 1 ");
    pass_us(0U);
    EXPECT(0U, "");
    snapshot.mode = (uint32_t)MODE_PROGRAM;
    snapshot.program_step = 0U;
    pass_us(0U);
    EXPECT(0U, "");
}

void test_SWR_PROG_016_the_client_that_runs_it_is_informed_of_each_step_once(void)
{
    char line[64];

    run_program();
    snapshot.program_step = 1U;
    pass_us(0U);
    (void)snprintf(line, sizeof line, "STRING CURRENT_PROGRAM 2 %u 1 0.0 s",
                   (unsigned)sum_of_both());
    EXPECT(0U, line);
    snapshot.program_dwelt_us = 12450000U;
    pass_us(0U);
    EXPECT(0U, "");
    EXPECT(1U, "");
    answer_to(&command, ANSWER_DONE, STATUS_OK, 1U);
    EXPECT_BEGIN(0U, "STATUS PROGRAM 1 ");
    snapshot.program_step = 2U;
    pass_us(0U);
    EXPECT(0U, "");
    snapshot.mode = (uint32_t)MODE_NONE;
    run_program();
    snapshot.program_step = 1U;
    pass_us(0U);
    EXPECT_BEGIN(0U, "STRING CURRENT_PROGRAM 2 ");
}

/* Between a command and its answer nothing else is sent. */
void test_SWR_PROG_016_a_step_that_is_done_waits_for_an_answer_that_is_owed(void)
{
    run_program();
    say(0U, "CMD_9", "STOP");
    EXPECT(0U, "STRING ACK_9 STOP");
    snapshot.program_step = 1U;
    pass_us(0U);
    EXPECT(0U, "");
}

void test_SWR_PROG_016_anybody_may_ask_how_far_it_is(void)
{
    say(1U, "CURRENT_PROGRAM", "");
    EXPECT(1U, "STRING CURRENT_PROGRAM 0");
    snapshot.program_steps = 3U;
    snapshot.program_crc = 4000000000U;
    snapshot.program_step = 1U;
    snapshot.program_dwelt_us = 12450000U;
    say(1U, "CMD_4", "CURRENT_PROGRAM");
    EXPECT(1U, "STRING ACK_4 CURRENT_PROGRAM");
    EXPECT(1U, "STRING CURRENT_PROGRAM 3 4000000000 1 12.4 s");
    moment.snapshot = NULL;
    say(1U, "CURRENT_PROGRAM", "");
    EXPECT_BEGIN(1U, "STATUS CURRENT_PROGRAM 7 NO_ANSWER|");
}

static void put_at(uint32_t row, uint32_t column, double value)
{
    write_double(value, &content[HEADER + (8U * ((row * array.columns) + column))]);
}

/* The two steps, and zeros behind them. */
static void make(uint32_t rows)
{
    static const double numbers[2][COLUMNS] = {{12.0, -90.0, 30.0, 1.0}, {8.5, 0.0, 0.25, 0.0}};

    array = (igtl_message_t){.kind = IGTL_KIND_ARRAY,
                             .name = "PROGRAM",
                             .content = content,
                             .rows = rows,
                             .columns = COLUMNS,
                             .number_bytes = 8U};
    for (uint32_t i = 0U; i < (2U * COLUMNS); i++) {
        put_at(i / COLUMNS, i % COLUMNS, numbers[i / COLUMNS][i % COLUMNS]);
    }
}

static void hand_in(void)
{
    workphase_dialect_receive(&dialect, 0U, &array, &moment);
    pass_us(0U);
}

void test_SWR_PROG_014_an_array_becomes_the_commands_of_its_steps_and_one_answer(void)
{
    make(2U);
    hand_in();
    expect_command(COMMAND_PROGRAM_BEGIN, 2U);
    taken();
    pass_us(0U);
    for (uint32_t i = 0U; i < 2U; i++) {
        EXPECT(0U, "");
        expect_step(i);
        taken();
        pass_us(0U);
    }
    expect_command(COMMAND_PROGRAM_END, sum_of_both());
    taken();
    EXPECT_BEGIN(0U, "STATUS PROGRAM 1 ");
    say(0U, "Text", "PROGRAM RUN");
    expect_command(COMMAND_RUN_PROGRAM, sum_of_both());
}

void test_SWR_PROG_014_a_refused_step_of_an_array_is_reported_once_with_its_index(void)
{
    make(2U);
    hand_in();
    expect_command(COMMAND_PROGRAM_BEGIN, 2U);
    taken();
    expect_step(0U);
    taken();
    expect_step(1U);
    answer_to(&command, ANSWER_REFUSED, STATUS_PROGRAM_DEPTH, 1U);
    while (igtl_requests_take(&dialect.requests, &command)) {
        answer_to(&command, ANSWER_REFUSED, STATUS_PROGRAM_ORDER, 1U);
    }
    pass_us(0U);
    const char *const reported = igtl_peer_next(&outboxes[0]);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS PROGRAM 10 ", reported, 18U);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, "|PROGRAM_DEPTH: "), reported);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, " Step 1."), reported);
    EXPECT(0U, "");
}

void test_SWR_PROG_014_numbers_that_no_step_has_are_refused_before_any_is_passed_on(void)
{
    static const struct {
        uint32_t column;
        double number;
        const char *reported;
    } cases[] = {{0U, NAN, "STATUS PROGRAM 10 NOT_FINITE|"},
                 {0U, -INFINITY, "STATUS PROGRAM 10 NOT_FINITE|"},
                 {0U, 1e300, "STATUS PROGRAM 10 OUT_OF_RANGE|"},
                 {1U, NAN, "STATUS PROGRAM 10 NOT_FINITE|"},
                 {2U, INFINITY, "STATUS PROGRAM 10 NOT_FINITE|"},
                 {2U, -0.001, "STATUS PROGRAM 10 OUT_OF_RANGE|"},
                 {2U, 0.0, "STATUS PROGRAM 10 PROGRAM_DWELL|"},
                 {3U, 0.5, "STATUS PROGRAM 10 OUT_OF_RANGE|"},
                 {3U, 2.0, "STATUS PROGRAM 10 OUT_OF_RANGE|"},
                 {3U, -1.0, "STATUS PROGRAM 10 OUT_OF_RANGE|"}};

    for (uint32_t i = 0U; i < (sizeof cases / sizeof cases[0]); i++) {
        make(2U);
        put_at(0U, cases[i].column, cases[i].number);
        hand_in();
        EXPECT_BEGIN(0U, cases[i].reported);
        EXPECT(0U, "");
        expect_no_command();
    }
}

void test_SWR_PROG_014_another_shape_is_refused(void)
{
    static const uint32_t shapes[][2] = {
        {0U, COLUMNS}, {LIMIT_PROGRAM_STEPS + 1U, COLUMNS}, {2U, COLUMNS - 1U}, {2U, COLUMNS + 1U}};

    for (uint32_t i = 0U; i < (sizeof shapes / sizeof shapes[0]); i++) {
        make(2U);
        array.rows = shapes[i][0];
        array.columns = shapes[i][1];
        hand_in();
        EXPECT_BEGIN(0U, "STATUS PROGRAM 10 OUT_OF_RANGE|");
        expect_no_command();
    }
    make(2U);
    robot.axes[turning()].needle_motion = 0U;
    hand_in();
    EXPECT_BEGIN(0U, "STATUS PROGRAM 10 OUT_OF_RANGE|");
    array.columns = COLUMNS - 1U;
    put_at(0U, 2U, 0.0); /* Where there is no angle the gate stands here. */
    put_at(1U, 0U, 1.0);
    put_at(1U, 1U, 2.0);
    put_at(1U, 2U, 1.0);
    put_at(0U, 1U, 5.0);
    hand_in();
    expect_command(COMMAND_PROGRAM_BEGIN, 2U);
    taken();
    pass_us(0U);
    expect_command(COMMAND_PROGRAM_STEP, 0U);
    TEST_ASSERT_EQUAL_UINT32(5000U, command.as.step.dwell_ms);
}

void test_SWR_IGTL_075_a_step_needs_its_units(void)
{
    static const char *const texts[] = {
        "PROGRAM STEP 0 12 90 30", "PROGRAM STEP 0 12 deg 90 mm 30 s",
        "PROGRAM STEP 0 12 mm 90 deg 30", "PROGRAM STEP 0 12 mm 90 deg 30 ms",
        "PROGRAM STEP 0 12 mm 90 30 s GATE"};

    for (size_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        say(0U, "Text", texts[i]);
        EXPECT(0U, "STATUS PROGRAM 10 WRONG_UNIT|WRONG_UNIT: Send each number with its unit: "
                   "PROGRAM STEP 0 12 mm 90 deg 30 s.");
    }
}

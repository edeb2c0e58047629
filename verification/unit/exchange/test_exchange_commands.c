/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: commands of each source reach control once and in order, and what finds no room
 * is refused or counted.
 */
#include "unit/support/commands.h"
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_segment.h"

#include "unit/support/exchange_world.h"

#include <pthread.h>

void setUp(void)
{
    exchange_world_init();
}

void tearDown(void)
{
    exchange_world_end();
}

void test_SWR_CMD_007_what_a_command_does_not_use_arrives_as_zero(void)
{
    command_t jog = {.id = 1U, .kind = COMMAND_JOG};
    const command_t expected = {
        .id = 1U, .kind = COMMAND_JOG, .as.jog = {.axis = 0x5A5A5A5AU, .to_ticks = 0x5A5A5A5A}};
    command_t taken[2];

    (void)memset(&jog.as, 0x5A, sizeof jog.as);
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &jog));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 2U));
    TEST_ASSERT_EQUAL_MEMORY(&expected.as, &taken[0].as, sizeof expected.as);
}

void test_SWR_EXCH_002_a_full_command_lane_refuses_and_keeps_what_it_has(void)
{
    command_t command = {.kind = COMMAND_WORKPHASE};
    command_t taken[EXCHANGE_COMMANDS + 1U];

    for (uint32_t i = 0U; i < EXCHANGE_COMMANDS; i++) {
        command.id = i;
        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &command));
    }
    command.id = 99U;
    TEST_ASSERT_EQUAL(STATUS_BUSY, exchange_send_command(reader, &command));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_COMMANDS,
                             exchange_take_commands(control, taken, EXCHANGE_COMMANDS + 1U));
    for (uint32_t i = 0U; i < EXCHANGE_COMMANDS; i++) {
        TEST_ASSERT_EQUAL_UINT32(i, taken[i].id);
    }
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &command));
}

void test_SWR_EXCH_002_each_source_has_a_lane_of_its_own(void)
{
    const command_t page = {.source = COMMAND_SOURCE_HTTP, .kind = COMMAND_JOG, .id = 4U};
    const command_t nobody = {.source = COMMAND_SOURCE_COUNT, .kind = COMMAND_JOG};
    const command_t connection = {.source = COMMAND_SOURCE_IGTL, .kind = COMMAND_RETRACT};
    const answer_t answer = {.source = COMMAND_SOURCE_HTTP, .id = 4U, .command = COMMAND_JOG};
    answer_t reported;
    command_t taken[2];

    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &connection));
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &page));
    TEST_ASSERT_EQUAL(STATUS_NOT_ALLOWED, exchange_send_command(reader, &nobody));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_commands(control, taken, 2U));
    TEST_ASSERT_NOT_EQUAL_UINT32(taken[0].source, taken[1].source);
    TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    TEST_ASSERT_FALSE(exchange_take_answer(reader, COMMAND_SOURCE_IGTL, &reported));
    TEST_ASSERT_TRUE(exchange_take_answer(reader, COMMAND_SOURCE_HTTP, &reported));
    TEST_ASSERT_EQUAL_UINT32(4U, reported.id);
}

void test_SWR_EXCH_002_a_full_lane_keeps_no_other_waiting(void)
{
    const command_t page = {.source = COMMAND_SOURCE_HTTP, .kind = COMMAND_JOG};
    const command_t connection = {.source = COMMAND_SOURCE_IGTL, .kind = COMMAND_TARGET};
    command_t taken[4];
    uint32_t cycles = 0U;

    while (exchange_send_command(reader, &connection) == STATUS_OK) {
    }
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &page));
    do {
        cycles++;
        TEST_ASSERT_LESS_THAN_UINT32(3U, cycles);
        (void)exchange_take_commands(control, taken, 4U);
    } while (taken[0].source != (uint32_t)COMMAND_SOURCE_HTTP);
}

void test_SWR_CTRL_021_a_cycle_takes_no_more_after_a_command_that_computes(void)
{
    static const command_kind_t costly[] = {
        COMMAND_REGISTRATION,  COMMAND_TARGET,         COMMAND_PROPOSE_REGISTRATION,
        COMMAND_PROPOSE_ENTRY, COMMAND_PROPOSE_TARGET, COMMAND_NEEDLE,
        COMMAND_ENTRY,         COMMAND_WITHDRAW,       COMMAND_WORKPHASE,
        COMMAND_LIST_ROW,      COMMAND_RUN_TRAJECTORY, COMMAND_PROGRAM_STEP,
        COMMAND_RUN_PROGRAM,   COMMAND_ALIGN,          COMMAND_INSERT,
        COMMAND_POSE};
    command_t taken[4];

    for (uint32_t i = 0U; i < (sizeof costly / sizeof costly[0]); i++) {
        const command_t cheap = {.source = COMMAND_SOURCE_IGTL, .kind = (uint32_t)COMMAND_JOG};
        const command_t dear = commands_of_number(costly[i], (uint32_t)WORKPHASE_MOVE_TO_TARGET);
        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &cheap));
        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &dear));
        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &dear));
        TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_commands(control, taken, 4U));
        TEST_ASSERT_EQUAL_UINT32(costly[i], taken[1].kind);
        TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
        TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, 4U));
    }
}

void test_SWR_CTRL_021_a_workphase_that_computes_nothing_lets_others_follow(void)
{
    const command_t cheap = {.source = COMMAND_SOURCE_IGTL,
                             .kind = (uint32_t)COMMAND_WORKPHASE,
                             .as.workphase = {.workphase = (uint32_t)WORKPHASE_TARGETING}};
    command_t taken[4];
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &cheap));
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &cheap));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_commands(control, taken, 4U));
}

void test_SWR_EXCH_021_a_lane_that_reports_nonsense_is_emptied(void)
{
    command_t taken[4];

    reader->segment->others.lanes[COMMAND_SOURCE_IGTL].head = UINT32_MAX;
    (void)exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 1U));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_lane_damages(reader, COMMAND_SOURCE_IGTL));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_lane_damages(reader, COMMAND_SOURCE_HTTP));
}

void test_SWR_EXCH_021_what_nobody_has_put_into_a_lane_is_no_command(void)
{
    const command_t jog = {.kind = COMMAND_JOG, .id = 7U};
    command_t taken[4];

    for (uint32_t i = 0U; i < (2U * SEGMENT_COMMANDS); i++) {
        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &jog));
        TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    }
    reader->segment->others.lanes[COMMAND_SOURCE_IGTL].head += 3U;
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(3U, exchange_lane_damages(reader, COMMAND_SOURCE_IGTL));
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &jog));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(7U, taken[0].id);
}

static void *send_commands(void *unused)
{
    (void)unused;
    for (uint32_t id = 0U; id < ROUNDS; id++) {
        command_t command = {
            .id = id, .kind = (uint32_t)COMMAND_JOG, .as.jog = {.to_ticks = (int32_t)id}};
        while (exchange_send_command(reader, &command) == STATUS_BUSY) {
            (void)sched_yield();
        }
    }
    return NULL;
}

void test_SWR_EXCH_002_every_command_arrives_once_and_in_order(void)
{
    pthread_t writer;
    uint32_t received = 0U;

    TEST_ASSERT_EQUAL_INT(0, pthread_create(&writer, NULL, send_commands, NULL));
    while (received < ROUNDS) {
        command_t taken[4];
        const uint32_t count = exchange_take_commands(control, taken, 4U);
        for (uint32_t i = 0U; i < count; i++) {
            TEST_ASSERT_EQUAL_UINT32(received + i, taken[i].id);
            TEST_ASSERT_EQUAL_INT32((int32_t)taken[i].id, taken[i].as.jog.to_ticks);
        }
        received += count;
    }
    (void)pthread_join(writer, NULL);
    TEST_ASSERT_EQUAL_UINT32(ROUNDS, received);
}

void test_SWR_EXCH_003_an_answer_that_finds_its_lane_full_is_counted(void)
{
    answer_t answer = {.source = COMMAND_SOURCE_IGTL};
    answer_t taken;

    for (uint32_t i = 0U; i < EXCHANGE_ANSWERS; i++) {
        answer.id = i;
        TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    }
    TEST_ASSERT_FALSE(exchange_push_answer(control, &answer));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_answers_lost(reader));
    for (uint32_t i = 0U; i < EXCHANGE_ANSWERS; i++) {
        TEST_ASSERT_TRUE(exchange_take_answer(reader, COMMAND_SOURCE_IGTL, &taken));
        TEST_ASSERT_EQUAL_UINT32(i, taken.id);
    }
    TEST_ASSERT_FALSE(exchange_take_answer(reader, COMMAND_SOURCE_IGTL, &taken));
    answer.source = COMMAND_SOURCE_COUNT;
    TEST_ASSERT_FALSE(exchange_push_answer(control, &answer));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_answers_lost(reader));
}

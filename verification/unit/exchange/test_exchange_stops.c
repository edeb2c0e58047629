/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a stop passes all commands that wait, discards those that came before it, and
 * is answered.
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

void test_SWR_EXCH_015_a_stop_in_one_lane_discards_what_waits_in_the_other(void)
{
    static const workphase_t stops[] = {WORKPHASE_STOP, WORKPHASE_EMERGENCY};
    for (uint32_t i = 0U; i < 2U; i++) {
        const command_t stop = {.kind = COMMAND_WORKPHASE, .as.workphase = {.workphase = stops[i]}};
        const command_t move = {.source = COMMAND_SOURCE_HTTP, .kind = COMMAND_RETRACT};
        answer_t reported;
        command_t taken[4];

        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &move));
        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &stop));
        TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
        TEST_ASSERT_EQUAL_UINT32(stops[i], taken[0].as.workphase.workphase);
        TEST_ASSERT_TRUE(exchange_take_answer(reader, COMMAND_SOURCE_HTTP, &reported));
        TEST_ASSERT_EQUAL_UINT32(STATUS_DISCARDED, reported.status);
        TEST_ASSERT_EQUAL_UINT32(stops[i], reported.workphase);
    }
}

void test_SWR_HTTP_030_an_emergency_that_is_requested_refuses_what_waits(void)
{
    const command_t move = {.kind = COMMAND_RETRACT};
    answer_t reported;
    command_t taken[4];

    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &move));
    (void)exchange_request_stop(reader, WORKPHASE_EMERGENCY);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_TRUE(exchange_take_answer(reader, COMMAND_SOURCE_IGTL, &reported));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, reported.workphase);
}

void test_SWR_HTTP_030_an_emergency_among_stops_is_one_for_all(void)
{
    answer_t answer = {
        .source = COMMAND_SOURCE_HTTP, .command = COMMAND_WORKPHASE, .asked = WORKPHASE_EMERGENCY};
    command_t taken[4];
    const uint32_t first = exchange_request_stop(reader, WORKPHASE_STOP);
    const uint32_t second = exchange_request_stop(reader, WORKPHASE_EMERGENCY);
    const uint32_t third = exchange_request_stop(reader, WORKPHASE_STOP);

    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, taken[0].as.workphase.workphase);
    TEST_ASSERT_EQUAL_UINT32(third, taken[0].id);
    TEST_ASSERT_EQUAL_UINT32(first + 1U, second);
    answer.id = taken[0].id;
    TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    TEST_ASSERT_TRUE(exchange_read_stop_answer(reader, first, &answer));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, answer.asked);
    (void)exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, taken[0].as.workphase.workphase);
}

void test_SWR_HTTP_008_a_stop_of_the_console_takes_no_lane(void)
{
    static const workphase_t stops[] = {WORKPHASE_STOP, WORKPHASE_EMERGENCY};
    for (uint32_t i = 0U; i < 2U; i++) {
        const command_t stop = {.source = COMMAND_SOURCE_HTTP,
                                .kind = COMMAND_WORKPHASE,
                                .as.workphase = {.workphase = stops[i]}};

        TEST_ASSERT_EQUAL(STATUS_NOT_ALLOWED, exchange_send_command(reader, &stop));
    }
}

static void fill_lane(void)
{
    const command_t command = {.kind = COMMAND_JOG};

    while (exchange_send_command(reader, &command) == STATUS_OK) {
    }
}

static void expect_stop(uint32_t number, const command_t *command)
{
    TEST_ASSERT_EQUAL_UINT32(number, command->id);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_SOURCE_HTTP, command->source);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_WORKPHASE, command->kind);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, command->as.workphase.workphase);
}

void test_SWR_HTTP_008_a_stop_passes_a_full_lane_and_is_the_last_command_of_its_cycle(void)
{
    const command_t emergency = {.kind = COMMAND_WORKPHASE,
                                 .as.workphase = {.workphase = WORKPHASE_EMERGENCY}};
    command_t taken[4];

    fill_lane();
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &emergency));
    const uint32_t number = exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, taken[0].as.workphase.workphase);
    expect_stop(number, &taken[1]);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, 4U));
}

void test_SWR_HTTP_008_a_stop_leaves_where_there_is_room_for_one_command_only(void)
{
    command_t taken;

    fill_lane();
    const uint32_t number = exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, &taken, 1U));
    expect_stop(number, &taken);
}

void test_SWR_HTTP_008_one_command_and_its_answer_serve_every_stop_requested_before(void)
{
    answer_t answer = {.source = COMMAND_SOURCE_HTTP,
                       .command = COMMAND_WORKPHASE,
                       .asked = WORKPHASE_STOP,
                       .workphase = WORKPHASE_STOP};
    answer_t read;
    command_t taken[4];
    uint32_t numbers[1000];

    for (uint32_t i = 0U; i < 1000U; i++) {
        numbers[i] = exchange_request_stop(reader, WORKPHASE_STOP);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_FALSE(exchange_read_stop_answer(reader, numbers[0], &read));
    const uint32_t late = exchange_request_stop(reader, WORKPHASE_STOP);
    answer.id = taken[0].id;
    TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    for (uint32_t i = 0U; i < 1000U; i++) {
        TEST_ASSERT_TRUE(exchange_read_stop_answer(reader, numbers[i], &read));
        TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, read.workphase);
    }
    TEST_ASSERT_FALSE(exchange_read_stop_answer(reader, late, &read));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    expect_stop(late, &taken[0]);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, 4U));
}

void test_SWR_HTTP_008_the_numbers_of_stops_may_wrap(void)
{
    answer_t answer = {
        .source = COMMAND_SOURCE_HTTP, .command = COMMAND_WORKPHASE, .asked = WORKPHASE_STOP};
    command_t taken;

    reader->segment->others.stops_requested = UINT64_MAX - SEGMENT_STOP;
    control->segment->control.stops_taken = UINT64_MAX - SEGMENT_STOP;
    const uint32_t before = exchange_request_stop(reader, WORKPHASE_STOP);
    const uint32_t after = exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(0U, after);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, &taken, 1U));
    answer.id = taken.id;
    TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    TEST_ASSERT_TRUE(exchange_read_stop_answer(reader, before, &answer));
    TEST_ASSERT_TRUE(exchange_read_stop_answer(reader, after, &answer));
    TEST_ASSERT_FALSE(exchange_read_stop_answer(reader, after + 1U, &answer));
}

static void send(uint32_t kind, uint32_t argument)
{
    command_t command = commands_of_number((command_kind_t)kind, argument);
    command.id = kind;

    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &command));
}

static void expect_refusals(uint32_t count, workphase_t workphase)
{
    answer_t answer;

    for (uint32_t i = 0U; i < count; i++) {
        TEST_ASSERT_TRUE(exchange_take_answer(reader, COMMAND_SOURCE_IGTL, &answer));
        TEST_ASSERT_EQUAL_UINT32(ANSWER_REFUSED, answer.kind);
        TEST_ASSERT_EQUAL_UINT32(STATUS_DISCARDED, answer.status);
        TEST_ASSERT_EQUAL_UINT32(1U, answer.is_final);
        TEST_ASSERT_EQUAL_UINT32(answer.command, answer.id);
        TEST_ASSERT_EQUAL_UINT32(workphase, answer.workphase);
    }
    TEST_ASSERT_FALSE(exchange_take_answer(reader, COMMAND_SOURCE_IGTL, &answer));
}

void test_SWR_EXCH_015_stop_or_emergency_behind_a_full_lane_leaves_in_the_next_cycle(void)
{
    static const workphase_t stops[] = {WORKPHASE_STOP, WORKPHASE_EMERGENCY};
    command_t taken[4];

    for (uint32_t i = 0U; i < 2U; i++) {
        for (uint32_t j = 0U; j < EXCHANGE_COMMANDS; j++) {
            send((uint32_t)COMMAND_TARGET, 0U);
        }
        send((uint32_t)COMMAND_WORKPHASE, (uint32_t)stops[i]);
        TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
        TEST_ASSERT_EQUAL_UINT32(stops[i], taken[0].as.workphase.workphase);
        TEST_ASSERT_EQUAL_UINT32(COMMAND_SOURCE_IGTL, taken[0].source);
        expect_refusals(EXCHANGE_COMMANDS, stops[i]);
    }
}

void test_SWR_EXCH_015_a_requested_stop_discards_what_came_before_it(void)
{
    command_t taken[4];

    for (uint32_t j = 0U; j < EXCHANGE_COMMANDS; j++) {
        send((uint32_t)COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    }
    const uint32_t number = exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    expect_stop(number, &taken[0]);
    expect_refusals(EXCHANGE_COMMANDS, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, 4U));
}

void test_SWR_EXCH_015_what_came_after_a_stop_follows_it(void)
{
    command_t taken[4];

    send((uint32_t)COMMAND_JOG, 0U);
    send((uint32_t)COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    send((uint32_t)COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, taken[0].as.workphase.workphase);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_PLANNING, taken[1].as.workphase.workphase);
    expect_refusals(1U, WORKPHASE_STOP);
}

/* More stops than leave in a cycle. */
void test_SWR_EXCH_015_what_came_before_a_requested_stop_never_follows_it(void)
{
    command_t taken[4];

    for (uint32_t i = 0U; i < 9U; i++) {
        send((uint32_t)COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    }
    send((uint32_t)COMMAND_WORKPHASE, (uint32_t)WORKPHASE_START_UP);
    const uint32_t number = exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(4U, exchange_take_commands(control, taken, 4U));
    expect_stop(number, &taken[3]);
    send((uint32_t)COMMAND_WORKPHASE, (uint32_t)WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL_UINT32(4U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(3U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, taken[1].as.workphase.workphase);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_PLANNING, taken[2].as.workphase.workphase);
    expect_refusals(1U, WORKPHASE_STOP);
}

void test_SWR_EXCH_015_every_stop_is_handed_over_and_none_refused_for_another(void)
{
    command_t taken[4];

    for (uint32_t i = 0U; i < (EXCHANGE_COMMANDS + EXCHANGE_STOPS); i++) {
        send((uint32_t)COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    }
    const command_t more = {.kind = COMMAND_WORKPHASE,
                            .as.workphase = {.workphase = WORKPHASE_STOP}};
    TEST_ASSERT_EQUAL(STATUS_BUSY, exchange_send_command(reader, &more));
    for (uint32_t i = 0U; i < ((EXCHANGE_COMMANDS + EXCHANGE_STOPS) / 4U); i++) {
        TEST_ASSERT_EQUAL_UINT32(4U, exchange_take_commands(control, taken, 4U));
    }
    expect_refusals(0U, WORKPHASE_STOP);
}

static void *request_stops(void *unused)
{
    (void)unused;
    for (uint32_t i = 0U; i < 50U; i++) {
        const uint32_t number = exchange_request_stop(reader, WORKPHASE_STOP);
        answer_t answer;
        while (!exchange_read_stop_answer(reader, number, &answer)) {
            (void)sched_yield();
        }
        TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, answer.workphase);
    }
    return NULL;
}

void test_SWR_HTTP_008_each_of_a_thousand_stops_of_twenty_threads_is_answered(void)
{
    pthread_t threads[20];
    command_t taken[4] = {0};

    for (uint32_t i = 0U; i < 20U; i++) {
        TEST_ASSERT_EQUAL_INT(0, pthread_create(&threads[i], NULL, request_stops, NULL));
    }
    while (taken[0].id != 1000U) {
        if (exchange_take_commands(control, taken, 4U) == 0U) {
            (void)sched_yield();
            continue;
        }
        const answer_t answer = {.id = taken[0].id,
                                 .source = taken[0].source,
                                 .command = taken[0].kind,
                                 .asked = taken[0].as.workphase.workphase,
                                 .workphase = taken[0].as.workphase.workphase};
        TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    }
    for (uint32_t i = 0U; i < 20U; i++) {
        (void)pthread_join(threads[i], NULL);
    }
}

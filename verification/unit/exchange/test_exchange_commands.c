/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: commands of each source reach control once and in order, a stop passes them all,
 * and what finds no room is refused or counted.
 */
#include "unit/support/commands.h"
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_peers.h"
#include "exchange/exchange_rows.h"
#include "exchange/exchange_segment.h"
#include "robot/robot_neuro.h"

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

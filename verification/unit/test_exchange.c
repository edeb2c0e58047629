/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: control publishes without waiting for anybody; what a reader gets is whole, and
 * what it did not get is counted or refused, never silent.
 */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_peers.h"
#include "exchange/exchange_rows.h"
#include "exchange/exchange_segment.h"
#include "robot/robot_neuro.h"

#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#define ROUNDS 20000U

static exchange_t *control; /* The creator's view. */
static exchange_t *reader;
static char name[32];
static char error[256];
static snapshot_t snapshot;
static snapshot_t copy;

void setUp(void)
{
    (void)snprintf(name, sizeof(name), "test-exchange-%d", (int)getpid());
    control = exchange_create(name, error, sizeof(error));
    TEST_ASSERT_NOT_NULL_MESSAGE(control, error);
    reader = exchange_open(name, error, sizeof(error));
    TEST_ASSERT_NOT_NULL_MESSAGE(reader, error);
    error[0] = '\0';
}

void tearDown(void)
{
    exchange_close(reader);
    exchange_close(control);
}

static void fill(snapshot_t *to, uint32_t value)
{
    uint32_t words[sizeof(snapshot_t) / sizeof(uint32_t)];

    for (size_t i = 0U; i < (sizeof(words) / sizeof(words[0])); i++) {
        words[i] = value;
    }
    (void)memcpy(to, words, sizeof(*to));
}

static bool is_whole(const snapshot_t *from)
{
    uint32_t words[sizeof(snapshot_t) / sizeof(uint32_t)];
    bool is_same = true;

    (void)memcpy(words, from, sizeof(*from));
    for (size_t i = 1U; i < (sizeof(words) / sizeof(words[0])); i++) {
        is_same = is_same && (words[i] == words[0]);
    }
    return is_same;
}

static void *publish_snapshots(void *unused)
{
    snapshot_t mine;

    (void)unused;
    for (uint32_t i = 1U; i <= ROUNDS; i++) {
        fill(&mine, i);
        exchange_publish_snapshot(control, &mine);
    }
    return NULL;
}

void test_SWR_EXCH_001_a_snapshot_read_while_another_is_written_is_never_torn(void)
{
    pthread_t writer;
    uint32_t newest = 0U;

    TEST_ASSERT_EQUAL_INT(0, pthread_create(&writer, NULL, publish_snapshots, NULL));
    while (newest < ROUNDS) {
        if (exchange_read_snapshot(reader, &copy)) {
            TEST_ASSERT_TRUE(is_whole(&copy));
            TEST_ASSERT_TRUE(copy.cycle >= newest);
            newest = copy.cycle;
        }
    }
    (void)pthread_join(writer, NULL);
    TEST_ASSERT_EQUAL_UINT32(ROUNDS, newest);
}

void test_SWR_EXCH_001_there_is_no_snapshot_before_the_first_one(void)
{
    TEST_ASSERT_FALSE(exchange_read_snapshot(reader, &copy));
    fill(&snapshot, 7U);
    exchange_publish_snapshot(control, &snapshot);
    TEST_ASSERT_TRUE(exchange_read_snapshot(reader, &copy));
    TEST_ASSERT_EQUAL_MEMORY(&snapshot, &copy, sizeof(copy));
}

void test_SWR_EXCH_001_a_writer_that_died_while_writing_leaves_the_snapshot_before_readable(void)
{
    for (uint32_t i = 1U; i <= 5U; i++) {
        fill(&snapshot, i);
        exchange_publish_snapshot(control, &snapshot);
    }
    control->segment->control.snapshots[5U % SEGMENT_SNAPSHOTS].sequence |= 1U;
    TEST_ASSERT_TRUE(exchange_read_snapshot(reader, &copy));
    TEST_ASSERT_EQUAL_UINT32(5U, copy.cycle);
}

void test_SWR_EXCH_001_a_reader_gives_up_when_the_newest_snapshot_stays_half_written(void)
{
    fill(&snapshot, 1U);
    exchange_publish_snapshot(control, &snapshot);
    control->segment->control.snapshots[0].sequence |= 1U;
    TEST_ASSERT_FALSE(exchange_read_snapshot(reader, &copy));
}

void test_SWR_EXCH_001_loop_figures_come_back_whole(void)
{
    const loop_figures_t figures = {
        .cycles = UINT64_C(5000000000), .rights = 5U, .wake_worst_us = 77U, .cycles_lost = 3U};
    loop_figures_t read = {0};

    TEST_ASSERT_FALSE(exchange_read_loop(reader, &read));
    exchange_publish_loop(control, &figures);
    TEST_ASSERT_TRUE(exchange_read_loop(reader, &read));
    TEST_ASSERT_EQUAL_MEMORY(&figures, &read, sizeof(read));
    control->segment->control.loop_sequence |= 1U;
    TEST_ASSERT_FALSE(exchange_read_loop(reader, &read));
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
    answer_t told;
    command_t taken[2];

    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &connection));
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &page));
    TEST_ASSERT_EQUAL(STATUS_NOT_ALLOWED, exchange_send_command(reader, &nobody));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_commands(control, taken, 2U));
    TEST_ASSERT_NOT_EQUAL_UINT32(taken[0].source, taken[1].source);
    TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    TEST_ASSERT_FALSE(exchange_take_answer(reader, COMMAND_SOURCE_IGTL, &told));
    TEST_ASSERT_TRUE(exchange_take_answer(reader, COMMAND_SOURCE_HTTP, &told));
    TEST_ASSERT_EQUAL_UINT32(4U, told.id);
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
        const command_t stop = {.kind = COMMAND_WORKPHASE, .argument = stops[i]};
        const command_t move = {.source = COMMAND_SOURCE_HTTP, .kind = COMMAND_RETRACT};
        answer_t told;
        command_t taken[4];

        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &move));
        TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &stop));
        TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
        TEST_ASSERT_EQUAL_UINT32(stops[i], taken[0].argument);
        TEST_ASSERT_TRUE(exchange_take_answer(reader, COMMAND_SOURCE_HTTP, &told));
        TEST_ASSERT_EQUAL_UINT32(STATUS_DISCARDED, told.status);
        TEST_ASSERT_EQUAL_UINT32(stops[i], told.workphase);
    }
}

void test_SWR_HTTP_030_an_emergency_that_is_requested_refuses_what_waits(void)
{
    const command_t move = {.kind = COMMAND_RETRACT};
    answer_t told;
    command_t taken[4];

    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &move));
    (void)exchange_request_stop(reader, WORKPHASE_EMERGENCY);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_TRUE(exchange_take_answer(reader, COMMAND_SOURCE_IGTL, &told));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, told.workphase);
}

void test_SWR_HTTP_030_an_emergency_among_stops_is_one_for_all(void)
{
    answer_t answer = {.source = COMMAND_SOURCE_HTTP,
                       .command = COMMAND_WORKPHASE,
                       .argument = WORKPHASE_EMERGENCY};
    command_t taken[4];
    const uint32_t first = exchange_request_stop(reader, WORKPHASE_STOP);
    const uint32_t second = exchange_request_stop(reader, WORKPHASE_EMERGENCY);
    const uint32_t third = exchange_request_stop(reader, WORKPHASE_STOP);

    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, taken[0].argument);
    TEST_ASSERT_EQUAL_UINT32(third, taken[0].id);
    TEST_ASSERT_EQUAL_UINT32(first + 1U, second);
    answer.id = taken[0].id;
    TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    TEST_ASSERT_TRUE(exchange_read_stop_answer(reader, first, &answer));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, answer.argument);
    (void)exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, taken[0].argument);
}

void test_SWR_HTTP_008_a_stop_of_the_console_takes_no_lane(void)
{
    static const workphase_t stops[] = {WORKPHASE_STOP, WORKPHASE_EMERGENCY};
    for (uint32_t i = 0U; i < 2U; i++) {
        const command_t stop = {
            .source = COMMAND_SOURCE_HTTP, .kind = COMMAND_WORKPHASE, .argument = stops[i]};

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
        const command_t dear = {.source = COMMAND_SOURCE_IGTL,
                                .kind = (uint32_t)costly[i],
                                .argument = (uint32_t)WORKPHASE_MOVE_TO_TARGET};
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
                             .argument = (uint32_t)WORKPHASE_TARGETING};
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
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, command->argument);
}

void test_SWR_HTTP_008_a_stop_passes_a_full_lane_and_is_the_last_command_of_its_cycle(void)
{
    const command_t emergency = {.kind = COMMAND_WORKPHASE, .argument = WORKPHASE_EMERGENCY};
    command_t taken[4];

    fill_lane();
    TEST_ASSERT_EQUAL(STATUS_OK, exchange_send_command(reader, &emergency));
    const uint32_t number = exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_commands(control, taken, 4U));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, taken[0].argument);
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
                       .argument = WORKPHASE_STOP,
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
        .source = COMMAND_SOURCE_HTTP, .command = COMMAND_WORKPHASE, .argument = WORKPHASE_STOP};
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
    const command_t command = {.id = kind, .kind = kind, .argument = argument};

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
        TEST_ASSERT_EQUAL_UINT32(stops[i], taken[0].argument);
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
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, taken[0].argument);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_PLANNING, taken[1].argument);
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
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, taken[1].argument);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_PLANNING, taken[2].argument);
    expect_refusals(1U, WORKPHASE_STOP);
}

void test_SWR_EXCH_015_every_stop_is_handed_over_and_none_refused_for_another(void)
{
    command_t taken[4];

    for (uint32_t i = 0U; i < (EXCHANGE_COMMANDS + EXCHANGE_STOPS); i++) {
        send((uint32_t)COMMAND_WORKPHASE, (uint32_t)WORKPHASE_STOP);
    }
    const command_t more = {.kind = COMMAND_WORKPHASE, .argument = WORKPHASE_STOP};
    TEST_ASSERT_EQUAL(STATUS_BUSY, exchange_send_command(reader, &more));
    for (uint32_t i = 0U; i < ((EXCHANGE_COMMANDS + EXCHANGE_STOPS) / 4U); i++) {
        TEST_ASSERT_EQUAL_UINT32(4U, exchange_take_commands(control, taken, 4U));
    }
    expect_refusals(0U, WORKPHASE_STOP);
}

void test_SWR_EXCH_015_a_lane_that_tells_nonsense_is_not_followed_out_of_it(void)
{
    command_t taken[4];

    reader->segment->others.lanes[COMMAND_SOURCE_IGTL].head = UINT32_MAX;
    (void)exchange_request_stop(reader, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 1U));
    TEST_ASSERT_EQUAL_UINT32(4U, exchange_take_commands(control, taken, 4U));
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
                                 .argument = taken[0].argument,
                                 .workphase = taken[0].argument};
        TEST_ASSERT_TRUE(exchange_push_answer(control, &answer));
    }
    for (uint32_t i = 0U; i < 20U; i++) {
        (void)pthread_join(threads[i], NULL);
    }
}

void test_SWR_LIFE_002_who_was_replaced_is_told_once(void)
{
    exchange_note_replaced(control, EXCHANGE_IGTL);
    exchange_note_replaced(control, EXCHANGE_IGTL);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_replaced(reader, EXCHANGE_HTTP));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_replaced(reader, EXCHANGE_IGTL));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_replaced(reader, EXCHANGE_IGTL));
}

void test_SWR_HTTP_007_the_port_for_stops_is_noted_for_the_next_run(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_stop_port(reader));
    exchange_note_stop_port(reader, 40000U);
    TEST_ASSERT_EQUAL_UINT32(40000U, exchange_stop_port(control));
}

static void *send_commands(void *unused)
{
    (void)unused;
    for (uint32_t id = 0U; id < ROUNDS; id++) {
        command_t command = {.id = id, .value = (int32_t)id};
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
            TEST_ASSERT_EQUAL_INT32((int32_t)taken[i].id, taken[i].value);
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

#define UTC_US UINT64_C(1790000000000000)

static void push_events(uint32_t from, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        const event_t event = {.number = from + i, .cycle = (from + i) * 3U, .value = (int32_t)i};
        exchange_push_event(control, &event, UTC_US + from + i);
    }
}

void test_SWR_EXCH_003_events_are_read_in_order_by_several_readers(void)
{
    exchange_event_t events[8];
    uint32_t first = 0U;
    uint32_t second = 0U;
    uint32_t lost = 0U;

    push_events(0U, 5U);
    TEST_ASSERT_EQUAL_UINT32(3U, exchange_read_events(reader, &first, events, 3U, &lost));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_read_events(reader, &first, events, 3U, &lost));
    TEST_ASSERT_EQUAL_UINT32(4U, events[1].event.number);
    TEST_ASSERT_EQUAL_UINT32(5U, exchange_read_events(reader, &second, events, 8U, &lost));
    TEST_ASSERT_EQUAL_UINT32(0U, events[0].event.number);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_read_events(reader, &second, events, 8U, &lost));
    TEST_ASSERT_EQUAL_UINT32(0U, lost);
}

void test_SWR_EVENT_013_an_event_is_read_with_the_time_of_its_publication(void)
{
    exchange_event_t event;
    uint32_t next = 1U;
    uint32_t lost = 0U;

    push_events(0U, 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_read_events(reader, &next, &event, 1U, &lost));
    TEST_ASSERT_EQUAL_UINT64(UTC_US + 1U, event.utc_us);
}

void test_SWR_EXCH_020_what_the_recorder_writes_is_known_to_others(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_file(reader, EXCHANGE_FILE_RECORDING));
    exchange_note_file(control, EXCHANGE_FILE_RECORDING, 7U);
    exchange_note_file(control, EXCHANGE_FILE_LOG, 8U);
    exchange_note_file(control, EXCHANGE_FILE_LOG_BEFORE, 6U);
    TEST_ASSERT_EQUAL_UINT32(7U, exchange_file(reader, EXCHANGE_FILE_RECORDING));
    TEST_ASSERT_EQUAL_UINT32(8U, exchange_file(reader, EXCHANGE_FILE_LOG));
    TEST_ASSERT_EQUAL_UINT32(6U, exchange_file(reader, EXCHANGE_FILE_LOG_BEFORE));
}

void test_SWR_EXCH_020_no_level_was_set_before_the_first(void)
{
    exchange_log_level_t level;

    TEST_ASSERT_FALSE(exchange_read_log_level(reader, &level));
}

void test_SWR_EXCH_020_a_level_hides_nothing_critical_and_no_name_writes_a_line(void)
{
    exchange_log_level_t level = {.severity = 1U, .by = "eve"};

    exchange_set_log_level(reader, &level);
    TEST_ASSERT_TRUE(exchange_read_log_level(control, &level));
    TEST_ASSERT_EQUAL_UINT32(1U, level.severity);
    TEST_ASSERT_EQUAL_STRING("eve", level.by);
    level.severity = 9U;
    (void)memset(level.by, 'x', sizeof level.by);
    level.by[1] = '\n';
    level.by[2] = '\x1b';
    exchange_set_log_level(reader, &level);
    TEST_ASSERT_TRUE(exchange_read_log_level(control, &level));
    TEST_ASSERT_EQUAL_UINT32(EVENT_SEVERITY_CRITICAL, level.severity);
    TEST_ASSERT_EQUAL_STRING("x??xxxxxxxxxxxxxxxxxxxxxxxxxxxx", level.by);
    control->segment->others.log_level_sequence |= 1U; /* It died there. */
    TEST_ASSERT_FALSE(exchange_read_log_level(control, &level));
}

void test_SWR_EXCH_003_exactly_a_full_event_ring_loses_nothing_and_one_more_loses_one(void)
{
    static exchange_event_t events[EXCHANGE_EVENTS];
    uint32_t next = 0U;
    uint32_t lost = 0U;

    push_events(0U, EXCHANGE_EVENTS);
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_EVENTS,
                             exchange_read_events(reader, &next, events, EXCHANGE_EVENTS, &lost));
    TEST_ASSERT_EQUAL_UINT32(0U, lost);
    push_events(EXCHANGE_EVENTS, EXCHANGE_EVENTS + 1U);
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_EVENTS,
                             exchange_read_events(reader, &next, events, EXCHANGE_EVENTS, &lost));
    TEST_ASSERT_EQUAL_UINT32(1U, lost);
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_EVENTS + 1U, events[0].event.number);
}

void test_SWR_EXCH_003_an_event_overwritten_while_it_is_read_counts_as_lost(void)
{
    exchange_event_t events[4];
    uint32_t next = 0U;
    uint32_t lost = 0U;

    push_events(0U, 3U);
    control->segment->control.events[1].sequence |= 1U;
    control->segment->control.events[2].event.event.number = 2U + EXCHANGE_EVENTS;
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_read_events(reader, &next, events, 4U, &lost));
    TEST_ASSERT_EQUAL_UINT32(2U, lost);
    TEST_ASSERT_EQUAL_UINT32(3U, next);
}

void test_SWR_EXCH_003_a_reader_ahead_of_the_ring_gets_nothing(void)
{
    exchange_event_t events[4];
    uint32_t next = 10U;
    uint32_t lost = 0U;

    push_events(0U, 3U);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_read_events(reader, &next, events, 4U, &lost));
    TEST_ASSERT_EQUAL_UINT32(0U, lost);
}

static void *push_many_events(void *unused)
{
    (void)unused;
    push_events(0U, ROUNDS);
    return NULL;
}

void test_SWR_EXCH_003_each_event_is_either_read_or_counted_as_lost(void)
{
    pthread_t writer;
    uint32_t next = 0U;
    uint32_t lost = 0U;
    uint32_t received = 0U;

    TEST_ASSERT_EQUAL_INT(0, pthread_create(&writer, NULL, push_many_events, NULL));
    while (next < ROUNDS) {
        exchange_event_t events[16];
        const uint32_t count = exchange_read_events(reader, &next, events, 16U, &lost);
        for (uint32_t i = 0U; i < count; i++) {
            TEST_ASSERT_EQUAL_UINT32(events[i].event.number * 3U, events[i].event.cycle);
        }
        received += count;
    }
    (void)pthread_join(writer, NULL);
    TEST_ASSERT_EQUAL_UINT32(ROUNDS, received + lost);
}

static bool push_cycle(uint32_t cycle)
{
    cycle_record_t *record = exchange_reserve_cycle(control);

    if (record == NULL) {
        return false;
    }
    record->kind = CYCLE_RECORD_CYCLE;
    record->cycle = cycle;
    (void)memset(&record->body, (int)(cycle & 0xFFU), sizeof(record->body));
    exchange_commit_cycle(control);
    return true;
}

void test_SWR_EXCH_003_cycles_that_find_the_lane_full_are_counted_and_control_goes_on(void)
{
    for (uint32_t i = 0U; i < EXCHANGE_CYCLES; i++) {
        TEST_ASSERT_TRUE(push_cycle(i));
    }
    TEST_ASSERT_FALSE(push_cycle(EXCHANGE_CYCLES));
    TEST_ASSERT_FALSE(push_cycle(EXCHANGE_CYCLES + 1U));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_cycles_lost(reader));
    for (uint32_t i = 0U; i < EXCHANGE_CYCLES; i++) {
        const cycle_record_t *record = exchange_peek_cycle(reader);
        TEST_ASSERT_NOT_NULL(record);
        TEST_ASSERT_EQUAL_UINT32(i, record->cycle);
        exchange_release_cycle(reader);
    }
    TEST_ASSERT_NULL(exchange_peek_cycle(reader));
    TEST_ASSERT_TRUE(push_cycle(EXCHANGE_CYCLES + 2U));
}

static void *push_cycles(void *unused)
{
    (void)unused;
    for (uint32_t i = 0U; i < ROUNDS; i++) {
        (void)push_cycle(i);
    }
    return NULL;
}

void test_SWR_EXCH_003_each_cycle_is_either_read_whole_or_counted(void)
{
    pthread_t writer;
    uint32_t received = 0U;

    TEST_ASSERT_EQUAL_INT(0, pthread_create(&writer, NULL, push_cycles, NULL));
    while ((received + exchange_cycles_lost(reader)) < ROUNDS) {
        const cycle_record_t *record = exchange_peek_cycle(reader);
        if (record != NULL) {
            TEST_ASSERT_EQUAL_HEX8_MESSAGE(record->cycle & 0xFFU, record->body.checkpoint[0],
                                           "first byte");
            TEST_ASSERT_EQUAL_HEX8_MESSAGE(
                record->cycle & 0xFFU,
                record->body.checkpoint[sizeof(record->body.checkpoint) - 1U], "last byte");
            exchange_release_cycle(reader);
            received++;
        } else {
            (void)sched_yield();
        }
    }
    (void)pthread_join(writer, NULL);
    TEST_ASSERT_EQUAL_UINT32(ROUNDS, received + exchange_cycles_lost(reader));
}

static controller_t controller;
static controller_outputs_t outputs;
static cycle_record_t checkpoint;
static trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];

/* A cycle in which the list has got so many rows, of a list that was begun in it or before. */
static void come(uint32_t count, bool is_begun)
{
    for (uint32_t i = controller.mode.list.count; i < count; i++) {
        controller.rows[i].time_ms++;
        controller.rows[i].crc = i;
    }
    controller.mode.list.count = count;
    outputs.answer_count = 2U;
    outputs.answers[0] = (answer_t){.command = COMMAND_LIST_ROW, .kind = ANSWER_ACCEPTED};
    outputs.answers[1] = (answer_t){.command = is_begun ? COMMAND_LIST_BEGIN : COMMAND_LIST_ROW,
                                    .kind = ANSWER_ACCEPTED};
    exchange_publish_rows(control, &controller, &outputs);
}

void test_SWR_TRAJ_018_of_rows_that_wait_one_is_taken_in_a_cycle(void)
{
    const command_t sent = {.source = (uint32_t)COMMAND_SOURCE_HTTP, .kind = COMMAND_LIST_ROW};
    command_t taken[4];

    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, exchange_send_command(reader, &sent));
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, 4U));
}

void test_SWR_TRAJ_016_rows_are_there_for_any_checkpoint_after_they_have_come(void)
{
    come(2U, true);
    come(LIMIT_TRAJECTORY_ROWS, false);
    exchange_note_rows(control, &checkpoint);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_TRAJECTORY_ROWS, checkpoint.rows);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows));
    TEST_ASSERT_EQUAL_MEMORY(controller.rows, rows, sizeof rows);
}

void test_SWR_TRAJ_016_what_has_come_is_not_looked_at_again(void)
{
    come(3U, true);
    controller.rows[1].crc = 77U; /* Damage is no row that has come. */
    come(4U, false);
    exchange_note_rows(control, &checkpoint);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows));
    TEST_ASSERT_EQUAL_UINT32(1U, rows[1].crc);
    TEST_ASSERT_EQUAL_UINT32(3U, rows[3].crc);
}

void test_SWR_TRAJ_016_of_a_list_that_is_replaced_there_are_none_any_more(void)
{
    come(3U, true);
    exchange_note_rows(control, &checkpoint);
    come(5U, false);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows)); /* It has only grown. */
    controller.mode.list.count = 0U;
    come(4U, true);
    TEST_ASSERT_FALSE(exchange_read_rows(reader, &checkpoint, rows));
    exchange_note_rows(control, &checkpoint);
    TEST_ASSERT_EQUAL_UINT32(4U, checkpoint.rows);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows));
    TEST_ASSERT_EQUAL_MEMORY(controller.rows, rows, 4U * sizeof rows[0]);
}

void test_SWR_TRAJ_016_a_list_that_is_lost_or_damaged_has_none(void)
{
    come(3U, true);
    exchange_note_rows(control, &checkpoint);
    controller.mode.list.count = UINT32_MAX;
    outputs.answer_count = 0U;
    exchange_publish_rows(control, &controller, &outputs);
    TEST_ASSERT_FALSE(exchange_read_rows(reader, &checkpoint, rows));
    exchange_note_rows(control, &checkpoint);
    TEST_ASSERT_EQUAL_UINT32(0U, checkpoint.rows);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows));
    checkpoint.rows = LIMIT_TRAJECTORY_ROWS + 1U;
    TEST_ASSERT_FALSE(exchange_read_rows(reader, &checkpoint, rows));
    controller.mode.list.count = 0U;
}

void test_SWR_MODE_004_where_a_trajectory_begins_is_read_while_there_is_one(void)
{
    trajectory_row_t start;
    controller.mode.list.count = 0U;
    come(2U, true);
    TEST_ASSERT_TRUE(exchange_read_start(reader, &start));
    TEST_ASSERT_EQUAL_MEMORY(&controller.rows[0], &start, sizeof start);
    controller.mode.list.count = 0U;
    outputs.answer_count = 0U;
    exchange_publish_rows(control, &controller, &outputs);
    TEST_ASSERT_FALSE(exchange_read_start(reader, &start));
}

void test_SWR_EXCH_003_a_checkpoint_request_is_taken_once(void)
{
    TEST_ASSERT_FALSE(exchange_take_checkpoint_request(control));
    exchange_request_checkpoint(reader);
    exchange_request_checkpoint(reader);
    TEST_ASSERT_TRUE(exchange_take_checkpoint_request(control));
    TEST_ASSERT_FALSE(exchange_take_checkpoint_request(control));
}

void test_SWR_EXCH_003_each_process_beats_its_own_counter(void)
{
    exchange_beat(reader, EXCHANGE_HTTP);
    exchange_beat(reader, EXCHANGE_HTTP);
    exchange_beat(control, EXCHANGE_CONTROL);
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_beats(control, EXCHANGE_HTTP));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_beats(reader, EXCHANGE_CONTROL));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_beats(reader, EXCHANGE_SUPERVISOR));
}

void test_SWR_EXCH_003_a_protected_reader_cannot_write_what_control_writes(void)
{
    const pid_t child = fork();
    int status = 0;

    if (child == 0) {
        exchange_protect(reader);
        exchange_beat(reader, EXCHANGE_IGTL);
        exchange_publish_snapshot(reader, &snapshot); /* Ends this process. */
        _exit(0);
    }
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_beats(control, EXCHANGE_IGTL));
    TEST_ASSERT_FALSE(WIFEXITED(status) && (WEXITSTATUS(status) == 0));
    TEST_ASSERT_FALSE(exchange_read_snapshot(control, &copy));
}

static void expect_refusal(const char *because)
{
    TEST_ASSERT_NULL(exchange_open(name, error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, because), error);
}

void test_SWR_EXCH_004_a_segment_of_another_layout_is_refused(void)
{
    control->segment->header.layout++;
    expect_refusal("layout of another build");
    control->segment->header.layout--;
    exchange_t *again = exchange_open(name, error, sizeof(error));
    TEST_ASSERT_NOT_NULL(again);
    exchange_close(again);
}

void test_SWR_EXCH_004_a_segment_of_another_size_is_refused(void)
{
    TEST_ASSERT_EQUAL_INT(0, ftruncate(control->file, (off_t)sizeof(segment_t) + 1));
    expect_refusal("size of another build");
}

void test_SWR_EXCH_004_a_segment_that_is_not_an_exchange_is_refused(void)
{
    control->segment->header.magic = 0U;
    expect_refusal("is not an exchange");
}

void test_SWR_EXCH_004_a_missing_segment_is_refused_with_what_to_do(void)
{
    TEST_ASSERT_NULL(exchange_open("test-exchange-missing", error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "start the program boresight"), error);
    TEST_ASSERT_NULL(exchange_open("a/b", error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "cannot name an exchange"), error);
    TEST_ASSERT_NULL(exchange_create("", error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "cannot name an exchange"), error);
}

void test_SWR_EXCH_004_the_segment_of_a_living_creator_is_not_replaced(void)
{
    TEST_ASSERT_NULL(exchange_create(name, error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "already runs"), error);
}

void test_SWR_EXCH_004_the_segment_of_a_dead_creator_is_replaced(void)
{
    char second[48];
    int status = 0;

    (void)snprintf(second, sizeof(second), "%s-second", name);
    const pid_t child = fork();
    if (child == 0) {
        exchange_t *dying = exchange_create(second, error, sizeof(error));
        exchange_publish_snapshot(dying, &snapshot);
        _exit(0);
    }
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    TEST_ASSERT_EQUAL_INT(0, status);
    exchange_t *successor = exchange_create(second, error, sizeof(error));
    TEST_ASSERT_NOT_NULL_MESSAGE(successor, error);
    TEST_ASSERT_FALSE(exchange_read_snapshot(successor, &copy));
    exchange_close(successor);
}

void test_SWR_ROBOT_015_readers_see_the_robot_that_control_drives(void)
{
    const robot_t *const seen = exchange_robot(reader);
    TEST_ASSERT_EQUAL_UINT32(0U, seen->axis_count);
    exchange_publish_robot(control, &robot_neuro);
    TEST_ASSERT_EQUAL_MEMORY(&robot_neuro, seen, sizeof *seen);
}

void test_SWR_ROBOT_015_no_reader_can_change_the_robot(void)
{
    exchange_publish_robot(control, &robot_neuro);
    const pid_t child = fork();
    if (child == 0) {
        exchange_protect(reader);
        exchange_publish_robot(reader, &robot_neuro); /* Ends this process. */
        _exit(0);
    }
    int status = 0;
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    TEST_ASSERT_FALSE(WIFEXITED(status) && (WEXITSTATUS(status) == 0));
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, exchange_robot(control)->axis_count);
}

void test_SWR_EXCH_019_the_last_notes_are_kept(void)
{
    exchange_note_t note;

    TEST_ASSERT_FALSE(exchange_read_note(control, 0U, &note));
    TEST_ASSERT_FALSE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_newest_note(control));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_write_note(reader, NOTE_LOGIN, "anna", "logged in."));
    TEST_ASSERT_TRUE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_EQUAL_UINT32(NOTE_LOGIN, note.kind);
    TEST_ASSERT_EQUAL_STRING("anna", note.who);
    TEST_ASSERT_EQUAL_STRING("logged in.", note.text);
    for (uint32_t i = 1U; i < LIMIT_NOTES_KEPT; i++) {
        TEST_ASSERT_EQUAL_UINT32(i + 1U, exchange_write_note(reader, NOTE_LOGOUT, "b", "c"));
    }
    TEST_ASSERT_TRUE(exchange_read_note(control, 1U, &note));
    (void)exchange_write_note(reader, NOTE_LOGOUT, "b", "c");
    TEST_ASSERT_FALSE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_TRUE(exchange_read_note(control, LIMIT_NOTES_KEPT + 1U, &note));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_NOTES_KEPT + 1U, exchange_newest_note(control));
}

void test_SWR_EXCH_019_a_note_has_its_ends_and_no_control_characters(void)
{
    char letters[300];
    exchange_note_t note;

    (void)memset(letters, 'x', sizeof letters - 1U);
    letters[sizeof letters - 1U] = '\0';
    (void)exchange_write_note(reader, NOTE_OPERATOR, letters, letters);
    TEST_ASSERT_TRUE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_EQUAL_size_t(EXCHANGE_NOTE_WHO_SIZE - 1U, strlen(note.who));
    TEST_ASSERT_EQUAL_size_t(EXCHANGE_NOTE_TEXT_SIZE - 1U, strlen(note.text));
    (void)exchange_write_note(reader, NOTE_OPERATOR, "a\nb", "\x1b[2J\x7f\xc3\xa4\r\n");
    TEST_ASSERT_TRUE(exchange_read_note(control, 2U, &note));
    TEST_ASSERT_EQUAL_STRING("a b", note.who);
    TEST_ASSERT_EQUAL_STRING(" [2J \xc3\xa4  ", note.text);
}

void test_SWR_EXCH_019_what_is_not_whole_is_not_handed_over(void)
{
    segment_note_t *slot = &reader->segment->others.notes[1];
    exchange_note_t note;

    (void)exchange_write_note(reader, NOTE_LOGIN, "anna", "logged in.");
    slot->sequence++;
    TEST_ASSERT_FALSE(exchange_read_note(control, 1U, &note));
    slot->sequence++;
    slot->note.kind = NOTE_KIND_COUNT;
    TEST_ASSERT_FALSE(exchange_read_note(control, 1U, &note));
}

void test_SWR_EVENT_010_an_event_is_told_in_the_words_of_its_note(void)
{
    char text[256];
    event_t event = {.id = EVENT_NOTE, .subject = NOTE_LOGIN, .value = 1};

    TEST_ASSERT_FALSE(exchange_tell_note(control, &event, text, sizeof text));
    (void)exchange_write_note(reader, NOTE_LOGIN, "anna", "logged in as operator.");
    (void)exchange_write_note(reader, NOTE_LOGIN_REFUSED, "?", "was refused.");
    (void)exchange_write_note(reader, NOTE_OPERATOR, "anna", "logged out.");
    TEST_ASSERT_TRUE(exchange_tell_note(control, &event, text, sizeof text));
    TEST_ASSERT_EQUAL_STRING("anna: logged in as operator.", text);
    event = (event_t){.id = EVENT_LOGIN_REFUSED, .subject = NOTE_LOGIN_REFUSED, .value = 2};
    TEST_ASSERT_TRUE(exchange_tell_note(control, &event, text, sizeof text));
    TEST_ASSERT_EQUAL_STRING("?: was refused.", text);
    event = (event_t){.id = EVENT_NOTE, .subject = NOTE_OPERATOR, .value = 3};
    TEST_ASSERT_TRUE(exchange_tell_note(control, &event, text, sizeof text));
    TEST_ASSERT_EQUAL_STRING("Note of anna: logged out.", text);
    event.subject = (uint32_t)NOTE_LOGOUT;
    TEST_ASSERT_FALSE(exchange_tell_note(control, &event, text, sizeof text));
    event = (event_t){.id = EVENT_AXIS_HOMED, .subject = NOTE_OPERATOR, .value = 3};
    TEST_ASSERT_FALSE(exchange_tell_note(control, &event, text, sizeof text));
}

void test_SWR_IGTL_028_ports_are_read_as_they_were_published(void)
{
    exchange_ports_t ports = {.count = 1U, .ports = {{.name = "slicer", .state = 2U}}};
    exchange_ports_t read;

    TEST_ASSERT_FALSE(exchange_read_ports(reader, &read));
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_TRUE(exchange_read_ports(reader, &read));
    TEST_ASSERT_EQUAL_MEMORY(&ports, &read, sizeof ports);
}

void test_SWR_IGTL_028_damaged_ports_are_not_shown(void)
{
    exchange_ports_t ports = {.count = EXCHANGE_PORTS};
    exchange_ports_t read;

    (void)memset(ports.ports[1].name, 'x', sizeof ports.ports[1].name);
    (void)memset(ports.ports[1].trouble, 'x', sizeof ports.ports[1].trouble);
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_TRUE(exchange_read_ports(reader, &read));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PORT_NAME_SIZE - 1U, strlen(read.ports[1].name));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PORT_TROUBLE_SIZE - 1U, strlen(read.ports[1].trouble));
    ports.ports[3].state = EXCHANGE_PORT_STATES;
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_FALSE(exchange_read_ports(reader, &read));
    ports.ports[3].state = 0U;
    ports.ports[3].dialect = EXCHANGE_DIALECTS;
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_FALSE(exchange_read_ports(reader, &read));
    ports.ports[3].dialect = 0U;
    ports.count = EXCHANGE_PORTS + 1U;
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_FALSE(exchange_read_ports(reader, &read));
}

static exchange_peers_t peers;
static exchange_peers_t read_peers;

static void have_one_peer(uint32_t number, const char *port, const char *peer_name)
{
    (void)memset(&peers, 0, sizeof peers);
    peers.count = 1U;
    peers.peers[0].number = number;
    (void)snprintf(peers.peers[0].port, sizeof peers.peers[0].port, "%s", port);
    (void)snprintf(peers.peers[0].name, sizeof peers.peers[0].name, "%s", peer_name);
}

void test_SWR_EXCH_016_peers_are_read_as_their_process_wrote_them(void)
{
    TEST_ASSERT_FALSE(exchange_read_peers(reader, COMMAND_SOURCE_IGTL, &read_peers));
    have_one_peer(21U, "brp", "127.0.0.1:53212");
    exchange_publish_peers(control, COMMAND_SOURCE_IGTL, &peers);
    TEST_ASSERT_TRUE(exchange_read_peers(reader, COMMAND_SOURCE_IGTL, &read_peers));
    TEST_ASSERT_EQUAL_MEMORY(&peers, &read_peers, sizeof peers);
    TEST_ASSERT_FALSE(exchange_read_peers(reader, COMMAND_SOURCE_HTTP, &read_peers));
}

static void check_damaged(uint32_t *number, uint32_t value)
{
    const uint32_t good = *number;

    *number = value;
    exchange_publish_peers(control, COMMAND_SOURCE_HTTP, &peers);
    TEST_ASSERT_FALSE(exchange_read_peers(reader, COMMAND_SOURCE_HTTP, &read_peers));
    *number = good;
}

void test_SWR_EXCH_016_damaged_peers_are_not_shown(void)
{
    have_one_peer(1U, "", "anna");
    check_damaged(&peers.count, EXCHANGE_PEERS + 1U);
    check_damaged(&peers.peers[47].dialect, EXCHANGE_DIALECTS);
    check_damaged(&peers.peers[47].is_waiting, 2U);
    check_damaged(&peers.peers[47].is_kept_alive, 2U);
    (void)memset(peers.peers[0].name, 'x', sizeof peers.peers[0].name);
    (void)memset(peers.peers[0].port, 'x', sizeof peers.peers[0].port);
    (void)memset(peers.peers[0].message, 'x', sizeof peers.peers[0].message);
    exchange_publish_peers(control, COMMAND_SOURCE_HTTP, &peers);
    TEST_ASSERT_TRUE(exchange_read_peers(reader, COMMAND_SOURCE_HTTP, &read_peers));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PEER_NAME_SIZE - 1U, strlen(read_peers.peers[0].name));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PORT_NAME_SIZE - 1U, strlen(read_peers.peers[0].port));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PEER_MESSAGE_SIZE - 1U, strlen(read_peers.peers[0].message));
}

void test_SWR_EXCH_016_peers_that_were_half_written_are_not_shown(void)
{
    have_one_peer(1U, "", "anna");
    exchange_publish_peers(control, COMMAND_SOURCE_HTTP, &peers);
    control->segment->others.peers[COMMAND_SOURCE_HTTP].sequence++;
    TEST_ASSERT_FALSE(exchange_read_peers(reader, COMMAND_SOURCE_HTTP, &read_peers));
}

void test_SWR_EXCH_018_an_order_is_taken_once_and_its_answer_comes_back(void)
{
    const exchange_order_t order = {.kind = 1U, .number = 21U, .is_on = 1U};
    exchange_order_t taken;
    status_t status = STATUS_BUSY;

    TEST_ASSERT_FALSE(exchange_take_order(reader, &taken));
    const uint32_t first = exchange_give_order(control, &order);
    TEST_ASSERT_FALSE(exchange_read_order_answer(control, first, &status));
    TEST_ASSERT_TRUE(exchange_take_order(reader, &taken));
    TEST_ASSERT_EQUAL_UINT32(1U, taken.kind);
    TEST_ASSERT_EQUAL_UINT32(21U, taken.number);
    TEST_ASSERT_EQUAL_UINT32(1U, taken.is_on);
    exchange_answer_order(reader, &taken, STATUS_OK);
    TEST_ASSERT_FALSE(exchange_take_order(reader, &taken));
    TEST_ASSERT_TRUE(exchange_read_order_answer(control, first, &status));
    TEST_ASSERT_EQUAL_INT(STATUS_OK, status);
    const uint32_t second = exchange_give_order(control, &order);
    TEST_ASSERT_FALSE(exchange_read_order_answer(control, second, &status));
    TEST_ASSERT_TRUE(exchange_take_order(reader, &taken));
    TEST_ASSERT_EQUAL_UINT32(second, taken.id);
}

void test_SWR_EXCH_018_a_newer_order_is_answered_by_itself(void)
{
    const exchange_order_t order = {.number = 21U};
    exchange_order_t taken;
    status_t status;

    (void)exchange_give_order(control, &order);
    TEST_ASSERT_TRUE(exchange_take_order(reader, &taken));
    const uint32_t second = exchange_give_order(control, &order);
    exchange_answer_order(reader, &taken, STATUS_OK);
    TEST_ASSERT_FALSE(exchange_read_order_answer(control, second, &status));
    TEST_ASSERT_TRUE(exchange_take_order(reader, &taken));
}

void test_SWR_EXCH_018_a_damaged_order_is_not_taken(void)
{
    exchange_order_t order = {.kind = 2U};
    exchange_order_t taken;

    (void)exchange_give_order(control, &order);
    TEST_ASSERT_FALSE(exchange_take_order(reader, &taken));
    order = (exchange_order_t){.is_on = 2U};
    (void)exchange_give_order(control, &order);
    TEST_ASSERT_FALSE(exchange_take_order(reader, &taken));
}

static void check_title(const char *expected, command_source_t source, uint32_t number)
{
    char title[EXCHANGE_TITLE_SIZE];

    exchange_title(reader, source, number, title);
    TEST_ASSERT_EQUAL_STRING(expected, title);
}

void test_SWR_EXCH_017_a_peer_is_called_by_its_port_and_address_or_its_account(void)
{
    have_one_peer(21U, "brp", "127.0.0.1:53212");
    exchange_publish_peers(control, COMMAND_SOURCE_IGTL, &peers);
    have_one_peer(4000000000U, "", "anna");
    exchange_publish_peers(control, COMMAND_SOURCE_HTTP, &peers);
    check_title("brp 127.0.0.1:53212", COMMAND_SOURCE_IGTL, 21U);
    check_title("page of anna", COMMAND_SOURCE_HTTP, 4000000000U);
}

void test_SWR_EXCH_017_who_is_not_in_the_table_is_called_by_its_number(void)
{
    check_title("connection 21", COMMAND_SOURCE_IGTL, 21U);
    have_one_peer(31U, "brp", "127.0.0.1:53212");
    exchange_publish_peers(control, COMMAND_SOURCE_IGTL, &peers);
    check_title("connection 21", COMMAND_SOURCE_IGTL, 21U);
    check_title("page 7", COMMAND_SOURCE_HTTP, 7U);
}

static long faults(void)
{
    struct rusage usage;

    (void)getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_minflt;
}

/* The creator has written each page; the other view has touched none. */
void test_SWR_ARM_007_pages_that_were_touched_are_as_they_were_and_written_without_a_fault(void)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    uint8_t *const ours = (uint8_t *)&control->segment->control;
    volatile uint8_t *const theirs = (volatile uint8_t *)&reader->segment->control;

    for (size_t at = 0U; at < sizeof(segment_control_t); at += page) {
        ours[at] = (uint8_t)((at / page) % 251U);
    }
    exchange_touch(reader);
    const long before = faults();
    for (size_t at = 0U; at < sizeof(segment_control_t); at += page) {
        TEST_ASSERT_EQUAL_UINT8((at / page) % 251U, theirs[at]);
        theirs[at] = 0U;
    }
    TEST_ASSERT_EQUAL_INT64(before, faults());
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: each cycle is handed over once and whole, whatever the capacity of the lane and
 * however often its indices wrap, until a reader has it in a file; what a neighbour writes into the
 * indices is set right.
 */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_segment.h"
#include "limits/requirement_limits.h"

#include "unit/support/exchange_world.h"

#include <pthread.h>
#include <sched.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static cycle_record_t record;
static controller_t controller;

void setUp(void)
{
    uint32_t dropped = 0U;

    exchange_world_init();
    TEST_ASSERT_FALSE(exchange_repair_cycles(reader, &dropped));
}

void tearDown(void)
{
    exchange_world_end();
}

static bool push(uint32_t cycle)
{
    cycle_entry_t *const entry = exchange_reserve_cycle(control);

    if (entry == NULL) {
        return false;
    }
    entry->kind = CYCLE_RECORD_CYCLE;
    entry->cycle = cycle;
    (void)memset(&entry->body, (int)(cycle & 0xFFU), sizeof entry->body);
    exchange_commit_cycle(control);
    return true;
}

static void release(void)
{
    exchange_release_cycles(reader, exchange_cycles_taken(reader));
}

static void expect(uint32_t cycle)
{
    TEST_ASSERT_TRUE(exchange_take_cycle(reader, &record));
    TEST_ASSERT_EQUAL_UINT32(CYCLE_RECORD_CYCLE, record.kind);
    TEST_ASSERT_EQUAL_UINT32(cycle, record.cycle);
    TEST_ASSERT_EQUAL_HEX8(cycle & 0xFFU, record.body.checkpoint[0]);
    TEST_ASSERT_EQUAL_HEX8(cycle & 0xFFU, record.body.checkpoint[sizeof(recorded_cycle_t) - 1U]);
}

void test_SWR_EXCH_003_exactly_a_full_lane_loses_nothing_and_one_more_finds_no_room(void)
{
    for (uint32_t i = 0U; i < LANE; i++) {
        TEST_ASSERT_EQUAL_UINT32(LANE - i, exchange_cycle_room(control));
        TEST_ASSERT_TRUE(push(i));
    }
    TEST_ASSERT_FALSE(push(LANE));
    for (uint32_t i = 0U; i < LANE; i++) {
        expect(i);
    }
    TEST_ASSERT_FALSE(exchange_take_cycle(reader, &record));
    TEST_ASSERT_FALSE(push(LANE)); /* They are in no file yet. */
    release();
    TEST_ASSERT_TRUE(push(LANE));
    expect(LANE);
}

void test_SWR_EXCH_003_indices_wrap_at_any_capacity(void)
{
    for (uint32_t i = 0U; i < (5U * LANE); i++) {
        TEST_ASSERT_TRUE(push(2U * i));
        TEST_ASSERT_TRUE(push((2U * i) + 1U));
        expect(2U * i);
        expect((2U * i) + 1U);
        release();
        TEST_ASSERT_EQUAL_UINT32(LANE, exchange_cycle_room(control));
    }
}

static void *push_all(void *unused)
{
    (void)unused;
    for (uint32_t i = 0U; i < ROUNDS; i++) {
        while (!push(i)) {
            (void)sched_yield();
        }
    }
    return NULL;
}

void test_SWR_EXCH_003_each_cycle_is_read_whole_and_in_order(void)
{
    pthread_t writer;

    TEST_ASSERT_EQUAL_INT(0, pthread_create(&writer, NULL, push_all, NULL));
    for (uint32_t cycle = 0U; cycle < ROUNDS;) {
        if (exchange_take_cycle(reader, &record)) {
            TEST_ASSERT_EQUAL_UINT32(cycle, record.cycle);
            TEST_ASSERT_EQUAL_HEX8(cycle & 0xFFU,
                                   record.body.checkpoint[sizeof(recorded_cycle_t) - 1U]);
            cycle++;
            release();
        } else {
            (void)sched_yield();
        }
    }
    (void)pthread_join(writer, NULL);
}

void test_SWR_TRAJ_017_a_checkpoint_comes_whole_or_not_at_all(void)
{
    uint8_t *const bytes = (uint8_t *)&controller;

    for (size_t i = 0U; i < CONTROLLER_CHECKPOINT_BYTES; i++) {
        bytes[i] = (uint8_t)(i % 251U);
    }
    for (uint32_t i = 0U; i < (LANE - EXCHANGE_CHECKPOINT_ENTRIES); i++) {
        TEST_ASSERT_TRUE(push(i));
    }
    TEST_ASSERT_TRUE(exchange_push_checkpoint(control, &controller));
    TEST_ASSERT_FALSE(exchange_push_checkpoint(control, &controller));
    for (uint32_t i = 0U; i < (LANE - EXCHANGE_CHECKPOINT_ENTRIES); i++) {
        expect(i);
    }
    TEST_ASSERT_TRUE(exchange_take_cycle(reader, &record));
    TEST_ASSERT_EQUAL_UINT32(CYCLE_RECORD_CHECKPOINT, record.kind);
    TEST_ASSERT_EQUAL_UINT32(controller.sealed.cycle, record.cycle);
    TEST_ASSERT_EQUAL_MEMORY(&controller, record.body.checkpoint, CONTROLLER_CHECKPOINT_BYTES);
    TEST_ASSERT_FALSE(exchange_take_cycle(reader, &record));
}

void test_SWR_REC_020_the_least_lane_of_a_board_holds_five_seconds_and_what_is_not_written(void)
{
    const uint32_t second = 1000000U / LIMIT_CYCLE_US;

    TEST_ASSERT_GREATER_OR_EQUAL_UINT32((LIMIT_RECORDER_PAUSE_US / LIMIT_CYCLE_US) + second,
                                        exchange_cycles_in(LIMIT_CYCLE_LANE_MB));
}

void test_SWR_REC_023_a_recorder_that_is_started_again_gets_what_was_not_released(void)
{
    uint32_t dropped = 0U;

    TEST_ASSERT_TRUE(push(7U));
    TEST_ASSERT_TRUE(push(8U));
    expect(7U);
    release();
    expect(8U);
    exchange_close(reader);
    reader = exchange_open(exchange_name, error, sizeof error);
    TEST_ASSERT_FALSE(exchange_repair_cycles(reader, &dropped));
    expect(8U);
}

static const uint32_t damage[] = {0U,          1U,         37U,        LANE - 1U,
                                  LANE,        LANE + 50U, 2U * LANE,  2U * LANE + 1U,
                                  4294965248U, INT32_MAX,  UINT32_MAX, 0x80000000U};

void test_SWR_EXCH_025_a_damaged_index_of_the_reader_costs_nothing(void)
{
    for (size_t i = 0U; i < (sizeof damage / sizeof damage[0]); i++) {
        uint32_t dropped = 0U;
        const uint32_t first = 10U * (uint32_t)i;
        for (uint32_t j = 0U; j < 5U; j++) {
            TEST_ASSERT_TRUE(push(first + j));
        }
        const uint32_t sound = control->segment->recorder.cycles_tail;
        reader->segment->recorder.cycles_tail = damage[i];
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(LANE, exchange_cycle_room(control));
        TEST_ASSERT_EQUAL(damage[i] != sound, exchange_repair_cycles(reader, &dropped));
        TEST_ASSERT_FALSE(exchange_repair_cycles(reader, &dropped)); /* Said once. */
        TEST_ASSERT_EQUAL_UINT32(0U, dropped);
        TEST_ASSERT_EQUAL_UINT32(LANE - 5U, exchange_cycle_room(control));
        for (uint32_t j = 0U; j < 5U; j++) {
            expect(first + j);
        }
        release();
    }
}

/* Ahead of control, by so much, or no index. */
static const uint32_t beyond[] = {1U, 50U, LANE - 1U, 2U * LANE, 4294965248U, UINT32_MAX};

static void damage_ahead(size_t which)
{
    const uint32_t ahead = (control->segment->control.cycles_head + beyond[which]) % (2U * LANE);

    control->segment->recorder.cycles_tail = (beyond[which] < LANE) ? ahead : beyond[which];
}

void test_SWR_EXCH_025_control_finds_as_much_room_as_before_the_damage(void)
{
    uint32_t dropped = 0U;

    for (size_t i = 0U; i < (sizeof beyond / sizeof beyond[0]); i++) {
        damage_ahead(i);
        TEST_ASSERT_EQUAL_UINT32(LANE - (uint32_t)i, exchange_cycle_room(control));
        TEST_ASSERT_TRUE(push((uint32_t)i));
        TEST_ASSERT_TRUE(exchange_repair_cycles(reader, &dropped));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, dropped);
}

void test_SWR_EXCH_025_a_new_reader_of_a_damaged_index_begins_where_control_saw_the_last_one(void)
{
    for (size_t i = 0U; i < (sizeof beyond / sizeof beyond[0]); i++) {
        uint32_t dropped = 0U;
        exchange_close(reader);
        TEST_ASSERT_TRUE(push(2U * (uint32_t)i));
        damage_ahead(i);
        reader = exchange_open(exchange_name, error, sizeof error);
        TEST_ASSERT_TRUE(exchange_repair_cycles(reader, &dropped));
        TEST_ASSERT_EQUAL_UINT32(0U, dropped);
        expect(2U * (uint32_t)i);
        release();
        TEST_ASSERT_EQUAL_UINT32(LANE, exchange_cycle_room(control));
        TEST_ASSERT_TRUE(push((2U * (uint32_t)i) + 1U));
        expect((2U * (uint32_t)i) + 1U);
        release();
    }
}

void test_SWR_EXCH_025_where_nothing_is_believable_what_waits_is_dropped(void)
{
    uint32_t dropped = 0U;

    exchange_close(reader);
    TEST_ASSERT_TRUE(push(1U));
    control->segment->recorder.cycles_tail = UINT32_MAX;
    control->segment->control.cycles_seen = UINT32_MAX;
    reader = exchange_open(exchange_name, error, sizeof error);
    TEST_ASSERT_TRUE(exchange_repair_cycles(reader, &dropped));
    TEST_ASSERT_EQUAL_UINT32(LANE, dropped);
    TEST_ASSERT_FALSE(exchange_take_cycle(reader, &record));
    TEST_ASSERT_TRUE(push(2U));
    expect(2U);
}

/* It looked as if there was room. */
void test_SWR_EXCH_025_what_control_has_written_over_is_dropped(void)
{
    uint32_t dropped = 0U;

    for (uint32_t i = 0U; i < LANE; i++) {
        TEST_ASSERT_TRUE(push(i));
    }
    reader->segment->recorder.cycles_tail = 10U;
    TEST_ASSERT_TRUE(push(LANE));
    TEST_ASSERT_FALSE(exchange_take_cycle(reader, &record));
    TEST_ASSERT_TRUE(exchange_repair_cycles(reader, &dropped));
    TEST_ASSERT_EQUAL_UINT32(LANE, dropped);
    TEST_ASSERT_TRUE(push(LANE + 1U));
    expect(LANE + 1U);
}

void test_SWR_EXCH_025_a_damaged_index_of_control_is_its_next_one_again(void)
{
    for (size_t i = 0U; i < (sizeof damage / sizeof damage[0]); i++) {
        uint32_t dropped = 0U;
        control->segment->control.cycles_head = damage[i];
        (void)exchange_repair_cycles(reader, &dropped);
        while (exchange_take_cycle(reader, &record)) {
        }
        release();
        (void)push(100U);
        (void)exchange_repair_cycles(reader, &dropped);
        while (exchange_take_cycle(reader, &record)) {
        }
        release();
        TEST_ASSERT_FALSE(exchange_repair_cycles(reader, &dropped));
        TEST_ASSERT_TRUE(push(200U + (uint32_t)i));
        expect(200U + (uint32_t)i);
        release();
    }
}

static void release_all(void)
{
    exchange_release_cycles(reader, reader->segment->control.cycles_head);
}

static void beat(void)
{
    exchange_beat(reader, EXCHANGE_RECORDER);
}

static void ask_for_checkpoint(void)
{
    exchange_request_checkpoint(reader);
}

/* Only the recorder gets through with it. */
static void act_as(exchange_process_t process, void (*act)(void))
{
    const pid_t child = fork();
    int status = 0;

    if (child == 0) {
        exchange_protect(reader, process);
        act();
        _exit(0);
    }
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    TEST_ASSERT_EQUAL(process == EXCHANGE_RECORDER,
                      WIFEXITED(status) && (WEXITSTATUS(status) == 0));
}

void test_SWR_EXCH_026_no_neighbour_of_a_held_recorder_releases_what_it_has_not_read(void)
{
    for (uint32_t i = 0U; i < LANE; i++) {
        TEST_ASSERT_TRUE(push(i));
    }
    act_as(EXCHANGE_HTTP, release_all);
    act_as(EXCHANGE_IGTL, release_all);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_cycle_room(control));
    TEST_ASSERT_FALSE(push(LANE)); /* Control counts it as lost. */
    for (uint32_t i = 0U; i < LANE; i++) {
        expect(i);
    }
    act_as(EXCHANGE_RECORDER, release_all);
    TEST_ASSERT_EQUAL_UINT32(LANE, exchange_cycle_room(control));
}

void test_SWR_EXCH_026_no_neighbour_lives_or_asks_in_the_place_of_the_recorder(void)
{
    const uint32_t beats = exchange_beats(control, EXCHANGE_RECORDER);
    act_as(EXCHANGE_HTTP, beat);
    act_as(EXCHANGE_IGTL, ask_for_checkpoint);
    TEST_ASSERT_EQUAL_UINT32(beats, exchange_beats(control, EXCHANGE_RECORDER));
    TEST_ASSERT_FALSE(exchange_take_checkpoint_request(control));
    act_as(EXCHANGE_RECORDER, beat);
    act_as(EXCHANGE_RECORDER, ask_for_checkpoint);
    TEST_ASSERT_EQUAL_UINT32(beats + 1U, exchange_beats(control, EXCHANGE_RECORDER));
    TEST_ASSERT_TRUE(exchange_take_checkpoint_request(control));
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a recorder that reads again is waited for, one that does not once and not for
 * long; a gap is counted cycle by cycle and ends when half of the lane is free. Time is a number.
 */
#include "unity.h"

#include "control/cycle_lane.h"
#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_peers.h"
#include "exchange/exchange_rows.h"
#include "exchange/exchange_segment.h"
#include "limits/requirement_limits.h"
#include "mock_bsp.h"
#include "mock_realtime.h"
#include "robot/robot_neuro.h"

#include "unit/support/exchange_world.h"

#define NEVER UINT32_MAX

static cycle_lane_t lane;
static uint64_t world_ns;
static uint32_t naps;
static uint32_t reads_at; /* In which nap the recorder reads */
static uint32_t reads;    /* so many, */
static uint32_t beats_until;
static uint32_t stops_at; /* and control is asked to end. */
static volatile sig_atomic_t stop;

static void read_cycles(uint32_t count)
{
    static cycle_record_t record;

    for (uint32_t i = 0U; i < count; i++) {
        (void)exchange_take_cycle(reader, &record);
        exchange_beat(reader, EXCHANGE_RECORDER);
    }
    exchange_release_cycles(reader, exchange_cycles_taken(reader));
}

static void nap(uint64_t nap_ns, int calls)
{
    (void)calls;
    world_ns += nap_ns;
    naps++;
    if (naps == reads_at) {
        read_cycles(reads);
    }
    if (naps < beats_until) {
        exchange_beat(reader, EXCHANGE_RECORDER);
    }
    stop = (naps == stops_at) ? 15 : stop;
}

static uint64_t give_now(int calls)
{
    (void)calls;
    return world_ns;
}

void setUp(void)
{
    uint32_t dropped = 0U;

    exchange_world_init();
    (void)exchange_repair_cycles(reader, &dropped);
    lane = (cycle_lane_t){0};
    naps = 0U;
    reads_at = NEVER;
    reads = LANE;
    beats_until = 0U;
    stops_at = NEVER;
    stop = 0;
    bsp_stand_still_ns_Stub(nap);
    realtime_now_ns_Stub(give_now);
}

void tearDown(void)
{
    exchange_world_end();
}

/* As control records it. @return whether a gap ended with it */
static bool run_cycle(void)
{
    const bool is_resuming = cycle_lane_look(&lane, control);

    if (!lane.is_gap) {
        cycle_entry_t *const entry = exchange_reserve_cycle(control);
        TEST_ASSERT_NOT_NULL(entry);
        entry->kind = (uint32_t)CYCLE_RECORD_CYCLE;
        exchange_commit_cycle(control);
    }
    return is_resuming;
}

static void fill(void)
{
    while (exchange_cycle_room(control) >= EXCHANGE_CYCLE_ENTRIES) {
        (void)run_cycle();
    }
    TEST_ASSERT_EQUAL_UINT32(0U, lane.lost);
}

static void wait_for_recorder(void)
{
    naps = 0U;
    cycle_lane_wait(&lane, control, &stop);
}

void test_SWR_REC_019_nobody_is_waited_for_while_there_is_room(void)
{
    wait_for_recorder();
    TEST_ASSERT_EQUAL_UINT32(0U, naps);
}

void test_SWR_REC_019_a_recorder_that_reads_again_loses_nothing(void)
{
    fill();
    reads_at = 5U;
    wait_for_recorder();
    TEST_ASSERT_EQUAL_UINT32(5U, naps);
    TEST_ASSERT_FALSE(run_cycle());
    TEST_ASSERT_EQUAL_UINT32(0U, lane.lost);
}

void test_SWR_REC_019_a_recorder_that_is_dead_is_waited_for_once_and_not_for_long(void)
{
    const uint64_t began_ns = world_ns;

    fill();
    wait_for_recorder();
    TEST_ASSERT_EQUAL_UINT64(UINT64_C(1000) * LIMIT_RECORDER_ANSWER_CLOCK_US, world_ns - began_ns);
    for (uint32_t i = 0U; i < 10U; i++) {
        (void)run_cycle();
        wait_for_recorder();
        TEST_ASSERT_EQUAL_UINT32(0U, naps);
    }
    TEST_ASSERT_EQUAL_UINT32(10U, lane.lost);
}

void test_SWR_REC_019_a_recorder_that_has_read_since_is_waited_for_again(void)
{
    fill();
    wait_for_recorder();
    (void)run_cycle();
    read_cycles(1U);
    reads_at = 3U;
    wait_for_recorder();
    TEST_ASSERT_EQUAL_UINT32(3U, naps);
    TEST_ASSERT_TRUE(run_cycle());
    TEST_ASSERT_EQUAL_UINT32(1U, lane.lost);
}

/* It has the next block not written yet. */
void test_SWR_REC_019_a_recorder_that_is_slow_is_waited_for_as_long_as_it_lives(void)
{
    fill();
    reads_at = 10000U; /* 20 s. */
    beats_until = reads_at;
    wait_for_recorder();
    TEST_ASSERT_EQUAL_UINT32(reads_at, naps);
    TEST_ASSERT_FALSE(run_cycle());
    TEST_ASSERT_EQUAL_UINT32(0U, lane.lost);
}

void test_SWR_REC_019_a_signal_ends_it_at_once(void)
{
    fill();
    stops_at = 4U;
    wait_for_recorder();
    TEST_ASSERT_EQUAL_UINT32(4U, naps);
}

void test_SWR_REC_019_control_shows_that_it_lives(void)
{
    fill();
    const uint32_t beats = exchange_beats(reader, EXCHANGE_CONTROL);
    reads_at = 7U;
    wait_for_recorder();
    TEST_ASSERT_EQUAL_UINT32(beats + 7U, exchange_beats(reader, EXCHANGE_CONTROL));
}

void test_SWR_REC_022_a_gap_ends_when_half_of_the_lane_is_free(void)
{
    fill();
    for (uint32_t i = 1U; i <= 20U; i++) {
        TEST_ASSERT_FALSE(run_cycle());
        TEST_ASSERT_TRUE(lane.is_gap);
        TEST_ASSERT_EQUAL_UINT32(i, lane.lost);
    }
    read_cycles((LANE / 2U) - EXCHANGE_CYCLE_ENTRIES);
    TEST_ASSERT_FALSE(run_cycle());
    read_cycles(1U);
    TEST_ASSERT_TRUE(run_cycle());
    TEST_ASSERT_FALSE(run_cycle());
    TEST_ASSERT_EQUAL_UINT32(21U, lane.lost);
}

void test_SWR_REC_033_while_the_recorder_cannot_write_each_cycle_is_counted_and_none_handed_over(
    void)
{
    (void)run_cycle();
    exchange_note_recorder(reader, true, 0U);
    for (uint32_t i = 1U; i <= 20U; i++) {
        TEST_ASSERT_FALSE(run_cycle());
        TEST_ASSERT_TRUE(lane.is_gap);
        TEST_ASSERT_TRUE(lane.is_failing);
        TEST_ASSERT_EQUAL_UINT32(i, lane.lost);
    }
    TEST_ASSERT_EQUAL_UINT32(LANE - 1U, exchange_cycle_room(control));
    exchange_note_recorder(reader, false, 0U);
    TEST_ASSERT_TRUE(run_cycle());
    TEST_ASSERT_FALSE(run_cycle());
    TEST_ASSERT_FALSE(lane.is_failing);
    TEST_ASSERT_EQUAL_UINT32(20U, lane.lost);
}

void test_SWR_REC_033_elastic_time_does_not_wait_for_a_disk(void)
{
    fill();
    exchange_note_recorder(reader, true, 0U);
    beats_until = NEVER;
    wait_for_recorder();
    TEST_ASSERT_EQUAL_UINT32(0U, naps);
}

void test_SWR_REC_033_what_was_removed_is_counted_once_and_reported_as_what_cannot_be_written(void)
{
    exchange_note_recorder(reader, false, 500U);
    (void)run_cycle();
    TEST_ASSERT_TRUE(lane.is_failing);
    TEST_ASSERT_FALSE(lane.is_gap);
    (void)run_cycle();
    TEST_ASSERT_FALSE(lane.is_failing);
    TEST_ASSERT_EQUAL_UINT32(500U, lane.lost);
    exchange_note_recorder(reader, false, 0U); /* Damage. */
    (void)run_cycle();
    exchange_note_recorder(reader, false, 502U);
    (void)run_cycle();
    TEST_ASSERT_EQUAL_UINT32(502U, lane.lost);
}

static bool lacks_after(uint64_t passed_us)
{
    world_ns += UINT64_C(1000) * passed_us;
    (void)cycle_lane_look(&lane, control);
    return cycle_lane_lacks_recorder(&lane, control);
}

void test_SWR_REC_050_a_recorder_lives_that_gives_a_sign_within_its_time(void)
{
    TEST_ASSERT_FALSE(lacks_after(1U));
    TEST_ASSERT_FALSE(lacks_after(LIMIT_RECORDER_SILENT_US - 1U));
    exchange_beat(reader, EXCHANGE_RECORDER); /* Another one, in its place. */
    TEST_ASSERT_FALSE(lacks_after(1U));
    TEST_ASSERT_FALSE(lacks_after(LIMIT_RECORDER_SILENT_US - 1U));
    TEST_ASSERT_TRUE(lacks_after(1U));
    exchange_beat(reader, EXCHANGE_RECORDER);
    TEST_ASSERT_FALSE(lacks_after(1U));
}

void test_SWR_REC_050_a_recorder_that_cannot_write_is_a_lack_until_it_has_written_for_a_time(void)
{
    TEST_ASSERT_FALSE(lacks_after(1U));
    exchange_note_recorder(reader, true, 0U);
    TEST_ASSERT_TRUE(lacks_after(1U));
    exchange_note_recorder(reader, false, 0U);
    TEST_ASSERT_TRUE(lacks_after(LIMIT_RECORDER_PROOF_US - 1U));
    TEST_ASSERT_FALSE(lacks_after(1U));
}

void test_SWR_REC_050_so_is_a_gap_of_a_recorder_that_does_not_read(void)
{
    fill();
    TEST_ASSERT_TRUE(lacks_after(1U));
    read_cycles(LANE);
    TEST_ASSERT_TRUE(lacks_after(1U));
    TEST_ASSERT_FALSE(lacks_after(LIMIT_RECORDER_PROOF_US));
}

void test_SWR_REC_050_a_recording_that_others_remove_is_none(void)
{
    exchange_note_recorder(reader, false, 500U);
    TEST_ASSERT_FALSE(lacks_after(1U));
}

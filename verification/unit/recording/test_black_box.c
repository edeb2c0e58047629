/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: whatever becomes of the disk, recording goes on, and what a recording lacks is
 * counted in the next one.
 */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_rows.h"
#include "exchange/exchange_segment.h"
#include "recording/write/black_box.h"
#include "recording/format/cycle_code.h"
#include "recording/format/recording.h"
#include "recording/read/recording_reader.h"
#include "recording/write/recording_writer.h"

#include <string.h>

#include "unit/recording/black_box_world.inc"

void setUp(void)
{
    begin_black_box();
}

void tearDown(void)
{
    end_black_box();
}

void test_SWR_REC_012_what_a_full_disk_has_cost_is_counted_in_the_next_file(void)
{
    record_cycles(0U, 10U);
    fill_disk(1U);
    record_cycles(10U, 20U); /* In a block that cannot be written; control is informed. */
    TEST_ASSERT_TRUE(exchange_is_recorder_failing(exchange));
    free_disk();
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_FALSE(exchange_is_recorder_failing(exchange));
    record_cycles(35U, 40U); /* It goes on with a checkpoint. */
    expect_newest(3U, 6U, 15U);
}

void test_SWR_REC_032_nothing_is_lost_of_what_control_has_handed_over_before_it_was_informed(void)
{
    record_cycles(0U, 10U);
    fill_disk(1U);
    record_cycles(10U, 20U);
    record_cycles(20U, 25U);
    TEST_ASSERT_EQUAL_UINT32(LANE - 15U - (2U * EXCHANGE_CHECKPOINT_ENTRIES),
                             exchange_cycle_room(exchange));
    free_disk();
    record_cycles(25U, 30U);
    TEST_ASSERT_EQUAL_UINT32(LANE, exchange_cycle_room(exchange));
    expect_newest(2U, 23U, 0U);
}

void test_SWR_REC_032_control_is_informed_until_a_block_is_written_and_not_only_a_header(void)
{
    record_cycles(0U, 10U);
    fill_disk(RECORDING_HEADER_SIZE + 1U);
    record_cycles(10U, 20U);
    TEST_ASSERT_TRUE(exchange_is_recorder_failing(exchange));
    for (uint32_t i = 0U; i < 3U; i++) {
        now_us += BLACK_BOX_RETRY_US;
        black_box_drain(&black_box, now_us);
        TEST_ASSERT_TRUE(exchange_is_recorder_failing(exchange));
    }
    free_disk();
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_FALSE(exchange_is_recorder_failing(exchange));
    expect_newest(2U, 11U, 0U);
}

void test_SWR_REC_032_what_a_neighbour_says_of_the_recorder_is_set_right(void)
{
    record_cycles(0U, 10U);
    exchange_note_recorder(exchange, true, 5U);
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_FALSE(exchange_is_recorder_failing(exchange));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_cycles_removed(exchange));
}

void test_SWR_REC_012_what_the_lane_lost_is_counted_also_before_a_checkpoint(void)
{
    record_cycles(0U, 10U);
    record_cycles(13U, 20U);
    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_size_t(2U, read_newest());
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, finding.verdict);
    TEST_ASSERT_EQUAL_UINT32(3U, reader.cycles_lost);
}

void test_SWR_REC_012_nothing_is_lost_before_the_first_file(void)
{
    record_cycles(1000U, 1010U);
    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_size_t(1U, read_newest());
    TEST_ASSERT_EQUAL_UINT32(0U, reader.cycles_lost);
}

void test_SWR_REC_013_a_file_that_holds_nothing_is_removed_again(void)
{
    record_cycles(0U, 10U);
    free_disk(); /* Time enough for the next attempt. */
    black_box_close(&black_box);
    fill_disk(RECORDING_HEADER_SIZE);
    record_cycles(10U, 20U);
    TEST_ASSERT_EQUAL_size_t(1U, read_newest());
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, finding.verdict);
}

void test_SWR_REC_030_each_file_names_the_run_of_its_exchange_whoever_writes_it(void)
{
    record_cycles(0U, 10U);
    black_box_close(&black_box);
    (void)read_newest();
    TEST_ASSERT_EQUAL_UINT64(exchange_run(exchange), reader.header.run);
    recording_reader_close(&reader);
    black_box_open(&black_box, folder, exchange, &header); /* Another recorder is started. */
    record_cycles(10U, 20U);
    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_size_t(2U, read_newest());
    TEST_ASSERT_EQUAL_UINT64(exchange_run(exchange), reader.header.run);
}

/* Control's last cycle is 19; the recorder ends after those before `end`. */
static bool says_run_end(bool has_control_ended, uint32_t end)
{
    const snapshot_t snapshot = {.cycle = 19U};

    exchange_publish_snapshot(exchange, &snapshot);
    record_cycles(0U, end);
    if (has_control_ended) {
        exchange_note_control_ended(exchange);
    }
    TEST_ASSERT_EQUAL_UINT32(has_control_ended ? (20U - end) : 0U, black_box_close(&black_box));
    TEST_ASSERT_EQUAL_size_t(1U, read_newest());
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, finding.verdict);
    return reader.is_run_end;
}

void test_SWR_REC_031_the_run_ends_with_the_last_cycle_of_a_control_that_has_ended(void)
{
    TEST_ASSERT_TRUE(says_run_end(true, 20U));
}

void test_SWR_REC_031_the_run_does_not_end_while_control_lives(void)
{
    TEST_ASSERT_FALSE(says_run_end(false, 20U));
}

void test_SWR_REC_031_the_end_of_the_run_is_not_there_when_its_last_cycle_is_lost(void)
{
    TEST_ASSERT_FALSE(says_run_end(true, 19U));
}

/* Control's last cycle is 29, and it has handed over those before 20. */
static void end_on_full_disk(void)
{
    const snapshot_t snapshot = {.cycle = 29U};

    exchange_publish_snapshot(exchange, &snapshot);
    record_cycles(0U, 10U);
    fill_disk(1U);
    record_cycles(10U, 20U);
    TEST_ASSERT_TRUE(exchange_is_recorder_failing(exchange));
}

void test_SWR_REC_040_cycles_that_wait_at_the_end_on_a_full_disk_are_counted(void)
{
    end_on_full_disk();
    exchange_note_control_ended(exchange);
    TEST_ASSERT_EQUAL_UINT32(20U, black_box_close(&black_box));
}

void test_SWR_REC_040_they_are_counted_when_control_was_killed(void)
{
    end_on_full_disk();
    TEST_ASSERT_EQUAL_UINT32(20U, black_box_close(&black_box));
}

void test_SWR_REC_040_what_the_end_of_the_disk_costs_last_is_counted(void)
{
    const snapshot_t snapshot = {.cycle = 19U};

    exchange_publish_snapshot(exchange, &snapshot);
    record_cycles(0U, 10U);
    for (uint32_t cycle = 10U; cycle < 20U; cycle++) {
        push(cycle);
    }
    black_box_drain(&black_box, now_us);
    fill_disk(1U);
    exchange_note_control_ended(exchange);
    TEST_ASSERT_EQUAL_UINT32(10U, black_box_close(&black_box));
    TEST_ASSERT_TRUE(exchange_is_recorder_failing(exchange));
}

/* `count` rows of a list that is begun, and a checkpoint of them. */
static void hold_rows(uint32_t count, uint32_t first)
{
    static controller_outputs_t outputs;

    outputs.answer_count = 1U;
    outputs.answers[0] = (answer_t){.command = COMMAND_LIST_BEGIN, .kind = ANSWER_ACCEPTED};
    controller.mode.sealed.list.count = count;
    for (uint32_t i = 0U; i < count; i++) {
        controller.rows[i].time_ms = first + i;
    }
    exchange_publish_rows(exchange, &controller, &outputs);
}

static void expect_rows(uint32_t count, uint32_t first)
{
    static cycle_record_t record;
    cycle_known_t known;
    trajectory_row_t row;

    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_size_t(1U, read_newest());
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, finding.verdict);
    TEST_ASSERT_TRUE(recording_reader_next(&reader, &record, &known));
    TEST_ASSERT_EQUAL_UINT32(CYCLE_RECORD_CHECKPOINT, record.kind);
    TEST_ASSERT_EQUAL_UINT32(count, record.rows);
    for (uint32_t i = 0U; i < count; i++) {
        (void)memcpy(&row, &known.rows[i * sizeof row], sizeof row);
        TEST_ASSERT_EQUAL_UINT32(first + i, row.time_ms);
    }
    TEST_ASSERT_TRUE(recording_reader_next(&reader, &record, &known));
    TEST_ASSERT_EQUAL_UINT32(CYCLE_RECORD_CYCLE, record.kind);
}

void test_SWR_TRAJ_017_a_recording_begins_with_the_rows_of_its_checkpoint(void)
{
    hold_rows(LIMIT_TRAJECTORY_ROWS, 5U);
    push_checkpoint(10U);
    push(10U);
    black_box_drain(&black_box, now_us);
    expect_rows(LIMIT_TRAJECTORY_ROWS, 5U);
}

void test_SWR_TRAJ_017_a_checkpoint_whose_rows_are_gone_is_asked_for_again(void)
{
    hold_rows(3U, 5U);
    push_checkpoint(10U);
    hold_rows(4U, 50U);
    TEST_ASSERT_TRUE(exchange_take_checkpoint_request(exchange));
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_TRUE(exchange_take_checkpoint_request(exchange));
    push_checkpoint(10U);
    push(10U);
    black_box_drain(&black_box, now_us);
    expect_rows(4U, 50U);
}

void test_SWR_REC_023_what_a_killed_recorder_had_not_written_is_in_the_file_of_the_next(void)
{
    record_cycles(0U, 10U);
    for (uint32_t cycle = 10U; cycle < 20U; cycle++) {
        push(cycle);
    }
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_EQUAL_UINT32(LANE - 10U, exchange_cycle_room(exchange));
    start_another();
    black_box_drain(&black_box, now_us);
    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_UINT32(LANE, exchange_cycle_room(exchange));
    TEST_ASSERT_EQUAL_size_t(2U, read_newest());
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, finding.verdict);
    TEST_ASSERT_EQUAL_UINT64(10U, reader.records);
    TEST_ASSERT_EQUAL_UINT32(0U, reader.cycles_lost);
}

void test_SWR_REC_023_a_block_that_is_full_is_released_while_the_next_one_waits(void)
{
    push_checkpoint(0U);
    for (uint32_t cycle = 0U; cycle < (4U * RECORDING_BLOCK_RECORDS); cycle++) {
        push(cycle);
        black_box_drain(&black_box, now_us);
        TEST_ASSERT_GREATER_THAN_UINT32(0U, exchange_cycle_room(exchange));
    }
}

void test_SWR_REC_032_a_recorder_that_takes_the_place_of_one_that_cannot_write_goes_on_for_it(void)
{
    record_cycles(0U, 10U);
    fill_disk(RECORDING_HEADER_SIZE + 1U);
    record_cycles(10U, 40U);
    start_another();
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_TRUE(exchange_is_recorder_failing(exchange));
    free_disk();
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_FALSE(exchange_is_recorder_failing(exchange));
    TEST_ASSERT_EQUAL_UINT32(LANE, exchange_cycle_room(exchange));
    expect_newest(2U, 31U, 0U);
}

void test_SWR_REC_032_with_nothing_left_to_write_control_is_asked_for_more(void)
{
    exchange_note_recorder(exchange, true, 0U);
    black_box_open(&black_box, folder, exchange, &header);
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_FALSE(exchange_is_recorder_failing(exchange));
}

void test_SWR_REC_035_control_is_informed_how_long_the_disk_lasts_also_by_the_next_recorder(void)
{
    record_cycles(0U, 10U);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_recording_left_min(exchange));
    now_us += LIMIT_RECORDING_LOOK_US;
    record_cycles(10U, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_recording_left_min(exchange));
    black_box_close(&black_box);
    black_box_open(&black_box, folder, exchange, &header);
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_recording_left_min(exchange));
}

void test_SWR_REC_024_a_damaged_lane_begins_no_file_after_another(void)
{
    static const uint32_t damage[] = {0U, 1U, LANE, 2U * LANE, 4294965248U, UINT32_MAX};

    record_cycles(0U, 10U);
    for (uint32_t i = 0U; i < (sizeof damage / sizeof damage[0]); i++) {
        exchange->segment->recorder.cycles_tail = damage[i];
        black_box_drain(&black_box, now_us);
        record_cycles(10U * (i + 1U), 10U * (i + 2U));
    }
    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_size_t(1U, read_newest());
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, finding.verdict);
    TEST_ASSERT_EQUAL_UINT32(0U, reader.cycles_lost);
}

void test_SWR_REC_024_a_cycle_that_was_passed_is_dropped(void)
{
    record_cycles(0U, 10U);
    push(3U);
    push(9U);
    push(10U);
    black_box_drain(&black_box, now_us);
    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_size_t(1U, read_newest());
    TEST_ASSERT_EQUAL_UINT64(12U, reader.records);
}

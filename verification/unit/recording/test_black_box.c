/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: whatever becomes of the disk, recording goes on, and what a recording lacks is
 * counted in the next one.
 */
#include "unity.h"

#include "base/crc.h"
#include "card/card_frame.h"
#include "common/clock.h"
#include "common/directory.h"
#include "common/file_series.h"
#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_rows.h"
#include "exchange/exchange_segment.h"
#include "recording/write/black_box.h"
#include "recording/format/cycle_code.h"
#include "recording/format/cycle_words.h"
#include "recording/format/proof.h"
#include "recording/format/recording.h"
#include "recording/read/recording_block.h"
#include "recording/read/recording_reader.h"
#include "recording/read/recording_verify.h"
#include "recording/write/recording_writer.h"

#include <glob.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <zstd.h>

#define SECOND_US UINT64_C(1000000)
#define LANE 2100U

static const recording_header_t header = {.build = "test-build",
                                          .robot = "neuro",
                                          .inputs_size = sizeof(controller_inputs_t),
                                          .outputs_size = sizeof(controller_outputs_t),
                                          .controller_size = CONTROLLER_CHECKPOINT_BYTES};
static char folder[48];
static char name[48];
static char error[256];
static exchange_t *exchange;
static black_box_t black_box;
static recording_reader_t reader;
static recording_finding_t finding;
static struct rlimit unlimited;
static uint64_t now_us;

/* In the place of the system's: nothing is free. */
int statvfs(const char *path, struct statvfs *found)
{
    TEST_ASSERT_EQUAL_STRING(folder, path);
    (void)memset(found, 0, sizeof *found);
    return 0;
}

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-black-box-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(name, sizeof name, "test-black-box-%d", (int)getpid());
    exchange = exchange_create(name, LANE, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(exchange, error);
    (void)signal(SIGXFSZ, SIG_IGN);
    TEST_ASSERT_EQUAL_INT(0, getrlimit(RLIMIT_FSIZE, &unlimited));
    now_us = 10U * SECOND_US;
    black_box_open(&black_box, folder, exchange, &header);
}

void tearDown(void)
{
    char command[80];

    (void)setrlimit(RLIMIT_FSIZE, &unlimited);
    recording_reader_close(&reader);
    black_box_close(&black_box);
    exchange_close(exchange);
    (void)snprintf(command, sizeof command, "rm -rf %s", folder);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

static controller_t controller;

static void push_checkpoint(uint32_t cycle)
{
    controller.sealed.cycle = cycle;
    TEST_ASSERT_TRUE(exchange_push_checkpoint(exchange, &controller));
}

static void push(uint32_t cycle)
{
    cycle_entry_t *const entry = exchange_reserve_cycle(exchange);

    TEST_ASSERT_NOT_NULL(entry);
    (void)memset(entry, 0, sizeof *entry);
    entry->kind = (uint32_t)CYCLE_RECORD_CYCLE;
    entry->cycle = cycle;
    exchange_commit_cycle(exchange);
}

/* Those cycles, a checkpoint before them, and so much time that they are written. */
static void record_cycles(uint32_t first, uint32_t end)
{
    push_checkpoint(first);
    for (uint32_t cycle = first; cycle < end; cycle++) {
        push(cycle);
    }
    black_box_drain(&black_box, now_us);
    now_us += SECOND_US;
    black_box_drain(&black_box, now_us);
}

/* No file may become larger than that. */
static void fill_disk(uint32_t bytes)
{
    struct rlimit limit = unlimited;

    limit.rlim_cur = bytes;
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &limit));
}

static void free_disk(void)
{
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &unlimited));
    now_us += BLACK_BOX_RETRY_US;
}

/* The number of recordings; opens the newest one. */
static size_t read_newest(void)
{
    char pattern[80];
    glob_t found;

    (void)snprintf(pattern, sizeof pattern, "%s/*.bsr", folder);
    if (glob(pattern, 0, NULL, &found) != 0) {
        return 0U;
    }
    const size_t count = found.gl_pathc;
    (void)recording_reader_open(&reader, found.gl_pathv[count - 1U], &finding);
    globfree(&found);
    return count;
}

/* The newest of `files` is whole and has `records`; before it `lost` cycles are in no file. */
static void expect_newest(size_t files, uint64_t records, uint32_t lost)
{
    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_size_t(files, read_newest());
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, finding.verdict);
    TEST_ASSERT_EQUAL_UINT64(records, reader.records);
    TEST_ASSERT_EQUAL_UINT32(lost, reader.cycles_lost);
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

static void remove_folder(void)
{
    char command[80];

    (void)snprintf(command, sizeof command, "rm -r %s", folder);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

void test_SWR_REC_014_a_folder_that_is_removed_is_made_again_with_a_new_recording(void)
{
    record_cycles(0U, 10U);
    remove_folder();
    black_box_drain(&black_box, now_us);
    record_cycles(10U, 20U);
    black_box_close(&black_box);
    TEST_ASSERT_EQUAL_size_t(1U, read_newest());
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, finding.verdict);
    TEST_ASSERT_EQUAL_UINT64(11U, reader.records);
}

void test_SWR_REC_012_what_was_in_a_removed_recording_is_counted_as_lost(void)
{
    record_cycles(0U, 10U);
    remove_folder();
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
    record_cycles(10U, 20U);
    expect_newest(1U, 11U, 10U);
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
}

void test_SWR_REC_014_a_folder_that_is_moved_is_made_again_with_a_new_recording(void)
{
    char moved[64];
    char command[80];

    record_cycles(0U, 10U);
    (void)snprintf(moved, sizeof moved, "%s-moved", folder);
    TEST_ASSERT_EQUAL_INT(0, rename(folder, moved));
    record_cycles(10U, 20U);
    (void)snprintf(command, sizeof command, "rm -r %s", moved);
    TEST_ASSERT_EQUAL_INT(0, system(command));
    expect_newest(1U, 11U, 10U);
}

void test_SWR_REC_032_a_folder_that_a_file_has_replaced_is_reported_until_it_is_a_folder_again(void)
{
    record_cycles(0U, 10U);
    remove_folder();
    (void)fclose(fopen(folder, "w"));
    record_cycles(10U, 20U);
    TEST_ASSERT_TRUE(exchange_is_recorder_failing(exchange));
    TEST_ASSERT_EQUAL_INT(0, remove(folder));
    free_disk();
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_FALSE(exchange_is_recorder_failing(exchange));
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
    expect_newest(1U, 11U, 10U);
}

/* In the folder, by the shell. */
static void in_folder(const char *what)
{
    char command[96];

    (void)snprintf(command, sizeof command, "cd %s && %s", folder, what);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

void test_SWR_REC_033_a_recording_that_is_emptied_in_place_is_counted_and_another_begun(void)
{
    record_cycles(0U, 10U);
    (void)exchange_take_checkpoint_request(exchange);
    in_folder("truncate -s 0 blackbox-000001-*.bsr");
    push(10U);
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
    TEST_ASSERT_TRUE(exchange_take_checkpoint_request(exchange));
    in_folder("test ! -s blackbox-000001-*.bsr"); /* It is left as it was found. */
    record_cycles(11U, 20U);
    expect_newest(2U, 11U, 10U);
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
}

void test_SWR_REC_033_a_recording_that_lost_its_end_is_counted_too(void)
{
    record_cycles(0U, 10U);
    in_folder("truncate -s -1 blackbox-000001-*.bsr");
    record_cycles(10U, 20U);
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
    expect_newest(2U, 11U, 10U);
}

void test_SWR_REC_033_recordings_that_are_removed_while_none_can_be_written_are_counted(void)
{
    record_cycles(0U, 10U);
    fill_disk(1U);
    record_cycles(10U, 20U);
    TEST_ASSERT_TRUE(exchange_is_recorder_failing(exchange));
    in_folder("rm *.bsr"); /* Act that the next step suggests. */
    now_us += SECOND_US;
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
    free_disk();
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_FALSE(exchange_is_recorder_failing(exchange));
    expect_newest(1U, 11U, 10U);
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
}

void test_SWR_REC_033_all_that_was_removed_is_missing_before_the_next_recording(void)
{
    record_cycles(0U, 10U);
    record_cycles(13U, 20U);
    in_folder("rm *.bsr");
    record_cycles(20U, 30U);
    TEST_ASSERT_EQUAL_UINT32(17U, exchange_cycles_removed(exchange));
    expect_newest(1U, 11U, 20U);
}

void test_SWR_REC_033_an_earlier_recording_of_the_run_that_is_removed_is_counted_once(void)
{
    record_cycles(0U, 10U);
    record_cycles(13U, 20U);
    record_cycles(23U, 30U);
    in_folder("rm *-000001-*.bsr");
    now_us += SECOND_US;
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_EQUAL_UINT32(10U, exchange_cycles_removed(exchange));
    in_folder("truncate -s 0 blackbox-000002-*.bsr");
    for (uint32_t i = 0U; i < 2U; i++) {
        now_us += SECOND_US;
        black_box_drain(&black_box, now_us);
        TEST_ASSERT_EQUAL_UINT32(17U, exchange_cycles_removed(exchange));
    }
    expect_newest(2U, 8U, 3U);
}

/* Names that are newer than all of the run, and more than are kept. */
void test_SWR_REC_033_what_makes_room_for_a_new_recording_is_not_counted(void)
{
    char many[64];

    record_cycles(0U, 10U);
    (void)snprintf(many, sizeof many, "touch $(seq -f blackbox-%%06.0f-x.bsr 2 %u)",
                   LIMIT_RECORDINGS + 1U);
    in_folder(many);
    record_cycles(13U, 20U);
    in_folder("test ! -e blackbox-000001-*.bsr");
    now_us += SECOND_US;
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_cycles_removed(exchange));
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

/* The one before was killed. */
static void start_another(void)
{
    (void)close(black_box.files.writer.file); /* As the kernel does, without what waited. */
    (void)ZSTD_freeCCtx(black_box.files.writer.compressor);
    free(black_box.files.writer.output);
    black_box.files.writer = (recording_writer_t){.file = -1};
    exchange->is_taking = false;
    black_box_open(&black_box, folder, exchange, &header);
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

/* LIM-030: removed before it was there, and while it is. */
void test_SWR_REC_033_a_recording_of_the_recorder_before_is_removed_uncounted(void)
{
    record_cycles(0U, 10U);
    record_cycles(13U, 20U);
    in_folder("rm *-000001-*.bsr");
    start_another();
    record_cycles(20U, 30U);
    in_folder("rm *-000002-*.bsr");
    now_us += SECOND_US;
    black_box_drain(&black_box, now_us);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_cycles_removed(exchange));
    expect_newest(1U, 11U, 0U);
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

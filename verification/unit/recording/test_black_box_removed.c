/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: recordings and folders that are removed, moved or emptied while the recorder
 * runs are made again, and their cycles are counted as missing.
 */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_segment.h"
#include "recording/write/black_box.h"
#include "recording/format/recording.h"
#include "recording/read/recording_reader.h"
#include "recording/write/recording_writer.h"

#include <stdio.h>
#include <stdlib.h>

#include "unit/recording/black_box_world.inc"

void setUp(void)
{
    begin_black_box();
}

void tearDown(void)
{
    end_black_box();
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

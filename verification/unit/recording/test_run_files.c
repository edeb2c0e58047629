/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: what the recordings of a run hold, and what comes next, is known after each of
 * them, whether it was ended, could not be written or was removed.
 */
#include "unity.h"

#include "recording/write/run_files.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#define NOW_US UINT64_C(5000000)

static const recording_header_t header = {.build = "test-build",
                                          .robot = "neuro",
                                          .inputs_size = sizeof(controller_inputs_t),
                                          .outputs_size = sizeof(controller_outputs_t),
                                          .controller_size = CONTROLLER_CHECKPOINT_BYTES};
static char folder[48];
static run_files_t files;
static struct rlimit unlimited;

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-run-files-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)signal(SIGXFSZ, SIG_IGN);
    TEST_ASSERT_EQUAL_INT(0, getrlimit(RLIMIT_FSIZE, &unlimited));
    run_files_init(&files, folder, &header);
}

static void limit_size(rlim_t bytes)
{
    struct rlimit limit = unlimited;

    limit.rlim_cur = bytes;
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &limit));
}

void tearDown(void)
{
    char command[80];

    limit_size(unlimited.rlim_cur);
    (void)run_files_end(&files);
    (void)snprintf(command, sizeof command, "rm -rf %s", folder);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

static void store(uint32_t first, uint32_t end)
{
    static cycle_record_t record;

    record.kind = (uint32_t)CYCLE_RECORD_CYCLE;
    for (record.cycle = first; record.cycle < end; record.cycle++) {
        TEST_ASSERT_TRUE(run_files_store(&files, &record, NULL, NOW_US));
    }
}

static void begin(uint32_t cycle)
{
    run_files_expect(&files, cycle);
    TEST_ASSERT_TRUE(run_files_begin(&files, cycle, NOW_US));
}

static void expect(bool is_open, uint32_t kept_until, uint32_t next_cycle)
{
    TEST_ASSERT_EQUAL(is_open, run_files_is_open(&files));
    TEST_ASSERT_EQUAL_UINT32(kept_until, files.kept_until);
    TEST_ASSERT_EQUAL_UINT32(next_cycle, files.next_cycle);
}

void test_SWR_REC_012_what_came_before_the_first_cycle_is_another_recorders(void)
{
    begin(7U);
    expect(true, 7U, 7U);
    run_files_expect(&files, 9U);
    expect(true, 7U, 7U);
    TEST_ASSERT_EQUAL_UINT32(0U, files.writer.cycles_lost);
}

void test_SWR_REC_012_a_file_that_was_ended_keeps_its_cycles(void)
{
    begin(0U);
    store(0U, 10U);
    TEST_ASSERT_TRUE(run_files_end(&files));
    expect(false, 10U, 10U);
    TEST_ASSERT_TRUE(run_files_end(&files));
    begin(13U);
    TEST_ASSERT_EQUAL_UINT32(3U, files.writer.cycles_lost);
    TEST_ASSERT_EQUAL_UINT32(2U, files.number);
}

void test_SWR_REC_012_what_could_not_be_written_comes_next_again(void)
{
    begin(0U);
    store(0U, 10U);
    TEST_ASSERT_TRUE(run_files_flush(&files, NOW_US + 1U));
    TEST_ASSERT_EQUAL_UINT64(NOW_US + 1U, files.flushed_us);
    store(10U, 20U);
    limit_size(1U);
    TEST_ASSERT_FALSE(run_files_flush(&files, NOW_US + 2U));
    expect(false, 10U, 20U);
    run_files_go_back(&files);
    expect(false, 10U, 10U);
}

void test_SWR_REC_013_a_file_without_a_block_is_removed(void)
{
    begin(0U);
    store(0U, 10U);
    limit_size(RECORDING_HEADER_SIZE);
    TEST_ASSERT_FALSE(run_files_end(&files));
    TEST_ASSERT_EQUAL_INT(-1, access(files.path, F_OK));
    expect(false, 0U, 10U);
    limit_size(1U);
    TEST_ASSERT_FALSE(run_files_begin(&files, 10U, NOW_US));
    expect(false, 0U, 10U);
}

void test_SWR_REC_014_of_a_removed_file_only_what_was_written_is_gone(void)
{
    begin(0U);
    store(0U, 10U);
    TEST_ASSERT_TRUE(run_files_flush(&files, NOW_US));
    store(10U, 20U);
    TEST_ASSERT_FALSE(run_files_is_present_gone(&files));
    TEST_ASSERT_EQUAL_INT(0, unlink(files.path));
    TEST_ASSERT_TRUE(run_files_is_present_gone(&files));
    TEST_ASSERT_EQUAL_UINT32(10U, run_files_give_up(&files));
    expect(false, 0U, 10U);
    TEST_ASSERT_FALSE(run_files_is_present_gone(&files));
}

void test_SWR_REC_033_what_an_earlier_file_held_is_counted_and_missing_before_the_next(void)
{
    begin(0U);
    store(0U, 10U);
    TEST_ASSERT_TRUE(run_files_end(&files));
    TEST_ASSERT_EQUAL_INT(0, unlink(files.path));
    TEST_ASSERT_EQUAL_UINT32(10U, run_files_forget_gone(&files));
    expect(false, 0U, 10U);
    TEST_ASSERT_EQUAL_UINT32(0U, run_files_forget_gone(&files));
}

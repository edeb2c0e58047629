/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: of a series of files the oldest are removed first, by their numbers and not by
 * the clock, and the one that is being written never.
 */
#include "unity.h"

#include "common/file_series.h"

#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define MORNING UINT64_C(1700000000000000)
#define HOUR UINT64_C(3600000000)
#define PLENTY UINT64_C(1000000)
#define SIZE 1000

static char folder[48];
static file_series_t series;

void setUp(void)
{
    series = file_series_recordings;
    (void)strcpy(folder, "/tmp/test-file-series-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
}

void tearDown(void)
{
    char command[80];

    (void)snprintf(command, sizeof command, "rm -r %s", folder);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

static const char *named(uint32_t number, uint64_t utc_us)
{
    static char path[FILE_SERIES_PATH_SIZE];

    file_series_path(&series, folder, number, utc_us, path);
    return path;
}

static void make(const char *path)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_EXCL, 0600);

    TEST_ASSERT_TRUE(file >= 0);
    TEST_ASSERT_EQUAL_INT(0, ftruncate(file, SIZE));
    (void)close(file);
}

static uint64_t remove_oldest(uint32_t files, uint64_t bytes, const char *present)
{
    series.files = files;
    series.bytes = bytes;
    return file_series_remove_oldest(&series, folder, present);
}

static bool is_there(const char *path)
{
    return access(path, F_OK) == 0;
}

void test_SWR_REC_007_the_oldest_go_until_few_enough_are_left(void)
{
    for (uint32_t i = 1U; i <= 12U; i++) {
        make(named(i, MORNING + (i * HOUR)));
    }
    TEST_ASSERT_EQUAL_UINT64(5U * SIZE,
                             remove_oldest(5U, PLENTY, named(12U, MORNING + (12U * HOUR))));
    for (uint32_t i = 1U; i <= 12U; i++) {
        TEST_ASSERT_EQUAL(i > 7U, is_there(named(i, MORNING + (i * HOUR))));
    }
}

void test_SWR_REC_007_the_oldest_go_until_they_are_small_enough(void)
{
    for (uint32_t i = 1U; i <= 6U; i++) {
        make(named(i, MORNING));
    }
    (void)remove_oldest(100U, (uint64_t)(3 * SIZE) + 1U, named(6U, MORNING));
    for (uint32_t i = 1U; i <= 6U; i++) {
        TEST_ASSERT_EQUAL(i > 3U, is_there(named(i, MORNING)));
    }
}

void test_SWR_REC_007_a_clock_that_is_set_back_makes_no_recording_older(void)
{
    make(named(999998U, MORNING + HOUR));
    make(named(999999U, MORNING));
    make(named(1000000U, MORNING - HOUR));
    TEST_ASSERT_EQUAL_UINT32(1000000U, file_series_newest(&series, folder));
    (void)remove_oldest(2U, PLENTY, named(1000000U, MORNING - HOUR));
    TEST_ASSERT_FALSE(is_there(named(999998U, MORNING + HOUR)));
    TEST_ASSERT_TRUE(is_there(named(999999U, MORNING)));
    TEST_ASSERT_TRUE(is_there(named(1000000U, MORNING - HOUR)));
}

void test_SWR_REC_007_the_present_one_stays_whatever_its_size(void)
{
    make(named(1U, MORNING));
    make(named(2U, MORNING));
    (void)remove_oldest(1U, 1U, named(1U, MORNING));
    TEST_ASSERT_TRUE(is_there(named(1U, MORNING)));
}

void test_SWR_REC_007_recordings_without_a_number_are_the_oldest_and_other_files_stay(void)
{
    char dated[128];
    char other[128];

    (void)snprintf(dated, sizeof dated, "%s/blackbox-20260101T120000Z-0001.bsr", folder);
    (void)snprintf(other, sizeof other, "%s/blackbox-notes.txt", folder);
    make(dated);
    make(other);
    TEST_ASSERT_EQUAL_UINT32(0U, file_series_newest(&series, folder));
    make(named(1U, MORNING));
    TEST_ASSERT_EQUAL_UINT32(1U, file_series_newest(&series, folder));
    (void)remove_oldest(1U, PLENTY, named(1U, MORNING));
    TEST_ASSERT_FALSE(is_there(dated));
    TEST_ASSERT_TRUE(is_there(other));
    TEST_ASSERT_TRUE(is_there(named(1U, MORNING)));
}

void test_SWR_REC_007_an_empty_folder_has_no_newest(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, file_series_newest(&series, folder));
    TEST_ASSERT_EQUAL_UINT32(0U, file_series_newest(&series, "/tmp/no-such-folder"));
}

/* There is no next one. */
void test_SWR_REC_007_the_largest_number_is_none(void)
{
    make(named(7U, MORNING));
    make(named(UINT32_MAX, MORNING));
    TEST_ASSERT_EQUAL_UINT32(7U, file_series_newest(&series, folder));
}

/* A reader puts it after all others. */
void test_SWR_REPLAY_036_a_number_of_more_than_32_bits_is_read(void)
{
    TEST_ASSERT_EQUAL_UINT64(UINT64_C(4294967297), file_series_any_number("blackbox-4294967297-x"));
    TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, file_series_any_number("blackbox-99999999999999999999-x"));
    TEST_ASSERT_EQUAL_UINT64(0U, file_series_any_number("blackbox-20261122T175000Z.bsr"));
    TEST_ASSERT_EQUAL_UINT64(0U, file_series_any_number("foreign.bsr"));
}

void test_SWR_REC_007_only_names_of_the_series_are_of_it(void)
{
    static const char *const others[] = {"blackbox-.bsr",
                                         "blackbox-1.log",
                                         "blackbox-1.bsr~",
                                         "events-000001-20261122T175000Z.log",
                                         "blackbox-a/../1.bsr",
                                         "blackbox-1\n.bsr",
                                         "blackbox-1 .bsr",
                                         "",
                                         ".bsr",
                                         "blackbox-"};

    TEST_ASSERT_TRUE(file_series_has(&series, "blackbox-000001-20261122T175000Z.bsr"));
    TEST_ASSERT_TRUE(file_series_has(&file_series_logs, "events-000001-20261122T175000Z.log"));
    for (size_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(file_series_has(&series, others[i]), others[i]);
    }
}

void test_SWR_EVENT_014_one_is_found_by_its_number(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    make(named(7U, MORNING));
    make(named(9U, MORNING));
    TEST_ASSERT_TRUE(file_series_find(&series, folder, 7U, path));
    TEST_ASSERT_EQUAL_STRING(named(7U, MORNING), path);
    TEST_ASSERT_FALSE(file_series_find(&series, folder, 8U, path));
    TEST_ASSERT_FALSE(file_series_find(&series, "/tmp/no-such-folder", 7U, path));
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: recordings are thrown away oldest first, by their numbers and not by the clock,
 * and the one that is being written never.
 */
#include "unity.h"

#include "recorder/black_box_files.h"

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

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-black-box-XXXXXX");
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
    static char path[128];

    black_box_name(path, sizeof path, folder, number, utc_us);
    return path;
}

static void make(const char *path)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_EXCL, 0600);

    TEST_ASSERT_TRUE(file >= 0);
    TEST_ASSERT_EQUAL_INT(0, ftruncate(file, SIZE));
    (void)close(file);
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
    black_box_remove_oldest(folder, named(12U, MORNING + (12U * HOUR)), 5U, PLENTY);
    for (uint32_t i = 1U; i <= 12U; i++) {
        TEST_ASSERT_EQUAL(i > 7U, is_there(named(i, MORNING + (i * HOUR))));
    }
}

void test_SWR_REC_007_the_oldest_go_until_they_are_small_enough(void)
{
    for (uint32_t i = 1U; i <= 6U; i++) {
        make(named(i, MORNING));
    }
    black_box_remove_oldest(folder, named(6U, MORNING), 100U, (uint64_t)(3 * SIZE) + 1U);
    for (uint32_t i = 1U; i <= 6U; i++) {
        TEST_ASSERT_EQUAL(i > 3U, is_there(named(i, MORNING)));
    }
}

void test_SWR_REC_007_a_clock_that_is_set_back_makes_no_recording_older(void)
{
    make(named(999998U, MORNING + HOUR));
    make(named(999999U, MORNING));
    make(named(1000000U, MORNING - HOUR));
    TEST_ASSERT_EQUAL_UINT32(1000000U, black_box_newest(folder));
    black_box_remove_oldest(folder, named(1000000U, MORNING - HOUR), 2U, PLENTY);
    TEST_ASSERT_FALSE(is_there(named(999998U, MORNING + HOUR)));
    TEST_ASSERT_TRUE(is_there(named(999999U, MORNING)));
    TEST_ASSERT_TRUE(is_there(named(1000000U, MORNING - HOUR)));
}

void test_SWR_REC_007_the_present_one_stays_whatever_its_size(void)
{
    make(named(1U, MORNING));
    make(named(2U, MORNING));
    black_box_remove_oldest(folder, named(1U, MORNING), 1U, 1U);
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
    TEST_ASSERT_EQUAL_UINT32(0U, black_box_newest(folder));
    make(named(1U, MORNING));
    TEST_ASSERT_EQUAL_UINT32(1U, black_box_newest(folder));
    black_box_remove_oldest(folder, named(1U, MORNING), 1U, PLENTY);
    TEST_ASSERT_FALSE(is_there(dated));
    TEST_ASSERT_TRUE(is_there(other));
    TEST_ASSERT_TRUE(is_there(named(1U, MORNING)));
}

void test_SWR_REC_007_an_empty_folder_has_no_newest(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, black_box_newest(folder));
    TEST_ASSERT_EQUAL_UINT32(0U, black_box_newest("/tmp/no-such-folder"));
}

/* There is no next one. */
void test_SWR_REC_007_the_largest_number_is_none(void)
{
    make(named(7U, MORNING));
    make(named(UINT32_MAX, MORNING));
    TEST_ASSERT_EQUAL_UINT32(7U, black_box_newest(folder));
}

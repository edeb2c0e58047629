/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a recording that is removed, replaced or emptied is found gone, once, and what
 * is kept goes back to the file before it.
 */
#include "unity.h"

#include "common/file_series.h"
#include "recording/write/kept_files.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define MORNING UINT64_C(1700000000000000)
#define SIZE 1000
#define CYCLES 100U

static char folder[48];
static kept_files_t kept;
static uint32_t kept_until;

static const char *path_of(uint32_t number)
{
    static char path[FILE_SERIES_PATH_SIZE];

    file_series_path(&file_series_recordings, folder, number, MORNING, path);
    return path;
}

static kept_file_t make(uint32_t number)
{
    kept_file_t file = {.started_us = MORNING,
                        .number = number,
                        .first_cycle = number * CYCLES,
                        .end_cycle = (number + 1U) * CYCLES,
                        .kept_before = number * CYCLES,
                        .size = SIZE};
    const int descriptor = open(path_of(number), O_WRONLY | O_CREAT | O_EXCL, 0600);

    TEST_ASSERT_TRUE(descriptor >= 0);
    TEST_ASSERT_EQUAL_INT(0, ftruncate(descriptor, SIZE));
    kept_file_identify(&file, descriptor);
    (void)close(descriptor);
    return file;
}

static void keep(uint32_t count)
{
    for (uint32_t number = 1U; number <= count; number++) {
        const kept_file_t file = make(number);
        kept_files_add(&kept, &file);
        kept_until = file.end_cycle;
    }
}

static void expect_kept(uint32_t cycles_gone, uint32_t until, uint32_t count)
{
    TEST_ASSERT_EQUAL_UINT32(cycles_gone, kept_files_forget_gone(&kept, folder, &kept_until));
    TEST_ASSERT_EQUAL_UINT32(until, kept_until);
    TEST_ASSERT_EQUAL_UINT32(count, kept.count);
}

void setUp(void)
{
    (void)memset(&kept, 0, sizeof kept);
    (void)strcpy(folder, "/tmp/test-kept-files-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
}

void tearDown(void)
{
    char command[80];

    (void)snprintf(command, sizeof command, "rm -rf %s", folder);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

void test_SWR_REC_012_files_that_stay_are_kept(void)
{
    off_t size = 0;

    keep(3U);
    expect_kept(0U, 400U, 3U);
    TEST_ASSERT_TRUE(kept_file_is_at(&kept.files[0], path_of(1U), &size));
    TEST_ASSERT_EQUAL_INT64(SIZE, size);
}

void test_SWR_REC_012_one_that_is_removed_is_gone_once(void)
{
    off_t size = 0;

    keep(3U);
    TEST_ASSERT_EQUAL_INT(0, unlink(path_of(2U)));
    TEST_ASSERT_FALSE(kept_file_is_at(&kept.files[1], path_of(2U), &size));
    expect_kept(CYCLES, 400U, 2U);
    TEST_ASSERT_EQUAL_UINT32(3U, kept.files[1].number);
    expect_kept(0U, 400U, 2U);
}

void test_SWR_REC_012_what_is_kept_goes_back_over_all_that_are_gone_from_the_end(void)
{
    keep(3U);
    TEST_ASSERT_EQUAL_INT(0, unlink(path_of(2U)));
    TEST_ASSERT_EQUAL_INT(0, unlink(path_of(3U)));
    expect_kept(2U * CYCLES, 200U, 1U);
}

void test_SWR_REC_012_one_that_is_emptied_or_replaced_is_gone(void)
{
    off_t size = 0;

    keep(3U);
    TEST_ASSERT_EQUAL_INT(0, truncate(path_of(1U), SIZE - 1));
    char other[FILE_SERIES_PATH_SIZE];
    (void)strcpy(other, path_of(9U));
    (void)make(9U);
    TEST_ASSERT_EQUAL_INT(0, rename(other, path_of(2U)));
    TEST_ASSERT_FALSE(kept_file_is_at(&kept.files[1], path_of(2U), &size));
    TEST_ASSERT_EQUAL_UINT32(2U * CYCLES, kept_files_forget_gone(&kept, folder, NULL));
    TEST_ASSERT_EQUAL_UINT32(1U, kept.count);
    TEST_ASSERT_EQUAL_UINT32(3U, kept.files[0].number);
}

void test_SWR_REC_012_all_are_gone_with_their_folder_and_none_that_cannot_be_looked_for(void)
{
    keep(2U);
    char far_away[FILE_SERIES_PATH_SIZE];
    (void)memset(far_away, 'x', sizeof far_away);
    far_away[300] = '\0';
    TEST_ASSERT_FALSE(kept_file_is_gone(&kept.files[0], far_away));
    TEST_ASSERT_TRUE(kept_file_is_gone(&kept.files[0], "/dev/null"));
    tearDown();
    expect_kept(2U * CYCLES, 100U, 0U);
    setUp();
}

void test_SWR_REC_012_without_room_the_oldest_is_forgotten(void)
{
    for (uint32_t number = 0U; number <= LIMIT_RECORDINGS; number++) {
        const kept_file_t file = {.number = number};
        kept_files_add(&kept, &file);
    }
    TEST_ASSERT_EQUAL_UINT32(LIMIT_RECORDINGS, kept.count);
    TEST_ASSERT_EQUAL_UINT32(1U, kept.files[0].number);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_RECORDINGS, kept.files[LIMIT_RECORDINGS - 1U].number);
}

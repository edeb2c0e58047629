/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the recorder says in how many minutes the disk is full at the rate at which its
 * file grows, and foresees no end where the oldest recordings make room before.
 */
#include "recording/write/recording_room.h"

#include "unity.h"

#include "limits/requirement_limits.h"

#include <string.h>
#include <sys/statvfs.h>

#define BLOCK 4096U
#define MEGABYTE UINT64_C(1000000)
#define BOUND (LIMIT_RECORDINGS_MB * MEGABYTE)
#define RATE UINT64_C(100000) /* Bytes per second. */
#define LOOK_S (LIMIT_RECORDING_LOOK_US / UINT64_C(1000000))

static recording_room_t room;
static uint64_t free_now;
static int statvfs_result;
static uint64_t now_us;
static uint64_t size;
static uint64_t earlier;

/* In the place of the system's: a disk as full as a test wants it. */
int statvfs(const char *path, struct statvfs *found)
{
    TEST_ASSERT_EQUAL_STRING("folder", path);
    (void)memset(found, 0, sizeof *found);
    found->f_frsize = BLOCK;
    found->f_bavail = free_now / BLOCK;
    return statvfs_result;
}

void setUp(void)
{
    (void)memset(&room, 0, sizeof room);
    free_now = 0U;
    statvfs_result = 0;
    now_us = LIMIT_RECORDING_LOOK_US;
    size = 0U;
    earlier = 0U;
}

void tearDown(void)
{
}

static void look(void)
{
    recording_room_look(&room, "folder", earlier, size, now_us);
}

/* So many measurements at `rate`. */
static void grow(uint32_t looks, uint64_t rate)
{
    for (uint32_t i = 0U; i < looks; i++) {
        now_us += LIMIT_RECORDING_LOOK_US;
        size += rate * LOOK_S;
        look();
    }
}

static void minutes_free(uint64_t minutes)
{
    free_now = (minutes * 60U * RATE) + BLOCK;
}

void test_SWR_REC_035_the_free_space_is_said_as_time_at_the_present_rate(void)
{
    look();
    TEST_ASSERT_EQUAL_UINT32(0U, room.left_min); /* There is no rate yet. */
    minutes_free(130U);
    grow(1U, RATE);
    TEST_ASSERT_EQUAL_UINT32(130U, room.left_min);
    minutes_free(29U);
    grow(1U, RATE);
    TEST_ASSERT_EQUAL_UINT32(29U, room.left_min);
    free_now = 0U;
    grow(1U, RATE);
    TEST_ASSERT_EQUAL_UINT32(1U, room.left_min);
}

void test_SWR_REC_035_it_is_measured_every_10_s(void)
{
    look();
    minutes_free(10U);
    now_us += LIMIT_RECORDING_LOOK_US - 1U;
    size += RATE * LOOK_S;
    look();
    TEST_ASSERT_EQUAL_UINT32(0U, room.left_min);
    now_us++;
    look();
    TEST_ASSERT_EQUAL_UINT32(10U, room.left_min);
}

void test_SWR_REC_035_a_rate_that_changes_is_followed_within_minutes(void)
{
    minutes_free(30U);
    look();
    grow(1U, RATE);
    grow(1U, RATE / 2U);
    TEST_ASSERT_EQUAL_UINT32(34U, room.left_min); /* 30 min * 8 / 7. */
    grow(20U, RATE / 2U);
    TEST_ASSERT_UINT32_WITHIN(1U, 60U, room.left_min);
}

/* As many blocks are free as the recordings may still grow by, and `more`, after the next look. */
static void free_what_they_may_take(int64_t more)
{
    const uint64_t most = BOUND + (RATE * 600U);
    const uint64_t used = earlier + size + (RATE * LOOK_S);

    free_now = (((most - used) / BLOCK) + 1U + (uint64_t)more) * BLOCK;
}

void test_SWR_REC_035_no_end_is_foreseen_where_the_oldest_make_room_before(void)
{
    look();
    free_what_they_may_take(0);
    grow(1U, RATE);
    TEST_ASSERT_EQUAL_UINT32(0U, room.left_min);
    free_what_they_may_take(-1);
    grow(1U, RATE);
    TEST_ASSERT_TRUE(room.left_min > 0U);
    earlier = BOUND + (RATE * 600U);
    free_now = 0U;
    grow(1U, RATE);
    TEST_ASSERT_EQUAL_UINT32(0U, room.left_min);
}

void test_SWR_REC_035_the_first_look_at_a_new_file_changes_nothing(void)
{
    look();
    minutes_free(20U);
    grow(1U, RATE);
    size = 5U;
    now_us += LIMIT_RECORDING_LOOK_US;
    look();
    TEST_ASSERT_EQUAL_UINT32(20U, room.left_min);
    TEST_ASSERT_EQUAL_UINT64(RATE, room.bytes_per_s);
    grow(1U, RATE);
    TEST_ASSERT_EQUAL_UINT64(RATE, room.bytes_per_s);
}

void test_SWR_REC_035_nothing_is_said_where_nothing_is_written_or_the_disk_says_nothing(void)
{
    look();
    grow(1U, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, room.left_min);
    statvfs_result = -1;
    grow(3U, RATE);
    TEST_ASSERT_EQUAL_UINT32(0U, room.left_min);
}

void test_SWR_REC_035_a_very_long_time_has_an_end(void)
{
    look();
    free_now = 900U * MEGABYTE;
    grow(1U, 1U);
    TEST_ASSERT_EQUAL_UINT32(999999U, room.left_min);
}

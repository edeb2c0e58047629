/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: what is kept of the positions comes back whole or not at all, whatever became of
 * its file, and only to the robot, the power-on and the day it belongs to.
 */
#include "unity.h"

#include "base/crc.h"
#include "limits/requirement_limits.h"
#include "positions/position_record.h"
#include "positions/position_store.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <signal.h>
#include <unistd.h>

#define ROBOT 0x12345678U
#define POWER_ON 0xCAFE0001U
#define NOW_US UINT64_C(1700000000123456)
#define AGE_US (UINT64_C(1000000) * LIMIT_STORE_AGE_S)

static char folder[] = "/tmp/test-positions-XXXXXX";
static char path[64];
static position_record_t found;
static kept_positions_t kept;

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-positions-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(path, sizeof path, "%s/positions", folder);
}

void tearDown(void)
{
    (void)unlink(path);
    (void)rmdir(path);
    (void)rmdir(folder);
}

static position_record_t record_of(uint64_t number)
{
    position_record_t record = {
        .number = number, .utc_us = NOW_US, .power_on = POWER_ON, .robot_crc = ROBOT};

    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        record.axes[i] =
            (kept_axis_t){.grade = (uint32_t)KEPT_KNOWN,
                          .position_ticks = -1000 * (int32_t)i - (int32_t)number,
                          .reading_ticks = (i == 1U) ? INT32_MIN : INT32_MAX - (int32_t)i};
    }
    return record;
}

static void keep(uint64_t number)
{
    const position_record_t record = record_of(number);

    TEST_ASSERT_TRUE(position_store_write(path, &record));
}

/* Writes `size` bytes of the file anew, all of the same value. */
static void spoil(uint32_t offset, uint8_t value, uint32_t size)
{
    uint8_t bytes[2U * POSITION_SLOT_SIZE];
    const int file = open(path, O_WRONLY | O_CREAT, 0600);

    (void)memset(bytes, value, sizeof bytes);
    TEST_ASSERT_EQUAL_INT(size, pwrite(file, bytes, size, (off_t)offset));
    TEST_ASSERT_EQUAL_INT(0, close(file));
}

static void assert_read(uint64_t number)
{
    const position_record_t expected = record_of(number);
    uint8_t wanted[POSITION_RECORD_SIZE];
    uint8_t read[POSITION_RECORD_SIZE];

    TEST_ASSERT_EQUAL(POSITION_FILE_GOOD, position_store_read(path, &found));
    position_record_encode(&expected, wanted);
    position_record_encode(&found, read);
    TEST_ASSERT_EQUAL_MEMORY(wanted, read, sizeof wanted);
}

static uint32_t ask(uint64_t utc_us, uint32_t robot_crc, uint32_t power_on, bool was_used)
{
    const position_asker_t asker = {
        .utc_us = utc_us, .robot_crc = robot_crc, .power_on = power_on, .was_used = was_used};

    (void)memset(&kept, 0xA5, sizeof kept);
    position_store_ask(path, &asker, &kept);
    TEST_ASSERT_EQUAL_HEX32(power_on, kept.power_on);
    return kept.verdict;
}

static void assert_no_axis_is_kept(void)
{
    static const kept_axis_t none[ROBOT_AXIS_MAX];

    TEST_ASSERT_EQUAL_MEMORY(none, kept.axes, sizeof none);
}

void test_SWR_STORE_002_what_was_written_is_read(void)
{
    keep(1U);
    assert_read(1U);
}

void test_SWR_STORE_002_the_newest_record_is_read_whatever_its_slot(void)
{
    for (uint64_t number = 1U; number < 6U; number++) {
        keep(number);
        assert_read(number);
    }
}

void test_SWR_STORE_002_a_record_in_which_any_bit_was_changed_is_refused(void)
{
    const position_record_t record = record_of(7U);
    uint8_t bytes[POSITION_RECORD_SIZE];

    position_record_encode(&record, bytes);
    TEST_ASSERT_TRUE(position_record_decode(bytes, &found));
    for (uint32_t bit = 0U; bit < (8U * POSITION_RECORD_SIZE); bit++) {
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
        TEST_ASSERT_FALSE(position_record_decode(bytes, &found));
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
    }
}

void test_SWR_STORE_002_a_record_of_another_format_is_refused(void)
{
    const position_record_t record = record_of(7U);
    uint8_t bytes[POSITION_RECORD_SIZE];

    position_record_encode(&record, bytes);
    bytes[7] = '2';
    const uint32_t crc = crc32c(bytes, POSITION_RECORD_SIZE - 4U);
    for (uint32_t i = 0U; i < 4U; i++) {
        bytes[POSITION_RECORD_SIZE - 4U + i] = (uint8_t)(crc >> (8U * i));
    }
    TEST_ASSERT_FALSE(position_record_decode(bytes, &found));
}

void test_SWR_STORE_002_a_write_cut_short_leaves_the_record_before(void)
{
    for (uint32_t written = 0U; written < POSITION_RECORD_SIZE; written++) {
        const position_record_t torn = record_of(4U);
        uint8_t bytes[POSITION_RECORD_SIZE];
        keep(2U);
        keep(3U);
        position_record_encode(&torn, bytes);
        const int file = open(path, O_WRONLY);
        TEST_ASSERT_EQUAL_INT(written, pwrite(file, bytes, written, 0));
        (void)close(file);
        assert_read(3U);
    }
}

void test_SWR_STORE_002_a_damaged_slot_is_written_next(void)
{
    keep(2U);
    keep(3U);
    spoil(0U, 0xFFU, POSITION_RECORD_SIZE);
    keep(4U);
    spoil(POSITION_SLOT_SIZE, 0xFFU, POSITION_RECORD_SIZE);
    assert_read(4U);
}

void test_SWR_STORE_002_a_write_that_finds_no_room_says_so_and_leaves_the_other_slot(void)
{
    const struct rlimit none = {.rlim_cur = POSITION_SLOT_SIZE + 10U, .rlim_max = RLIM_INFINITY};
    const struct rlimit all = {.rlim_cur = RLIM_INFINITY, .rlim_max = RLIM_INFINITY};
    const position_record_t record = record_of(3U);

    keep(2U);
    (void)signal(SIGXFSZ, SIG_IGN);
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &none));
    const bool is_written = position_store_write(path, &record);
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &all));
    TEST_ASSERT_FALSE(is_written);
    assert_read(2U);
}

void test_SWR_STORE_002_a_folder_that_is_not_there_is_said(void)
{
    const position_record_t record = record_of(1U);

    TEST_ASSERT_FALSE(position_store_write("/tmp/no-such-folder/positions", &record));
}

void test_SWR_STORE_003_positions_of_this_power_on_are_good(void)
{
    const position_record_t record = record_of(1U);

    keep(1U);
    TEST_ASSERT_EQUAL_UINT32(KEPT_GOOD, ask(NOW_US, ROBOT, POWER_ON, true));
    TEST_ASSERT_EQUAL_MEMORY(record.axes, kept.axes, sizeof kept.axes);
    TEST_ASSERT_EQUAL_UINT32(KEPT_GOOD, ask(NOW_US + AGE_US, ROBOT, POWER_ON, true));
}

void test_SWR_STORE_003_positions_of_another_robot_are_refused(void)
{
    keep(1U);
    TEST_ASSERT_EQUAL_UINT32(KEPT_OTHER_ROBOT, ask(NOW_US, ROBOT + 1U, POWER_ON, true));
    assert_no_axis_is_kept();
}

void test_SWR_STORE_003_old_positions_are_refused(void)
{
    keep(1U);
    TEST_ASSERT_EQUAL_UINT32(KEPT_TOO_OLD, ask(NOW_US + AGE_US + 1U, ROBOT, POWER_ON, true));
    assert_no_axis_is_kept();
}

void test_SWR_STORE_003_positions_from_the_future_are_refused(void)
{
    keep(1U);
    TEST_ASSERT_EQUAL_UINT32(KEPT_FROM_FUTURE, ask(NOW_US - 1U, ROBOT, POWER_ON, true));
    assert_no_axis_is_kept();
}

void test_SWR_STORE_003_a_box_that_was_used_without_positions_kept_is_reported(void)
{
    TEST_ASSERT_EQUAL_UINT32(KEPT_MISSING, ask(NOW_US, ROBOT, POWER_ON, true));
    assert_no_axis_is_kept();
    keep(1U);
    TEST_ASSERT_EQUAL_UINT32(KEPT_MISSING, ask(NOW_US, ROBOT, POWER_ON + 1U, true));
    assert_no_axis_is_kept();
}

static void assert_damaged(void)
{
    TEST_ASSERT_EQUAL_UINT32(KEPT_DAMAGED, ask(NOW_US, ROBOT, POWER_ON, false));
    assert_no_axis_is_kept();
}

void test_SWR_STORE_003_a_file_without_a_whole_record_is_damaged(void)
{
    spoil(0U, 0U, 0U);
    assert_damaged();
    spoil(0U, 'x', 1U);
    assert_damaged();
    spoil(0U, 0U, 2U * POSITION_SLOT_SIZE);
    assert_damaged();
    keep(1U);
    keep(2U);
    spoil(20U, 0x5AU, 1U);
    spoil(POSITION_SLOT_SIZE + 20U, 0x5AU, 1U);
    assert_damaged();
}

void test_SWR_STORE_003_what_is_no_file_is_damaged_and_waits_for_nobody(void)
{
    TEST_ASSERT_EQUAL_INT(0, mkdir(path, 0700));
    assert_damaged();
    TEST_ASSERT_EQUAL_INT(0, rmdir(path));
    TEST_ASSERT_EQUAL_INT(0, mkfifo(path, 0600));
    assert_damaged();
}

void test_SWR_STORE_003_each_refusal_has_its_words(void)
{
    static const uint32_t refusals[] = {KEPT_MISSING, KEPT_DAMAGED, KEPT_OTHER_ROBOT, KEPT_TOO_OLD,
                                        KEPT_FROM_FUTURE};

    for (uint32_t i = 0U; i < 5U; i++) {
        for (uint32_t k = 0U; k < i; k++) {
            TEST_ASSERT_TRUE(
                strcmp(position_store_why(refusals[i]), position_store_why(refusals[k])) != 0);
        }
    }
}

void test_SWR_STORE_004_positions_of_another_power_on_are_not_used(void)
{
    keep(1U);
    TEST_ASSERT_EQUAL_UINT32(KEPT_NOTHING, ask(NOW_US, ROBOT, POWER_ON + 1U, false));
    assert_no_axis_is_kept();
}

void test_SWR_STORE_004_without_a_file_nothing_was_kept(void)
{
    TEST_ASSERT_EQUAL_UINT32(KEPT_NOTHING, ask(NOW_US, ROBOT, POWER_ON, false));
    assert_no_axis_is_kept();
}

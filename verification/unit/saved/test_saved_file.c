/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a file of positions is of this robot, names each of its axes once, is as it was
 * written, and is neither old nor from the future; or it is refused by name. */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "positions/position_record.h"
#include "robot/robot_neuro.h"
#include "saved/saved_file.h"
#include "saved/saved_seal.h"

#include <stdio.h>
#include <string.h>

#define UTC_US UINT64_C(1795370400000000) /* 2026-11-22T18:00:00Z */
#define SECOND_US UINT64_C(1000000)

static const saved_key_t key = {.bytes = {1U, 2U, 3U}};
static request_saved_positions_t file;
static request_old_motor_t motors[10];
static saved_t saved;

/* As the server writes it, of `record`. */
static void seal(void)
{
    position_record_t record = {
        .utc_us = UTC_US, .power_on = file.power_on, .robot_crc = robot_neuro.crc};
    uint8_t bytes[SAVED_SEAL_SIZE];
    for (uint32_t i = 0U; i < file.axes_count; i++) {
        record.axes[i] = (kept_axis_t){.grade = file.axes[i].grade,
                                       .position_ticks = file.axes[i].position_ticks,
                                       .reading_ticks = file.axes[i].reading_ticks};
    }
    TEST_ASSERT_TRUE(saved_seal_make(&key, &record, bytes));
    saved_write_hmac(bytes, file.hmac);
    file.has_hmac = true;
}

void setUp(void)
{
    (void)memset(&file, 0, sizeof file);
    (void)strcpy(file.format, SAVED_FORMAT);
    (void)strcpy(file.robot, robot_neuro.name);
    saved_write_sum(robot_neuro.crc, file.checksum);
    saved_write_utc(UTC_US, file.saved_utc);
    file.power_on = 0xCAFE0001U;
    file.axes_count = robot_neuro.axis_count;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        (void)strcpy(file.axes[i].name, robot_neuro.axes[i].name);
        file.axes[i].grade = (uint32_t)KEPT_KNOWN;
        file.axes[i].position_ticks = -100 * (int32_t)i;
        file.axes[i].reading_ticks = 7 * (int32_t)i;
        motors[i] = (request_old_motor_t){
            .slot = robot_neuro.axes[i].slot, .current_ticks = (int32_t)i, .homed = i != 2U};
    }
    seal();
}

void tearDown(void)
{
}

static saved_verdict_t read_file(void)
{
    return saved_read_file(&saved, &file, &robot_neuro);
}

static saved_verdict_t judge_at(uint64_t utc_us)
{
    TEST_ASSERT_EQUAL(SAVED_GOOD, read_file());
    return saved_judge(&saved, &key, utc_us);
}

void test_SWR_STORE_026_a_file_is_read_as_it_was_written(void)
{
    TEST_ASSERT_EQUAL(SAVED_GOOD, judge_at(UTC_US));
    TEST_ASSERT_EQUAL(SAVED_SEALED, saved.origin);
    TEST_ASSERT_EQUAL_STRING("2026-11-22T18:00:00Z", file.saved_utc);
    TEST_ASSERT_EQUAL_UINT64(UTC_US, saved.record.utc_us);
    TEST_ASSERT_EQUAL_HEX32(0xCAFE0001U, saved.record.power_on);
    TEST_ASSERT_EQUAL_HEX32(robot_neuro.crc, saved.record.robot_crc);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(-100 * (int32_t)i, saved.record.axes[i].position_ticks);
        TEST_ASSERT_EQUAL_INT32(7 * (int32_t)i, saved.record.axes[i].reading_ticks);
        TEST_ASSERT_EQUAL_UINT32(KEPT_KNOWN, saved.record.axes[i].grade);
    }
}

void test_SWR_STORE_026_axes_may_stand_in_any_order(void)
{
    const request_saved_axis_t first = file.axes[0];
    file.axes[0] = file.axes[6];
    file.axes[6] = first;
    TEST_ASSERT_EQUAL(SAVED_GOOD, judge_at(UTC_US));
    TEST_ASSERT_EQUAL_INT32(-600, saved.record.axes[6].position_ticks);
}

void test_SWR_STORE_026_another_format_robot_or_table_is_refused(void)
{
    file.format[sizeof SAVED_FORMAT - 2U] = '2';
    TEST_ASSERT_EQUAL(SAVED_OTHER_FORMAT, read_file());
    setUp();
    (void)strcpy(file.robot, "bench2");
    TEST_ASSERT_EQUAL(SAVED_OTHER_ROBOT, read_file());
    setUp();
    saved_write_sum(robot_neuro.crc ^ 1U, file.checksum);
    TEST_ASSERT_EQUAL(SAVED_OTHER_TABLE, read_file());
}

void test_SWR_STORE_026_a_checksum_or_seal_that_is_none_is_refused(void)
{
    static const char *const sums[] = {"", "1234567", "1234567g", "1234567G", " 1234567"};
    for (uint32_t i = 0U; i < (sizeof sums / sizeof sums[0]); i++) {
        (void)snprintf(file.checksum, sizeof file.checksum, "%s", sums[i]);
        TEST_ASSERT_EQUAL_MESSAGE(SAVED_BAD_VALUE, read_file(), sums[i]);
    }
    setUp();
    file.hmac[63] = '\0';
    TEST_ASSERT_EQUAL(SAVED_BAD_VALUE, read_file());
    setUp();
    file.hmac[0] = 'x';
    TEST_ASSERT_EQUAL(SAVED_BAD_VALUE, read_file());
}

void test_SWR_STORE_026_a_time_that_is_none_is_refused(void)
{
    static const char *const times[] = {
        "",
        "2026-11-22T18:00:00",
        "2026-11-22T18:00:00z",
        "2026-11-22 18:00:00Z",
        "2026-11-31T18:00:00Z",
        "2026-13-01T18:00:00Z",
        "2026-1-22T18:00:00Z",
        " 2026-1-22T18:00:00Z",
        "2026-11-22T24:00:00Z",
        "1969-11-22T18:00:00Z",
        "2026-11-22T18:00:60Z",
    };
    for (uint32_t i = 0U; i < (sizeof times / sizeof times[0]); i++) {
        (void)snprintf(file.saved_utc, sizeof file.saved_utc, "%s", times[i]);
        TEST_ASSERT_EQUAL_MESSAGE(SAVED_BAD_VALUE, read_file(), times[i]);
    }
}

void test_SWR_STORE_026_a_time_beyond_all_years_is_written_as_nothing(void)
{
    char text[SAVED_UTC_SIZE];
    saved_write_utc(UINT64_MAX, text);
    TEST_ASSERT_EQUAL_STRING("", text);
}

void test_SWR_STORE_026_axes_are_those_of_the_robot_once_each(void)
{
    file.axes_count--;
    TEST_ASSERT_EQUAL(SAVED_BAD_AXES, read_file());
    setUp();
    file.axes[1] = file.axes[0];
    TEST_ASSERT_EQUAL(SAVED_BAD_AXES, read_file());
    setUp();
    (void)strcpy(file.axes[3].name, "elbow");
    TEST_ASSERT_EQUAL(SAVED_BAD_AXES, read_file());
    setUp();
    file.axes[7] = file.axes[0];
    file.axes_count = 8U;
    TEST_ASSERT_EQUAL(SAVED_BAD_AXES, read_file());
}

void test_SWR_STORE_026_what_was_altered_is_refused(void)
{
    file.axes[2].position_ticks++;
    TEST_ASSERT_EQUAL(SAVED_ALTERED, judge_at(UTC_US));
    setUp();
    file.axes[2].grade = (uint32_t)KEPT_LOST;
    TEST_ASSERT_EQUAL(SAVED_ALTERED, judge_at(UTC_US));
    setUp();
    saved_write_utc(UTC_US + SECOND_US, file.saved_utc);
    TEST_ASSERT_EQUAL(SAVED_ALTERED, judge_at(UTC_US + SECOND_US));
    setUp();
    file.power_on++;
    TEST_ASSERT_EQUAL(SAVED_ALTERED, judge_at(UTC_US));
    setUp();
    (void)strcpy(file.axes[0].name, robot_neuro.axes[1].name);
    (void)strcpy(file.axes[1].name, robot_neuro.axes[0].name);
    TEST_ASSERT_EQUAL(SAVED_ALTERED, judge_at(UTC_US));
}

void test_SWR_STORE_026_age_has_an_end_and_the_future_none(void)
{
    const uint64_t most_us = (uint64_t)LIMIT_SAVED_AGE_S * SECOND_US;
    TEST_ASSERT_EQUAL(SAVED_GOOD, judge_at(UTC_US + most_us));
    TEST_ASSERT_EQUAL(SAVED_TOO_OLD, judge_at(UTC_US + most_us + 1U));
    TEST_ASSERT_EQUAL(SAVED_FROM_FUTURE, judge_at(UTC_US - 1U));
}

void test_SWR_STORE_026_without_a_seal_the_age_counts_all_the_same(void)
{
    const uint64_t most_us = (uint64_t)LIMIT_SAVED_AGE_S * SECOND_US;
    file.has_hmac = false;
    file.axes[2].position_ticks++;
    TEST_ASSERT_EQUAL(SAVED_GOOD, judge_at(UTC_US));
    TEST_ASSERT_EQUAL(SAVED_UNSEALED, saved.origin);
    TEST_ASSERT_EQUAL(SAVED_TOO_OLD, judge_at(UTC_US + most_us + 1U));
    TEST_ASSERT_EQUAL(SAVED_FROM_FUTURE, judge_at(UTC_US - 1U));
}

static saved_verdict_t read_motors(uint32_t count)
{
    return saved_read_motors(&saved, motors, count, &robot_neuro);
}

void test_SWR_STORE_028_a_list_of_slots_is_read_by_the_table_of_the_robot(void)
{
    const request_old_motor_t first = motors[0];
    motors[0] = motors[5];
    motors[5] = first;
    TEST_ASSERT_EQUAL(SAVED_GOOD, read_motors(robot_neuro.axis_count));
    TEST_ASSERT_EQUAL(SAVED_GOOD, saved_judge(&saved, &key, UTC_US));
    TEST_ASSERT_EQUAL(SAVED_OLD_LIST, saved.origin);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(i, saved.record.axes[i].position_ticks);
        TEST_ASSERT_EQUAL_UINT32((i != 2U) ? KEPT_KNOWN : KEPT_LOST, saved.record.axes[i].grade);
    }
}

void test_SWR_STORE_028_a_slot_that_is_missing_twice_there_or_strange_is_refused(void)
{
    const request_old_motor_t second = motors[1];
    TEST_ASSERT_EQUAL(SAVED_BAD_SLOTS, read_motors(robot_neuro.axis_count - 1U));
    motors[1] = motors[0];
    TEST_ASSERT_EQUAL(SAVED_BAD_SLOTS, read_motors(robot_neuro.axis_count));
    motors[1] = second;
    motors[1].slot = 9U;
    TEST_ASSERT_EQUAL(SAVED_BAD_SLOTS, read_motors(robot_neuro.axis_count));
}

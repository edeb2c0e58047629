/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: positions are kept when they are news and nothing moves, not too often, and what
 * is in the file is never one of a motion.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "limits/requirement_limits.h"
#include "positions/position_record.h"
#include "positions/position_store.h"
#include "recording/write/position_keeper.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define START_US UINT64_C(5000000)
#define UTC_US UINT64_C(1700000000000000)
#define SECOND_US UINT64_C(1000000)
#define POWER_ON 0xCAFE0001U
#define ROBOT 0x12345678U

static char folder[40];
static char path[64];
static position_keeper_t keeper;
static snapshot_t snapshot;
static position_record_t found;
static uint64_t passed_us;

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-keeper-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(path, sizeof path, "%s/positions", folder);
    position_keeper_open(&keeper, path);
    passed_us = 0U;
    (void)memset(&snapshot, 0, sizeof snapshot);
    snapshot.axis_count = 7U;
    snapshot.power_on = POWER_ON;
    snapshot.robot_crc = ROBOT;
    for (uint32_t i = 0U; i < snapshot.axis_count; i++) {
        snapshot.axes[i].reference = (uint32_t)AXIS_REFERENCE_VERIFIED;
        snapshot.axes[i].position_ticks = 100 * (int32_t)i;
        snapshot.axes[i].reading_ticks = -7 * (int32_t)i;
    }
}

void tearDown(void)
{
    (void)chmod(folder, 0700);
    (void)unlink(path);
    (void)rmdir(path);
    (void)rmdir(folder);
}

static void look_after(uint64_t us)
{
    passed_us += us;
    position_keeper_look(&keeper, &snapshot, START_US + passed_us, UTC_US + passed_us);
}

/* The number of the newest record; 0 when there is none. */
static uint64_t newest(void)
{
    (void)position_store_read(path, &found);
    return found.number;
}

void test_SWR_STORE_007_what_is_shown_is_kept(void)
{
    look_after(0U);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
    TEST_ASSERT_EQUAL_UINT64(UTC_US, found.utc_us);
    TEST_ASSERT_EQUAL_HEX32(POWER_ON, found.power_on);
    TEST_ASSERT_EQUAL_HEX32(ROBOT, found.robot_crc);
    for (uint32_t i = 0U; i < snapshot.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(KEPT_KNOWN, found.axes[i].grade);
        TEST_ASSERT_EQUAL_INT32(100 * (int32_t)i, found.axes[i].position_ticks);
        TEST_ASSERT_EQUAL_INT32(-7 * (int32_t)i, found.axes[i].reading_ticks);
    }
}

void test_SWR_STORE_007_each_grade_is_kept_as_what_it_is_worth(void)
{
    static const struct {
        axis_reference_t reference;
        kept_grade_t grade;
    } worths[] = {{AXIS_REFERENCE_FRESH, KEPT_FRESH},      {AXIS_REFERENCE_LOST, KEPT_LOST},
                  {AXIS_REFERENCE_LEAVE, KEPT_LOST},       {AXIS_REFERENCE_APPROACH, KEPT_LOST},
                  {AXIS_REFERENCE_BACK_OFF, KEPT_LOST},    {AXIS_REFERENCE_LATCH, KEPT_LOST},
                  {AXIS_REFERENCE_UNVERIFIED, KEPT_KNOWN}, {AXIS_REFERENCE_TAKEN, KEPT_KNOWN},
                  {AXIS_REFERENCE_VERIFIED, KEPT_KNOWN}};

    for (uint32_t i = 0U; i < (sizeof worths / sizeof worths[0]); i++) {
        snapshot.axes[2].reference = (uint32_t)worths[i].reference;
        look_after(SECOND_US);
        (void)newest();
        TEST_ASSERT_EQUAL_UINT32(worths[i].grade, found.axes[2].grade);
        TEST_ASSERT_EQUAL_INT32((worths[i].grade == KEPT_KNOWN) ? 200 : 0,
                                found.axes[2].position_ticks);
        TEST_ASSERT_EQUAL_INT32((worths[i].grade != KEPT_LOST) ? -14 : 0,
                                found.axes[2].reading_ticks);
    }
}

void test_SWR_STORE_007_nothing_is_written_without_news(void)
{
    look_after(0U);
    for (uint32_t i = 0U; i < 100U; i++) {
        look_after(SECOND_US);
    }
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
}

void test_SWR_STORE_007_news_are_written_once_a_second_at_most(void)
{
    for (uint32_t i = 0U; i <= 40U; i++) {
        snapshot.axes[0].position_ticks++;
        look_after(50000U);
    }
    TEST_ASSERT_EQUAL_UINT64(3U, newest());
}

void test_SWR_STORE_007_each_kind_of_news_is_written(void)
{
    look_after(0U);
    snapshot.axes[6].reading_ticks++;
    look_after(SECOND_US);
    TEST_ASSERT_EQUAL_UINT64(2U, newest());
    snapshot.power_on++;
    look_after(SECOND_US);
    TEST_ASSERT_EQUAL_UINT64(3U, newest());
    snapshot.robot_crc++;
    look_after(SECOND_US);
    TEST_ASSERT_EQUAL_UINT64(4U, newest());
    snapshot.axes[6].reference = (uint32_t)AXIS_REFERENCE_LOST;
    look_after(SECOND_US);
    TEST_ASSERT_EQUAL_UINT64(5U, newest());
}

void test_SWR_STORE_007_while_an_axis_moves_the_record_before_stays(void)
{
    look_after(0U);
    snapshot.axes[3].position_ticks = 999;
    snapshot.axes[3].drive_mode = (uint32_t)CARD_DRIVE_PWM;
    look_after(SECOND_US);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
    snapshot.axes[3].drive_mode = (uint32_t)CARD_DRIVE_OFF;
    snapshot.axes[3].speed_ticks_per_s_q8 = -1;
    look_after(SECOND_US);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
    position_keeper_close(&keeper, &snapshot, UTC_US + passed_us);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
    snapshot.axes[3].speed_ticks_per_s_q8 = 0;
    look_after(0U);
    TEST_ASSERT_EQUAL_UINT64(2U, newest());
    TEST_ASSERT_EQUAL_INT32(999, found.axes[3].position_ticks);
}

void test_SWR_STORE_007_the_last_speed_of_a_lost_axis_keeps_nothing_back(void)
{
    snapshot.axes[3].reference = (uint32_t)AXIS_REFERENCE_LOST;
    snapshot.axes[3].speed_ticks_per_s_q8 = 77;
    look_after(0U);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
}

void test_SWR_STORE_007_nothing_is_kept_before_every_kept_position_was_compared(void)
{
    snapshot.positions_awaited = 1U;
    look_after(0U);
    TEST_ASSERT_EQUAL_UINT64(0U, newest());
    snapshot.positions_awaited = 0U;
    look_after(0U);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
}

void test_SWR_STORE_007_at_the_end_the_last_news_are_kept(void)
{
    look_after(0U);
    snapshot.axes[0].position_ticks++;
    look_after(1000U);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
    position_keeper_close(&keeper, &snapshot, UTC_US + passed_us);
    TEST_ASSERT_EQUAL_UINT64(2U, newest());
}

void test_SWR_STORE_007_a_record_that_is_still_true_does_not_grow_old(void)
{
    look_after(0U);
    look_after((SECOND_US * LIMIT_STORE_REFRESH_S) - 1U);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
    look_after(1U);
    TEST_ASSERT_EQUAL_UINT64(2U, newest());
}

void test_SWR_STORE_007_a_record_from_the_future_is_written_anew(void)
{
    look_after(0U);
    position_keeper_look(&keeper, &snapshot, START_US + SECOND_US, UTC_US - 1U);
    TEST_ASSERT_EQUAL_UINT64(2U, newest());
    TEST_ASSERT_EQUAL_UINT64(UTC_US - 1U, found.utc_us);
}

void test_SWR_STORE_007_a_recorder_that_is_started_again_goes_on_with_the_other_slot(void)
{
    look_after(0U);
    position_keeper_open(&keeper, path);
    look_after(0U);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
    snapshot.axes[0].position_ticks++;
    look_after(SECOND_US);
    TEST_ASSERT_EQUAL_UINT64(2U, newest());
}

void test_SWR_STORE_007_what_could_not_be_kept_is_tried_again_a_second_later(void)
{
    TEST_ASSERT_EQUAL_INT(0, mkdir(path, 0700));
    look_after(0U);
    TEST_ASSERT_TRUE(keeper.is_failing);
    TEST_ASSERT_EQUAL_INT(0, rmdir(path));
    look_after(SECOND_US - 1U);
    TEST_ASSERT_EQUAL_UINT64(0U, newest());
    look_after(1U);
    TEST_ASSERT_EQUAL_UINT64(1U, newest());
    TEST_ASSERT_FALSE(keeper.is_failing);
}

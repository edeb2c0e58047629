/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a row of a terminal is never left, no part is cut, and what is in trouble is
 * seen before what is well.
 */
#include "unity.h"

#include "charts/loop_guard_chart.h"
#include "interface/loop_figures.h"
#include "limits/requirement_limits.h"
#include "supervisor/status_parts.h"

#include <string.h>

#define TEXT_SIZE 512U

static status_parts_t parts;
static char text[TEXT_SIZE];

void setUp(void)
{
    (void)memset(&parts, 0, sizeof parts);
    status_parts_add(&parts, STATUS_PLAIN, "PLANNING");
    status_parts_add(&parts, STATUS_GOOD, "motion permitted");
    status_parts_add(&parts, STATUS_PLAIN, "pedal %s", "pressed");
    status_parts_add(&parts, STATUS_NOTE, "slicer not connected");
    status_parts_add(&parts, STATUS_BAD, "igtl SILENT");
}

void tearDown(void)
{
}

static void expect(uint32_t columns, bool is_coloured, const char *line)
{
    status_parts_write(&parts, columns, is_coloured, text, sizeof text);
    TEST_ASSERT_EQUAL_STRING(line, text);
}

void test_SWR_SUP_011_without_a_bound_all_stands_in_its_order(void)
{
    expect(0U, false,
           "PLANNING | motion permitted | pedal pressed | slicer not connected | igtl SILENT");
}

void test_SWR_SUP_011_what_fits_exactly_is_whole(void)
{
    expect(80U, false,
           "PLANNING | motion permitted | pedal pressed | slicer not connected | igtl SILENT");
    TEST_ASSERT_EQUAL_size_t(80U, strlen(text));
}

void test_SWR_SUP_011_what_is_least_important_gives_way(void)
{
    expect(79U, false, "PLANNING | motion permitted | slicer not connected | igtl SILENT ...");
    expect(60U, false, "PLANNING | slicer not connected | igtl SILENT ...");
    expect(30U, false, "PLANNING | igtl SILENT ...");
    expect(20U, false, "PLANNING ...");
}

void test_SWR_SUP_011_no_width_is_exceeded_and_the_first_part_is_always_there(void)
{
    for (uint32_t columns = 12U; columns <= 90U; columns++) {
        status_parts_write(&parts, columns, false, text, sizeof text);
        TEST_ASSERT_LESS_OR_EQUAL_size_t(columns, strlen(text));
        TEST_ASSERT_EQUAL_STRING_LEN("PLANNING", text, 8U);
    }
    expect(1U, false, "PLANNING ...");
}

void test_SWR_SUP_011_colours_take_no_column(void)
{
    expect(80U, true,
           "PLANNING | \033[32mmotion permitted\033[0m | pedal pressed | "
           "\033[33mslicer not connected\033[0m | \033[1;31migtl SILENT\033[0m");
}

void test_SWR_SUP_011_what_the_text_does_not_hold_is_left_out_whole(void)
{
    char little[22];

    status_parts_write(&parts, 0U, true, little, sizeof little);
    TEST_ASSERT_EQUAL_STRING("PLANNING", little);
}

void test_SWR_SUP_011_more_parts_than_there_is_room_for_are_left_out(void)
{
    for (uint32_t i = 0U; i <= STATUS_PARTS; i++) {
        status_parts_add(&parts, STATUS_PLAIN, "%u", (unsigned)i);
    }
    TEST_ASSERT_EQUAL_UINT32(STATUS_PARTS, parts.count);
    parts.count = 0U;
    expect(80U, true, "");
}

static void expect_room(uint32_t minutes, status_tone_t tone, const char *words)
{
    parts.count = 0U;
    status_parts_add_room(&parts, minutes);
    TEST_ASSERT_EQUAL_UINT32(1U, parts.count);
    TEST_ASSERT_EQUAL(tone, parts.parts[0].tone);
    TEST_ASSERT_EQUAL_STRING(words, parts.parts[0].text);
}

void test_SWR_REC_037_the_time_until_the_disk_is_full_is_a_part_to_look_at_below_the_limit(void)
{
    expect_room(130U, STATUS_PLAIN, "disk full in 2 h 10 min at this rate");
    expect_room(LIMIT_RECORDING_LEFT_MIN, STATUS_PLAIN, "disk full in 30 min at this rate");
    expect_room(LIMIT_RECORDING_LEFT_MIN - 1U, STATUS_NOTE, "disk full in 29 min at this rate");
    parts.count = 0U;
    status_parts_add_room(&parts, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, parts.count);
}

void test_SWR_CTRL_030_a_loop_that_was_late_too_often_names_stage_and_figures(void)
{
    snapshot_t shown = {.loop = (uint32_t)LOOP_GUARD_STATE_STOPPED,
                        .late_stage = (uint32_t)LOOP_STAGE_WAKE,
                        .late_us = 4100U,
                        .late_count = 3U,
                        .late_span_us = 8700U};
    parts.count = 0U;
    status_parts_add_lateness(&parts, &shown);
    TEST_ASSERT_EQUAL_UINT32(1U, parts.count);
    TEST_ASSERT_EQUAL(STATUS_BAD, parts.parts[0].tone);
    TEST_ASSERT_EQUAL_STRING("loop STOPPED: WAKE late by 4.1 ms, 3 in 8.7 ms", parts.parts[0].text);
    parts.count = 0U;
    shown.loop = (uint32_t)LOOP_GUARD_STATE_ON_TIME;
    status_parts_add_lateness(&parts, &shown);
    TEST_ASSERT_EQUAL_UINT32(0U, parts.count);
}

void test_SWR_SUP_004_a_log_has_the_line_every_five_seconds(void)
{
    status_repeat_t repeat = {.shown_us = 0U};
    uint32_t lines = 0U;

    for (uint64_t i = 1U; i < 11U; i++) {
        lines += status_repeat_is_due(&repeat, &parts, i * UINT64_C(1000000)) ? 1U : 0U;
    }
    TEST_ASSERT_EQUAL_UINT32(2U, lines);
}

void test_SWR_SUP_014_a_log_has_each_trouble_as_it_begins(void)
{
    status_repeat_t repeat = {.shown_us = 0U};

    TEST_ASSERT_TRUE(status_repeat_is_due(&repeat, &parts, 1U));
    TEST_ASSERT_FALSE(status_repeat_is_due(&repeat, &parts, 2U));
    status_parts_add(&parts, STATUS_BAD, "7 cycles NOT RECORDED");
    TEST_ASSERT_TRUE(status_repeat_is_due(&repeat, &parts, 3U));
    TEST_ASSERT_FALSE(status_repeat_is_due(&repeat, &parts, 4U));
    parts.count--;
    TEST_ASSERT_FALSE(status_repeat_is_due(&repeat, &parts, 5U));
    status_parts_add(&parts, STATUS_BAD, "8 cycles NOT RECORDED");
    TEST_ASSERT_TRUE(status_repeat_is_due(&repeat, &parts, 6U));
}

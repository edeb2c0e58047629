/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a table of force and depth is read by the names of its columns, and refused with
 * its line and the reason; what is sampled of it lies on straight lines between its rows.
 */
#include "unity.h"

#include "replay/membranes/force_csv.h"

#include <stdio.h>
#include <string.h>

#define HEAD "time_ms,depth_mm,force_n\n"

static force_csv_t csv;

void setUp(void)
{
    (void)memset(&csv, 0, sizeof csv);
}

void tearDown(void)
{
    force_csv_free(&csv);
}

static void take(const char *text)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, force_csv_read(&csv, text), csv.refused);
}

static void refuse(uint32_t line, const char *reason, const char *text)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(line, force_csv_read(&csv, text), text);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(reason, csv.refused, text);
    TEST_ASSERT_NULL(csv.rows);
}

void test_SWR_PUNCT_554_columns_are_found_by_name_among_others(void)
{
    take("who,force_n,depth_mm,x,time_ms\r\nme,1.5,-2e1,,100.5\r\n,.25,+3,7;8,101\r\n\r\n");
    TEST_ASSERT_EQUAL_UINT32(2U, csv.count);
    TEST_ASSERT_EQUAL_DOUBLE(100.5, csv.rows[0].time_ms);
    TEST_ASSERT_EQUAL_DOUBLE(-20.0, csv.rows[0].depth_mm);
    TEST_ASSERT_EQUAL_DOUBLE(1.5, csv.rows[0].force_n);
    TEST_ASSERT_EQUAL_DOUBLE(3.0, csv.rows[1].depth_mm);
}

void test_SWR_PUNCT_554_a_last_line_needs_no_end(void)
{
    take(HEAD "0,1,2\n1,1,2");
    TEST_ASSERT_EQUAL_UINT32(2U, csv.count);
}

void test_SWR_PUNCT_554_a_head_without_its_columns_is_refused(void)
{
    static const char reason[] = "it must name time_ms, depth_mm and force_n, each once";
    refuse(1U, reason, "");
    refuse(1U, reason, "0,1,2\n");
    refuse(1U, reason, "time_ms,depth_mm\n0,1\n1,1\n");
    refuse(1U, reason, "time_ms,depth_mm,force_n,force_n\n0,1,2,2\n");
    refuse(1U, reason, "time_ms,depth_mm,force_mn\n0,1,2\n");
    refuse(1U, reason, "time_ms;depth_mm;force_n\n0;1;2\n");
    refuse(1U, reason, "time_ms,depth_mm,force_n\r0,1,2\n");
}

void test_SWR_PUNCT_554_a_value_that_is_no_number_is_refused(void)
{
    static const char reason[] = "a value is no decimal number";
    refuse(3U, reason, HEAD "0,1,2\n1,,2\n");
    refuse(2U, reason, HEAD "0,1,nan\n");
    refuse(2U, reason, HEAD "0x1,1,2\n");
    refuse(2U, reason, HEAD "0,1, 2\n");
    refuse(2U, reason, HEAD "0,1,2e\n");
    refuse(3U, reason, HEAD "0,1,2\n\n1,1,2\n");
}

void test_SWR_PUNCT_554_a_row_with_more_or_fewer_values_is_refused(void)
{
    static const char reason[] = "it has not as many values as the head has columns";
    refuse(2U, reason, HEAD "0,1\n");
    refuse(2U, reason, HEAD "0,1,2,3\n");
    refuse(2U, reason, HEAD "0,1,2\r3\n");
}

void test_SWR_PUNCT_554_a_value_beyond_its_range_is_refused(void)
{
    refuse(2U, "depth_mm is not from -1000 to 1000", HEAD "0,1000.1,2\n");
    refuse(2U, "force_n is not from -100 to 100", HEAD "0,1,-100.1\n");
    refuse(2U, "force_n is not from -100 to 100", HEAD "0,1,1e999\n");
    refuse(2U, "time_ms is not from -4000000000 to 4000000000", HEAD "4.1e9,1,2\n");
    take(HEAD "-4e9,-1000,-100\n-3999999999,1000,100\n");
}

void test_SWR_PUNCT_554_a_time_that_stands_goes_back_or_leaps_is_refused(void)
{
    static const char reason[] = "time_ms is not after the row before, or more than 20 after it";
    refuse(3U, reason, HEAD "5,1,2\n5,1,2\n");
    refuse(4U, reason, HEAD "5,1,2\n6,1,2\n5.9,1,2\n");
    refuse(3U, reason, HEAD "5,1,2\n25.1,1,2\n");
    take(HEAD "5,1,2\n25,1,2\n");
}

void test_SWR_PUNCT_554_fewer_than_two_rows_are_refused(void)
{
    refuse(1U, "there are fewer than two rows", HEAD);
    refuse(2U, "there are fewer than two rows", HEAD "0,1,2\n");
}

void test_SWR_PUNCT_554_many_rows_are_all_there(void)
{
    static char text[400000];
    size_t size = (size_t)snprintf(text, sizeof text, HEAD);
    for (uint32_t i = 0U; i < 20000U; i++) {
        size += (size_t)snprintf(&text[size], sizeof text - size, "%u,%u,1\n", i, i % 100U);
    }
    take(text);
    TEST_ASSERT_EQUAL_UINT32(20000U, csv.count);
    TEST_ASSERT_EQUAL_DOUBLE(99.0, csv.rows[19999].depth_mm);
    TEST_ASSERT_EQUAL_UINT32(2U, force_csv_line(0U));
}

void test_SWR_PUNCT_552_each_millisecond_is_on_the_line_between_two_rows(void)
{
    force_samples_t samples = {.csv = &csv};
    force_row_t sample;
    take(HEAD "10.5,0,1\n12.5,4,2\n12.6,4,2\n15.5,10,8\n");
    TEST_ASSERT_TRUE(force_samples_next(&samples, &sample));
    TEST_ASSERT_EQUAL_DOUBLE(10.5, sample.time_ms);
    TEST_ASSERT_EQUAL_DOUBLE(1.0, sample.force_n);
    TEST_ASSERT_TRUE(force_samples_next(&samples, &sample));
    TEST_ASSERT_EQUAL_DOUBLE(2.0, sample.depth_mm);
    TEST_ASSERT_EQUAL_DOUBLE(1.5, sample.force_n);
    TEST_ASSERT_TRUE(force_samples_next(&samples, &sample));
    TEST_ASSERT_EQUAL_DOUBLE(4.0, sample.depth_mm);
    TEST_ASSERT_TRUE(force_samples_next(&samples, &sample));
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 4.0 + (6.0 * 0.9 / 2.9), sample.depth_mm);
    TEST_ASSERT_TRUE(force_samples_next(&samples, &sample));
    TEST_ASSERT_TRUE(force_samples_next(&samples, &sample));
    TEST_ASSERT_EQUAL_DOUBLE(8.0, sample.force_n);
    TEST_ASSERT_FALSE(force_samples_next(&samples, &sample));
}

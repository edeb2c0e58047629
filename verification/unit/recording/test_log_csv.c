/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the log as a table is one that every spreadsheet reads in the same way, and
 * nothing in it is a formula.
 */
#include "unity.h"

#include "recording/archive/log_csv.h"
#include "recording/archive/log_search.h"
#include "common/log_entry.h"
#include "exchange/exchange_segment.h"
#include "interface/event.h"
#include "robot/robot_neuro.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define UTC_US UINT64_C(1790000000123000)
#define HEAD "number,utc,cycle,severity,name,subject,value,cause,peer,text\r\n"

static log_entry_t entry;
static const log_filter_t filter = {.limit = 1U};
static char *text;

void setUp(void)
{
    (void)memset(&entry, 0, sizeof entry);
    entry.utc_us = UTC_US;
    entry.event.number = 7U;
    entry.event.id = (uint32_t)EVENT_ESTOP_PULLED;
    entry.event.value = -3;
}

void tearDown(void)
{
    free(text);
    text = NULL;
}

static void write(const char *sentence, uint32_t count)
{
    const log_search_t found = {.count = count, .filter = &filter, .entries = &entry};
    size_t size = 0U;

    (void)snprintf(entry.text, sizeof entry.text, "%s", sentence);
    free(text);
    text = log_csv_write(&found, &robot_neuro, &size);
    TEST_ASSERT_NOT_NULL(text);
    TEST_ASSERT_EQUAL_size_t(strlen(text), size);
}

void test_SWR_HTTP_042_there_is_a_line_of_names_and_one_for_each_event(void)
{
    write("The e-stop was pulled.", 0U);
    TEST_ASSERT_EQUAL_STRING(HEAD, text);
    write("The e-stop was pulled.", 1U);
    TEST_ASSERT_EQUAL_STRING(HEAD
                             "7,2026-09-21T14:13:20.123Z,0,INFORMATION,ESTOP_PULLED,\"\",-3,NONE,"
                             "0,\"The e-stop was pulled.\"\r\n",
                             text);
}

static void assert_cell(const char *sentence, const char *cell)
{
    char expected[200];

    write(sentence, 1U);
    (void)snprintf(expected, sizeof expected, ",%s\r\n", cell);
    TEST_ASSERT_EQUAL_STRING(expected, &text[strlen(text) - strlen(expected)]);
}

void test_SWR_HTTP_042_quotes_commas_and_ends_of_lines_stay_in_their_cell(void)
{
    assert_cell("a \"quoted\", b", "\"a \"\"quoted\"\", b\"");
    assert_cell("a\r\nb", "\"a\r\nb\"");
    assert_cell("\"", "\"\"\"\"");
}

void test_SWR_HTTP_042_no_cell_is_a_formula(void)
{
    assert_cell("=cmd|' /C calc'!A0", "\"'=cmd|' /C calc'!A0\"");
    assert_cell("+1", "\"'+1\"");
    assert_cell("-1", "\"'-1\"");
    assert_cell("@SUM(A1)", "\"'@SUM(A1)\"");
    assert_cell("\t=1", "\"'\t=1\"");
    assert_cell("\r=1", "\"'\r=1\"");
    assert_cell("1=1", "\"1=1\"");
}

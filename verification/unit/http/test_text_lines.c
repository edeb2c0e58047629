/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: each line of a text comes once, whole and with its number, and none is written
 * beyond its room.
 */
#include "unity.h"

#include "http/login/text_lines.h"

#define ROOM 4U

static char line[ROOM + 1U];
static text_lines_t lines;

void setUp(void)
{
    (void)memset(line, 'x', sizeof line);
}

void tearDown(void)
{
}

static void begin(const char *text, size_t length)
{
    lines = (text_lines_t){.text = text, .length = length};
}

static void expect(const char *expected, unsigned number)
{
    TEST_ASSERT_TRUE(text_lines_next(&lines, line, ROOM));
    TEST_ASSERT_NULL(lines.fault);
    TEST_ASSERT_EQUAL_STRING(expected, line);
    TEST_ASSERT_EQUAL_UINT(number, lines.number);
}

static void expect_fault(unsigned number)
{
    TEST_ASSERT_TRUE(text_lines_next(&lines, line, ROOM));
    TEST_ASSERT_NOT_NULL(lines.fault);
    TEST_ASSERT_EQUAL_STRING("", line);
    TEST_ASSERT_EQUAL_UINT(number, lines.number);
}

void test_SWR_SESS_001_lines_come_in_turn_with_their_numbers(void)
{
    begin("a\n\nbcd\ne", 8U);
    expect("a", 1U);
    expect("", 2U);
    expect("bcd", 3U);
    expect("e", 4U);
    TEST_ASSERT_FALSE(text_lines_next(&lines, line, ROOM));
}

void test_SWR_SESS_001_a_text_ends_with_its_last_line(void)
{
    begin("", 0U);
    TEST_ASSERT_FALSE(text_lines_next(&lines, line, ROOM));
    begin("a\nb", 2U);
    expect("a", 1U);
    TEST_ASSERT_FALSE(text_lines_next(&lines, line, ROOM));
}

void test_SWR_SESS_001_a_line_that_does_not_fit_is_at_fault_and_the_next_is_not(void)
{
    begin("abcd\nabc\nabcde", 14U);
    expect_fault(1U);
    expect("abc", 2U);
    expect_fault(3U);
    TEST_ASSERT_EQUAL('x', line[ROOM]);
}

void test_SWR_SESS_001_a_line_with_a_nul_is_at_fault(void)
{
    begin("a\0b\nc", 5U);
    expect_fault(1U);
    expect("c", 2U);
}

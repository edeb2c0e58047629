/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a row states what the reader cannot know, and nothing else; a row without
 * numbers is exact all the same.
 */
#include "unity.h"

#include "replay/data/bytes.h"
#include "replay/data/tape.h"

static tape_t tape;
static bytes_t row;

void setUp(void)
{
}

void tearDown(void)
{
    tape_free(&tape);
    bytes_free(&row);
}

static const char *take(uint32_t cycle, bool with_numbers, const char *json)
{
    cJSON *const now = cJSON_Parse(json);

    bytes_clear(&row);
    (void)tape_take(&tape, cycle, with_numbers, now, &row);
    bytes_put8(&row, 0U);
    cJSON_Delete(now);
    return (const char *)row.at;
}

void test_SWR_REPLAY_015_the_first_row_has_all_of_it(void)
{
    TEST_ASSERT_EQUAL_STRING("[7,0,{\"a\":1,\"b\":[\"x\"]}]",
                             take(7U, true, "{\"a\":1,\"b\":[\"x\"]}"));
}

void test_SWR_REPLAY_015_later_ones_have_what_changed_at_its_place(void)
{
    (void)take(0U, true, "{\"a\":\"x\",\"b\":{\"c\":false,\"d\":1},\"e\":null}");
    TEST_ASSERT_EQUAL_STRING(
        "[-3,3,true,2,\"y\"]",
        take(3U, false, "{\"a\":\"x\",\"b\":{\"c\":true,\"d\":2},\"e\":\"y\"}"));
    TEST_ASSERT_EQUAL_STRING(
        "[2,4,2]", take(5U, true, "{\"a\":\"x\",\"b\":{\"c\":true,\"d\":2},\"e\":\"y\"}"));
}

void test_SWR_REPLAY_015_a_number_that_goes_on_is_not_reported(void)
{
    (void)take(0U, true, "{\"a\":0,\"b\":1.5}");
    TEST_ASSERT_EQUAL_STRING("[10,1,20]", take(10U, true, "{\"a\":20,\"b\":1.5}"));
    TEST_ASSERT_EQUAL_STRING("[25]", take(35U, true, "{\"a\":70,\"b\":1.5}"));
    TEST_ASSERT_EQUAL_STRING("[5,1,70]", take(40U, true, "{\"a\":70,\"b\":1.5}"));
}

void test_SWR_REPLAY_015_a_part_that_grows_is_reported_whole(void)
{
    (void)take(0U, true, "{\"a\":[],\"b\":1}");
    (void)take(1U, true, "{\"a\":[],\"b\":2}");
    TEST_ASSERT_EQUAL_STRING("[-1,1,[\"x\",\"y\"]]",
                             take(2U, false, "{\"a\":[\"x\",\"y\"],\"b\":3}"));
    TEST_ASSERT_EQUAL_STRING("[1,4,2.25]", take(3U, true, "{\"a\":[\"x\",\"y\"],\"b\":2.25}"));
}

void test_SWR_REPLAY_015_what_stands_behind_a_part_that_shrinks_keeps_its_place(void)
{
    (void)take(0U, true, "{\"a\":[\"x\",\"y\"],\"b\":\"p\"}");
    TEST_ASSERT_EQUAL_STRING("[-1,1,[],3,\"q\"]", take(1U, false, "{\"a\":[],\"b\":\"q\"}"));
}

void test_SWR_REPLAY_015_nothing_to_report_is_no_row(void)
{
    (void)take(0U, true, "{\"a\":1}");
    TEST_ASSERT_EQUAL_STRING("", take(1U, false, "{\"a\":2}"));
    TEST_ASSERT_EQUAL_STRING("[2,1,2]", take(2U, true, "{\"a\":2}"));
}

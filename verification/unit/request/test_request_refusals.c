/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a refused request is answered with its place and with the expected words, type
 * or range.
 */
#include "unity.h"

#include "request/request_body.h"
#include "request/request_fault.h"
#include "request/request_query.h"
#include "unit/support/every_request.h"

#include <stdint.h>
#include <string.h>

#include "unit/request/request_world.inc"

void setUp(void)
{
    (void)memset(&every, 0x5A, sizeof every);
}

void tearDown(void)
{
}

void test_SWR_HTTP_079_a_word_that_is_missing_is_asked_for_with_its_words(void)
{
    static const request_word_t units[] = {{"mm", 0U}, {"deg", 1U}};
    static const request_field_t unit = {
        .name = "unit", .kind = REQUEST_WORD, .word_count = 2U, .words = units};
    static const request_message_t message = {&unit, 1U};
    const request_result_t result = request_read_body(&message, "{}", 2U, NULL);
    TEST_ASSERT_EQUAL_STRING("/unit", result.place);
    TEST_ASSERT_EQUAL_STRING("This is missing. Expected is one of mm, deg.", result.text);
}

void test_SWR_HTTP_153_a_word_that_is_none_of_its_words_is_refused_with_them(void)
{
    static const request_word_t units[] = {{"mm", 0U}, {"deg", 1U}};
    static const request_field_t unit = {.name = "unit",
                                         .kind = REQUEST_WORD,
                                         .size = sizeof(uint32_t),
                                         .word_count = 2U,
                                         .words = units};
    static const request_message_t message = {&unit, 1U};
    static const char inch[] = "{\"unit\":\"inch\"}";
    uint32_t value = 0U;
    const request_result_t result = request_read_body(&message, inch, sizeof inch - 1U, &value);
    TEST_ASSERT_EQUAL(REQUEST_OUT_OF_RANGE, result.fault);
    TEST_ASSERT_EQUAL_STRING("/unit", result.place);
    TEST_ASSERT_EQUAL_STRING("This is outside its range. Expected is one of mm, deg.", result.text);
}

static void say(const char *text, const char *sentence)
{
    const request_result_t result = read_bytes(text, strlen(text));
    TEST_ASSERT_EQUAL_STRING_MESSAGE(sentence, result.text, text);
}

static void say_query(const char *text, const char *sentence)
{
    const request_result_t result = request_read_query(&every_query, text, &every);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(sentence, result.text, text);
}

void test_SWR_HTTP_320_a_byte_that_no_query_may_have_is_named_as_that(void)
{
    say_query("flag=false&name=%c3%a9",
              "A byte of this is no printable ASCII character. Expected is "
              "a string of at most 7 bytes.");
    say_query("flag=false&name=\xC3\xA9",
              "A byte of this is no printable ASCII character. Expected "
              "is a string of at most 7 bytes.");
    say_query("flag=false&count=%3g", "A percent sign of this is not followed by two hexadecimal "
                                      "digits. Expected is a whole number from 0 to 4294967295.");
}

void test_SWR_HTTP_300_a_value_of_another_type_is_named_beside_the_expected_one(void)
{
    say(with("speed_mm_per_s", "\"5\""),
        "This must be a number in mm per s from -10 to 10, and is a string.");
    say(with("count", "true"), "This must be a whole number from 0 to 4294967295, and is true.");
    say(with("ticks", "{}"),
        "This must be a whole number in ticks from -2147483648 to 2147483647, and is an object.");
    say(with("ticks", "1.5"), "This must be a whole number in ticks from -2147483648 to "
                              "2147483647, and is a number with a fraction or an exponent.");
    say(with("flag", "1"), "This must be true or false, and is a number.");
    say(with("flag", "\"true\""), "This must be true or false, and is a string.");
    say(with("name", "null"), "This must be a string of at most 7 bytes, and is null.");
    say(with("workphase", "false"), "This must be one of STOP, MANUAL, and is false.");
    say(with("inner", "[1]"), "This must be an object, and is a list.");
    say(with("point", "7"),
        "This must be a list of 3 values, each a number from -1000 to 1000, and is a number.");
    say(with("point", "[1,\"2\",3]"), "This must be a number from -1000 to 1000, and is a string.");
    say(with("rows", "{}"),
        "This must be a list of 0 to 2 values, each an object, and is an object.");
    say(with("rows", "[\"a\"]"), "This must be an object, and is a string.");
    say("[]", "This must be an object, and is a list.");
}

/* A word that no JSON has is no value of another type. */
void test_SWR_HTTP_300_a_value_that_is_no_json_is_of_no_type(void)
{
    static const char *const names[] = {"flag",      "count", "speed_mm_per_s", "name",
                                        "workphase", "inner", "point"};
    for (size_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        say(with(names[i], "nope"), "This is not JSON.");
        say(with(names[i], "-"), "This is not JSON.");
    }
}

void test_SWR_HTTP_300_a_value_outside_its_range_is_answered_with_the_range(void)
{
    say(with("speed_mm_per_s", "11"),
        "This is outside its range. Expected is a number in mm per s from -10 to 10.");
    say(with("count", "-1"),
        "This is outside its range. Expected is a whole number from 0 to 4294967295.");
    say(with("point", "[1,2,-1000.5]"),
        "This is outside its range. Expected is a number from -1000 to 1000.");
    say(with("point", "[1,2]"), "There are too few or too many of these. Expected is a list of 3 "
                                "values, each a number from -1000 to 1000.");
    say(with("rows", "[{\"depth_mm\":1},{\"depth_mm\":1},{\"depth_mm\":1}]"),
        "There are too few or too many of these. Expected is a list of 0 to 2 values, each an "
        "object.");
    say(with("name", "\"12345678\""), "This is too long. Expected is a string of at most 7 bytes.");
    say("{\"flag\":true}", "This is missing. Expected is a whole number from 0 to 4294967295.");
}

void test_SWR_HTTP_300_a_parameter_is_answered_with_the_expected_value(void)
{
    say_query("flag=false&count=abc", "This is of another type than expected. Expected is a whole "
                                      "number from 0 to 4294967295.");
    say_query("flag=false&speed_mm_per_s=11",
              "This is outside its range. Expected is a number in mm per s from -10 to 10.");
    say_query("flag", "This is of another type than expected. Expected is true or false.");
    say_query("flag=false&workphase=RUN",
              "This is outside its range. Expected is one of STOP, MANUAL.");
    say_query("flag=false&name=12345678",
              "This is too long. Expected is a string of at most 7 bytes.");
    say_query("", "This is missing. Expected is true or false.");
    say_query("flag=false&other=1", "Nothing of this name is expected. Expected are flag, count, "
                                    "ticks, speed_mm_per_s, name, workphase.");
}

void test_SWR_HTTP_011_every_fault_has_a_sentence(void)
{
    for (int fault = (int)REQUEST_OK; fault <= (int)REQUEST_COUNT; fault++) {
        const char *text = request_fault_text((request_fault_t)fault);
        TEST_ASSERT_EQUAL('.', text[strlen(text) - 1U]);
    }
}

/* Names of the object in which the wrong name stands. */
void test_SWR_HTTP_058_the_names_that_are_expected_stand_beside_one_that_is_not(void)
{
    const request_result_t nested = read_bytes("{\"inner\":{\"depth\":1}}", 21U);
    TEST_ASSERT_EQUAL(REQUEST_UNKNOWN, nested.fault);
    TEST_ASSERT_EQUAL_STRING("Nothing of this name is expected. Expected are depth_mm, hard.",
                             nested.text);
    const request_result_t flat = read_bytes("{\"flat\":1}", 10U);
    TEST_ASSERT_NOT_NULL(strstr(flat.text, "Expected are flag, count, "));
}

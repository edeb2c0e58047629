/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a request is read exactly as its tables say, or refused with the place of what
 * is wrong; whatever bytes come, nothing is read or written outside of its room. */
#include "unity.h"

#include "request/request_body.h"
#include "request/request_fault.h"
#include "request/request_query.h"
#include "unit/support/every_request.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "unit/request/request_world.inc"

void setUp(void)
{
    (void)memset(&every, 0x5A, sizeof every);
}

void tearDown(void)
{
}

static void refuse(const char *text, request_fault_t fault, const char *place)
{
    const request_result_t result = read_bytes(text, strlen(text));
    TEST_ASSERT_EQUAL_MESSAGE(fault, result.fault, text);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(place, result.place, text);
}

static void take(const char *text)
{
    refuse(text, REQUEST_OK, "");
}

static void refuse_query(const char *text, request_fault_t fault, const char *place)
{
    const request_result_t result = request_read_query(&every_query, text, &every);
    TEST_ASSERT_EQUAL_MESSAGE(fault, result.fault, text);
    TEST_ASSERT_EQUAL_STRING_MESSAGE(place, result.place, text);
}

void test_SWR_HTTP_011_every_type_is_read(void)
{
    take(" { \"flag\" : true , "
         "\"count\":4294967295,\"ticks\":-2147483648,\"speed_mm_per_s\":-1.25e-1,\r\n"
         "\t\"name\":\"\\u00e9\\n\\ud83d\\ude00\",\"workphase\":\"MANUAL\",\"inner\":{\"depth_mm\":"
         "2,\"hard\":false},"
         "\"point\":[1,2.5,-3],\"rows\":[{\"depth_mm\":4},{\"hard\":true,\"depth_mm\":5}],\"note\":"
         "\"\"}\n");
    TEST_ASSERT_TRUE(every.flag);
    TEST_ASSERT_EQUAL_UINT32(4294967295U, every.count);
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, every.ticks);
    TEST_ASSERT_EQUAL_DOUBLE(-0.125, every.speed_mm_per_s);
    TEST_ASSERT_EQUAL_STRING("\xC3\xA9\n\xF0\x9F\x98\x80", every.name);
    TEST_ASSERT_EQUAL_UINT32(6U, every.workphase);
    TEST_ASSERT_EQUAL_DOUBLE(2.0, every.inner.depth_mm);
    TEST_ASSERT_TRUE(every.inner.has_hard);
    TEST_ASSERT_FALSE(every.inner.hard);
    TEST_ASSERT_EQUAL_UINT32(3U, every.point_count);
    TEST_ASSERT_EQUAL_DOUBLE(-3.0, every.point[2]);
    TEST_ASSERT_EQUAL_UINT32(2U, every.rows_count);
    TEST_ASSERT_EQUAL_DOUBLE(5.0, every.rows[1].depth_mm);
    TEST_ASSERT_TRUE(every.rows[1].hard);
    TEST_ASSERT_TRUE(every.has_note);
    TEST_ASSERT_EQUAL_STRING("", every.note);
}

void test_SWR_HTTP_011_what_is_optional_may_be_missing(void)
{
    (void)memset(&every, 0, sizeof every);
    take(with("flag", "false"));
    TEST_ASSERT_FALSE(every.flag);
    TEST_ASSERT_FALSE(every.has_note);
    TEST_ASSERT_EQUAL_UINT32(0U, every.point_count);
    TEST_ASSERT_FALSE(every.inner.has_hard);
}

void test_SWR_HTTP_011_nothing_and_an_empty_object_say_nothing(void)
{
    static const char *const texts[] = {"", "{}", "{ }", "{}\n", "\r\n\t { } "};
    for (size_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        TEST_ASSERT_EQUAL_MESSAGE(
            REQUEST_OK, request_read_body(&no_members, texts[i], strlen(texts[i]), NULL).fault,
            texts[i]);
    }
    const request_result_t result = request_read_body(&no_members, "{\"a\":1}", 7U, NULL);
    TEST_ASSERT_EQUAL(REQUEST_UNKNOWN, result.fault);
    TEST_ASSERT_EQUAL_STRING("/a", result.place);
}

void test_SWR_HTTP_011_members_are_known_single_and_complete(void)
{
    refuse(with("speed", "1"), REQUEST_UNKNOWN, "/speed");
    refuse(with("Flag", "true"), REQUEST_UNKNOWN, "/Flag");
    refuse(with("", "true"), REQUEST_UNKNOWN, "");
    refuse(with("a/b~c", "1"), REQUEST_UNKNOWN, "/a~1b~0c");
    refuse("{\"flag\":true,\"fl\\u0061g\":true}", REQUEST_TWICE, "/flag");
    refuse("{\"flag\":true,\"flag\":tru", REQUEST_TWICE, "/flag");
    refuse("{\"flag\":true}", REQUEST_MISSING, "/count");
    refuse("{}", REQUEST_MISSING, "/flag");
    refuse("", REQUEST_MISSING, "/flag");
    refuse(with("inner", "{}"), REQUEST_MISSING, "/inner/depth_mm");
    refuse(with("inner", "{\"depth_mm\":1,\"x\":1}"), REQUEST_UNKNOWN, "/inner/x");
    refuse(with("rows", "[{\"depth_mm\":1},{}]"), REQUEST_MISSING, "/rows/1/depth_mm");
    refuse(with("a_name_that_is_longer_than_the_room_for_any_name_is", "1"), REQUEST_UNKNOWN, "");
}

void test_SWR_HTTP_011_values_are_of_their_type(void)
{
    static const char *const others[] = {"null", "\"1\"", "{}",  "[1]",
                                         "true", "1.0",   "1e2", "-1.5"};
    for (size_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        refuse(with("count", others[i]), REQUEST_WRONG_TYPE, "/count");
        refuse(with("ticks", others[i]), REQUEST_WRONG_TYPE, "/ticks");
    }
    refuse(with("flag", "1"), REQUEST_WRONG_TYPE, "/flag");
    refuse(with("flag", "null"), REQUEST_WRONG_TYPE, "/flag");
    refuse(with("speed_mm_per_s", "false"), REQUEST_WRONG_TYPE, "/speed_mm_per_s");
    refuse(with("name", "1"), REQUEST_WRONG_TYPE, "/name");
    refuse(with("workphase", "3"), REQUEST_WRONG_TYPE, "/workphase");
    refuse(with("inner", "[]"), REQUEST_WRONG_TYPE, "/inner");
    refuse(with("inner", "null"), REQUEST_WRONG_TYPE, "/inner");
    refuse(with("point", "{}"), REQUEST_WRONG_TYPE, "/point");
    refuse(with("point", "[1,[2],3]"), REQUEST_WRONG_TYPE, "/point/1");
    refuse(with("rows", "[7]"), REQUEST_WRONG_TYPE, "/rows/0");
    refuse("[]", REQUEST_WRONG_TYPE, "");
    refuse("7", REQUEST_WRONG_TYPE, "");
}

void test_SWR_HTTP_011_values_are_within_their_bounds(void)
{
    refuse(with("count", "4294967296"), REQUEST_OUT_OF_RANGE, "/count");
    refuse(with("count", "99999999999999999999999999"), REQUEST_OUT_OF_RANGE, "/count");
    refuse(with("count", "-1"), REQUEST_OUT_OF_RANGE, "/count");
    take(with("count", "-0"));
    refuse(with("ticks", "2147483648"), REQUEST_OUT_OF_RANGE, "/ticks");
    refuse(with("ticks", "-2147483649"), REQUEST_OUT_OF_RANGE, "/ticks");
    refuse(with("speed_mm_per_s", "10.000001"), REQUEST_OUT_OF_RANGE, "/speed_mm_per_s");
    refuse(with("speed_mm_per_s", "-10.1"), REQUEST_OUT_OF_RANGE, "/speed_mm_per_s");
    refuse(with("speed_mm_per_s", "1e999"), REQUEST_NOT_FINITE, "/speed_mm_per_s");
    refuse(with("speed_mm_per_s", "-1e999"), REQUEST_NOT_FINITE, "/speed_mm_per_s");
    take(with("speed_mm_per_s", "1e-999"));
    refuse(with("workphase", "\"stop\""), REQUEST_OUT_OF_RANGE, "/workphase");
    refuse(with("workphase", "\"\""), REQUEST_OUT_OF_RANGE, "/workphase");
    refuse(with("point", "[1,2]"), REQUEST_COUNT, "/point");
    refuse(with("point", "[]"), REQUEST_COUNT, "/point");
    refuse(with("point", "[1,2,3,4]"), REQUEST_COUNT, "/point");
    refuse(with("rows", "[{\"depth_mm\":1},{\"depth_mm\":1},{\"depth_mm\":1}]"), REQUEST_COUNT,
           "/rows");
    take(with("rows", "[]"));
}

void test_SWR_HTTP_011_what_is_too_long_is_refused(void)
{
    take(with("name", "\"1234567\""));
    TEST_ASSERT_EQUAL_STRING("1234567", every.name);
    refuse(with("name", "\"12345678\""), REQUEST_TOO_LONG, "/name");
    refuse(with("name", "\"123456\\u00e9\""), REQUEST_TOO_LONG, "/name");
    refuse(with("workphase", "\"a_word_that_is_longer_than_the_room_for_any_name\""),
           REQUEST_TOO_LONG, "/workphase");
    refuse(
        with("speed_mm_per_s", "0.00000000000000000000000000000000000000000000000000000000000001"),
        REQUEST_TOO_LONG, "/speed_mm_per_s");
}

void test_SWR_HTTP_011_text_is_json_and_nothing_stands_behind_it(void)
{
    static const char *const numbers[] = {"01",  "-01",      "1.",  ".5",   "+1",  "1e",
                                          "1e+", "1.e1",     "-",   "0x10", "NaN", "nan",
                                          "inf", "Infinity", "1_0", "True", "nul", "1.5.5"};
    for (size_t i = 0U; i < (sizeof numbers / sizeof numbers[0]); i++) {
        refuse(with("speed_mm_per_s", numbers[i]), REQUEST_NOT_JSON, "/speed_mm_per_s");
        refuse(with("count", numbers[i]), REQUEST_NOT_JSON, "/count");
    }
    static const char *const texts[] = {"{} {}",
                                        "{}x",
                                        "{",
                                        "}",
                                        "{{}",
                                        "{]",
                                        "{\"",
                                        "{\"a",
                                        "{a:1}",
                                        "{'a':1}",
                                        "x",
                                        "{,}",
                                        "\xEF\xBB\xBF{}",
                                        "// {}",
                                        "{}/**/"};
    for (size_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        TEST_ASSERT_EQUAL_MESSAGE(
            REQUEST_NOT_JSON,
            request_read_body(&no_members, texts[i], strlen(texts[i]), NULL).fault, texts[i]);
    }
    refuse(with("flag", "true true"), REQUEST_NOT_JSON, "");
    refuse(with("flag", ""), REQUEST_NOT_JSON, "/flag");
    refuse(with("inner", "{\"depth_mm\":1,}"), REQUEST_NOT_JSON, "/inner");
    refuse(with("point", "[1,2,]"), REQUEST_NOT_JSON, "/point/2");
    refuse(with("point", "[1 2]"), REQUEST_NOT_JSON, "/point/0");
    refuse(with("point", "[,1]"), REQUEST_NOT_JSON, "/point/0");
    refuse(with("point", "x"), REQUEST_NOT_JSON, "/point");
    refuse(with("inner", "x"), REQUEST_NOT_JSON, "/inner");
    refuse(with("name", "x"), REQUEST_NOT_JSON, "/name");
    refuse("{\"flag\" true}", REQUEST_NOT_JSON, "/flag");
    refuse("\t", REQUEST_NOT_JSON, "");
    const request_result_t zero = read_bytes("{\0}", 3U);
    TEST_ASSERT_EQUAL(REQUEST_NOT_JSON, zero.fault);
    TEST_ASSERT_EQUAL(REQUEST_NOT_JSON, request_read_body(&no_members, "{}\0", 3U, NULL).fault);
}

void test_SWR_HTTP_011_strings_are_well_formed(void)
{
    static const char *const wrong[] = {"\"\t\"",
                                        "\"\\x\"",
                                        "\"\\u12\"",
                                        "\"\\u00G0\"",
                                        "\"\\u0000\"",
                                        "\"\\ud800\"",
                                        "\"\\ud800\\u0041\"",
                                        "\"\\udc00\"",
                                        "\"\xFF\"",
                                        "\"\xC0\xAF\"",
                                        "\"\xED\xA0\x80\"",
                                        "\"\xE0\x80\xAF\"",
                                        "\"\xF4\x90\x80\x80\"",
                                        "\"\xC3\"",
                                        "\"\xE2\x82\"",
                                        "\"\\ud800x\"",
                                        "\"\xF0\x9F\x98z\"",
                                        "\"\x80\"",
                                        "\"\\ud800\\"};
    for (size_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        refuse(with("name", wrong[i]), REQUEST_NOT_JSON, "/name");
    }
    take(with("name", "\"\\\"\\\\\\/\\b\\f\\r\\t\""));
    TEST_ASSERT_EQUAL_STRING("\"\\/\b\f\r\t", every.name);
    take(with("name", "\"\\u20AC\\u007f\""));
    TEST_ASSERT_EQUAL_STRING("\xE2\x82\xAC\x7F", every.name);
    take(with("name", "\"\xE2\x82\xAC\x7F\""));
}

void test_SWR_HTTP_011_depth_is_that_of_the_tables(void)
{
    char deep[20000];
    (void)memset(deep, '[', sizeof deep);
    TEST_ASSERT_EQUAL(REQUEST_WRONG_TYPE, read_bytes(deep, sizeof deep).fault);
    size_t size = 0U;
    while (size < (sizeof deep - 8U)) {
        size += (size_t)snprintf(&deep[size], sizeof deep - size, "{\"a\":");
    }
    TEST_ASSERT_EQUAL(REQUEST_UNKNOWN, read_bytes(deep, size).fault);
    TEST_ASSERT_EQUAL(REQUEST_WRONG_TYPE, request_read_body(&endless, deep, size, NULL).fault);
}

void test_SWR_HTTP_011_a_place_that_is_too_long_ends_early(void)
{
    char text[600] = "";
    size_t size = 0U;
    for (uint32_t i = 0U; i < REQUEST_DEPTH; i++) {
        size += (size_t)snprintf(&text[size], sizeof text - size,
                                 "{\"a_long_name_that_fills_the_room_of_names_too\":");
    }
    const request_result_t result = request_read_body(&endless, text, size, NULL);
    TEST_ASSERT_EQUAL(REQUEST_WRONG_TYPE, result.fault);
    TEST_ASSERT_EQUAL_size_t(5U * 45U, strlen(result.place));
}

/* Every beginning of a good text is refused, and every changed byte is survived. */
void test_SWR_HTTP_011_no_bytes_lead_astray(void)
{
    const char *text = with("rows", "[{\"depth_mm\":4},{\"hard\":true,\"depth_mm\":5}]");
    const size_t size = strlen(text);
    char changed[1024];
    for (size_t length = 1U; length < size; length++) {
        TEST_ASSERT_NOT_EQUAL(REQUEST_OK, read_bytes(text, length).fault);
    }
    for (size_t place = 0U; place < size; place++) {
        for (unsigned byte = 0U; byte < 256U; byte++) {
            (void)memcpy(changed, text, size);
            changed[place] = (char)byte;
            const request_result_t result = read_bytes(changed, size);
            TEST_ASSERT_TRUE(strlen(result.place) < sizeof result.place);
            TEST_ASSERT_EQUAL(0x5A, every.guard);
        }
    }
}

/* Pieces of texts in any order, from a generator of its own: the same on every run. */
void test_SWR_HTTP_011_random_texts_are_survived(void)
{
    static const char *const pieces[] = {"{",
                                         "}",
                                         "[",
                                         "]",
                                         ",",
                                         ":",
                                         "\"flag\"",
                                         "\"rows\"",
                                         "\"inner\"",
                                         "true",
                                         "1",
                                         "-1e9",
                                         "\"STOP\"",
                                         "\"",
                                         "\\u",
                                         "\xC3",
                                         "\"name\"",
                                         "null",
                                         " ",
                                         "0.5",
                                         "\"point\"",
                                         "\"depth_mm\"",
                                         "\"workphase\"",
                                         "\"count\""};
    uint32_t state = 20261122U;
    for (uint32_t round = 0U; round < 100000U; round++) {
        size_t length = 0U;
        body[0] = '\0';
        while (length < 80U) {
            state = (state * 1664525U) + 1013904223U;
            const size_t piece = (state >> 16U) % (sizeof pieces / sizeof pieces[0]);
            length += (size_t)snprintf(&body[length], sizeof body - length, "%s", pieces[piece]);
        }
        const request_result_t result = read_bytes(body, length);
        TEST_ASSERT_NOT_EQUAL(REQUEST_OK, result.fault);
        TEST_ASSERT_EQUAL(0x5A, every.guard);
    }
}

void test_SWR_HTTP_012_parameters_are_read(void)
{
    refuse_query("flag=true&count=7&ticks=-7&speed_mm_per_s=%2d2.5&name=a%20b&workphase=STOP",
                 REQUEST_OK, "workphase");
    TEST_ASSERT_TRUE(every.flag);
    TEST_ASSERT_EQUAL_UINT32(7U, every.count);
    TEST_ASSERT_EQUAL_INT32(-7, every.ticks);
    TEST_ASSERT_EQUAL_DOUBLE(-2.5, every.speed_mm_per_s);
    TEST_ASSERT_EQUAL_STRING("a b", every.name);
    TEST_ASSERT_EQUAL_UINT32(3U, every.workphase);
    TEST_ASSERT_EQUAL(REQUEST_OK, request_read_query(&no_members, NULL, NULL).fault);
    TEST_ASSERT_EQUAL(REQUEST_OK, request_read_query(&no_members, "", NULL).fault);
}

void test_SWR_HTTP_012_what_differs_is_refused_by_its_name(void)
{
    refuse_query(NULL, REQUEST_MISSING, "flag");
    refuse_query("flag=false&counts=1", REQUEST_UNKNOWN, "counts");
    refuse_query("flag=false&flag=false", REQUEST_TWICE, "flag");
    refuse_query("flag=false&", REQUEST_UNKNOWN, "");
    refuse_query("flag=false&&count=1", REQUEST_UNKNOWN, "");
    refuse_query("flag", REQUEST_WRONG_TYPE, "flag");
    refuse_query("flag=", REQUEST_WRONG_TYPE, "flag");
    refuse_query("flag=1", REQUEST_WRONG_TYPE, "flag");
    refuse_query("%zz=1", REQUEST_UNKNOWN, "");
    refuse_query("%f", REQUEST_UNKNOWN, "");
    refuse_query("count=%", REQUEST_NOT_ENCODED, "count");
    refuse_query("count=%3", REQUEST_NOT_ENCODED, "count");
    refuse_query("count=%3g", REQUEST_NOT_ENCODED, "count");
    refuse_query("count=%00", REQUEST_NOT_ASCII, "count");
    refuse_query("name=%c3%a9", REQUEST_NOT_ASCII, "name");
    refuse_query("name=12345678", REQUEST_TOO_LONG, "name");
    refuse_query("workphase=RUN", REQUEST_OUT_OF_RANGE, "workphase");
    static const char *const numbers[] = {"01",  "+1",  " 1",  "1 ",  "1.5", "0x10",
                                          "1e2", "abc", "1\n", "--1", "1&"};
    for (size_t i = 0U; i < (sizeof numbers / sizeof numbers[0]) - 1U; i++) {
        char query[32];
        (void)snprintf(query, sizeof query, "count=%s", numbers[i]);
        const bool is_control = strchr(query, '\n') != NULL;
        refuse_query(query, is_control ? REQUEST_NOT_ASCII : REQUEST_WRONG_TYPE, "count");
    }
    refuse_query("count=-1", REQUEST_OUT_OF_RANGE, "count");
    refuse_query("count=4294967296", REQUEST_OUT_OF_RANGE, "count");
    refuse_query("count=1000000000000000000000000000000000000000000000000000000000000000000000",
                 REQUEST_TOO_LONG, "count");
    (void)memset(body, '1', 300U);
    (void)memcpy(body, "count=", 6U);
    body[300] = '\0';
    refuse_query(body, REQUEST_TOO_LONG, "count");
    (void)memset(body, 'a', 300U);
    refuse_query(body, REQUEST_UNKNOWN, "");
}

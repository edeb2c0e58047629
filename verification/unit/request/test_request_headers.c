/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: what a header says is what RFC 9110 has it say, and half a word says nothing. */
#include "unity.h"

#include "request/request_headers.h"

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_HTTP_015_gzip_is_taken_when_it_is_named(void)
{
    static const char *const takes[] = {"gzip",
                                        "GZip",
                                        "deflate, gzip, br",
                                        "gzip;q=0.5",
                                        "br,gzip;q=1",
                                        "*",
                                        "br;q=1.0, *;q=0.1",
                                        "gzip , br",
                                        "identity;q=0, gzip ;q=0.001"};
    static const char *const refuses[] = {
        "",      "br",       "gzipped",     "x-gzip", "gzip;q=0", "gzip; q=0.000", "*, gzip;q=0",
        "*;q=0", "identity", "deflate, br", ",",      "agzip"};
    for (size_t i = 0U; i < (sizeof takes / sizeof takes[0]); i++) {
        TEST_ASSERT_TRUE_MESSAGE(request_headers_take_gzip(takes[i]), takes[i]);
    }
    for (size_t i = 0U; i < (sizeof refuses / sizeof refuses[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(request_headers_take_gzip(refuses[i]), refuses[i]);
    }
    TEST_ASSERT_FALSE(request_headers_take_gzip(NULL));
}

void test_SWR_HTTP_014_what_the_client_has_is_known_by_its_tag(void)
{
    static const char *const knows[] = {
        "\"ab\"", "W/\"ab\"", "*", "\"x\", \"ab\"", "\"x\",W/\"ab\" , \"y\"", "\"ab\" "};
    static const char *const others[] = {"",      "ab",      "\"a\"",   "\"abc\"", "\"ab",
                                         "\"x\"", "W/\"x\"", "\"ab\"x", "**"};
    for (size_t i = 0U; i < (sizeof knows / sizeof knows[0]); i++) {
        TEST_ASSERT_TRUE_MESSAGE(request_headers_know(knows[i], "\"ab\""), knows[i]);
    }
    for (size_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(request_headers_know(others[i], "\"ab\""), others[i]);
    }
    TEST_ASSERT_FALSE(request_headers_know(NULL, "\"ab\""));
}

void test_SWR_HTTP_020_json_is_named_or_nothing_is(void)
{
    TEST_ASSERT_TRUE(request_headers_are_json(NULL));
    TEST_ASSERT_TRUE(request_headers_are_json("application/json"));
    TEST_ASSERT_TRUE(request_headers_are_json("Application/JSON ; charset=utf-8"));
    static const char *const others[] = {"",
                                         "text/plain",
                                         "application/jsonp",
                                         "multipart/form-data; boundary=x",
                                         "application/x-www-form-urlencoded",
                                         "x;application/json"};
    for (size_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(request_headers_are_json(others[i]), others[i]);
    }
}

void test_SWR_HTTP_016_the_last_event_is_a_number(void)
{
    uint32_t number = 0U;
    TEST_ASSERT_TRUE(request_headers_number("4294967295", &number));
    TEST_ASSERT_EQUAL_UINT32(4294967295U, number);
    static const char *const others[] = {"", "-1", "1.5", "4294967296", "0x1", "1 ", "00000000001"};
    for (size_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(request_headers_number(others[i], &number), others[i]);
    }
    TEST_ASSERT_FALSE(request_headers_number(NULL, &number));
}

void test_SWR_SESS_012_one_cookie_of_a_name_counts(void)
{
    char value[5] = "";
    TEST_ASSERT_TRUE(request_headers_cookie("a=1; bs=abcd; c=2", "bs", value, sizeof value));
    TEST_ASSERT_EQUAL_STRING("abcd", value);
    TEST_ASSERT_TRUE(request_headers_cookie("bs=", "bs", value, sizeof value));
    TEST_ASSERT_EQUAL_STRING("", value);
    static const char *const none[] = {"",      "a=1",    "bs",         "xbs=1",
                                       "bs =1", "a=bs=1", "bs=1; bs=1", "bs=abcde",
                                       "BS=1",  "bsx=1",  "bs=1;bs=",   "bs=abcde; bs=1"};
    for (size_t i = 0U; i < (sizeof none / sizeof none[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(request_headers_cookie(none[i], "bs", value, sizeof value),
                                  none[i]);
    }
    TEST_ASSERT_FALSE(request_headers_cookie(NULL, "bs", value, sizeof value));
}

void test_SWR_HTTP_059_a_client_that_expects_to_go_on_says_so(void)
{
    TEST_ASSERT_TRUE(request_headers_expect("1.1", "100-continue"));
    TEST_ASSERT_TRUE(request_headers_expect("1.1", "100-Continue"));
    TEST_ASSERT_FALSE(request_headers_expect("1.1", "100"));
    TEST_ASSERT_FALSE(request_headers_expect("1.1", ""));
    TEST_ASSERT_FALSE(request_headers_expect("1.1", NULL));
}

void test_SWR_HTTP_077_an_expectation_that_is_repeated_is_one_and_that_of_http_1_0_none(void)
{
    TEST_ASSERT_TRUE(request_headers_expect("1.1", "100-continue, 100-continue"));
    TEST_ASSERT_FALSE(request_headers_expect("1.0", "100-continue"));
}

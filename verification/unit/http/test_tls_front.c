/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the file that says how TLS leads here is read whole or refused, and names the
 * hosts that are served. */
#include "unity.h"

#include "http/login/tls_front.h"

#include <stdio.h>
#include <string.h>

#define GOOD                                                                                       \
    "# outside\nhosts = robot.example, 10.0.0.2\nconsole = 8443\nstop=8444\n"                      \
    "console-from = 8081\nstop-from = 8082\ncertificate = /c.pem\nkey = /k.pem\n"

static tls_front_t front;
static char error[256];

void setUp(void)
{
}

void tearDown(void)
{
}

static bool parse(const char *text)
{
    return tls_front_parse(&front, "F", text, strlen(text), error, sizeof error);
}

/* GOOD with `new` in place of `old`. */
static bool parse_with(const char *old, const char *new)
{
    char text[1000];
    const char *place = strstr(GOOD, old);
    TEST_ASSERT_NOT_NULL_MESSAGE(place, old);
    (void)snprintf(text, sizeof text, "%.*s%s%s", (int)(place - GOOD), GOOD, new,
                   &place[strlen(old)]);
    return parse(text);
}

void test_SWR_SESS_019_hosts_ports_and_files_are_read(void)
{
    TEST_ASSERT_TRUE_MESSAGE(parse(GOOD), error);
    TEST_ASSERT_EQUAL_UINT32(2U, front.host_count);
    TEST_ASSERT_EQUAL_UINT16(8444U, front.stop);
    TEST_ASSERT_EQUAL_STRING("/k.pem", front.key);
    TEST_ASSERT_TRUE(tls_front_serves(&front, 8443U, "Robot.example:8443"));
    TEST_ASSERT_TRUE(tls_front_serves(&front, 443U, "10.0.0.2"));
    TEST_ASSERT_FALSE(tls_front_serves(&front, 8443U, "10.0.0.2"));
    TEST_ASSERT_FALSE(tls_front_serves(&front, 8443U, "robot.example:8444"));
    TEST_ASSERT_FALSE(tls_front_serves(&front, 8443U, "robot.example.evil:8443"));
}

void test_SWR_SESS_019_what_cannot_be_read_is_refused_with_its_line(void)
{
    static const char *const wrong[][2] = {{"8443", "8443s"},
                                           {"8443", "8443r"},
                                           {"8443", "0"},
                                           {"8443", "65536"},
                                           {"8443", "127.0.0.1:8443"},
                                           {"8443", ""},
                                           {"robot", "Robot"},
                                           {", 10.0.0.2", ","},
                                           {", 10.0.0.2", ",a,b,c,d"},
                                           {"/c.pem", "c.pem"},
                                           {"stop=8444", "stop 8444"},
                                           {"stop=8444", "Stop=8444"},
                                           {"stop=8444", "console=8444"}};
    for (size_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(parse_with(wrong[i][0], wrong[i][1]), wrong[i][1]);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "F, line "), error);
    }
}

void test_SWR_SESS_019_nothing_is_missing_and_no_port_is_double(void)
{
    TEST_ASSERT_FALSE(parse_with("key = /k.pem\n", ""));
    TEST_ASSERT_EQUAL_STRING("F: \"key\" is missing.", error);
    TEST_ASSERT_FALSE(parse_with("8082", "8443"));
    TEST_ASSERT_EQUAL_STRING("F: port 8443 is given twice.", error);
    TEST_ASSERT_FALSE(tls_front_read(&front, "/nowhere/tls", error, sizeof error));
}

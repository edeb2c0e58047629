/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a file of ports says what is opened and who may connect, or is refused with its
 * line.
 */
#include "igtl/server/igtl_ports.h"
#include "unity.h"

#include <stdio.h>
#include <string.h>

#define FULL                                                                                       \
    "# Two labs.\n"                                                                                \
    "[slicer]\r\n"                                                                                 \
    "  dialect = brp-2021\n"                                                                       \
    "connect = 192.168.1.10:18944\n"                                                               \
    "entry-prefix = ENT_\n"                                                                        \
    "\n"                                                                                           \
    "[near]\n"                                                                                     \
    "listen=127.0.0.1:18936\n"                                                                     \
    "dialect=brp-2013\n"                                                                           \
    "[far]\n"                                                                                      \
    "allow = 192.168.1.10 , 10.0.0.0/8\n"                                                          \
    "listen = 0.0.0.0:18945\n"                                                                     \
    "dialect = crtk"

static igtl_ports_t ports;
static char error[300];

static bool parse(const char *text)
{
    error[0] = '\0';
    return igtl_ports_parse(&ports, "ports.ini", text, strlen(text), error, sizeof error);
}

static void refuses(const char *text, const char *sentence)
{
    TEST_ASSERT_FALSE_MESSAGE(parse(text), text);
    TEST_ASSERT_EQUAL_STRING(sentence, error);
}

/* One section with a line of its own. */
static void refuses_line(const char *line, const char *sentence)
{
    char text[400];

    (void)snprintf(text, sizeof text, "[a]\n%s\n", line);
    refuses(text, sentence);
}

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_IGTL_023_file_says_the_ports(void)
{
    char place[IGTL_PLACE_SIZE];

    TEST_ASSERT_TRUE_MESSAGE(parse(FULL), error);
    TEST_ASSERT_EQUAL_UINT32(3U, ports.count);
    TEST_ASSERT_EQUAL_STRING("slicer", ports.ports[0].name);
    TEST_ASSERT_EQUAL_INT(IGTL_LANGUAGE_BRP_2021, ports.ports[0].language);
    TEST_ASSERT_TRUE(ports.ports[0].is_calling);
    igtl_port_place(ports.ports[0].address, ports.ports[0].number, place);
    TEST_ASSERT_EQUAL_STRING("192.168.1.10:18944", place);
    TEST_ASSERT_EQUAL_STRING("ENT_", ports.ports[0].entry_prefix);
    TEST_ASSERT_EQUAL_INT(IGTL_LANGUAGE_BRP_2013, ports.ports[1].language);
    TEST_ASSERT_FALSE(ports.ports[1].is_calling);
    TEST_ASSERT_EQUAL_UINT16(18936U, ports.ports[1].number);
    TEST_ASSERT_EQUAL_STRING("ENTRY_", ports.ports[1].entry_prefix);
    TEST_ASSERT_EQUAL_INT(IGTL_LANGUAGE_CRTK, ports.ports[2].language);
}

void test_SWR_IGTL_024_only_who_is_allowed_may_connect(void)
{
    TEST_ASSERT_TRUE_MESSAGE(parse(FULL), error);
    TEST_ASSERT_TRUE(igtl_port_allows(&ports.ports[2], 0xC0A8010AU));
    TEST_ASSERT_FALSE(igtl_port_allows(&ports.ports[2], 0xC0A8010BU));
    TEST_ASSERT_TRUE(igtl_port_allows(&ports.ports[2], 0x0AFFFFFFU));
    TEST_ASSERT_FALSE(igtl_port_allows(&ports.ports[2], 0x0B000000U));
    TEST_ASSERT_TRUE(igtl_port_allows(&ports.ports[1], 0x7F000001U));
    TEST_ASSERT_TRUE(parse("[a]\ndialect=crtk\nlisten=0.0.0.0:1\nallow=0.0.0.0/0\n"));
    TEST_ASSERT_TRUE(igtl_port_allows(&ports.ports[0], 0xFFFFFFFFU));
}

void test_SWR_IGTL_023_without_a_file_there_are_two_ports(void)
{
    TEST_ASSERT_TRUE(igtl_ports_set(&ports, "127.0.0.1", 18936U, 18944U));
    TEST_ASSERT_EQUAL_UINT32(2U, ports.count);
    TEST_ASSERT_EQUAL_INT(IGTL_LANGUAGE_BRP_2013, ports.ports[0].language);
    TEST_ASSERT_EQUAL_INT(IGTL_LANGUAGE_CRTK, ports.ports[1].language);
    TEST_ASSERT_EQUAL_UINT32(0x7F000001U, ports.ports[1].address);
    TEST_ASSERT_FALSE(igtl_ports_set(&ports, "localhost", 18936U, 18944U));
}

void test_SWR_IGTL_023_what_is_no_section_or_key_is_refused_with_its_line(void)
{
    refuses("", "ports.ini, line 0: It names no port.");
    refuses("# nothing\n\n", "ports.ini, line 2: It names no port.");
    refuses("dialect = crtk\n", "ports.ini, line 1: \"dialect\" stands before the first [NAME].");
    refuses("[a\n", "ports.ini, line 1: \"[a\" lacks its ].");
    refuses("[a b]\n", "ports.ini, line 1: \"a b\" is no name: 1 to 15 letters, digits, - or _.");
    refuses("[sixteen-letters-]\n", "ports.ini, line 1: \"sixteen-letters-\" is no name: 1 to 15 "
                                    "letters, digits, - or _.");
    refuses_line("dialect", "ports.ini, line 2: \"dialect\" is neither [NAME] nor KEY = VALUE.");
    refuses_line("speed = 9", "ports.ini, line 2: \"speed\" is unknown; there are dialect, listen, "
                              "connect, allow, entry-prefix.");
    refuses_line("dialect = crtk\ndialect = crtk",
                 "ports.ini, line 3: \"dialect\" is given twice.");
    refuses_line("dialect = cr\xC3\xBCk", "ports.ini, line 2: It is no plain text.");
    TEST_ASSERT_FALSE(igtl_ports_parse(&ports, "f", "[a]\ndi\0a=1", 9U, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("f, line 2: It is no plain text.", error);
}

void test_SWR_IGTL_023_line_that_is_too_long_is_refused(void)
{
    char text[300];

    (void)memset(text, ' ', sizeof text);
    text[199] = '\n';
    TEST_ASSERT_FALSE(igtl_ports_parse(&ports, "f", text, 200U, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("f, line 1: It names no port.", error);
    text[199] = ' ';
    TEST_ASSERT_FALSE(igtl_ports_parse(&ports, "f", text, 200U, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("f, line 1: It is longer than 199 characters.", error);
}

void test_SWR_IGTL_023_wrong_values_are_refused_with_their_line(void)
{
    static const char *const places[] = {"18944",
                                         "localhost:18944",
                                         "1.2.3:18944",
                                         "1.2.3.4:",
                                         "1.2.3.4:0",
                                         "1.2.3.4:65536",
                                         "1.2.3.4:018944",
                                         "1.2.3.4:4294985240",
                                         "1.2.3.4:18x",
                                         "1.2.3.4 :1",
                                         "01.002.3.256:1",
                                         "::1",
                                         "1.2.3.4.5.6.7.8.9.0.1.2.3.4.5.6:1"};
    static const char *const lists[] = {
        "",
        "192.168.1.10,",
        "192.168.1.10/33",
        "192.168.1.10/24",
        "1.2.3.4/",
        "1.2.3.4/08",
        "slicer",
        "192.168.1.100/24                 ,1.2.3.4",
        "0.0.0.0/0,0.0.0.0/0,0.0.0.0/0,0.0.0.0/0,0.0.0.0/0,0.0.0.0/0,0.0.0.0/0,0.0.0.0/0,1.2.3.4"};
    static const char *const prefixes[] = {"", "A B_", "NINE_LONG", "TGT_", "TGT_1", "C", "ACK"};
    char line[200];

    for (uint32_t i = 0U; i < (sizeof places / sizeof places[0]); i++) {
        (void)snprintf(line, sizeof line, "[a]\nlisten = %s\n", places[i]);
        TEST_ASSERT_FALSE_MESSAGE(parse(line), line);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "ports.ini, line 2: \""), error);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "is no ADDRESS:PORT"), error);
    }
    for (uint32_t i = 0U; i < (sizeof lists / sizeof lists[0]); i++) {
        (void)snprintf(line, sizeof line, "[a]\nallow = %s\n", lists[i]);
        TEST_ASSERT_FALSE_MESSAGE(parse(line), line);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "is no list of at most 8"), error);
    }
    for (uint32_t i = 0U; i < (sizeof prefixes / sizeof prefixes[0]); i++) {
        (void)snprintf(line, sizeof line, "[a]\nentry-prefix = %s\n", prefixes[i]);
        TEST_ASSERT_FALSE_MESSAGE(parse(line), line);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "is no prefix"), error);
    }
    refuses_line("dialect = brp",
                 "ports.ini, line 2: \"brp\" is no dialect; use brp-2013, brp-2021 or crtk.");
    refuses_line("connect = 0.0.0.0:1",
                 "ports.ini, line 2: 0.0.0.0 cannot be called; give the peer's address.");
}

void test_SWR_IGTL_023_section_without_what_it_needs_is_refused_with_its_line(void)
{
    refuses_line("listen = 127.0.0.1:1", "ports.ini, line 1: [a] says no dialect.");
    refuses_line("dialect = crtk", "ports.ini, line 1: [a] needs either listen or connect.");
    refuses_line("dialect = crtk\nlisten = 127.0.0.1:1\nconnect = 127.0.0.1:2",
                 "ports.ini, line 1: [a] needs either listen or connect.");
    refuses_line("dialect = crtk\nconnect = 127.0.0.1:1\nallow = 127.0.0.1",
                 "ports.ini, line 1: [a] connects, and needs no allow.");
    refuses_line("dialect = crtk\nlisten = 127.0.0.1:1\nentry-prefix = A_",
                 "ports.ini, line 1: [a] has no use for entry-prefix.");
    refuses_line("dialect = crtk\nlisten = 0.0.0.0:1",
                 "ports.ini, line 1: [a] can be reached by other machines: say in allow by which "
                 "(0.0.0.0/0 is everyone).");
    refuses("[a]\ndialect=crtk\n[b]\n", "ports.ini, line 1: [a] needs either listen or connect.");
}

static void same(const char *one, const char *other, bool is_refused)
{
    char text[300];

    (void)snprintf(text, sizeof text, "[a]\ndialect=crtk\n%s\n[b]\ndialect=crtk\n%s\n", one, other);
    TEST_ASSERT_EQUAL_MESSAGE(is_refused, !parse(text), text);
    if (is_refused) {
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, ": [a] and [b] have the same address."), error);
    }
}

void test_SWR_IGTL_023_two_ports_of_one_address_are_refused(void)
{
    same("listen=127.0.0.1:1", "listen=127.0.0.1:1", true);
    same("listen=127.0.0.1:1", "listen=127.0.0.1:2", false);
    same("listen=127.0.0.1:1", "connect=127.0.0.1:1", true);
    same("listen=0.0.0.0:1\nallow=1.2.3.4", "listen=127.0.0.1:1", true);
    same("listen=0.0.0.0:1\nallow=1.2.3.4", "connect=127.0.0.1:1", true);
    same("connect=1.2.3.4:1", "listen=0.0.0.0:1\nallow=1.2.3.4", false);
    same("listen=1.2.3.4:1\nallow=1.2.3.4", "listen=0.0.0.0:1\nallow=1.2.3.4", true);
    same("connect=1.2.3.4:1", "connect=1.2.3.4:1", true);
    same("connect=1.2.3.4:1", "connect=1.2.3.5:1", false);
}

void test_SWR_IGTL_023_too_many_ports_and_doubled_names_are_refused(void)
{
    char text[400] = "";

    for (uint32_t i = 0U; i <= IGTL_PORTS; i++) {
        const size_t used = strlen(text);

        (void)snprintf(&text[used], sizeof text - used,
                       "[p%u]\ndialect=crtk\nlisten=127.0.0.1:%u\n", (unsigned)i,
                       (unsigned)(i + 1U));
    }
    refuses(text, "ports.ini, line 13: There may be 4 ports.");
    refuses("[a]\ndialect=crtk\nlisten=127.0.0.1:1\n[a]\n",
            "ports.ini, line 4: [a] is there twice.");
}

void test_SWR_IGTL_023_file_that_cannot_be_read_is_named(void)
{
    TEST_ASSERT_FALSE(igtl_ports_read(&ports, "/nowhere/ports.ini", error, sizeof error));
    TEST_ASSERT_EQUAL_STRING(
        "The file of ports /nowhere/ports.ini cannot be read: No such file or directory.", error);
    TEST_ASSERT_FALSE(igtl_ports_read(&ports, "/dev/zero", error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("The file of ports /dev/zero cannot be read: it is too long.", error);
    TEST_ASSERT_FALSE(igtl_ports_read(&ports, "/", error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("The file of ports / cannot be read: it is no file.", error);
}

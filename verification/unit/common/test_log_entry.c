/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an event and its time come out of a line of the log as they went in, and what is
 * no time and no such line is none.
 */
#include "unity.h"

#include "common/log_entry.h"
#include "common/utc_text.h"
#include "exchange/exchange.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_peers.h"
#include "exchange/exchange_segment.h"
#include "interface/app/names.h"
#include "interface/event.h"
#include "interface/mode_list.h"
#include "robot/robot_neuro.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define UTC_US UINT64_C(1790000000123000) /* 2026-09-21T14:13:20.123Z */

static char name[48];
static char error[256];
static exchange_t *exchange;
static log_entry_t entry;
static log_entry_t again;
static char line[LOG_ENTRY_LINE_SIZE];

void setUp(void)
{
    (void)snprintf(name, sizeof name, "test-log-entry-%d", (int)getpid());
    exchange = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(exchange, error);
    exchange_publish_robot(exchange, &robot_neuro);
    (void)memset(&entry, 0, sizeof entry);
    (void)memset(&again, 0, sizeof again);
}

void tearDown(void)
{
    exchange_close(exchange);
}

static void make(const event_t *event)
{
    const exchange_event_t dated = {.event = *event, .utc_us = UTC_US};

    log_entry_make(&entry, exchange, &dated);
}

static void assert_comes_back(const event_t *event)
{
    make(event);
    log_entry_write(&entry, line);
    TEST_ASSERT_TRUE_MESSAGE(log_entry_read(&again, line), line);
    TEST_ASSERT_EQUAL_MEMORY(&entry.event, &again.event, sizeof entry.event);
    TEST_ASSERT_EQUAL_UINT64(UTC_US, again.utc_us);
    TEST_ASSERT_EQUAL_STRING(entry.text, again.text);
}

void test_SWR_EVENT_013_every_event_comes_back_out_of_its_line(void)
{
    for (uint32_t id = 0U; id < (uint32_t)EVENT_ID_COUNT; id++) {
        if (strcmp(event_id_name((int32_t)id), "UNKNOWN") == 0) {
            continue; /* No event has this code. */
        }
        const event_t event = {.number = UINT32_MAX - id,
                               .cycle = id,
                               .id = id,
                               .severity = id % 3U,
                               .subject = 1U,
                               .value = INT32_MIN,
                               .cause = (uint32_t)EVENT_CAUSE_CARD,
                               .peer = 3U};
        assert_comes_back(&event);
    }
}

void test_SWR_EVENT_013_a_line_says_all_of_an_event_in_its_order(void)
{
    const event_t event = {
        .number = 7U, .cycle = 12U, .id = (uint32_t)EVENT_ESTOP_PULLED, .severity = 2U};

    make(&event);
    log_entry_write(&entry, line);
    TEST_ASSERT_EQUAL_STRING("2026-09-21T14:13:20.123Z 7 cycle=12 CRITICAL ESTOP_PULLED subject=0 "
                             "value=0 cause=NONE peer=0 The e-stop was pulled.\n",
                             line);
}

void test_SWR_EVENT_013_what_is_no_event_is_none(void)
{
    static const char *const lines[] = {"",
                                        "\n",
                                        "2026-09-21T14:13:20.123Z 7 EVENTS_LOST value=3\n",
                                        "2026-09-21T14:13:20.123Z 7 cycle=12 CRITICAL ESTOP_PULLED "
                                        "subject=0 value=0 cause=NONE peer=0",
                                        "2026-09-21 14:13:20.123Z 7 cycle=12 CRITICAL ESTOP_PULLED "
                                        "subject=0 value=0 cause=NONE peer=0 a",
                                        "2026-09-21T14:13:20.123Z 7 cycle=12 AWFUL ESTOP_PULLED "
                                        "subject=0 value=0 cause=NONE peer=0 a",
                                        "2026-09-21T14:13:20.123Z 7 cycle=12 CRITICAL NOTHING "
                                        "subject=0 value=0 cause=NONE peer=0 a",
                                        "2026-09-21T14:13:20.123Z 7 cycle=12 CRITICAL ESTOP_PULLED "
                                        "subject=0 value=0 cause=NO peer=0 a"};

    for (size_t i = 0U; i < (sizeof lines / sizeof lines[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(log_entry_read(&entry, lines[i]), lines[i]);
    }
}

static void assert_time(const char *text, uint64_t expected_us)
{
    uint64_t utc_us = 0U;

    TEST_ASSERT_TRUE_MESSAGE(utc_text_read(text, &utc_us), text);
    TEST_ASSERT_EQUAL_UINT64_MESSAGE(expected_us, utc_us, text);
}

void test_SWR_EVENT_013_a_time_is_read_as_iso_8601_has_it(void)
{
    assert_time("1970-01-01T00:00:00Z", 0U);
    assert_time("2026-09-21T14:13:20Z", UINT64_C(1790000000000000));
    assert_time("2026-09-21T14:13:20.1Z", UINT64_C(1790000000100000));
    assert_time("2026-09-21T14:13:20.123456Z", UINT64_C(1790000000123456));
    assert_time("2024-02-29T23:59:59.000Z", UINT64_C(1709251199000000));
}

void test_SWR_EVENT_013_what_is_no_time_is_none(void)
{
    static const char *const texts[] = {"",
                                        "2026-09-21",
                                        "2026-09-21T14:13:20",
                                        "2026-09-21T14:13:20.Z",
                                        "2026-09-21T14:13:20+00:00",
                                        "2026-09-21T14:13:20.1234567Z",
                                        "2026-09-21T14:13:20Zz",
                                        "2026-02-29T00:00:00Z",
                                        "2026-13-01T00:00:00Z",
                                        "2026-01-01T24:00:00Z",
                                        "2026-01-01T00:60:00Z",
                                        "2026-01-01T00:00:60Z",
                                        "1969-12-31T23:59:59Z",
                                        " 2026-09-21T14:13:20Z",
                                        "2026-09-21T14:13:2",
                                        "+026-09-21T14:13:20Z"};
    uint64_t utc_us;

    for (size_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(utc_text_read(texts[i], &utc_us), texts[i]);
    }
}

void test_SWR_EVENT_010_an_event_of_a_note_stands_there_in_its_words(void)
{
    const uint32_t note = exchange_write_note(exchange, NOTE_OPERATOR, "anna", "needle in");
    const event_t event = {
        .id = (uint32_t)EVENT_NOTE, .subject = (uint32_t)NOTE_OPERATOR, .value = (int32_t)note};

    assert_comes_back(&event);
    TEST_ASSERT_EQUAL_STRING("Note of anna: needle in", again.text);
}

void test_SWR_SESS_026_what_a_page_has_done_is_reported_with_the_name_of_its_account(void)
{
    const event_t event = {.id = EVENT_ORDER_DISCARDED,
                           .subject = MODE_MOVE,
                           .cause = EVENT_CAUSE_CONSOLE,
                           .peer = 51234U};
    const exchange_peers_t peers = {.count = 1U, .peers = {{.number = 51234U, .name = "anna"}}};

    make(&event);
    TEST_ASSERT_EQUAL_STRING("MOVE was discarded. By the console, page 51234.", entry.text);
    exchange_publish_peers(exchange, COMMAND_SOURCE_HTTP, &peers);
    make(&event);
    TEST_ASSERT_EQUAL_STRING("MOVE was discarded. By the console, page of anna.", entry.text);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an event of this run is found by what it is, wherever it is kept, in its order
 * and once.
 */
#include "unity.h"

#include "recording/archive/log_search.h"
#include "common/file_series.h"
#include "exchange/exchange.h"
#include "exchange/exchange_segment.h"
#include "interface/event.h"
#include "recording/write/event_log.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define UTC_US UINT64_C(1790000000000000)
#define SECOND_US UINT64_C(1000000)

static char folder[48];
static char name[48];
static char error[256];
static exchange_t *exchange;
static event_log_t event_log;
static uint32_t events;
static log_filter_t filter;
static log_search_t found;

void setUp(void)
{
    const log_filter_t any = {.limit = 200U, .to_us = UINT64_MAX};

    (void)strcpy(folder, "/tmp/test-log-search-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(name, sizeof name, "test-log-search-%d", (int)getpid());
    exchange = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(exchange, error);
    event_log_open(&event_log, folder, exchange);
    events = 0U;
    filter = any;
}

void tearDown(void)
{
    char command[80];

    log_search_end(&found);
    event_log_close(&event_log);
    exchange_close(exchange);
    (void)snprintf(command, sizeof command, "rm -r %s", folder);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

/* One a second. Each tenth is a warning, each hundredth critical; the recorder keeps up. */
static void happen(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        const uint32_t severity = ((events % 100U) == 0U) ? 2U : (((events % 10U) == 0U) ? 1U : 0U);
        const event_t event = {
            .number = events,
            .id = (uint32_t)((severity == 2U) ? EVENT_ESTOP_PULLED : EVENT_PEDAL_PRESSED),
            .severity = severity};
        exchange_push_event(exchange, &event, UTC_US + (events * SECOND_US));
        event_log_drain(&event_log);
        events++;
    }
}

static void search(const char *directory)
{
    log_search_end(&found);
    TEST_ASSERT_TRUE(log_search(&found, &filter, exchange, events, directory));
}

static uint32_t number_at(uint32_t place)
{
    return log_search_entry(&found, place)->event.number;
}

/* `count` of them, the first one with this number, and each `step` after the one before. */
static void assert_found(uint32_t count, uint32_t first, uint32_t step)
{
    TEST_ASSERT_EQUAL_UINT32(count, found.count);
    for (uint32_t i = 0U; i < count; i++) {
        TEST_ASSERT_EQUAL_UINT32(first + (i * step), number_at(i));
        TEST_ASSERT_EQUAL_UINT64(UTC_US + ((first + (i * step)) * SECOND_US),
                                 log_search_entry(&found, i)->utc_us);
    }
}

void test_SWR_EVENT_016_without_a_number_the_newest_are_found(void)
{
    happen(300U);
    search(NULL);
    assert_found(200U, 100U, 1U);
    TEST_ASSERT_EQUAL_UINT32(300U, found.next);
    TEST_ASSERT_EQUAL_UINT32(0U, found.lost);
    TEST_ASSERT_FALSE(found.wants_files);
    filter.limit = 7U;
    search(NULL);
    assert_found(7U, 293U, 1U);
}

void test_SWR_EVENT_016_after_a_number_the_first_ones_are_found(void)
{
    happen(300U);
    filter.has_after = true;
    filter.after = 49U;
    search(NULL);
    assert_found(200U, 50U, 1U);
    TEST_ASSERT_EQUAL_UINT32(250U, found.next);
    filter.after = found.next - 1U;
    search(NULL);
    assert_found(50U, 250U, 1U);
    TEST_ASSERT_EQUAL_UINT32(300U, found.next);
    filter.after = 299U;
    search(NULL);
    assert_found(0U, 0U, 1U);
    TEST_ASSERT_EQUAL_UINT32(300U, found.next);
    filter.after = UINT32_MAX;
    search(NULL);
    assert_found(0U, 0U, 1U);
}

void test_SWR_EVENT_016_what_the_exchange_has_no_more_comes_from_the_log(void)
{
    happen(EXCHANGE_EVENTS + 500U);
    filter.has_after = true;
    filter.after = 0U;
    filter.limit = 2000U;
    search(NULL);
    assert_found(EXCHANGE_EVENTS, 500U, 1U);
    TEST_ASSERT_TRUE(found.wants_files);
    TEST_ASSERT_EQUAL_UINT32(499U, found.lost);
    search(folder);
    assert_found(EXCHANGE_EVENTS + 499U, 1U, 1U);
    TEST_ASSERT_EQUAL_UINT32(0U, found.lost);
    filter.limit = 10U;
    search(folder);
    assert_found(10U, 1U, 1U);
    TEST_ASSERT_EQUAL_UINT32(11U, found.next);
}

void test_SWR_EVENT_016_and_from_the_log_before_it(void)
{
    happen(100U);
    event_log.size = UINT64_C(1000000) * 1000U;
    happen(EXCHANGE_EVENTS + 100U);
    filter.limit = 2000U;
    search(folder);
    assert_found(EXCHANGE_EVENTS + 200U, 0U, 1U);
}

void test_SWR_EVENT_016_what_is_nowhere_is_counted(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    happen(EXCHANGE_EVENTS + 100U);
    TEST_ASSERT_TRUE(file_series_find(&file_series_logs, folder, 1U, path));
    TEST_ASSERT_EQUAL_INT(0, unlink(path));
    filter.has_after = true;
    filter.after = 19U;
    filter.limit = 2000U;
    search(folder);
    assert_found(EXCHANGE_EVENTS, 100U, 1U);
    TEST_ASSERT_EQUAL_UINT32(80U, found.lost);
}

void test_SWR_EVENT_016_lines_that_are_no_events_are_passed_over(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    TEST_ASSERT_TRUE(file_series_find(&file_series_logs, folder, 1U, path));
    FILE *const file = fopen(path, "a");
    for (uint32_t i = 0U; i < 5000U; i++) {
        (void)fputc((i % 7U == 0U) ? '\0' : '#', file);
    }
    (void)fputs("\n\n2026 what\n", file);
    (void)fclose(file);
    happen(EXCHANGE_EVENTS + 10U);
    filter.limit = 2000U;
    search(folder);
    assert_found(EXCHANGE_EVENTS + 10U, 0U, 1U);
}

void test_SWR_EVENT_016_a_severity_finds_what_is_no_less(void)
{
    happen(300U);
    filter.severity = (uint32_t)EVENT_SEVERITY_WARNING;
    search(NULL);
    assert_found(30U, 0U, 10U);
    filter.severity = (uint32_t)EVENT_SEVERITY_CRITICAL;
    search(NULL);
    assert_found(3U, 0U, 100U);
}

void test_SWR_EVENT_016_a_text_is_found_in_the_sentence_and_the_name_whatever_its_case(void)
{
    happen(300U);
    filter.text = "E-STOP WAS pulled";
    search(NULL);
    assert_found(3U, 0U, 100U);
    filter.text = "estop_PULL";
    search(NULL);
    assert_found(3U, 0U, 100U);
    filter.text = "nothing of it";
    search(NULL);
    assert_found(0U, 0U, 1U);
    TEST_ASSERT_EQUAL_UINT32(300U, found.next);
}

void test_SWR_EVENT_016_a_time_is_found_with_its_ends(void)
{
    happen(300U);
    filter.from_us = UTC_US + (20U * SECOND_US);
    filter.to_us = UTC_US + (25U * SECOND_US);
    search(NULL);
    assert_found(6U, 20U, 1U);
}

void test_SWR_EVENT_016_the_log_is_read_where_too_few_are_found(void)
{
    happen(EXCHANGE_EVENTS + 500U);
    filter.severity = (uint32_t)EVENT_SEVERITY_CRITICAL;
    search(NULL);
    TEST_ASSERT_TRUE(found.wants_files);
    search(folder);
    assert_found(16U, 0U, 100U);
    filter.limit = 5U;
    search(NULL);
    TEST_ASSERT_FALSE(found.wants_files);
    assert_found(5U, 1100U, 100U);
}

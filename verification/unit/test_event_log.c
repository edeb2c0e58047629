/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the log of events never takes more than two files of its limit, and no event is
 * lost where one follows the other.
 */
#include "unity.h"

#include "common/clock.h"
#include "common/directory.h"
#include "common/event_text.h"
#include "common/log_entry.h"
#include "common/utc_text.h"
#include "exchange/exchange.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_segment.h"
#include "interface/app/event_words.h"
#include "interface/app/names.h"
#include "interface/event.h"
#include "limits/requirement_limits.h"
#include "recorder/event_log.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* 2026-09-21T14:13:20Z. */
#define UTC_US UINT64_C(1790000000000000)
#define FULL ((off_t)LIMIT_EVENT_LOG_MB * 1000000)

static char folder[48];
static char log_path[80];
static char older_path[80];
static char name[48];
static char error[256];
static exchange_t *exchange;
static event_log_t event_log;
static uint32_t number;

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-event-log-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(log_path, sizeof log_path, "%s/events.log", folder);
    (void)snprintf(older_path, sizeof older_path, "%s/events.1.log", folder);
    (void)snprintf(name, sizeof name, "test-event-log-%d", (int)getpid());
    exchange = exchange_create(name, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(exchange, error);
    number = 0U;
}

void tearDown(void)
{
    event_log_close(&event_log);
    exchange_close(exchange);
    (void)chmod(folder, 0700);
    (void)unlink(log_path);
    (void)unlink(older_path);
    (void)rmdir(folder);
}

/* An events.log of so many bytes from before. */
static void leave(off_t size)
{
    const int file = open(log_path, O_WRONLY | O_CREAT, 0600);

    TEST_ASSERT_EQUAL_INT(0, ftruncate(file, size));
    (void)close(file);
}

static off_t size_of(const char *path)
{
    struct stat status;

    return (stat(path, &status) == 0) ? status.st_size : -1;
}

static void log_events(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        const event_t event = {.number = number, .id = (uint32_t)EVENT_ESTOP_PULLED};
        exchange_push_event(exchange, &event, UTC_US);
        event_log_drain(&event_log, exchange);
        number++;
    }
}

void test_SWR_EVENT_008_a_log_goes_on_where_it_ended(void)
{
    leave(1000);
    event_log_open(&event_log, folder);
    log_events(1U);
    TEST_ASSERT_GREATER_THAN_INT(1000, size_of(log_path));
    TEST_ASSERT_EQUAL_INT(-1, size_of(older_path));
}

void test_SWR_EVENT_008_a_full_log_makes_room_and_takes_the_place_of_the_one_before(void)
{
    leave(FULL - 10);
    event_log_open(&event_log, folder);
    log_events(3U);
    TEST_ASSERT_EQUAL_INT(FULL - 10, size_of(older_path));
    TEST_ASSERT_GREATER_THAN_INT(100, size_of(log_path));
    TEST_ASSERT_LESS_THAN_INT(1000, size_of(log_path));
    event_log_close(&event_log);
    leave(FULL - 1);
    event_log_open(&event_log, folder);
    log_events(1U);
    TEST_ASSERT_EQUAL_INT(FULL - 1, size_of(older_path));
}

static uint32_t lines_of(const char *path)
{
    FILE *const file = fopen(path, "r");
    uint32_t lines = 0U;

    for (int letter = fgetc(file); letter != EOF; letter = fgetc(file)) {
        lines += (letter == '\n') ? 1U : 0U;
    }
    (void)fclose(file);
    return lines;
}

void test_SWR_EVENT_008_every_event_is_in_one_of_the_two(void)
{
    event_log_open(&event_log, folder);
    log_events(5U);
    event_log.size = (uint64_t)FULL; /* As if it were full now. */
    log_events(4U);
    TEST_ASSERT_EQUAL_UINT32(5U, lines_of(older_path));
    TEST_ASSERT_EQUAL_UINT32(4U, lines_of(log_path));
}

void test_SWR_EVENT_013_an_event_is_written_with_the_time_of_its_publication(void)
{
    char line[LOG_ENTRY_LINE_SIZE] = "";
    log_entry_t entry;

    event_log_open(&event_log, folder);
    log_events(1U);
    FILE *const file = fopen(log_path, "r");
    TEST_ASSERT_NOT_NULL(fgets(line, sizeof line, file));
    (void)fclose(file);
    TEST_ASSERT_TRUE(log_entry_read(&entry, line));
    TEST_ASSERT_EQUAL_UINT64(UTC_US, entry.utc_us);
}

void test_SWR_REC_010_a_log_that_is_opened_again_writes_no_event_twice(void)
{
    event_log_open(&event_log, folder);
    log_events(5U);
    event_log_close(&event_log);
    event_log_open(&event_log, folder);
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(7U, lines_of(log_path));
}

/* As when two instances have one folder. */
void test_SWR_REC_011_a_log_that_another_has_begun_is_gone_on_with(void)
{
    event_log_open(&event_log, folder);
    log_events(5U);
    TEST_ASSERT_EQUAL_INT(0, rename(log_path, older_path));
    leave(1000);
    event_log.size = (uint64_t)FULL;
    log_events(1U);
    TEST_ASSERT_EQUAL_UINT32(5U, lines_of(older_path));
    TEST_ASSERT_EQUAL_UINT32(1U, lines_of(log_path));
    TEST_ASSERT_EQUAL_UINT64((uint64_t)size_of(log_path), event_log.size);
}

void test_SWR_REC_011_a_full_log_that_was_removed_is_begun_anew(void)
{
    event_log_open(&event_log, folder);
    log_events(5U);
    TEST_ASSERT_EQUAL_INT(0, unlink(log_path));
    event_log.size = (uint64_t)FULL;
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(2U, lines_of(log_path));
    TEST_ASSERT_EQUAL_INT(-1, size_of(older_path));
}

void test_SWR_REC_014_a_folder_that_is_removed_is_made_again_with_a_new_log(void)
{
    event_log_open(&event_log, folder);
    log_events(5U);
    TEST_ASSERT_EQUAL_INT(0, unlink(log_path));
    TEST_ASSERT_EQUAL_INT(0, rmdir(folder));
    event_log_sync(&event_log);
    log_events(2U);
    TEST_ASSERT_TRUE(size_of(log_path) > 0);
    TEST_ASSERT_EQUAL_UINT32(2U, lines_of(log_path));
}

void test_SWR_EVENT_010_a_line_has_the_words_of_its_note(void)
{
    char line[512] = "";
    char words[161];
    const event_t event = {.id = (uint32_t)EVENT_NOTE, .subject = NOTE_OPERATOR, .value = 1};

    (void)memset(words, 'x', sizeof words - 1U);
    words[sizeof words - 1U] = '\0';
    (void)exchange_write_note(exchange, NOTE_OPERATOR, "a234567890123456789012345678901", words);
    event_log_open(&event_log, folder);
    exchange_push_event(exchange, &event, UTC_US);
    event_log_drain(&event_log, exchange);
    FILE *file = fopen(log_path, "r");
    TEST_ASSERT_NOT_NULL(file);
    TEST_ASSERT_NOT_NULL(fgets(line, (int)sizeof line, file));
    (void)fclose(file);
    TEST_ASSERT_NOT_NULL(strstr(line, "Note of a234567890123456789012345678901: xxx"));
    TEST_ASSERT_EQUAL_STRING("x\n", &line[strlen(line) - 2U]);
    TEST_ASSERT_NOT_NULL(strstr(line, words));
}

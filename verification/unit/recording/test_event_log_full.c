/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: events that cannot be written wait for room on the disk, are written in their
 * order, and are counted where they are lost.
 */
#include "unity.h"

#include "common/file_series.h"
#include "common/log_entry.h"
#include "exchange/exchange.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_segment.h"
#include "interface/event.h"
#include "recording/write/event_log.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "unit/recording/event_log_world.inc"

void setUp(void)
{
    begin_event_log();
}

void tearDown(void)
{
    end_event_log();
}

/* The log may become larger by that and no more. */
static void fill_disk(uint32_t log, uint32_t bytes)
{
    char path[FILE_SERIES_PATH_SIZE];
    struct rlimit limit = unlimited;
    struct stat status;

    TEST_ASSERT_TRUE(find_log(log, path));
    TEST_ASSERT_EQUAL_INT(0, stat(path, &status));
    limit.rlim_cur = (rlim_t)status.st_size + bytes;
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &limit));
}

static void free_disk(void)
{
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &unlimited));
}

/* Waiting events are written in the order of their numbers, behind the present ones. */
static void assert_numbers(uint32_t log, uint32_t first, uint32_t place, uint32_t count)
{
    char part[24];

    for (uint32_t i = 0U; i < count; i++) {
        (void)snprintf(part, sizeof part, "Z %u cycle=", (unsigned)(first + i));
        assert_line(log, place + i, part);
    }
}

void test_SWR_EVENT_017_events_wait_while_the_disk_is_full_and_are_written_in_order(void)
{
    log_events(3U);
    fill_disk(1U, 0U);
    log_events(5U);
    TEST_ASSERT_EQUAL_UINT32(3U, exchange_logged(exchange));
    TEST_ASSERT_EQUAL_UINT32(3U, lines_of(1U));
    free_disk();
    event_log_drain(&event_log);
    TEST_ASSERT_EQUAL_UINT32(8U, exchange_logged(exchange));
    TEST_ASSERT_EQUAL_UINT32(8U, lines_of(1U));
    assert_numbers(1U, 0U, 0U, 8U);
}

void test_SWR_EVENT_017_events_wait_also_for_the_next_recorder(void)
{
    log_events(3U);
    fill_disk(1U, 0U);
    log_events(5U);
    restart();
    log_events(1U);
    free_disk();
    event_log_drain(&event_log);
    TEST_ASSERT_EQUAL_UINT32(9U, lines_of(1U));
    assert_numbers(1U, 0U, 0U, 9U);
}

void test_SWR_EVENT_017_a_half_line_is_taken_back(void)
{
    log_events(3U);
    for (uint32_t bytes = 1U; bytes < 40U; bytes += 19U) {
        struct stat before;
        struct stat after;

        TEST_ASSERT_EQUAL_INT(0, fstat(event_log.file, &before));
        fill_disk(1U, bytes);
        log_events(1U);
        TEST_ASSERT_EQUAL_INT(0, fstat(event_log.file, &after));
        TEST_ASSERT_EQUAL_INT64(before.st_size, after.st_size);
    }
    free_disk();
    event_log_drain(&event_log);
    TEST_ASSERT_EQUAL_UINT32(number, lines_of(1U));
    assert_numbers(1U, 0U, 0U, number);
}

/* A recorder that was killed between the two. */
void test_SWR_EVENT_017_a_half_line_of_the_recorder_before_is_taken_back(void)
{
    static const char half[] = "2026-09-21T14:1";

    log_events(3U);
    TEST_ASSERT_EQUAL_INT((int)sizeof half, (int)write(event_log.file, half, sizeof half));
    restart();
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(5U, lines_of(1U));
    assert_numbers(1U, 0U, 0U, 5U);
    assert_line(1U, 3U, "2026-09-21T14:13:20.000Z 3 cycle=");
}

void test_SWR_EVENT_017_events_that_found_no_place_in_the_exchange_are_counted_in_the_log(void)
{
    log_events(3U);
    fill_disk(1U, 0U);
    log_events(EXCHANGE_EVENTS + 7U);
    restart(); /* The count does not end with the recorder. */
    free_disk();
    event_log_drain(&event_log);
    TEST_ASSERT_EQUAL_UINT32(3U + 1U + EXCHANGE_EVENTS, lines_of(1U));
    assert_line(1U, 3U, "Z 3 EVENTS_LOST value=7\n");
    assert_numbers(1U, 10U, 4U, 5U);
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_EVENTS + 10U, exchange_logged(exchange));
}

void test_SWR_EVENT_017_events_wait_for_a_folder(void)
{
    char moved[64];

    (void)snprintf(moved, sizeof moved, "%s-moved", folder);
    log_events(1U);
    TEST_ASSERT_EQUAL_INT(0, rename(folder, moved));
    const int blocker = open(folder, O_WRONLY | O_CREAT | O_EXCL, 0600);
    event_log_sync(&event_log);
    log_events(4U);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_logged(exchange));
    (void)close(blocker);
    TEST_ASSERT_EQUAL_INT(0, unlink(folder));
    TEST_ASSERT_EQUAL_INT(0, rename(moved, folder));
    event_log_sync(&event_log);
    event_log_drain(&event_log);
    TEST_ASSERT_EQUAL_UINT32(4U, lines_of(2U));
    assert_numbers(2U, 1U, 0U, 4U);
}

void test_SWR_EVENT_017_a_level_is_reported_when_there_is_room_again(void)
{
    log_events(1U);
    fill_disk(1U, 3U);
    set_level((uint32_t)EVENT_SEVERITY_WARNING);
    event_log_drain(&event_log);
    free_disk();
    log_each_severity();
    assert_line(1U, 1U, "LOG_LEVEL value=1 ");
    TEST_ASSERT_EQUAL_UINT32(4U, lines_of(1U));
}

/* Output on stderr while `count` events are logged, or with none, while the log is closed. */
static void hear_events(uint32_t count, char said[1024])
{
    int ends[2];
    const int before = dup(STDERR_FILENO);

    TEST_ASSERT_EQUAL_INT(0, pipe(ends));
    TEST_ASSERT_TRUE(fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0);
    (void)dup2(ends[1], STDERR_FILENO);
    errno = EAGAIN; /* An older failure. */
    log_events(count);
    if (count == 0U) {
        event_log_close(&event_log);
    }
    (void)dup2(before, STDERR_FILENO);
    const ssize_t size = read(ends[0], said, 1023U);
    said[(size > 0) ? size : 0] = '\0';
    (void)close(ends[0]);
    (void)close(ends[1]);
    (void)close(before);
}

void test_SWR_EVENT_017_a_log_that_ends_without_its_last_events_says_so(void)
{
    char said[1024];

    log_events(2U);
    fill_disk(1U, 0U);
    log_events(1U);
    hear_events(0U, said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "events from number 2 on are not in the"), said);
}

void test_SWR_EVENT_017_a_full_disk_is_said_once_and_that_the_log_goes_on(void)
{
    char said[1024];

    log_events(1U);
    fill_disk(1U, 5U);
    hear_events(1U, said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, strerror(ENOSPC)), said);
    hear_events(1U, said);
    TEST_ASSERT_EQUAL_STRING("", said);
    free_disk();
    hear_events(1U, said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "the event log goes on"), said);
    fill_disk(1U, 0U);
    hear_events(EXCHANGE_EVENTS + 2U, said);
    free_disk();
    hear_events(1U, said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, " 3 events are missing"), said);
}

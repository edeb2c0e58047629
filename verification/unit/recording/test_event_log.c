/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: each run has a log of events of its own, the logs never take more than their
 * limits, and no event is lost where one follows the other.
 */
#include "unity.h"

#include "common/clock.h"
#include "common/directory.h"
#include "common/event_text.h"
#include "common/file_series.h"
#include "common/log_entry.h"
#include "common/utc_text.h"
#include "exchange/exchange.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_peers.h"
#include "exchange/exchange_segment.h"
#include "interface/app/event_words.h"
#include "interface/app/names.h"
#include "interface/event.h"
#include "limits/requirement_limits.h"
#include "recording/write/event_log.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/* 2026-09-21T14:13:20Z. */
#define UTC_US UINT64_C(1790000000000000)
#define FULL (LIMIT_EVENT_LOG_MB * UINT64_C(1000000))

static char folder[48];
static char name[48];
static char error[256];
static exchange_t *exchange;
static event_log_t event_log;
static uint32_t number;
static struct rlimit unlimited;

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-event-log-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(name, sizeof name, "test-event-log-%d", (int)getpid());
    exchange = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(exchange, error);
    (void)signal(SIGXFSZ, SIG_IGN);
    TEST_ASSERT_EQUAL_INT(0, getrlimit(RLIMIT_FSIZE, &unlimited));
    number = 0U;
    event_log_open(&event_log, folder, exchange);
}

void tearDown(void)
{
    char command[80];

    (void)setrlimit(RLIMIT_FSIZE, &unlimited);
    event_log_close(&event_log);
    exchange_close(exchange);
    (void)snprintf(command, sizeof command, "rm -r %s", folder);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

static void log_events(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        const event_t event = {.number = number, .id = (uint32_t)EVENT_ESTOP_PULLED};
        exchange_push_event(exchange, &event, UTC_US);
        event_log_drain(&event_log);
        number++;
    }
}

static bool find_log(uint32_t log, char path[FILE_SERIES_PATH_SIZE])
{
    return file_series_find(&file_series_logs, folder, log, path);
}

static uint32_t lines_of(uint32_t log)
{
    char path[FILE_SERIES_PATH_SIZE];
    TEST_ASSERT_TRUE(find_log(log, path));
    FILE *const file = fopen(path, "r");
    uint32_t lines = 0U;

    for (int letter = fgetc(file); letter != EOF; letter = fgetc(file)) {
        lines += (letter == '\n') ? 1U : 0U;
    }
    (void)fclose(file);
    return lines;
}

static void restart(void)
{
    event_log_close(&event_log);
    event_log_open(&event_log, folder, exchange);
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

/* As if it were full now. */
static void fill(void)
{
    event_log.size = FULL;
}

void test_SWR_EVENT_008_every_event_is_in_one_of_the_two(void)
{
    log_events(5U);
    fill();
    log_events(4U);
    TEST_ASSERT_EQUAL_UINT32(5U, lines_of(1U));
    TEST_ASSERT_EQUAL_UINT32(4U, lines_of(2U));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_file(exchange, EXCHANGE_FILE_LOG));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_file(exchange, EXCHANGE_FILE_LOG_BEFORE));
}

void test_SWR_EVENT_008_a_log_that_is_gone_on_with_counts_what_is_there(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    log_events(1U);
    TEST_ASSERT_TRUE(find_log(1U, path));
    TEST_ASSERT_EQUAL_INT(0, truncate(path, (off_t)FULL - 10));
    restart();
    log_events(1U);
    TEST_ASSERT_EQUAL_UINT32(1U, lines_of(2U));
}

void test_SWR_EVENT_008_the_oldest_logs_go_when_one_is_begun(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    for (uint32_t i = 0U; i < LIMIT_EVENT_LOGS; i++) {
        fill();
        log_events(1U);
    }
    TEST_ASSERT_FALSE(find_log(1U, path));
    TEST_ASSERT_TRUE(find_log(2U, path));
    TEST_ASSERT_TRUE(find_log(LIMIT_EVENT_LOGS + 1U, path));
}

void test_SWR_EVENT_008_without_a_place_for_another_log_the_full_one_goes_on(void)
{
    char moved[64];

    (void)snprintf(moved, sizeof moved, "%s-moved", folder);
    log_events(1U);
    TEST_ASSERT_EQUAL_INT(0, rename(folder, moved));
    const int blocker = open(folder, O_WRONLY | O_CREAT | O_EXCL, 0600);
    fill();
    log_events(1U);
    (void)close(blocker);
    TEST_ASSERT_EQUAL_INT(0, unlink(folder));
    TEST_ASSERT_EQUAL_INT(0, rename(moved, folder));
    TEST_ASSERT_EQUAL_UINT32(2U, lines_of(1U));
}

void test_SWR_EVENT_014_a_recorder_that_is_started_again_goes_on_with_the_log_of_its_run(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    log_events(5U);
    restart();
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(7U, lines_of(1U));
    TEST_ASSERT_FALSE(find_log(2U, path));
}

void test_SWR_EVENT_014_another_run_has_another_log(void)
{
    log_events(5U);
    event_log_close(&event_log);
    exchange_close(exchange);
    exchange = exchange_create(name, 64U, error, sizeof error);
    number = 0U;
    event_log_open(&event_log, folder, exchange);
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(5U, lines_of(1U));
    TEST_ASSERT_EQUAL_UINT32(2U, lines_of(2U));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_file(exchange, EXCHANGE_FILE_LOG_BEFORE));
}

void test_SWR_EVENT_013_an_event_is_written_with_the_time_of_its_publication(void)
{
    char line[LOG_ENTRY_LINE_SIZE] = "";
    log_entry_t entry;

    char path[FILE_SERIES_PATH_SIZE];

    log_events(1U);
    TEST_ASSERT_TRUE(find_log(1U, path));
    FILE *const file = fopen(path, "r");
    TEST_ASSERT_NOT_NULL(fgets(line, sizeof line, file));
    (void)fclose(file);
    TEST_ASSERT_TRUE(log_entry_read(&entry, line));
    TEST_ASSERT_EQUAL_UINT64(UTC_US, entry.utc_us);
}

static void log_each_severity(void)
{
    for (uint32_t severity = 0U; severity <= (uint32_t)EVENT_SEVERITY_CRITICAL; severity++) {
        const event_t event = {.number = number, .severity = severity};
        exchange_push_event(exchange, &event, UTC_US);
        number++;
    }
    event_log_drain(&event_log);
}

static void set_level(uint32_t severity)
{
    const exchange_log_level_t level = {.severity = severity, .by = "eve"};

    exchange_set_log_level(exchange, &level);
}

/* The line with this number (from 0 on) of a log. */
static void assert_line(uint32_t log, uint32_t place, const char *part)
{
    char path[FILE_SERIES_PATH_SIZE];
    char line[LOG_ENTRY_LINE_SIZE] = "";

    TEST_ASSERT_TRUE(find_log(log, path));
    FILE *const file = fopen(path, "r");
    for (uint32_t i = 0U; i <= place; i++) {
        TEST_ASSERT_NOT_NULL(fgets(line, sizeof line, file));
    }
    (void)fclose(file);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(line, part), line);
}

/* Damage that a neighbour may have written, where all processes write. */
static void damage_places(void)
{
    segment_others_t *others = &exchange->segment->others;

    others->events_logged = UINT64_MAX;
    (void)memset(others->files, 0x55, sizeof others->files);
}

void test_SWR_EXCH_022_a_log_that_lives_knows_how_far_it_is_and_in_which_files(void)
{
    log_events(3U);
    fill();
    log_events(2U);
    damage_places();
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(3U, lines_of(1U));
    TEST_ASSERT_EQUAL_UINT32(4U, lines_of(2U));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_file(exchange, EXCHANGE_FILE_LOG));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_file(exchange, EXCHANGE_FILE_LOG_BEFORE));
    TEST_ASSERT_EQUAL_UINT32(7U, exchange_logged(exchange));
}

void test_SWR_EXCH_022_a_log_that_is_opened_after_damage_lacks_no_event_that_is_kept(void)
{
    log_events(EXCHANGE_EVENTS + 10U);
    exchange->segment->others.events_logged = UINT64_MAX;
    restart();
    log_events(1U);
    TEST_ASSERT_EQUAL_UINT32((2U * EXCHANGE_EVENTS) + 11U, lines_of(1U));
    damage_places();
    restart();
    log_events(1U);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_file(exchange, EXCHANGE_FILE_LOG) - 1U);
    assert_line(2U, 1U, "ESTOP_PULLED");
}

void test_SWR_EXCH_022_a_level_that_was_damaged_is_said_to_be(void)
{
    const exchange_log_level_t none = {.severity = 0U};

    set_level((uint32_t)EVENT_SEVERITY_WARNING);
    event_log_drain(&event_log);
    exchange->segment->others.log_level.severity = 4U;
    event_log_drain(&event_log);
    TEST_ASSERT_EQUAL_UINT32(1U, lines_of(1U));
    exchange_set_log_level(exchange, &none);
    event_log_drain(&event_log);
    assert_line(1U, 1U, "are written, as the level was damaged.");
}

void test_SWR_EVENT_015_events_below_the_level_are_not_written_and_the_log_says_so(void)
{
    log_each_severity();
    set_level((uint32_t)EVENT_SEVERITY_WARNING);
    log_each_severity();
    TEST_ASSERT_EQUAL_UINT32(3U + 1U + 2U, lines_of(1U));
    assert_line(
        1U, 3U,
        "Z 3 LOG_LEVEL value=1 From here on events from WARNING on are written, set by eve.\n");
    assert_line(1U, 4U, "Z 4 cycle=0 WARNING ");
    set_level((uint32_t)EVENT_SEVERITY_INFORMATION);
    log_each_severity();
    TEST_ASSERT_EQUAL_UINT32(6U + 1U + 3U, lines_of(1U));
    assert_line(1U, 6U, "LOG_LEVEL value=0 ");
}

void test_SWR_EVENT_015_what_is_critical_is_always_written(void)
{
    set_level(UINT32_MAX);
    log_each_severity();
    TEST_ASSERT_EQUAL_UINT32(1U + 1U, lines_of(1U));
    assert_line(1U, 1U, " CRITICAL ");
}

void test_SWR_EVENT_015_a_level_is_kept_for_the_run_and_reported_in_each_log(void)
{
    set_level((uint32_t)EVENT_SEVERITY_CRITICAL);
    log_each_severity();
    restart();
    log_each_severity();
    fill();
    log_each_severity();
    log_each_severity();
    assert_line(2U, 0U, " CRITICAL ");
    assert_line(2U, 1U, "LOG_LEVEL value=2 ");
    TEST_ASSERT_EQUAL_UINT32(3U, lines_of(2U));
}

void test_SWR_REC_010_a_log_that_is_opened_again_writes_no_event_twice(void)
{
    log_events(5U);
    restart();
    event_log_drain(&event_log);
    TEST_ASSERT_EQUAL_UINT32(5U, lines_of(1U));
}

void test_SWR_REC_011_two_instances_with_one_folder_have_a_log_each(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    TEST_ASSERT_TRUE(find_log(1U, path));
    fill(); /* Another one has begun number 2 meanwhile. */
    file_series_path(&file_series_logs, folder, 2U, UTC_US, path);
    (void)close(open(path, O_WRONLY | O_CREAT | O_EXCL, 0600));
    log_events(1U);
    TEST_ASSERT_EQUAL_UINT32(0U, lines_of(2U));
    TEST_ASSERT_EQUAL_UINT32(1U, lines_of(3U));
}

/* Neither a link nor a folder in the place of the log leads anywhere. */
void test_SWR_REC_011_what_is_no_log_is_not_gone_on_with(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    TEST_ASSERT_TRUE(find_log(1U, path));
    event_log_close(&event_log);
    TEST_ASSERT_EQUAL_INT(0, unlink(path));
    TEST_ASSERT_EQUAL_INT(0, symlink("/dev/full", path));
    event_log_open(&event_log, folder, exchange);
    log_events(1U);
    TEST_ASSERT_EQUAL_UINT32(1U, lines_of(2U));
    event_log_close(&event_log);
    TEST_ASSERT_TRUE(find_log(2U, path));
    TEST_ASSERT_EQUAL_INT(0, unlink(path));
    TEST_ASSERT_EQUAL_INT(0, mkdir(path, 0700));
    event_log_open(&event_log, folder, exchange);
    log_events(1U);
    TEST_ASSERT_EQUAL_UINT32(1U, lines_of(3U));
}

void test_SWR_REC_014_a_log_that_is_removed_is_begun_anew(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    log_events(5U);
    TEST_ASSERT_TRUE(find_log(1U, path));
    TEST_ASSERT_EQUAL_INT(0, unlink(path));
    event_log_sync(&event_log);
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(2U, lines_of(1U));
}

void test_SWR_REC_014_a_folder_that_is_removed_is_made_again_with_a_new_log(void)
{
    char path[FILE_SERIES_PATH_SIZE];

    log_events(5U);
    TEST_ASSERT_TRUE(find_log(1U, path));
    TEST_ASSERT_EQUAL_INT(0, unlink(path));
    TEST_ASSERT_EQUAL_INT(0, rmdir(folder));
    event_log_sync(&event_log);
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(2U, lines_of(1U));
}

void test_SWR_REC_014_a_log_that_is_moved_is_begun_anew(void)
{
    char path[FILE_SERIES_PATH_SIZE];
    char moved[64];

    (void)snprintf(moved, sizeof moved, "%s/moved", folder);
    log_events(5U);
    TEST_ASSERT_TRUE(find_log(1U, path));
    TEST_ASSERT_EQUAL_INT(0, rename(path, moved));
    event_log_sync(&event_log);
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(2U, lines_of(1U));
}

void test_SWR_REC_014_a_log_with_another_file_in_its_place_is_begun_anew(void)
{
    char path[FILE_SERIES_PATH_SIZE];
    char moved[64];

    (void)snprintf(moved, sizeof moved, "%s/moved", folder);
    log_events(5U);
    TEST_ASSERT_TRUE(find_log(1U, path));
    TEST_ASSERT_EQUAL_INT(0, rename(path, moved));
    (void)close(open(path, O_WRONLY | O_CREAT | O_EXCL, 0600));
    event_log_sync(&event_log);
    log_events(2U);
    TEST_ASSERT_EQUAL_UINT32(0U, lines_of(1U));
    TEST_ASSERT_EQUAL_UINT32(2U, lines_of(2U));
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

void test_SWR_EVENT_010_a_line_has_the_words_of_its_note(void)
{
    char path[FILE_SERIES_PATH_SIZE];
    char line[512] = "";
    char words[161];
    const event_t event = {.id = (uint32_t)EVENT_NOTE, .subject = NOTE_OPERATOR, .value = 1};

    (void)memset(words, 'x', sizeof words - 1U);
    words[sizeof words - 1U] = '\0';
    (void)exchange_write_note(exchange, NOTE_OPERATOR, "a234567890123456789012345678901", words);
    exchange_push_event(exchange, &event, UTC_US);
    event_log_drain(&event_log);
    TEST_ASSERT_TRUE(find_log(1U, path));
    FILE *file = fopen(path, "r");
    TEST_ASSERT_NOT_NULL(file);
    TEST_ASSERT_NOT_NULL(fgets(line, (int)sizeof line, file));
    (void)fclose(file);
    TEST_ASSERT_NOT_NULL(strstr(line, "Note of a234567890123456789012345678901: xxx"));
    TEST_ASSERT_EQUAL_STRING("x\n", &line[strlen(line) - 2U]);
    TEST_ASSERT_NOT_NULL(strstr(line, words));
}

void test_SWR_REC_040_cycles_at_the_end_that_are_in_no_recording_are_a_line(void)
{
    log_events(3U);
    event_log_note_unrecorded(&event_log, 12U);
    assert_line(1U, 3U, "Z 3 CYCLES_UNRECORDED value=12 The last cycles of the run are in no rec");
}

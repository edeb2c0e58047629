/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: each run has a log of events of its own, the logs never take more than their
 * limits, and no event is lost where one follows the other.
 */
#include "unity.h"

#include "common/file_series.h"
#include "common/log_entry.h"
#include "exchange/exchange.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_segment.h"
#include "interface/event.h"
#include "limits/requirement_limits.h"
#include "recording/write/event_log.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "unit/recording/event_log_world.inc"

#define FULL (LIMIT_EVENT_LOG_MB * UINT64_C(1000000))

void setUp(void)
{
    begin_event_log();
}

void tearDown(void)
{
    end_event_log();
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

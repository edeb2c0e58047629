/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: of the recorder's folder the recordings and logs are read and nothing else,
 * whatever name is asked for, and of one that is being written what is finished.
 */
#include "unity.h"

#include "recording/archive/archive_folder.h"
#include "common/file_series.h"
#include "exchange/exchange_segment.h"
#include "recording/format/recording.h"
#include "recording/write/recording_writer.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define UTC_US UINT64_C(1790000000000000)
#define MOST 10U

static const recording_header_t header = {.build = "test-build",
                                          .robot = "neuro",
                                          .inputs_size = sizeof(controller_inputs_t),
                                          .outputs_size = sizeof(controller_outputs_t),
                                          .controller_size = CONTROLLER_CHECKPOINT_BYTES,
                                          .started_us = UTC_US};
static char folder[48];
static archive_file_t opened;
static archive_recording_t recordings[MOST];
static archive_log_t logs[MOST];
static recording_writer_t writer;
static cycle_record_t record;

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-archive-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    opened.file = -1;
}

void tearDown(void)
{
    char command[80];

    archive_close(&opened);
    (void)snprintf(command, sizeof command, "rm -r %s", folder);
    TEST_ASSERT_EQUAL_INT(0, system(command));
}

static const char *path_of(const char *name)
{
    static char path[400];

    (void)snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static void write_file(const char *name, const char *text)
{
    FILE *const file = fopen(path_of(name), "w");

    TEST_ASSERT_NOT_NULL(file);
    (void)fputs(text, file);
    (void)fclose(file);
}

static off_t size_of(const char *name)
{
    struct stat status;

    TEST_ASSERT_EQUAL_INT(0, stat(path_of(name), &status));
    return status.st_size;
}

#define FIRST "blackbox-000001-20260921T141320Z.bsr"
#define SECOND "blackbox-000002-20260921T141320Z.bsr"
#define LOG "events-000003-20260921T141320Z.log"

/* So many blocks of a cycle each; not closed. */
static void write_blocks(const char *name, uint32_t blocks)
{
    TEST_ASSERT_TRUE(recording_writer_open(&writer, path_of(name), &header));
    record.kind = (uint32_t)CYCLE_RECORD_CYCLE;
    for (record.cycle = 0U; record.cycle < blocks; record.cycle++) {
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
        TEST_ASSERT_TRUE(recording_writer_flush(&writer));
    }
}

static void append(const char *name, const void *bytes, size_t size)
{
    const int file = open(path_of(name), O_WRONLY | O_APPEND);

    TEST_ASSERT_EQUAL_INT(size, write(file, bytes, size));
    (void)close(file);
}

void test_SWR_REC_015_of_the_present_recording_whole_blocks_are_there(void)
{
    uint8_t block[80]; /* As long as these are. */

    write_blocks(FIRST, 3U);
    const off_t whole = size_of(FIRST);
    const int file = open(path_of(FIRST), O_RDONLY);
    TEST_ASSERT_EQUAL_INT(sizeof block, pread(file, block, sizeof block, RECORDING_HEADER_SIZE));
    (void)close(file);
    for (uint32_t i = 0U; i < 4U; i++) { /* The next block, piece by piece. */
        static const size_t ends[] = {0U, 1U, 32U, 64U, 79U};
        append(FIRST, &block[ends[i]], ends[i + 1U] - ends[i]);
        TEST_ASSERT_TRUE(archive_open(&opened, folder, &file_series_recordings, FIRST, 1U));
        TEST_ASSERT_EQUAL_UINT64(whole, opened.bytes);
        archive_close(&opened);
    }
    append(FIRST, &block[79], 1U);
    TEST_ASSERT_TRUE(archive_open(&opened, folder, &file_series_recordings, FIRST, 1U));
    TEST_ASSERT_EQUAL_UINT64(whole + (off_t)sizeof block, opened.bytes);
    archive_close(&opened);
    append(FIRST, block, 7U);
    TEST_ASSERT_TRUE(archive_open(&opened, folder, &file_series_recordings, FIRST, 2U));
    TEST_ASSERT_EQUAL_UINT64(size_of(FIRST), opened.bytes);
    (void)recording_writer_close(&writer);
}

void test_SWR_REC_015_a_present_recording_that_is_finished_is_whole_with_its_trailer(void)
{
    write_blocks(FIRST, 2U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_TRUE(archive_open(&opened, folder, &file_series_recordings, FIRST, 1U));
    TEST_ASSERT_EQUAL_UINT64(size_of(FIRST), opened.bytes);
}

void test_SWR_REC_015_one_without_a_header_has_nothing(void)
{
    write_file(FIRST, "BSREC");
    TEST_ASSERT_TRUE(archive_open(&opened, folder, &file_series_recordings, FIRST, 1U));
    TEST_ASSERT_EQUAL_UINT64(0U, opened.bytes);
}

void test_SWR_REC_016_only_a_listed_name_opens_a_file(void)
{
    static const char *const names[] = {"",
                                        ".",
                                        "..",
                                        "/etc/passwd",
                                        "../" LOG,
                                        "./" LOG,
                                        LOG "/",
                                        "events-000003",
                                        LOG "~",
                                        "positions-a",
                                        "*",
                                        FIRST,
                                        "%2e%2e",
                                        LOG "\n",
                                        "events-%2e%2e-1.log"};

    write_file(LOG, "a");
    write_file(FIRST, "a");
    write_file("positions-a", "secret");
    for (size_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(archive_open(&opened, folder, &file_series_logs, names[i], 0U),
                                  names[i]);
        TEST_ASSERT_EQUAL_INT(-1, opened.file);
    }
    TEST_ASSERT_TRUE(archive_open(&opened, folder, &file_series_logs, LOG, 0U));
    TEST_ASSERT_EQUAL_STRING(LOG, opened.name);
}

/* One of each kind that is no regular file, each with a good name. */
void test_SWR_REC_016_links_pipes_and_folders_are_not_there(void)
{
    static const char *const names[] = {"events-1-a.log", "events-2-a.log", "events-3-a.log",
                                        "events-4-a.log"};

    write_file("elsewhere", "2026-09-21T14:13:20.123Z a\n");
    TEST_ASSERT_EQUAL_INT(0, symlink("elsewhere", path_of(names[0])));
    TEST_ASSERT_EQUAL_INT(0, symlink("/etc/passwd", path_of(names[1])));
    TEST_ASSERT_EQUAL_INT(0, mkfifo(path_of(names[2]), 0600));
    TEST_ASSERT_EQUAL_INT(0, mkdir(path_of(names[3]), 0700));
    for (uint32_t i = 0U; i < 4U; i++) {
        TEST_ASSERT_FALSE(archive_open(&opened, folder, &file_series_logs, names[i], 0U));
        TEST_ASSERT_FALSE(archive_open_number(&opened, folder, &file_series_logs, i + 1U));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, archive_list_logs(folder, 0U, logs, MOST));
}

void test_SWR_REC_016_without_a_folder_nothing_is_there(void)
{
    TEST_ASSERT_FALSE(archive_open(&opened, "/tmp/no-such-folder", &file_series_logs, LOG, 0U));
    TEST_ASSERT_EQUAL_UINT32(0U, archive_list_logs("/tmp/no-such-folder", 0U, logs, MOST));
    TEST_ASSERT_EQUAL_UINT32(0U,
                             archive_list_recordings("/tmp/no-such-folder", 0U, recordings, MOST));
}

void test_SWR_REC_017_recordings_are_listed_with_what_their_headers_say(void)
{
    write_blocks(SECOND, 1U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    write_file(FIRST, "no recording");
    write_file(LOG, "a");
    TEST_ASSERT_EQUAL_UINT32(2U, archive_list_recordings(folder, 2U, recordings, MOST));
    TEST_ASSERT_EQUAL_STRING(SECOND, recordings[0].name);
    TEST_ASSERT_EQUAL_UINT64(size_of(SECOND), recordings[0].bytes);
    TEST_ASSERT_TRUE(recordings[0].is_known);
    TEST_ASSERT_TRUE(recordings[0].is_present);
    TEST_ASSERT_EQUAL_UINT64(UTC_US, recordings[0].started_us);
    TEST_ASSERT_EQUAL_STRING("neuro", recordings[0].robot);
    TEST_ASSERT_EQUAL_STRING(FIRST, recordings[1].name);
    TEST_ASSERT_EQUAL_UINT64(12U, recordings[1].bytes);
    TEST_ASSERT_FALSE(recordings[1].is_known);
    TEST_ASSERT_FALSE(recordings[1].is_present);
    TEST_ASSERT_EQUAL_UINT32(1U, archive_list_recordings(folder, 0U, recordings, 1U));
    TEST_ASSERT_FALSE(recordings[0].is_present);
}

void test_SWR_REC_017_logs_are_listed_with_their_first_and_last_time(void)
{
    char text[3000] = "";

    write_file("events-000001-20260921T141320Z.log", "");
    write_file("events-000002-20260921T141320Z.log",
               "2026-09-21T14:13:20.000Z 0 a\n2026-09-21T14:13:21.500Z 1 b\n2026-09-21T1");
    for (uint32_t i = 0U; i < 60U; i++) { /* Longer than what is read of it. */
        (void)snprintf(&text[strlen(text)], 50U, "2026-09-21T14:13:%02u.000Z %u an event\n",
                       (unsigned)i, (unsigned)i);
    }
    write_file(LOG, text);
    TEST_ASSERT_EQUAL_UINT32(3U, archive_list_logs(folder, 3U, logs, MOST));
    TEST_ASSERT_EQUAL_STRING(LOG, logs[0].name);
    TEST_ASSERT_EQUAL_UINT64(strlen(text), logs[0].bytes);
    TEST_ASSERT_TRUE(logs[0].has_lines);
    TEST_ASSERT_TRUE(logs[0].is_present);
    TEST_ASSERT_EQUAL_UINT64(UTC_US - 20000000U, logs[0].first_us);
    TEST_ASSERT_EQUAL_UINT64(UTC_US + 39000000U, logs[0].last_us);
    TEST_ASSERT_TRUE(logs[1].has_lines);
    TEST_ASSERT_EQUAL_UINT64(UTC_US, logs[1].first_us);
    TEST_ASSERT_EQUAL_UINT64(UTC_US + 1500000U, logs[1].last_us);
    TEST_ASSERT_FALSE(logs[1].is_present);
    TEST_ASSERT_FALSE(logs[2].has_lines);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: what comes out of a recording is what went in, and no byte of the file can
 * change without being reported at its place.
 */
#include "unity.h"

#include "base/crc.h"
#include "recording/recording.h"
#include "recording/recording_reader.h"
#include "recording/recording_writer.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#define INPUTS_SIZE 40U /* Small bodies keep the file small enough to try every byte. */
#define OUTPUTS_SIZE 60U
#define CONTROLLER_SIZE 48U
#define BLOCKS 3U
#define RECORDS_PER_BLOCK 24U

static const recording_header_t header = {.build = "test-build",
                                          .robot = "neuro",
                                          .robot_crc = 0x12345678U,
                                          .inputs_size = INPUTS_SIZE,
                                          .outputs_size = OUTPUTS_SIZE,
                                          .controller_size = CONTROLLER_SIZE,
                                          .started_us = UINT64_C(1700000000123456)};
static char path[64];
static recording_writer_t writer;
static recording_reader_t reader;
static recording_finding_t finding;
static cycle_record_t record;
static uint32_t noise;

void setUp(void)
{
    (void)snprintf(path, sizeof(path), "/tmp/test-recording-%d.bsr", (int)getpid());
    (void)unlink(path);
    noise = 1U;
}

void tearDown(void)
{
    recording_reader_close(&reader);
    (void)unlink(path);
}

static uint8_t next_noise(void)
{
    noise = (noise * 1664525U) + 1013904223U;
    return (uint8_t)(noise >> 24);
}

/* The same record for the same cycle, half of it noise. */
static void make_record(cycle_record_t *to, uint32_t cycle, cycle_record_kind_t kind)
{
    (void)memset(to, 0, sizeof(*to));
    to->kind = (uint32_t)kind;
    to->cycle = cycle;
    noise = cycle + 1U;
    for (uint32_t i = 0U; i < recording_body_size(&header, to->kind); i++) {
        to->body.checkpoint[i] = ((i % 2U) == 0U) ? next_noise() : (uint8_t)i;
    }
}

static cycle_record_kind_t kind_of(uint32_t cycle)
{
    return ((cycle % RECORDS_PER_BLOCK) == 0U) ? CYCLE_RECORD_CHECKPOINT : CYCLE_RECORD_CYCLE;
}

static void write_blocks(uint32_t blocks)
{
    TEST_ASSERT_TRUE(recording_writer_open(&writer, path, &header));
    for (uint32_t cycle = 0U; cycle < (blocks * RECORDS_PER_BLOCK); cycle++) {
        make_record(&record, cycle, kind_of(cycle));
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
        if ((cycle % RECORDS_PER_BLOCK) == (RECORDS_PER_BLOCK - 1U)) {
            TEST_ASSERT_TRUE(recording_writer_flush(&writer));
        }
    }
}

static uint32_t read_all(void)
{
    cycle_record_t expected;
    uint32_t count = 0U;

    while (recording_reader_next(&reader, &record)) {
        make_record(&expected, count, kind_of(count));
        TEST_ASSERT_EQUAL_UINT32(expected.kind, record.kind);
        TEST_ASSERT_EQUAL_UINT32(expected.cycle, record.cycle);
        TEST_ASSERT_EQUAL_MEMORY(expected.body.checkpoint, record.body.checkpoint,
                                 recording_body_size(&header, record.kind));
        count++;
    }
    return count;
}

static void flip(off_t offset, uint8_t mask)
{
    uint8_t byte = 0U;
    const int file = open(path, O_RDWR);

    TEST_ASSERT_EQUAL_INT(1, (int)pread(file, &byte, 1U, offset));
    byte ^= mask;
    TEST_ASSERT_EQUAL_INT(1, (int)pwrite(file, &byte, 1U, offset));
    (void)close(file);
}

static off_t file_size(void)
{
    struct stat status;

    TEST_ASSERT_EQUAL_INT(0, stat(path, &status));
    return status.st_size;
}

/* Offset of each block, of the trailer and of the end. */
static void find_blocks(off_t offsets[BLOCKS + 2U])
{
    uint8_t bytes[RECORDING_PREFIX_SIZE];
    recording_fields_t fields;
    const int file = open(path, O_RDONLY);

    offsets[0] = RECORDING_HEADER_SIZE;
    for (uint32_t i = 0U; i < BLOCKS; i++) {
        TEST_ASSERT_EQUAL_INT((int)sizeof(bytes),
                              (int)pread(file, bytes, sizeof(bytes), offsets[i]));
        TEST_ASSERT_TRUE(recording_decode_fields(bytes, &fields));
        offsets[i + 1U] = offsets[i] + (off_t)(RECORDING_PREFIX_SIZE +
                                               recording_checksums_size(fields.compressed_size) +
                                               fields.compressed_size);
    }
    (void)close(file);
    offsets[BLOCKS + 1U] = file_size();
}

void test_SWR_REC_002_records_come_back_as_they_were_appended(void)
{
    write_blocks(BLOCKS);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL_MESSAGE(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding),
                              finding.sentence);
    TEST_ASSERT_EQUAL_UINT32(BLOCKS, reader.blocks);
    TEST_ASSERT_EQUAL_UINT32(BLOCKS * RECORDS_PER_BLOCK, read_all());
}

void test_SWR_REC_002_a_block_is_written_when_it_is_full(void)
{
    TEST_ASSERT_TRUE(recording_writer_open(&writer, path, &header));
    for (uint32_t cycle = 0U; cycle < (RECORDING_BLOCK_RECORDS + 1U); cycle++) {
        make_record(&record, cycle, kind_of(cycle));
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
        TEST_ASSERT_EQUAL_UINT32((cycle < (RECORDING_BLOCK_RECORDS - 1U)) ? 0U : 1U, writer.blocks);
    }
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT32(RECORDING_BLOCK_RECORDS + 1U, read_all());
}

void test_SWR_REC_002_lost_cycles_are_written_into_the_block_after_them(void)
{
    write_blocks(1U);
    recording_writer_note_loss(&writer, 5U);
    make_record(&record, RECORDS_PER_BLOCK + 5U, CYCLE_RECORD_CYCLE);
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT32(5U, reader.cycles_lost);
}

void test_SWR_REC_002_a_record_of_an_unknown_kind_is_left_out(void)
{
    write_blocks(1U);
    record.kind = 7U;
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT32(RECORDS_PER_BLOCK, read_all());
}

void test_SWR_REC_002_a_full_disk_leaves_whole_blocks_and_says_so(void)
{
    struct rlimit limit;
    struct rlimit before;

    write_blocks(1U);
    (void)signal(SIGXFSZ, SIG_IGN);
    TEST_ASSERT_EQUAL_INT(0, getrlimit(RLIMIT_FSIZE, &before));
    limit = before;
    limit.rlim_cur = (rlim_t)file_size() + 100U; /* Half a block. */
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &limit));
    for (uint32_t cycle = 0U; cycle < RECORDS_PER_BLOCK; cycle++) {
        make_record(&record, cycle, CYCLE_RECORD_CYCLE);
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    }
    const bool is_written = recording_writer_flush(&writer);
    const int reason = errno;
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_FSIZE, &before));
    TEST_ASSERT_FALSE(is_written);
    TEST_ASSERT_EQUAL_INT(EFBIG, reason);
    TEST_ASSERT_EQUAL(RECORDING_CUT_SHORT, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT64((uint64_t)file_size(), finding.first_byte);
    TEST_ASSERT_EQUAL_UINT32(RECORDS_PER_BLOCK, read_all());
}

void test_SWR_REC_002_an_existing_file_is_never_overwritten(void)
{
    write_blocks(1U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_FALSE(recording_writer_open(&writer, path, &header));
    TEST_ASSERT_EQUAL_INT(EEXIST, errno);
}

void test_SWR_REC_003_the_header_names_build_and_robot(void)
{
    write_blocks(1U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_STRING("test-build", reader.header.build);
    TEST_ASSERT_EQUAL_STRING("neuro", reader.header.robot);
    TEST_ASSERT_EQUAL_HEX32(0x12345678U, reader.header.robot_crc);
    TEST_ASSERT_EQUAL_UINT64(UINT64_C(1700000000123456), reader.header.started_us);
}

void test_SWR_REC_003_a_recording_of_another_layout_does_not_fit(void)
{
    recording_header_t other = header;

    other.inputs_size = sizeof(controller_inputs_t);
    other.outputs_size = sizeof(controller_outputs_t);
    TEST_ASSERT_TRUE(recording_writer_open(&writer, path, &other));
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_TRUE(recording_reader_fits(&reader, CONTROLLER_SIZE));
    TEST_ASSERT_FALSE(recording_reader_fits(&reader, CONTROLLER_SIZE + 1U));
    reader.header.outputs_size--;
    TEST_ASSERT_FALSE(recording_reader_fits(&reader, CONTROLLER_SIZE));
    reader.header.outputs_size++;
    reader.header.inputs_size++;
    TEST_ASSERT_FALSE(recording_reader_fits(&reader, CONTROLLER_SIZE));
}

void test_SWR_REPLAY_002_a_flip_of_any_bit_pattern_in_any_byte_is_reported_with_its_place(void)
{
    static const uint8_t masks[] = {0x01U, 0x80U, 0xFFU};
    off_t offsets[BLOCKS + 2U];

    write_blocks(BLOCKS);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    find_blocks(offsets);
    for (off_t offset = 0; offset < file_size(); offset++) {
        uint32_t block = 0U;
        while ((offset >= RECORDING_HEADER_SIZE) && (offset >= offsets[block + 1U])) {
            block++;
        }
        for (size_t i = 0U; i < sizeof(masks); i++) {
            flip(offset, masks[i]);
            TEST_ASSERT_EQUAL(RECORDING_DAMAGED, recording_reader_open(&reader, path, &finding));
            TEST_ASSERT_EQUAL_UINT32_MESSAGE(block, finding.block, finding.sentence);
            TEST_ASSERT_TRUE_MESSAGE(finding.first_byte <= (uint64_t)offset, finding.sentence);
            TEST_ASSERT_TRUE_MESSAGE(finding.last_byte >= (uint64_t)offset, finding.sentence);
            TEST_ASSERT_TRUE_MESSAGE((finding.last_byte - finding.first_byte) < RECORDING_CHUNK,
                                     finding.sentence);
            flip(offset, masks[i]);
        }
    }
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
}

void test_SWR_REPLAY_002_a_file_cut_anywhere_is_not_called_whole(void)
{
    off_t offsets[BLOCKS + 2U];
    uint32_t blocks = BLOCKS;

    write_blocks(BLOCKS);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    find_blocks(offsets);
    for (off_t size = file_size() - 1; size >= 0; size--) {
        TEST_ASSERT_EQUAL_INT(0, truncate(path, size));
        const recording_verdict_t verdict = recording_reader_open(&reader, path, &finding);
        while ((blocks > 0U) && (size < offsets[blocks])) {
            blocks--;
        }
        if (size < (off_t)RECORDING_HEADER_SIZE) {
            TEST_ASSERT_EQUAL(RECORDING_UNREADABLE, verdict);
        } else {
            TEST_ASSERT_EQUAL_MESSAGE(RECORDING_CUT_SHORT, verdict, finding.sentence);
            TEST_ASSERT_EQUAL_UINT32(blocks, reader.blocks);
        }
        recording_reader_close(&reader);
    }
}

void test_SWR_REPLAY_002_what_is_left_of_a_cut_recording_is_usable(void)
{
    off_t offsets[BLOCKS + 2U];

    write_blocks(BLOCKS);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    find_blocks(offsets);
    TEST_ASSERT_EQUAL_INT(0, truncate(path, offsets[2] + 70));
    TEST_ASSERT_EQUAL(RECORDING_CUT_SHORT, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT32(2U * RECORDS_PER_BLOCK, read_all());
}

void test_SWR_REPLAY_002_bytes_after_the_trailer_are_reported(void)
{
    write_blocks(1U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    const off_t size = file_size();
    TEST_ASSERT_EQUAL_INT(0, truncate(path, size + 3));
    TEST_ASSERT_EQUAL(RECORDING_DAMAGED, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT64((uint64_t)size, finding.first_byte);
    TEST_ASSERT_EQUAL_UINT64((uint64_t)size + 2U, finding.last_byte);
}

void test_SWR_REPLAY_002_a_block_that_was_taken_out_is_reported(void)
{
    static uint8_t bytes[65536];
    off_t offsets[BLOCKS + 2U];

    write_blocks(BLOCKS);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    find_blocks(offsets);
    const int file = open(path, O_RDWR);
    const ssize_t rest = pread(file, bytes, sizeof(bytes), offsets[2]);
    TEST_ASSERT_EQUAL_INT((int)rest, (int)pwrite(file, bytes, (size_t)rest, offsets[1]));
    TEST_ASSERT_EQUAL_INT(0, ftruncate(file, offsets[1] + rest));
    (void)close(file);
    TEST_ASSERT_EQUAL(RECORDING_DAMAGED, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT32(1U, finding.block);
    TEST_ASSERT_NOT_NULL(strstr(finding.sentence, "another block belongs here"));
}

void test_SWR_REPLAY_002_a_missing_file_is_named(void)
{
    TEST_ASSERT_EQUAL(RECORDING_UNREADABLE,
                      recording_reader_open(&reader, "/tmp/no-such.bsr", &finding));
    TEST_ASSERT_NOT_NULL(strstr(finding.sentence, "/tmp/no-such.bsr"));
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: what comes out of a recording is what went in.
 */
#include "unity.h"

#include "recording/format/cycle_code.h"
#include "recording/format/cycle_words.h"
#include "recording/format/proof.h"
#include "recording/format/recording.h"
#include "recording/read/recording_reader.h"
#include "recording/write/recording_writer.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "unit/recording/recording_world.inc"

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

void test_SWR_REC_002_records_come_back_as_they_were_appended(void)
{
    write_blocks(BLOCKS);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL_MESSAGE(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding),
                              finding.sentence);
    TEST_ASSERT_EQUAL_UINT32(BLOCKS, reader.blocks);
    TEST_ASSERT_EQUAL_UINT32(BLOCKS * RECORDS_PER_BLOCK, read_all());
}

void test_SWR_REC_030_the_run_comes_back_and_has_the_name_of_its_time(void)
{
    char name[RECORDING_RUN_SIZE];

    write_blocks(1U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT64(header.run, reader.header.run);
    recording_run_name(reader.header.run, name);
    TEST_ASSERT_EQUAL_STRING("20231114T221320.000042Z", name);
    recording_run_name(UINT64_MAX, name);
    TEST_ASSERT_EQUAL_STRING("5865240119T080149.551615Z", name);
}

void test_SWR_REC_031_only_the_trailer_that_was_informed_says_that_the_run_ends(void)
{
    for (uint32_t i = 0U; i < 2U; i++) {
        write_blocks(1U);
        if (i == 1U) {
            recording_writer_note_run_end(&writer);
        }
        TEST_ASSERT_TRUE(recording_writer_close(&writer));
        TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
        TEST_ASSERT_EQUAL(i == 1U, reader.is_run_end);
        recording_reader_close(&reader);
        (void)unlink(path);
    }
}

void test_SWR_TRAJ_017_rows_come_back_with_their_checkpoint(void)
{
    static trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];
    const uint32_t counts[] = {LIMIT_TRAJECTORY_ROWS, 0U, 2U};

    for (uint32_t i = 0U; i < sizeof rows; i++) {
        ((uint8_t *)rows)[i] = next_noise();
    }
    TEST_ASSERT_TRUE(recording_writer_open(&writer, path, &header));
    for (uint32_t i = 0U; i < 3U; i++) {
        make_record(&record, i, CYCLE_RECORD_CHECKPOINT);
        record.rows = counts[i];
        TEST_ASSERT_TRUE(recording_writer_append_checkpoint(&writer, &record, rows));
        make_record(&record, i, CYCLE_RECORD_CYCLE);
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    }
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_TRUE(recording_reader_next(&reader, &record, &known));
        TEST_ASSERT_EQUAL_UINT32(CYCLE_RECORD_CHECKPOINT, record.kind);
        TEST_ASSERT_EQUAL_UINT32(counts[i], record.rows);
        TEST_ASSERT_EQUAL_INT(0, memcmp(rows, known.rows, counts[i] * sizeof rows[0]));
        TEST_ASSERT_TRUE(recording_reader_next(&reader, &record, &known));
        TEST_ASSERT_EQUAL_UINT32(CYCLE_RECORD_CYCLE, record.kind);
    }
    TEST_ASSERT_FALSE(recording_reader_next(&reader, &record, &known));
}

void test_SWR_REC_002_a_block_is_written_when_it_holds_a_second(void)
{
    TEST_ASSERT_TRUE(recording_writer_open(&writer, path, &header));
    for (uint32_t cycle = 0U; cycle < (RECORDING_BLOCK_RECORDS + 1U); cycle++) {
        make_record(&record, cycle, CYCLE_RECORD_CYCLE);
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
        TEST_ASSERT_EQUAL_UINT32((cycle < (RECORDING_BLOCK_RECORDS - 1U)) ? 0U : 1U, writer.blocks);
    }
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT32(2U, reader.blocks);
    TEST_ASSERT_EQUAL_UINT64(RECORDING_BLOCK_RECORDS + 1U, reader.records);
}

/* All words of every cycle are noise. */
void test_SWR_REC_002_a_block_is_written_before_its_room_is_full(void)
{
    TEST_ASSERT_TRUE(recording_writer_open(&writer, path, &header));
    for (uint32_t cycle = 0U; cycle < 200U; cycle++) {
        (void)memset(&record, 0, sizeof(record));
        record.kind = (uint32_t)CYCLE_RECORD_CYCLE;
        record.cycle = cycle;
        noise = cycle;
        for (uint32_t i = 0U; i < sizeof(record.body.cycle); i++) {
            record.body.checkpoint[i] = next_noise();
        }
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
        TEST_ASSERT_TRUE(writer.block.raw_size <= (RECORDING_RAW_MAX - RECORDING_RECORD_MAX));
    }
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_GREATER_THAN_UINT32(2U, reader.blocks);
    for (uint32_t cycle = 0U; cycle < 200U; cycle++) {
        TEST_ASSERT_TRUE(recording_reader_next(&reader, &record, &known));
        TEST_ASSERT_EQUAL_UINT32(cycle, record.cycle);
        noise = cycle;
        for (uint32_t i = 0U; i < offsetof(controller_outputs_t, snapshot); i++) {
            TEST_ASSERT_EQUAL_HEX8(next_noise(), record.body.checkpoint[i]);
        }
    }
}

/* Two blocks of 23 cycles with their checkpoints, then two cycles after a loss. */
void test_SWR_REC_006_whole_are_the_first_cycle_of_a_block_and_all_without_a_checkpoint(void)
{
    uint32_t whole = 0U;

    write_blocks(2U);
    make_record(&record, 1000U, CYCLE_RECORD_CYCLE);
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    make_record(&record, 1001U, CYCLE_RECORD_CYCLE);
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    make_record(&record, 1002U, CYCLE_RECORD_CHECKPOINT);
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    make_record(&record, 1002U, CYCLE_RECORD_CYCLE);
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    make_record(&record, 1003U, CYCLE_RECORD_CYCLE);
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT32(4U, reader.blocks);
    while (recording_reader_next(&reader, &record, &known)) {
        if (record.kind == (uint32_t)CYCLE_RECORD_CYCLE) {
            whole += known.is_whole ? 1U : 0U;
            TEST_ASSERT_EQUAL((record.cycle == 0U) || (record.cycle == 23U) ||
                                  ((record.cycle >= 1000U) && (record.cycle <= 1002U)),
                              known.is_whole);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(5U, whole);
}

/* Where it begins in the open recording. */
static uint64_t third_block(void)
{
    recording_fields_t fields;
    uint64_t offset = RECORDING_HEADER_SIZE;

    for (uint32_t i = 0U; i < 2U; i++) {
        TEST_ASSERT_TRUE(recording_decode_fields(&reader.bytes[offset], &fields));
        offset += RECORDING_PREFIX_SIZE + recording_checksums_size(fields.compressed_size) +
                  fields.compressed_size;
    }
    return offset;
}

void test_SWR_REC_002_lost_cycles_are_written_into_the_block_after_them(void)
{
    write_blocks(1U);
    make_record(&record, RECORDS_PER_BLOCK - 1U, CYCLE_RECORD_CYCLE);
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    recording_writer_note_loss(&writer, 5U);
    make_record(&record, RECORDS_PER_BLOCK + 5U, CYCLE_RECORD_CYCLE);
    TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_UINT32(5U, reader.cycles_lost);
    TEST_ASSERT_EQUAL_UINT32(3U, reader.blocks);
    recording_fields_t last;
    TEST_ASSERT_TRUE(recording_decode_fields(&reader.bytes[third_block()], &last));
    TEST_ASSERT_EQUAL_UINT32(5U, last.cycles_lost);
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
    for (uint32_t n = RECORDS_PER_BLOCK; n < (2U * RECORDS_PER_BLOCK); n++) {
        make_nth(&record, n);
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

/* The number of the frames as they are. A change of their layout is meant to change it. */
void test_SWR_REC_008_the_header_has_the_number_of_the_frames(void)
{
    write_blocks(1U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_HEX32(0xA6C1ED2AU, reader.header.frame_layout);
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

void test_SWR_REC_008_a_recording_of_another_layout_does_not_fit(void)
{
    write_blocks(1U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    TEST_ASSERT_EQUAL(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_HEX64(LAYOUT, reader.header.layout);
    TEST_ASSERT_TRUE(recording_reader_fits(&reader, LAYOUT, CONTROLLER_SIZE));
    TEST_ASSERT_FALSE(recording_reader_fits(&reader, LAYOUT + 1U, CONTROLLER_SIZE));
    TEST_ASSERT_FALSE(recording_reader_fits(&reader, LAYOUT, CONTROLLER_SIZE + 1U));
    reader.header.outputs_size--;
    TEST_ASSERT_FALSE(recording_reader_fits(&reader, LAYOUT, CONTROLLER_SIZE));
    reader.header.outputs_size++;
    reader.header.inputs_size++;
    TEST_ASSERT_FALSE(recording_reader_fits(&reader, LAYOUT, CONTROLLER_SIZE));
}

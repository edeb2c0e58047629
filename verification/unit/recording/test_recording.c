/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: what comes out of a recording is what went in, and no byte of the file can
 * change without being reported at its place.
 */
#include "unity.h"

#include "base/crc.h"
#include "card/card_frame.h"
#include "recording/format/cycle_code.h"
#include "recording/format/cycle_words.h"
#include "recording/format/proof.h"
#include "recording/format/recording.h"
#include "recording/read/recording_block.h"
#include "recording/read/recording_reader.h"
#include "recording/read/recording_verify.h"
#include "recording/write/recording_writer.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#define CONTROLLER_SIZE 48U /* A small one keeps the file small enough to try every byte. */
#define LAYOUT UINT64_C(0x0123456789ABCDEF)
#define BLOCKS 3U
#define RECORDS_PER_BLOCK 24U

static const recording_header_t header = {.build = "test-build",
                                          .robot = "neuro",
                                          .robot_crc = 0x12345678U,
                                          .inputs_size = sizeof(controller_inputs_t),
                                          .outputs_size = sizeof(controller_outputs_t),
                                          .controller_size = CONTROLLER_SIZE,
                                          .started_us = UINT64_C(1700000000123456),
                                          .run = UINT64_C(1700000000000042),
                                          .layout = LAYOUT};
static char path[64];
static recording_writer_t writer;
static recording_reader_t reader;
static recording_finding_t finding;
static cycle_record_t record;
static cycle_known_t known;
static prover_t prover;
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

/* The same record for the same cycle: a card that counts, and noise. */
static void make_record(cycle_record_t *to, uint32_t cycle, cycle_record_kind_t kind)
{
    const card_report_t report = {.slot = 2U, .heartbeat = cycle, .encoder_count = -(int32_t)cycle};
    const card_command_t command = {.slot = 2U, .sequence = cycle};

    (void)memset(to, 0, sizeof(*to));
    to->kind = (uint32_t)kind;
    to->cycle = cycle;
    noise = cycle + 1U;
    if (kind == CYCLE_RECORD_CHECKPOINT) {
        for (uint32_t i = 0U; i < CONTROLLER_SIZE; i++) {
            to->body.checkpoint[i] = next_noise();
        }
        return;
    }
    to->body.cycle.inputs.elapsed_us = 1000U + next_noise();
    card_frame_encode_report(&report, to->body.cycle.inputs.frames[2]);
    to->body.cycle.inputs.frames[5][next_noise()] = next_noise();
    to->body.cycle.board.sampled_us = 1000U * cycle;
    to->body.cycle.board.results[3] = next_noise();
    to->body.cycle.outputs.event_count = next_noise() & 1U;
    to->body.cycle.outputs.snapshot.cycle = cycle;
    to->body.cycle.outputs.snapshot.axes[0].position_ticks = next_noise();
    card_frame_encode_command(&command, to->body.cycle.outputs.frames[2]);
}

/* Each block begins with a checkpoint, which is of the cycle after it. */
static void make_nth(cycle_record_t *to, uint32_t n)
{
    const uint32_t block = n / RECORDS_PER_BLOCK;
    const uint32_t place = n % RECORDS_PER_BLOCK;
    const uint32_t first = block * (RECORDS_PER_BLOCK - 1U);

    if (place == 0U) {
        make_record(to, first, CYCLE_RECORD_CHECKPOINT);
    } else {
        make_record(to, first + (place - 1U), CYCLE_RECORD_CYCLE);
    }
}

static void write_blocks(uint32_t blocks)
{
    TEST_ASSERT_TRUE(recording_writer_open(&writer, path, &header));
    for (uint32_t n = 0U; n < (blocks * RECORDS_PER_BLOCK); n++) {
        make_nth(&record, n);
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &record));
    }
    TEST_ASSERT_TRUE(recording_writer_flush(&writer));
}

/* A cycle comes back as it was written, or as its proof. */
static void expect_cycle(const cycle_record_t *expected)
{
    const controller_outputs_t *const outputs = &expected->body.cycle.outputs;
    uint32_t words[CYCLE_WORDS_CHECKED];
    proof_t proof;

    TEST_ASSERT_EQUAL_MEMORY(&expected->body.cycle.inputs, &record.body.cycle.inputs,
                             sizeof(controller_inputs_t));
    TEST_ASSERT_EQUAL_MEMORY(&expected->body.cycle.board, &record.body.cycle.board,
                             sizeof(cycle_board_t));
    TEST_ASSERT_EQUAL_MEMORY(outputs, &record.body.cycle.outputs,
                             known.is_whole ? sizeof(controller_outputs_t)
                                            : offsetof(controller_outputs_t, snapshot));
    if (known.is_whole) {
        prover_begin(&prover);
    }
    cycle_words_of_checked(outputs, words);
    prover_take(&prover, expected->body.cycle.inputs.elapsed_us, words, &proof);
    TEST_ASSERT_TRUE(known.is_whole || (proof_difference(&proof, &known.proof) == PROOF_PARTS));
}

static uint32_t read_all(void)
{
    static cycle_record_t expected;
    uint32_t count = 0U;

    while (recording_reader_next(&reader, &record, &known)) {
        make_nth(&expected, count);
        TEST_ASSERT_EQUAL_UINT32(expected.kind, record.kind);
        TEST_ASSERT_EQUAL_UINT32(expected.cycle, record.cycle);
        if (record.kind == (uint32_t)CYCLE_RECORD_CYCLE) {
            expect_cycle(&expected);
        } else {
            TEST_ASSERT_EQUAL_MEMORY(expected.body.checkpoint, record.body.checkpoint,
                                     CONTROLLER_SIZE);
        }
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

void test_SWR_REPLAY_007_what_is_no_file_is_refused(void)
{
    TEST_ASSERT_EQUAL(RECORDING_UNREADABLE, recording_reader_open(&reader, "/tmp", &finding));
    TEST_ASSERT_NOT_NULL(strstr(finding.sentence, "/tmp cannot be read"));
    TEST_ASSERT_EQUAL(RECORDING_UNREADABLE, recording_reader_open(&reader, "/dev/zero", &finding));
}

static void write_bytes(const uint8_t *bytes, size_t size)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);

    TEST_ASSERT_EQUAL_INT((int)size, (int)write(file, bytes, size));
    (void)close(file);
}

void test_SWR_REPLAY_007_files_of_noise_are_refused_with_a_sentence(void)
{
    static uint8_t bytes[4096];

    for (uint32_t i = 0U; i < 200U; i++) {
        noise = i;
        for (size_t at = 0U; at < sizeof(bytes); at++) {
            bytes[at] = next_noise();
        }
        if ((i % 2U) == 1U) { /* With a right header. */
            recording_encode_header(&header, bytes);
        }
        write_bytes(bytes, 200U + (i * 19U));
        const recording_verdict_t verdict = recording_reader_open(&reader, path, &finding);
        TEST_ASSERT_TRUE((verdict == RECORDING_DAMAGED) || (verdict == RECORDING_UNREADABLE) ||
                         (((i % 2U) == 1U) && (verdict == RECORDING_CUT_SHORT)));
        TEST_ASSERT_NOT_EQUAL(0, strlen(finding.sentence));
        recording_reader_close(&reader);
    }
}

/* A block of these bytes with right checksums and hash, as a malicious writer makes it. */
static void forge_block(const uint8_t *raw, uint32_t raw_size, uint32_t reported_size)
{
    static uint8_t bytes[65536];
    uint8_t *const block = &bytes[RECORDING_HEADER_SIZE];
    uint8_t packed[32768];
    recording_fields_t fields = {
        .magic = RECORDING_BLOCK_MAGIC, .cycle = 7U, .records = 10U, .raw_size = reported_size};

    recording_encode_header(&header, bytes);
    fields.compressed_size = (uint32_t)ZSTD_compress(packed, sizeof(packed), raw, raw_size, 1);
    recording_encode_fields(&fields, block);
    recording_encode_checksums(packed, fields.compressed_size, &block[RECORDING_PREFIX_SIZE]);
    const size_t checksums = recording_checksums_size(fields.compressed_size);
    (void)memcpy(&block[RECORDING_PREFIX_SIZE + checksums], packed, fields.compressed_size);
    recording_hash(&bytes[RECORDING_HEADER_SIZE - RECORDING_HASH_SIZE], block,
                   &block[RECORDING_PREFIX_SIZE], checksums + fields.compressed_size,
                   &block[RECORDING_FIELDS_SIZE]);
    write_bytes(bytes,
                RECORDING_HEADER_SIZE + RECORDING_PREFIX_SIZE + checksums + fields.compressed_size);
}

void test_SWR_REPLAY_007_a_forged_block_never_gives_the_records_it_announces(void)
{
    static uint8_t raw[8192];

    for (uint32_t i = 0U; i < 300U; i++) {
        const uint32_t size = 1U + (i * 23U);
        uint32_t count = 0U;
        noise = i;
        for (size_t at = 0U; at < size; at++) {
            raw[at] = ((i % 3U) == 0U) ? next_noise() : (next_noise() >> 4U);
        }
        raw[0] = (uint8_t)(i % 5U);
        raw[size - 1U] = 0x80U; /* No record ends so. */
        forge_block(raw, size, ((i % 7U) == 0U) ? (size + i) : size);
        TEST_ASSERT_EQUAL_MESSAGE(RECORDING_CUT_SHORT,
                                  recording_reader_open(&reader, path, &finding), finding.sentence);
        while (recording_reader_next(&reader, &record, &known)) {
            count++;
        }
        TEST_ASSERT_TRUE((count != reader.records) || (reader.raw_next != reader.raw_size));
        recording_reader_close(&reader);
    }
}

void test_SWR_REPLAY_005_another_version_of_the_format_is_refused_by_both_versions(void)
{
    uint8_t bytes[RECORDING_HEADER_SIZE];

    write_blocks(1U);
    TEST_ASSERT_TRUE(recording_writer_close(&writer));
    const int file = open(path, O_RDWR);
    TEST_ASSERT_EQUAL_INT((int)sizeof(bytes), (int)pread(file, bytes, sizeof(bytes), 0));
    bytes[sizeof("BSRECORD") - 1U] = 1U;
    recording_seal_header(bytes);
    TEST_ASSERT_EQUAL_INT((int)sizeof(bytes), (int)pwrite(file, bytes, sizeof(bytes), 0));
    (void)close(file);
    TEST_ASSERT_EQUAL(RECORDING_OTHER_VERSION, recording_reader_open(&reader, path, &finding));
    TEST_ASSERT_EQUAL_STRING("The recording is of format version 1, this build reads version 5; "
                             "replay it with the build that recorded it, \"test-build\".",
                             finding.sentence);
}

void test_SWR_REPLAY_008_names_are_escaped(void)
{
    char escaped[64];

    recording_escape("neuro 2", escaped, sizeof(escaped));
    TEST_ASSERT_EQUAL_STRING("neuro 2", escaped);
    recording_escape("\x1B[2J\"\\\n\xFF", escaped, sizeof(escaped));
    TEST_ASSERT_EQUAL_STRING("\\x1B[2J\\x22\\x5C\\x0A\\xFF", escaped);
    recording_escape("\n\n\n", escaped, 11U);
    TEST_ASSERT_EQUAL_STRING("\\x0A\\x0A", escaped);
}

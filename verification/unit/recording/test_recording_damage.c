/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: no byte of a recording can change without being reported at its place, and no
 * file, whatever its bytes, gives more than it holds.
 */
#include "unity.h"

#include "recording/format/cycle_code.h"
#include "recording/format/cycle_words.h"
#include "recording/format/proof.h"
#include "recording/format/recording.h"
#include "recording/read/recording_reader.h"
#include "recording/write/recording_writer.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <zstd.h>

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

static void flip(off_t offset, uint8_t mask)
{
    uint8_t byte = 0U;
    const int file = open(path, O_RDWR);

    TEST_ASSERT_EQUAL_INT(1, (int)pread(file, &byte, 1U, offset));
    byte ^= mask;
    TEST_ASSERT_EQUAL_INT(1, (int)pwrite(file, &byte, 1U, offset));
    (void)close(file);
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

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: 64 words, most significant byte first, each field at its byte; a frame that does
 * not fit, or was damaged on the way, is refused by the name of the error, and the data of the
 * receiver stay as they were.
 */
#include "unity.h"

#include "base/crc.h"
#include "card/card_frame.h"
#include "unit/support/card_frame_world.inc"

#include <string.h>

void setUp(void)
{
    (void)memset(bytes, UNTOUCHED, sizeof bytes);
}

void tearDown(void)
{
}

static void expect_bytes(uint32_t at, const char *expected, size_t length)
{
    TEST_ASSERT_EQUAL_HEX8_ARRAY(expected, &bytes[at], length);
}

void test_SWR_CARD_001_command_fields_stand_at_their_bytes(void)
{
    encode_command();
    expect_bytes(0U, "\xFE\xFE\xFE\x01\x01\x07\x40\x01\x01\x02\x03\x04\x11\x12\x13\x14", 16U);
    expect_bytes(16U, "\x00\x00\x05\x07\x00\x00\x00\x01", 8U);
    expect_bytes(40U, "\x01\x01\x00\x00\x00\x01\xFF\xFF\x00\x00\x00\x00\x00\x00\x27\x10", 16U);
    expect_bytes(56U, "\x00\x00\x75\x30\xFF\xFF\xFF\xFE\x7F\xFF\xFF\xFF\x00\x00\x00\x03", 16U);
    expect_bytes(244U, "\xFF\xFF\xFF\xFE", 4U);
}

void test_SWR_CARD_001_report_fields_stand_at_their_bytes(void)
{
    encode_report();
    expect_bytes(0U, "\xFE\xFE\xFE\x01\x01\x07\x40\x02\x01\x02\x03\x04\x21\x22\x23\x24", 16U);
    expect_bytes(16U, "\x31\x32\x33\x34\x01\x01\x02\x03\x41\x42\x43\x44\x00\x00\x00\x02", 16U);
    expect_bytes(36U, "\x00\x00\x01\x02\x80\x00\x00\x00", 8U);
    expect_bytes(52U, "\x51\x52\x53\x54\x61\x62\x63\x64\x71\x72\x73\x74", 12U);
    expect_bytes(64U, "\x75\x76\x77\x78\x79\x7A\x7B\x7C", 8U);
    expect_bytes(72U, "\xFF\xFF\x01\xD7\x5D\xC0\x01\x5E", 8U);
    expect_bytes(96U,
                 "\x11\x01\xAB\xCD\x81\x82\x83\x84\x91\x92\x93\x94\xA1\xA2\xA3\xA4\xB1\xB2\xB3\xB4",
                 20U);
}

void test_SWR_CARD_001_words_without_a_field_are_zero(void)
{
    encode_command();
    for (uint32_t i = 18U; i < 61U; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, word(i));
    }
    encode_report();
    for (uint32_t i = 29U; i < 62U; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, word(i));
    }
}

void test_SWR_CARD_001_a_command_comes_back_as_it_was_sent(void)
{
    card_command_t read;
    const card_command_t sent = a_command();

    encode_command();
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_command(bytes, SLOT, &read));
    TEST_ASSERT_EQUAL_MEMORY(&sent, &read, sizeof sent);
}

void test_SWR_CARD_001_a_report_comes_back_as_it_was_sent(void)
{
    card_report_t read;
    const card_report_t sent = a_report();

    encode_report();
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(bytes, SLOT, &read));
    TEST_ASSERT_EQUAL_MEMORY(&sent, &read, sizeof sent);
}

void test_SWR_CARD_001_report_values_saturate_at_the_width_of_their_field(void)
{
    card_report_t report = a_report();
    card_report_t read;

    report.edges = 65536U;
    report.supply_mv = UINT32_MAX;
    report.driver_temperature_dc = INT32_MAX;
    report.motor_temperature_dc = INT32_MIN;
    card_frame_encode_report(&report, bytes);
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(bytes, SLOT, &read));
    TEST_ASSERT_EQUAL_UINT32(65535U, read.edges);
    TEST_ASSERT_EQUAL_UINT32(65535U, read.supply_mv);
    TEST_ASSERT_EQUAL_INT32(32767, read.driver_temperature_dc);
    TEST_ASSERT_EQUAL_INT32(-32768, read.motor_temperature_dc);
}

void test_SWR_CARD_001_temperatures_below_zero_come_back(void)
{
    card_report_t report = a_report();
    card_report_t read;

    report.driver_temperature_dc = -105;
    report.motor_temperature_dc = -32768;
    card_frame_encode_report(&report, bytes);
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(bytes, SLOT, &read));
    TEST_ASSERT_EQUAL_INT32(-105, read.driver_temperature_dc);
    TEST_ASSERT_EQUAL_INT32(-32768, read.motor_temperature_dc);
}

void test_SWR_CARD_002_word_63_is_the_crc_of_the_252_bytes_before_it(void)
{
    card_command_t command = a_command();
    card_report_t report = a_report();

    for (uint32_t slot = 0U; slot < 256U; slot++) {
        command.slot = slot;
        card_frame_encode_command(&command, bytes);
        TEST_ASSERT_EQUAL_HEX32(crc32c(bytes, 252U), word(63U));
        report.slot = slot;
        card_frame_encode_report(&report, bytes);
        TEST_ASSERT_EQUAL_HEX32(crc32c(bytes, 252U), word(63U));
    }
}

/* A word that is zero while a drive is off is not read for the checksum: each bit of it must still
 * be found. */
void test_SWR_CARD_002_each_bit_that_is_zero_while_the_drive_is_off_is_found(void)
{
    const card_command_t command = {.slot = 2U, .watchdog_us = 5000U};
    const card_report_t report = {.slot = 2U};
    card_command_t read_command;
    card_report_t read_report;

    card_frame_encode_command(&command, bytes);
    TEST_ASSERT_EQUAL_HEX32(crc32c(bytes, 252U), word(63U));
    TEST_ASSERT_EQUAL_UINT32(CARD_FRAME_OK, card_frame_decode_command(bytes, 2U, &read_command));
    for (uint32_t bit = 6U * 32U; bit < (13U * 32U); bit++) {
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
        TEST_ASSERT_EQUAL_UINT32(CARD_FRAME_BAD_CRC,
                                 card_frame_decode_command(bytes, 2U, &read_command));
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
    }
    card_frame_encode_report(&report, bytes);
    TEST_ASSERT_EQUAL_HEX32(crc32c(bytes, 252U), word(63U));
    TEST_ASSERT_EQUAL_UINT32(CARD_FRAME_OK, card_frame_decode_report(bytes, 2U, &read_report));
    for (uint32_t bit = 20U * 32U; bit < (27U * 32U); bit++) {
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
        TEST_ASSERT_EQUAL_UINT32(CARD_FRAME_BAD_CRC,
                                 card_frame_decode_report(bytes, 2U, &read_report));
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
    }
}

/* One of them alone makes the checksum read all of them. */
void test_SWR_CARD_002_each_count_that_is_zero_while_all_is_well_is_in_the_crc(void)
{
    const card_report_t report = {.slot = 2U};
    card_report_t read;

    for (uint32_t index = 25U; index < 29U; index++) {
        card_frame_encode_report(&report, bytes);
        set_word(index, 1U);
        sign_again();
        TEST_ASSERT_EQUAL_UINT32(CARD_FRAME_OK, card_frame_decode_report(bytes, 2U, &read));
    }
}

void test_SWR_CARD_002_a_frame_that_is_written_onto_zeros_is_the_same(void)
{
    card_command_t command = a_command();
    uint8_t zeros[CARD_FRAME_BYTES] = {0U};

    encode_command();
    card_frame_write_command(&command, zeros);
    TEST_ASSERT_EQUAL_MEMORY(bytes, zeros, CARD_FRAME_BYTES);
    command.drive = (card_drive_t){.mode = (uint32_t)CARD_DRIVE_OFF};
    card_frame_encode_command(&command, bytes);
    (void)memset(zeros, 0, sizeof zeros);
    card_frame_write_command(&command, zeros);
    TEST_ASSERT_EQUAL_MEMORY(bytes, zeros, CARD_FRAME_BYTES);
}

static uint32_t sum_of_63_words(void)
{
    uint32_t sum = 0U;

    for (uint32_t i = 0U; i < 63U; i++) {
        sum += word(i);
    }
    return sum;
}

void test_SWR_CARD_002_word_62_completes_the_sum_of_all_words_before_it(void)
{
    encode_command();
    TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFFU, sum_of_63_words());
    encode_report();
    TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFFU, sum_of_63_words());
}

void test_SWR_CARD_002_every_single_bit_error_is_found(void)
{
    card_command_t command;
    card_report_t report;

    for (uint32_t bit = 0U; bit < CARD_FRAME_BYTES * 8U; bit++) {
        const uint8_t mask = (uint8_t)(1U << (bit % 8U));
        encode_command();
        bytes[bit / 8U] ^= mask;
        TEST_ASSERT_NOT_EQUAL(CARD_FRAME_OK, card_frame_decode_command(bytes, SLOT, &command));
        encode_report();
        bytes[bit / 8U] ^= mask;
        TEST_ASSERT_NOT_EQUAL(CARD_FRAME_OK, card_frame_decode_report(bytes, SLOT, &report));
    }
}

/* A word that neither is summed nor must be zero would be a hole. */
void test_SWR_CARD_002_every_word_counts_in_the_sum_under_a_right_crc(void)
{
    card_command_t command;
    card_report_t report;

    for (uint32_t i = 0U; i < 63U; i++) {
        encode_command();
        set_word(i, word(i) ^ 0x00000100U);
        set_word(63U, crc32c(bytes, 252U));
        TEST_ASSERT_NOT_EQUAL(CARD_FRAME_OK, card_frame_decode_command(bytes, SLOT, &command));
        encode_report();
        set_word(i, word(i) ^ 0x00000100U);
        set_word(63U, crc32c(bytes, 252U));
        TEST_ASSERT_NOT_EQUAL(CARD_FRAME_OK, card_frame_decode_report(bytes, SLOT, &report));
    }
}

void test_SWR_CARD_003_a_wrong_start_word_is_named(void)
{
    encode_command();
    set_word(0U, 0xFEFEFE02U);
    sign_again();
    expect_command(CARD_FRAME_BAD_START);
    expect_report(CARD_FRAME_BAD_START);
}

void test_SWR_CARD_003_a_wrong_version_length_or_direction_of_travel_is_named(void)
{
    static const uint32_t headers[] = {0x02074001U, 0x01074101U, 0x01074002U};

    for (uint32_t i = 0U; i < 3U; i++) {
        encode_command();
        set_word(1U, headers[i]);
        sign_again();
        expect_command(CARD_FRAME_BAD_START);
    }
    encode_command();
    expect_report(CARD_FRAME_BAD_START);
}

void test_SWR_CARD_003_a_damaged_data_word_is_named_by_its_checksum(void)
{
    encode_command();
    bytes[45] ^= 0x01U;
    expect_command(CARD_FRAME_BAD_CRC);
    encode_report();
    bytes[43] ^= 0x80U;
    expect_report(CARD_FRAME_BAD_CRC);
}

void test_SWR_CARD_003_a_wrong_sum_under_a_right_crc_is_named_as_checksum(void)
{
    encode_command();
    set_word(62U, word(62U) + 1U);
    set_word(63U, crc32c(bytes, 252U));
    expect_command(CARD_FRAME_BAD_CRC);
}

void test_SWR_CARD_003_the_frame_of_another_slot_is_named(void)
{
    card_command_t command = a_command();
    card_report_t report = a_report();

    command.slot = SLOT + 1U;
    card_frame_encode_command(&command, bytes);
    expect_command(CARD_FRAME_BAD_SLOT);
    report.slot = SLOT - 1U;
    card_frame_encode_report(&report, bytes);
    expect_report(CARD_FRAME_BAD_SLOT);
}

void test_SWR_CARD_003_a_slot_that_does_not_fit_its_byte_is_not_taken_for_another(void)
{
    card_command_t command = a_command();

    command.slot = 256U + SLOT;
    card_frame_encode_command(&command, bytes);
    expect_command(CARD_FRAME_BAD_SLOT);
}

void test_SWR_CARD_003_a_wrong_complement_is_named(void)
{
    encode_command();
    set_word(61U, word(61U) ^ 0x00010000U);
    sign_again();
    expect_command(CARD_FRAME_BAD_COMPLEMENT);
}

void test_SWR_CARD_004_word_61_complements_word_5(void)
{
    card_command_t command = a_command();

    for (uint32_t control = 0U; control < 4U; control++) {
        command.control = control;
        card_frame_encode_command(&command, bytes);
        TEST_ASSERT_EQUAL_HEX32(control, word(5U));
        TEST_ASSERT_EQUAL_HEX32(~control, word(61U));
    }
}

/* Each word without a field in turn; `fields` are the others, in order. */
static void expect_refusal_of_reserved(const uint32_t *fields, uint32_t count, void (*encode)(void),
                                       void (*expect)(card_frame_result_t expected))
{
    uint32_t next = 0U;

    for (uint32_t i = 0U; i < CARD_FRAME_WORDS; i++) {
        if ((next < count) && (i == fields[next])) {
            next++;
            continue;
        }
        encode();
        set_word(i, 0x00010000U);
        sign_again();
        expect(CARD_FRAME_BAD_CRC);
    }
    TEST_ASSERT_EQUAL_UINT32(count, next);
    encode();
    sign_again();
    expect(CARD_FRAME_OK);
}

void test_SWR_CARD_006_a_command_with_a_reserved_word_that_is_not_zero_is_refused(void)
{
    static const uint32_t fields[] = {0U,  1U,  2U,  3U,  4U,  5U,  10U, 11U,
                                      13U, 14U, 15U, 16U, 17U, 61U, 62U, 63U};
    expect_refusal_of_reserved(fields, sizeof fields / sizeof fields[0], encode_command,
                               expect_command);
}

void test_SWR_CARD_006_a_report_with_a_reserved_word_that_is_not_zero_is_refused(void)
{
    static const uint32_t fields[] = {0U,  1U,  2U,  3U,  4U,  5U,  6U,  7U,  9U,  10U, 13U, 14U,
                                      15U, 16U, 17U, 18U, 19U, 24U, 25U, 26U, 27U, 28U, 62U, 63U};
    expect_refusal_of_reserved(fields, sizeof fields / sizeof fields[0], encode_report,
                               expect_report);
}

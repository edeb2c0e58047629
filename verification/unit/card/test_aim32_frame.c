/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a command of the dialect aim32 says what it has a word for and nothing else, a
 * drive without one goes out as off; a report counts only with its start word and its sum.
 */
#include "unity.h"

#include "card/aim32_frame.h"
#include "limits/requirement_limits.h"

#include <string.h>

#define START 0xFEFEFE01U

static uint8_t bytes[CARD_FRAME_BYTES];
static uint32_t words[AIM32_FRAME_WORDS];

static uint32_t word(uint32_t index)
{
    const uint8_t *const at = &bytes[index * 4U];
    return ((uint32_t)at[0] << 24U) | ((uint32_t)at[1] << 16U) | ((uint32_t)at[2] << 8U) | at[3];
}

/* The words as the bytes of a frame, with the sum that they need. */
static void write_words(void)
{
    uint32_t sum = 0U;
    for (uint32_t i = 0U; i < 31U; i++) {
        sum += words[i];
    }
    words[31] = 0xFFFFFFFFU - sum;
    for (uint32_t i = 0U; i < AIM32_FRAME_WORDS; i++) {
        for (uint32_t k = 0U; k < 4U; k++) {
            bytes[(i * 4U) + k] = (uint8_t)(words[i] >> (24U - (8U * k)));
        }
    }
}

static void encode(uint32_t mode, uint32_t direction, uint32_t duty, uint32_t amplitude)
{
    const card_command_t command = {.slot = 3U,
                                    .sequence = 7U,
                                    .time_us = 8U,
                                    .system_state = 9U,
                                    .control = CARD_CONTROL_AMPLIFIER | CARD_CONTROL_CLEAR_FAULT,
                                    .drive = {mode, direction, duty, amplitude},
                                    .watchdog_us = 10000U,
                                    .axis_id = 2U};
    (void)memset(bytes, 0xA5, sizeof bytes);
    aim32_frame_encode_command(&command, bytes);
}

/* The frame is whole, and of the words 1 to 30 only these four and the amplifier's may be there. */
static void expect_words(uint32_t second, uint32_t third, uint32_t fourth, uint32_t fifth)
{
    const uint32_t expected[AIM32_FRAME_WORDS] = {
        [0] = START, [2] = second, [3] = third, [4] = fourth, [5] = fifth, [14] = 1U};
    uint32_t sum = 0U;
    for (uint32_t i = 0U; i < 31U; i++) {
        TEST_ASSERT_EQUAL_HEX32(expected[i], word(i));
        sum += expected[i];
    }
    TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFFU - sum, word(31));
    TEST_ASSERT_EACH_EQUAL_HEX8(0U, &bytes[AIM32_FRAME_BYTES],
                                CARD_FRAME_BYTES - AIM32_FRAME_BYTES);
}

static void expect_off(uint32_t mode, uint32_t direction, uint32_t duty, uint32_t amplitude)
{
    encode(mode, direction, duty, amplitude);
    expect_words(0U, 0U, 0U, 0U);
}

static void make_report(void)
{
    (void)memset(bytes, 0, sizeof bytes);
    (void)memset(words, 0, sizeof words);
    words[0] = START;
    words[1] = 0x11U;
    words[2] = 0x00080000U;
    words[3] = 0xFFFFFFFEU;
    words[7] = 0x01020304U;
    words[8] = 0x05060708U;
    write_words();
}

static void expect_refused(card_frame_result_t expected)
{
    card_report_t report;
    card_report_t before;
    (void)memset(&report, 0x5A, sizeof report);
    before = report;
    TEST_ASSERT_EQUAL_INT(expected, aim32_frame_decode_report(bytes, &report));
    TEST_ASSERT_EQUAL_MEMORY(&before, &report, sizeof report);
}

void setUp(void)
{
    make_report();
}

void tearDown(void)
{
}

void test_SWR_NI_001_a_command_has_32_words_a_start_word_the_amplifier_and_a_sum(void)
{
    encode(CARD_DRIVE_OFF, 0U, 0U, 0U);
    expect_words(0U, 0U, 0U, 0U);
    const card_command_t idle = {.control = CARD_CONTROL_CLEAR_FAULT};
    aim32_frame_encode_command(&idle, bytes);
    TEST_ASSERT_EQUAL_HEX32(0U, word(14));
    TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFFU - START, word(31));
}

void test_SWR_NI_001_the_most_significant_byte_comes_first(void)
{
    const uint8_t start[4] = {0xFEU, 0xFEU, 0xFEU, 0x01U};
    encode(CARD_DRIVE_OFF, 0U, 0U, 0U);
    TEST_ASSERT_EQUAL_HEX8_ARRAY(start, bytes, 4U);
}

void test_SWR_NI_002_pwm_has_its_direction_in_bit_31(void)
{
    encode(CARD_DRIVE_PWM, 0U, 0x12345U, 0U);
    expect_words(0U, 0x80012345U, 0U, 0U);
    encode(CARD_DRIVE_PWM, 1U, 0x7FFFFFU, 0U);
    expect_words(0U, 0x007FFFFFU, 0U, 0U);
}

void test_SWR_NI_002_without_pwm_bit_30_says_run(void)
{
    encode(CARD_DRIVE_NON_PWM, 0U, 0U, 0U);
    expect_words(0U, 0xC0000000U, 0U, 0U);
    encode(CARD_DRIVE_NON_PWM, 1U, 0x1FFFFU, 0U);
    expect_words(0U, 0x4001FFFFU, 0U, 0U);
}

void test_SWR_NI_002_waves_have_tables_amplitude_and_one_frequency(void)
{
    const uint32_t fast = LIMIT_WAVE_FASTEST_WORD;
    const uint32_t slow = LIMIT_WAVE_SLOWEST_WORD;
    encode(CARD_DRIVE_HIGH_FREQUENCY, 0U, fast, 1U);
    expect_words(0x01000001U, fast, 0x00000001U, fast);
    encode(CARD_DRIVE_HIGH_FREQUENCY, 1U, slow, 255U);
    expect_words(0x000000FFU, slow, 0x010000FFU, slow);
}

void test_SWR_NI_002_a_drive_that_has_no_word_goes_out_as_off(void)
{
    expect_off(CARD_DRIVE_ANALOG, 0U, 100U, 0U);
    expect_off(5U, 0U, 100U, 0U);
    expect_off(CARD_DRIVE_PWM, 2U, 100U, 0U);
    expect_off(CARD_DRIVE_PWM, 0U, 0x800000U, 0U);
    expect_off(CARD_DRIVE_PWM, 0U, 100U, 1U);
    expect_off(CARD_DRIVE_NON_PWM, 0U, 0x40000000U, 0U);
    expect_off(CARD_DRIVE_HIGH_FREQUENCY, 2U, LIMIT_WAVE_SLOWEST_WORD, 1U);
    expect_off(CARD_DRIVE_HIGH_FREQUENCY, 0U, LIMIT_WAVE_FASTEST_WORD - 1U, 1U);
    expect_off(CARD_DRIVE_HIGH_FREQUENCY, 0U, LIMIT_WAVE_SLOWEST_WORD + 1U, 1U);
    expect_off(CARD_DRIVE_HIGH_FREQUENCY, 0U, LIMIT_WAVE_SLOWEST_WORD, 0U);
    expect_off(CARD_DRIVE_HIGH_FREQUENCY, 0U, LIMIT_WAVE_SLOWEST_WORD, 256U);
}

void test_SWR_NI_003_a_report_reports_state_switch_encoder_and_converters(void)
{
    card_report_t report = {.heartbeat = 77U, .motor_temperature_dc = 250};
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, aim32_frame_decode_report(bytes, &report));
    TEST_ASSERT_EQUAL_HEX32(0x11U, report.system_state);
    TEST_ASSERT_EQUAL_HEX32(0U, report.limits);
    TEST_ASSERT_EQUAL_INT32(-2, report.encoder_count);
    TEST_ASSERT_EQUAL_HEX32(0x01020304U, report.adc_words[0]);
    TEST_ASSERT_EQUAL_HEX32(0x05060708U, report.adc_words[1]);
    TEST_ASSERT_EQUAL_UINT32(77U, report.heartbeat);
    TEST_ASSERT_EQUAL_INT32(250, report.motor_temperature_dc);
}

void test_SWR_NI_003_the_switch_is_active_while_its_pair_is_low(void)
{
    card_report_t report = {.slot = 0U};
    words[2] = 0xFFF7FFFFU;
    words[3] = 5U;
    write_words();
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, aim32_frame_decode_report(bytes, &report));
    TEST_ASSERT_EQUAL_HEX32(CARD_LIMIT_LOWER, report.limits);
    TEST_ASSERT_EQUAL_HEX32(CARD_LIMIT_LOWER, report.limits_raw);
    TEST_ASSERT_EQUAL_INT32(5, report.encoder_count);
}

void test_SWR_NI_003_every_flipped_bit_is_refused(void)
{
    for (uint32_t bit = 0U; bit < (8U * AIM32_FRAME_BYTES); bit++) {
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
        expect_refused((bit < 32U) ? CARD_FRAME_BAD_START : CARD_FRAME_BAD_CRC);
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
    }
}

void test_SWR_NI_003_a_wire_that_stands_still_is_refused(void)
{
    (void)memset(bytes, 0, sizeof bytes);
    expect_refused(CARD_FRAME_BAD_START);
    (void)memset(bytes, 0xFF, sizeof bytes);
    expect_refused(CARD_FRAME_BAD_START);
}

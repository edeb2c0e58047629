/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the words of a drive have one meaning for each type of card; a value outside its
 * range, a contradiction, or a word of another drive is refused by name.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "unit/support/card_frame_world.inc"

#include <string.h>

void setUp(void)
{
    (void)memset(bytes, UNTOUCHED, sizeof bytes);
}

void tearDown(void)
{
}

static void expect_drive(uint32_t mode, uint32_t direction, uint32_t duty,
                         card_frame_result_t expected)
{
    card_command_t command = a_command();
    card_report_t report = a_report();

    command.drive = (card_drive_t){mode, direction, duty, 0U};
    card_frame_encode_command(&command, bytes);
    expect_command(expected);
    report.applied = command.drive;
    card_frame_encode_report(&report, bytes);
    expect_report(expected);
}

void test_SWR_CARD_003_a_drive_outside_its_range_is_named(void)
{
    expect_drive(CARD_DRIVE_PWM, 0U, 0U, CARD_FRAME_OK);
    expect_drive(CARD_DRIVE_PWM, 1U, 0x7FFFFFU, CARD_FRAME_OK);
    expect_drive(CARD_DRIVE_PWM, 2U, 0x7FFFFFU, CARD_FRAME_BAD_DRIVE);
    expect_drive(CARD_DRIVE_PWM, 256U, 0U, CARD_FRAME_BAD_DRIVE);
    expect_drive(CARD_DRIVE_PWM, 1U, 0x800000U, CARD_FRAME_BAD_DRIVE);
    expect_drive(CARD_DRIVE_NON_PWM, 1U, 0U, CARD_FRAME_OK);
    expect_drive(CARD_DRIVE_NON_PWM, 2U, 0U, CARD_FRAME_BAD_DRIVE);
    expect_drive(5U, 0U, 0U, CARD_FRAME_BAD_DRIVE);
    expect_drive(257U, 0U, 0U, CARD_FRAME_BAD_DRIVE);
}

void test_SWR_CARD_007_a_drive_without_pwm_has_a_magnitude_of_23_bits_or_none(void)
{
    expect_drive(CARD_DRIVE_NON_PWM, 0U, 0U, CARD_FRAME_OK);
    expect_drive(CARD_DRIVE_NON_PWM, 0U, 1U, CARD_FRAME_OK);
    expect_drive(CARD_DRIVE_NON_PWM, 1U, 0x7FFFFFU, CARD_FRAME_OK);
    expect_drive(CARD_DRIVE_NON_PWM, 1U, 0x800000U, CARD_FRAME_BAD_DRIVE);
    expect_drive(CARD_DRIVE_NON_PWM, 1U, 0x1000000U, CARD_FRAME_BAD_DRIVE);
    expect_drive(CARD_DRIVE_NON_PWM, 1U, UINT32_MAX, CARD_FRAME_BAD_DRIVE);
}

void test_SWR_CARD_007_the_magnitude_stands_where_that_of_pwm_stands(void)
{
    card_command_t command = a_command();
    card_report_t report = a_report();

    command.drive = (card_drive_t){CARD_DRIVE_NON_PWM, 1U, 0x7ABCDEU, 0U};
    card_frame_encode_command(&command, bytes);
    TEST_ASSERT_EQUAL_HEX32(0x02010000U, word(10U));
    TEST_ASSERT_EQUAL_HEX32(0x007ABCDEU, word(11U));
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_command(bytes, SLOT, &command));
    TEST_ASSERT_EQUAL_HEX32(0x7ABCDEU, command.drive.duty);
    report.applied = command.drive;
    card_frame_encode_report(&report, bytes);
    TEST_ASSERT_EQUAL_HEX32(0x217ABCDEU, word(24U));
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(bytes, SLOT, &report));
    TEST_ASSERT_EQUAL_HEX32(0x7ABCDEU, report.applied.duty);
}

#define WAVE 0x42B8DBB4U /* 50.862 kHz */

static card_drive_t a_wave(uint32_t direction)
{
    return (card_drive_t){CARD_DRIVE_HIGH_FREQUENCY, direction, WAVE, 0xA5U};
}

static void encode_wave_command(void)
{
    card_command_t command = a_command();

    command.drive = a_wave(1U);
    card_frame_encode_command(&command, bytes);
}

static void encode_wave_report(void)
{
    card_report_t report = a_report();

    report.applied = a_wave(1U);
    card_frame_encode_report(&report, bytes);
}

static void expect_waves(uint32_t first, uint32_t shape_1, uint32_t shape_2)
{
    TEST_ASSERT_EQUAL_HEX32(WAVE, word(first));
    TEST_ASSERT_EQUAL_HEX32(shape_1, word(first + 1U));
    TEST_ASSERT_EQUAL_HEX32(WAVE, word(first + 2U));
    TEST_ASSERT_EQUAL_HEX32(shape_2, word(first + 3U));
}

void test_SWR_DRIVE_001_both_waves_have_the_word_and_their_tables_the_direction(void)
{
    card_command_t command = a_command();
    card_report_t report = a_report();

    for (uint32_t direction = 0U; direction <= 1U; direction++) {
        const uint32_t leading = (direction == 0U) ? 0x010000A5U : 0x000000A5U;
        command.drive = a_wave(direction);
        card_frame_encode_command(&command, bytes);
        expect_waves(6U, leading, leading ^ 0x01000000U);
        TEST_ASSERT_EQUAL_HEX32(0x03000000U | (direction << 16U), word(10U));
        TEST_ASSERT_EQUAL_HEX32(0U, word(11U));
        TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_command(bytes, SLOT, &command));
        const card_drive_t sent = a_wave(direction);
        TEST_ASSERT_EQUAL_MEMORY(&sent, &command.drive, sizeof sent);
        report.applied = sent;
        card_frame_encode_report(&report, bytes);
        expect_waves(20U, leading, leading ^ 0x01000000U);
        TEST_ASSERT_EQUAL_HEX32(0x30000000U | (direction << 24U), word(24U));
        TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(bytes, SLOT, &report));
        TEST_ASSERT_EQUAL_MEMORY(&sent, &report.applied, sizeof sent);
    }
}

static void expect_wave(uint32_t duty, uint32_t amplitude, card_frame_result_t expected)
{
    card_command_t command = a_command();
    card_report_t report = a_report();

    command.drive = (card_drive_t){CARD_DRIVE_HIGH_FREQUENCY, 1U, duty, amplitude};
    card_frame_encode_command(&command, bytes);
    expect_command(expected);
    report.applied = command.drive;
    card_frame_encode_report(&report, bytes);
    expect_report(expected);
}

void test_SWR_DRIVE_001_a_wave_outside_its_range_is_refused(void)
{
    expect_wave(LIMIT_WAVE_FASTEST_WORD, 1U, CARD_FRAME_OK);
    expect_wave(LIMIT_WAVE_FASTEST_WORD - 1U, 1U, CARD_FRAME_BAD_DRIVE);
    expect_wave(LIMIT_WAVE_SLOWEST_WORD, 255U, CARD_FRAME_OK);
    expect_wave(LIMIT_WAVE_SLOWEST_WORD + 1U, 255U, CARD_FRAME_BAD_DRIVE);
    expect_wave(WAVE, 0U, CARD_FRAME_BAD_DRIVE);
    expect_wave(WAVE, 256U, CARD_FRAME_BAD_DRIVE);
    expect_wave(WAVE, 0x010000A5U, CARD_FRAME_BAD_DRIVE);
    expect_wave(WAVE, UINT32_MAX, CARD_FRAME_BAD_DRIVE);
    expect_wave(0U, 0U, CARD_FRAME_BAD_DRIVE);
}

/* Two waves that differ, or agree on another direction than the drive word. */
void test_SWR_DRIVE_001_a_wave_that_contradicts_the_other_is_refused(void)
{
    for (uint32_t i = 0U; i < 4U; i++) {
        for (uint32_t bit = 0U; bit < 32U; bit++) {
            encode_wave_command();
            set_word(6U + i, word(6U + i) ^ (1U << bit));
            sign_again();
            expect_command(CARD_FRAME_BAD_DRIVE);
            encode_wave_report();
            set_word(20U + i, word(20U + i) ^ (1U << bit));
            sign_again();
            expect_report(CARD_FRAME_BAD_DRIVE);
        }
    }
    encode_wave_command();
    set_word(10U, 0x03000000U);
    sign_again();
    expect_command(CARD_FRAME_BAD_DRIVE);
    encode_wave_command();
    set_word(11U, 1U);
    sign_again();
    expect_command(CARD_FRAME_BAD_DRIVE);
}

void test_SWR_DRIVE_002_the_first_converter_has_the_magnitude(void)
{
    card_command_t command = a_command();
    card_report_t report = a_report();
    const card_drive_t sent = {CARD_DRIVE_ANALOG, 1U, 0xABCDU, 0U};

    command.drive = sent;
    card_frame_encode_command(&command, bytes);
    TEST_ASSERT_EQUAL_HEX32(0x04010000U, word(10U));
    TEST_ASSERT_EQUAL_HEX32(0U, word(11U));
    TEST_ASSERT_EQUAL_HEX32(0xABCD0000U, word(12U));
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_command(bytes, SLOT, &command));
    TEST_ASSERT_EQUAL_MEMORY(&sent, &command.drive, sizeof sent);
    report.applied = sent;
    card_frame_encode_report(&report, bytes);
    TEST_ASSERT_EQUAL_HEX32(0x4100ABCDU, word(24U));
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(bytes, SLOT, &report));
    TEST_ASSERT_EQUAL_MEMORY(&sent, &report.applied, sizeof sent);
}

void test_SWR_DRIVE_002_a_magnitude_of_more_than_16_bits_is_refused(void)
{
    expect_drive(CARD_DRIVE_ANALOG, 0U, 0xFFFFU, CARD_FRAME_OK);
    expect_drive(CARD_DRIVE_ANALOG, 0U, 0U, CARD_FRAME_OK);
    expect_drive(CARD_DRIVE_ANALOG, 2U, 0U, CARD_FRAME_BAD_DRIVE);
    expect_drive(CARD_DRIVE_ANALOG, 0U, 0x10000U, CARD_FRAME_BAD_DRIVE);
    expect_drive(CARD_DRIVE_ANALOG, 0U, UINT32_MAX, CARD_FRAME_BAD_DRIVE);
}

void test_SWR_DRIVE_002_anything_else_beside_the_magnitude_is_refused(void)
{
    for (uint32_t i = 0U; i < 2U; i++) {
        card_command_t command = a_command();
        command.drive = (card_drive_t){CARD_DRIVE_ANALOG, 1U, 0xABCDU, 0U};
        card_frame_encode_command(&command, bytes);
        set_word(11U + i, word(11U + i) | 1U);
        sign_again();
        expect_command(CARD_FRAME_BAD_DRIVE);
    }
}

void test_SWR_DRIVE_003_words_of_another_drive_are_refused(void)
{
    for (uint32_t i = 0U; i < 4U; i++) {
        encode_command();
        set_word(6U + i, 1U);
        sign_again();
        expect_command(CARD_FRAME_BAD_CRC);
        encode_report();
        set_word(20U + i, 1U);
        sign_again();
        expect_report(CARD_FRAME_BAD_CRC);
    }
    encode_wave_command();
    set_word(12U, 0x00010000U);
    sign_again();
    expect_command(CARD_FRAME_BAD_CRC);
}

void test_SWR_DRIVE_001_each_type_of_card_has_its_drive(void)
{
    static const uint32_t modes[] = {CARD_DRIVE_OFF,
                                     CARD_DRIVE_PWM,
                                     CARD_DRIVE_NON_PWM,
                                     CARD_DRIVE_OFF,
                                     CARD_DRIVE_HIGH_FREQUENCY,
                                     CARD_DRIVE_ANALOG};

    for (uint32_t type = 0U; type < 6U; type++) {
        TEST_ASSERT_EQUAL_UINT32(modes[type], card_drive_mode_of(type));
    }
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, card_drive_mode_of(6U));
}

static void expect_drive_words(uint32_t mode_word, uint32_t duty_word)
{
    encode_command();
    set_word(10U, mode_word);
    set_word(11U, duty_word);
    sign_again();
    expect_command(CARD_FRAME_BAD_DRIVE);
}

void test_SWR_CARD_003_off_with_something_left_in_the_drive_words_is_named(void)
{
    expect_drive_words(0U, 1U);
    expect_drive_words(0x00010000U, 0U);
    expect_drive_words(0x01010001U, 0U);
}

void test_SWR_CARD_004_all_drive_words_are_zero_when_the_drive_is_off(void)
{
    card_command_t command = a_command();
    card_report_t report = a_report();

    command.drive = (card_drive_t){CARD_DRIVE_OFF, 1U, 0x1FFFFU, 0U};
    card_frame_encode_command(&command, bytes);
    for (uint32_t i = 6U; i <= 12U; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, word(i));
    }
    expect_command(CARD_FRAME_OK);
    report.applied = command.drive;
    card_frame_encode_report(&report, bytes);
    TEST_ASSERT_EQUAL_HEX32(0U, word(24U));
}

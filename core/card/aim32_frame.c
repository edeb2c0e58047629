/* SPDX-License-Identifier: Apache-2.0 */
#include "card/aim32_frame.h"

#include "card/frame_word.h"
#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <string.h>

/* Words of both directions. */
#define WORD_START 0U
#define WORD_SUM 31U

/* Words of a command. */
#define WORD_FIRST_SHAPE 2U
#define WORD_FIRST_WAVE 3U
#define WORD_SECOND_SHAPE 4U
#define WORD_SECOND_WAVE 5U
#define WORD_AMPLIFIER 14U

/* Words of a report. */
#define WORD_SYSTEM 1U
#define WORD_PAIRS 2U
#define WORD_ENCODER 3U
#define WORD_ADC 7U

/* Bit in the high half of the states: low while the switch is active. */
#define PAIR_SWITCH 0x00080000U

#define DOWNWARDS 0x80000000U
#define RUN 0x40000000U
#define TABLE 0x01000000U
#define LARGEST_DUTY 0x7FFFFFU
#define LARGEST_AMPLITUDE 0xFFU

/* Value that word 31 must have. */
static uint32_t sum_of(const uint8_t bytes[CARD_FRAME_BYTES])
{
    uint32_t sum = 0U;

    for (uint32_t i = WORD_START; i < WORD_SUM; i++) {
        sum += frame_word_get(bytes, i);
    }
    return ~sum;
}

static bool is_duty(const card_drive_t *drive)
{
    return (drive->direction <= 1U) && (drive->duty <= LARGEST_DUTY) && (drive->amplitude == 0U);
}

static bool is_wave(const card_drive_t *drive)
{
    return (drive->direction <= 1U) && (drive->duty >= LIMIT_WAVE_FASTEST_WORD) &&
           (drive->duty <= LIMIT_WAVE_SLOWEST_WORD) && (drive->amplitude >= 1U) &&
           (drive->amplitude <= LARGEST_AMPLITUDE);
}

/* The two tables decide the direction. */
static void put_waves(const card_drive_t *drive, uint8_t bytes[CARD_FRAME_BYTES])
{
    const bool is_upwards = drive->direction != 0U;

    frame_word_put(bytes, WORD_FIRST_SHAPE, (is_upwards ? 0U : TABLE) | drive->amplitude);
    frame_word_put(bytes, WORD_FIRST_WAVE, drive->duty);
    frame_word_put(bytes, WORD_SECOND_SHAPE, (is_upwards ? TABLE : 0U) | drive->amplitude);
    frame_word_put(bytes, WORD_SECOND_WAVE, drive->duty);
}

static void put_drive(const card_drive_t *drive, uint8_t bytes[CARD_FRAME_BYTES])
{
    const uint32_t direction = (drive->direction != 0U) ? 0U : DOWNWARDS;

    if ((drive->mode == (uint32_t)CARD_DRIVE_PWM) && is_duty(drive)) {
        frame_word_put(bytes, WORD_FIRST_WAVE, direction | drive->duty);
    } else if ((drive->mode == (uint32_t)CARD_DRIVE_NON_PWM) && is_duty(drive)) {
        frame_word_put(bytes, WORD_FIRST_WAVE, direction | RUN | drive->duty);
    } else if ((drive->mode == (uint32_t)CARD_DRIVE_HIGH_FREQUENCY) && is_wave(drive)) {
        put_waves(drive, bytes);
    } else {
        /* Off: all words are zero. */
    }
}

void aim32_frame_encode_command(const card_command_t *command, uint8_t bytes[CARD_FRAME_BYTES])
{
    (void)memset(bytes, 0, CARD_FRAME_BYTES);
    frame_word_put(bytes, WORD_START, CARD_FRAME_START);
    put_drive(&command->drive, bytes);
    frame_word_put(bytes, WORD_AMPLIFIER, command->control & CARD_CONTROL_AMPLIFIER);
    frame_word_put(bytes, WORD_SUM, sum_of(bytes));
}

card_frame_result_t aim32_frame_decode_report(const uint8_t bytes[CARD_FRAME_BYTES],
                                              card_report_t *report)
{
    if (frame_word_get(bytes, WORD_START) != CARD_FRAME_START) {
        return CARD_FRAME_BAD_START;
    }
    if (frame_word_get(bytes, WORD_SUM) != sum_of(bytes)) {
        return CARD_FRAME_BAD_CRC;
    }
    const bool is_switch_open = (frame_word_get(bytes, WORD_PAIRS) & PAIR_SWITCH) != 0U;
    report->system_state = frame_word_get(bytes, WORD_SYSTEM);
    report->limits = CARD_LIMIT_LOWER;
    if (is_switch_open) {
        report->limits = 0U;
    }
    report->limits_raw = report->limits;
    report->encoder_count = frame_word_signed(frame_word_get(bytes, WORD_ENCODER));
    report->adc_words[0] = frame_word_get(bytes, WORD_ADC);
    report->adc_words[1] = frame_word_get(bytes, WORD_ADC + 1U);
    return CARD_FRAME_OK;
}

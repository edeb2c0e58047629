/* SPDX-License-Identifier: Apache-2.0 */
/* Frames of any bytes and of any values; the checksum is a contract. */
#include "prove.h"

#include "card/card_frame.h"
#include "card/card_words.h"
#include "limits/requirement_limits.h"

static uint32_t word(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t index)
{
    return ((uint32_t)bytes[index * 4U] << 24U) | ((uint32_t)bytes[(index * 4U) + 1U] << 16U) |
           ((uint32_t)bytes[(index * 4U) + 2U] << 8U) | (uint32_t)bytes[(index * 4U) + 3U];
}

void prove_SWR_CARD_004_a_frame_whose_drive_is_off_has_no_drive_word(void)
{
    card_command_t command;
    uint8_t bytes[CARD_FRAME_BYTES];
    uint32_t index;

    card_frame_encode_command(&command, bytes);

    assume((index >= CARD_COMMAND_WAVES) && (index < CARD_COMMAND_WATCHDOG));
    const bool is_off = command.drive.mode == (uint32_t)CARD_DRIVE_OFF;
    PROVE(IMPLIES(is_off, word(bytes, index) == 0U), "SWR-CARD-004: off means zero words");
    PROVE(word(bytes, CARD_COMMAND_COMPLEMENT) == ~word(bytes, CARD_COMMAND_CONTROL),
          "SWR-CARD-004: the complement of the control word");
    PROVE(IMPLIES(!is_off && (command.drive.mode <= 255U),
                  (word(bytes, CARD_COMMAND_MODE) >> 24U) == command.drive.mode),
          "SWR-CARD-001: the mode of a drive");
    POSSIBLE(!is_off && (word(bytes, index) != 0U), "a drive word");
}

/* What a drive of its mode may hold. */
static bool is_drive(const card_drive_t *drive)
{
    const bool is_off = drive->mode == (uint32_t)CARD_DRIVE_OFF;
    const bool is_plain =
        (drive->mode == (uint32_t)CARD_DRIVE_PWM) || (drive->mode == (uint32_t)CARD_DRIVE_NON_PWM);
    const bool is_wave = drive->mode == (uint32_t)CARD_DRIVE_HIGH_FREQUENCY;
    const bool is_analog = drive->mode == (uint32_t)CARD_DRIVE_ANALOG;
    const bool has_wave = (drive->duty >= LIMIT_WAVE_FASTEST_WORD) &&
                          (drive->duty <= LIMIT_WAVE_SLOWEST_WORD) && (drive->amplitude >= 1U) &&
                          (drive->amplitude <= 255U);
    return (is_off && ((drive->direction | drive->duty | drive->amplitude) == 0U)) ||
           ((drive->direction <= 1U) &&
            ((is_plain && (drive->duty <= 0x7FFFFFU) && (drive->amplitude == 0U)) ||
             (is_wave && has_wave) ||
             (is_analog && (drive->duty <= 0xFFFFU) && (drive->amplitude == 0U))));
}

void prove_SWR_CARD_003_a_command_of_any_bytes_is_refused_or_a_drive_that_there_is(void)
{
    uint8_t bytes[CARD_FRAME_BYTES];
    uint32_t slot;
    uint32_t at;
    card_command_t command;
    const card_command_t before = command;
    assume(at < sizeof command);

    const card_frame_result_t result = card_frame_decode_command(bytes, slot, &command);

    PROVE(IMPLIES(result != CARD_FRAME_OK,
                  ((const uint8_t *)&before)[at] == ((const uint8_t *)&command)[at]),
          "SWR-CARD-003: a refused frame changes nothing");
    PROVE(IMPLIES(result == CARD_FRAME_OK, is_drive(&command.drive)),
          "SWR-CARD-003: a drive that there is");
    PROVE(IMPLIES(result == CARD_FRAME_OK,
                  (word(bytes, CARD_BOTH_START) == CARD_FRAME_START) && (command.slot == slot)),
          "SWR-CARD-003: start word and slot");
    PROVE(IMPLIES(result == CARD_FRAME_OK,
                  word(bytes, CARD_COMMAND_COMPLEMENT) == ~word(bytes, CARD_COMMAND_CONTROL)),
          "SWR-CARD-003: the complement");
    PROVE(IMPLIES((result == CARD_FRAME_OK) && (command.drive.mode == (uint32_t)CARD_DRIVE_OFF),
                  (word(bytes, CARD_COMMAND_MODE) | word(bytes, CARD_COMMAND_DUTY) |
                   word(bytes, CARD_COMMAND_CONVERTERS) | word(bytes, CARD_COMMAND_WAVES)) == 0U),
          "SWR-CARD-003: a drive is off only where no word says otherwise");
    POSSIBLE((result == CARD_FRAME_OK) && (command.drive.mode != (uint32_t)CARD_DRIVE_OFF),
             "a drive");
}

void prove_SWR_CARD_006_a_report_of_any_bytes_is_refused_or_says_a_drive_that_there_is(void)
{
    uint8_t bytes[CARD_FRAME_BYTES];
    uint32_t slot;
    uint32_t reserved;
    uint32_t at;
    card_report_t report;
    const card_report_t before = report;
    assume(at < sizeof report);

    const card_frame_result_t result = card_frame_decode_report(bytes, slot, &report);

    assume((reserved > CARD_REPORT_UPTIME) && (reserved < CARD_BOTH_LEGACY_SUM));
    PROVE(IMPLIES(result != CARD_FRAME_OK,
                  ((const uint8_t *)&before)[at] == ((const uint8_t *)&report)[at]),
          "SWR-CARD-003: a refused frame changes nothing");
    PROVE(IMPLIES(result == CARD_FRAME_OK, is_drive(&report.applied)),
          "SWR-CARD-003: a drive that there is");
    PROVE(IMPLIES(result == CARD_FRAME_OK, word(bytes, reserved) == 0U),
          "SWR-CARD-006: words without a field are zero");
    POSSIBLE(result == CARD_FRAME_OK, "a report");
}

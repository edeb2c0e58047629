/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/data/frame_fields.h"

#define SIZE(structure, name) sizeof(((structure *)0)->name)
#define FIELD(structure, field, is, says)                                                          \
    {                                                                                              \
#field, offsetof(structure, field), SIZE(structure, field), SIZE(structure, field), NULL,  \
            is, NULL, says                                                                         \
    }

const char *frame_drive_word(int32_t value)
{
    static const char *const words[] = {[CARD_DRIVE_OFF] = "OFF",
                                        [CARD_DRIVE_PWM] = "PWM",
                                        [CARD_DRIVE_NON_PWM] = "NON_PWM",
                                        [CARD_DRIVE_HIGH_FREQUENCY] = "HIGH_FREQUENCY",
                                        [CARD_DRIVE_ANALOG] = "ANALOG"};

    return ((value >= 0) && (value <= (int32_t)CARD_DRIVE_ANALOG)) ? words[value] : "UNKNOWN";
}

static const field_t fields_card_drive[] = {
    {"mode", offsetof(card_drive_t, mode), SIZE(card_drive_t, mode), SIZE(card_drive_t, mode), NULL,
     FIELD_WORD, frame_drive_word, "What the card is asked to do with its motor."},
    FIELD(card_drive_t, direction, FIELD_UNSIGNED, "0 or 1; the meaning is the robot's."),
    FIELD(card_drive_t, duty, FIELD_UNSIGNED, "The drive word."),
    FIELD(card_drive_t, amplitude, FIELD_UNSIGNED, "High frequency: of both waves."),
    {.element_size = 1U},
};

const field_t fields_card_command[] = {
    FIELD(card_command_t, sequence, FIELD_UNSIGNED, "Grows by one each exchange."),
    FIELD(card_command_t, time_us, FIELD_UNSIGNED, "Controller time, wraps."),
    FIELD(card_command_t, system_state, FIELD_UNSIGNED, "CARD_SYSTEM_ bits, mode in bits 8..15."),
    FIELD(card_command_t, control, FIELD_UNSIGNED, "CARD_CONTROL_ bits."),
    {"drive", offsetof(card_command_t, drive), SIZE(card_command_t, drive),
     SIZE(card_command_t, drive), fields_card_drive, FIELD_INSIDE, NULL, ""},
    FIELD(card_command_t, watchdog_us, FIELD_UNSIGNED,
          "The card switches its drive off after this time without a valid frame."),
    FIELD(card_command_t, overspeed_ticks_per_s, FIELD_UNSIGNED, "Faster, it switches off."),
    FIELD(card_command_t, guard_minimum_ticks, FIELD_SIGNED,
          "Raw encoder count below which the card switches off."),
    FIELD(card_command_t, guard_maximum_ticks, FIELD_SIGNED,
          "Raw encoder count above which the card switches off."),
    FIELD(card_command_t, axis_id, FIELD_UNSIGNED, "4294967295: the card has no axis."),
    {.element_size = 1U},
};

/* SPDX-License-Identifier: Apache-2.0 */
#include "card/card_frame.h"

#include "base/clear.h"
#include "base/crc.h"
#include "card/card_words.h"
#include "card/frame_word.h"
#include "limits/requirement_limits.h"

#include <string.h>

#define HEAD_BYTES 8U /* Start word and header. */

#define TYPE_COMMAND 1U
#define TYPE_REPORT 2U

#define LARGEST_4_BIT 0xFU
#define LARGEST_8_BIT 0xFFU
#define LARGEST_16_BIT 0xFFFFU
#define LARGEST_24_BIT 0xFFFFFFU
/* One bit less than a report has for it: a report shows a larger one as too large. */
#define LARGEST_DUTY 0x7FFFFFU
#define WAVE_WORDS 4U
#define DRIVE_MODES 5U

/* Saturating keeps a value that does not fit out of range, where a mask could make it valid. */
static uint32_t fit(uint32_t value, uint32_t largest)
{
    return (value < largest) ? value : largest;
}

static uint32_t fit_int16(int32_t value)
{
    int32_t fitted = value;

    if (fitted > INT16_MAX) {
        fitted = INT16_MAX;
    }
    if (fitted < INT16_MIN) {
        fitted = INT16_MIN;
    }
    return (uint32_t)fitted & LARGEST_16_BIT;
}

static int32_t from_int16(uint32_t half)
{
    const uint32_t sign = 0x8000U;

    return frame_word_signed((half ^ sign) - sign);
}

static uint32_t header_word(uint32_t slot, uint32_t type)
{
    const uint32_t protocol = CARD_FRAME_PROTOCOL;
    const uint32_t length_words = CARD_FRAME_WORDS;

    return (protocol << 24U) | (fit(slot, LARGEST_8_BIT) << 16U) | (length_words << 8U) | type;
}

/* Its bits in the order of the processor: enough where only zero is asked for. */
static inline uint32_t bits_of(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t index)
{
    uint32_t bits;

    (void)memcpy((uint8_t *)&bits, &bytes[index * 4U], sizeof bits);
    return bits;
}

/* A word from `first` to before `end` is not zero. Four at a time, and without a branch for each:
 * half of the instructions. */
static inline bool has_bits(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t first, uint32_t end)
{
    uint32_t bits = 0U;
    uint32_t index = first;

    for (; (index + 4U) <= end; index += 4U) {
        bits |= bits_of(bytes, index) | bits_of(bytes, index + 1U) | bits_of(bytes, index + 2U) |
                bits_of(bytes, index + 3U);
    }
    for (; index < end; index++) {
        bits |= bits_of(bytes, index);
    }
    return bits != 0U;
}

/* Start of the checksum of a direction: that of the first two words, by slot. */
static const uint32_t command_heads[CARD_SLOT_COUNT] = {
    0x79B02BB9U, 0xDCF1B9C7U, 0x36DF79B4U, 0x939EEBCAU, 0xE76E8FA3U,
    0x422F1DDDU, 0xA801DDAEU, 0x0D404FD0U, 0x41E1157CU, 0xE4A08702U};
static const uint32_t report_heads[CARD_SLOT_COUNT] = {
    0x6AE0D84DU, 0xCFA14A33U, 0x258F8A40U, 0x80CE183EU, 0xF43E7C57U,
    0x517FEE29U, 0xBB512E5AU, 0x1E10BC24U, 0x52B1E688U, 0xF7F074F6U};

static inline uint32_t two_words(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t first)
{
    return frame_word_get(bytes, first) + frame_word_get(bytes, first + 1U);
}

static inline uint32_t four_words(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t first)
{
    return two_words(bytes, first) + two_words(bytes, first + 2U);
}

/* The sum of a frame whose reserved words are zero: that of all other words. */
static uint32_t command_sum(const uint8_t bytes[CARD_FRAME_BYTES])
{
    return four_words(bytes, CARD_BOTH_START) + four_words(bytes, CARD_COMMAND_SYSTEM) +
           four_words(bytes, CARD_COMMAND_WAVES + 2U) + four_words(bytes, CARD_COMMAND_CONVERTERS) +
           two_words(bytes, CARD_COMMAND_GUARD_MAXIMUM) +
           frame_word_get(bytes, CARD_COMMAND_COMPLEMENT);
}

/* Without the words of waves. */
static uint32_t report_sum(const uint8_t bytes[CARD_FRAME_BYTES])
{
    return four_words(bytes, CARD_BOTH_START) + four_words(bytes, CARD_REPORT_TIME) +
           two_words(bytes, CARD_REPORT_LIMITS) + four_words(bytes, CARD_REPORT_LAST_EDGE) +
           two_words(bytes, CARD_REPORT_ADC + 1U) + frame_word_get(bytes, CARD_REPORT_SUPPLY) +
           four_words(bytes, CARD_REPORT_APPLIED) + frame_word_get(bytes, CARD_REPORT_UPTIME);
}

/* Words of a command that are zero while its drive is off. */
static inline bool is_command_quiet(const uint8_t bytes[CARD_FRAME_BYTES])
{
    return !has_bits(bytes, CARD_COMMAND_WAVES, CARD_COMMAND_WATCHDOG);
}

/* Words of a report that are zero while its drive is off and no command was lost. */
static inline bool is_report_quiet(const uint8_t bytes[CARD_FRAME_BYTES])
{
    return !has_bits(bytes, CARD_REPORT_WAVES, CARD_REPORT_TRIPS);
}

/* CRC of a frame with the start word and a header of its direction, whose reserved words are zero,
 * and whose quiet words are if it `is_quiet`. */
static inline uint32_t crc_of(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t type, bool is_quiet)
{
    const uint32_t slot = bytes[(CARD_BOTH_HEADER * 4U) + 1U];
    const bool is_command = type == TYPE_COMMAND;
    const uint32_t *const heads = is_command ? command_heads : report_heads;
    const uint32_t head = (slot < CARD_SLOT_COUNT) ? heads[slot] : crc32c(bytes, HEAD_BYTES);
    const uint8_t *const rest = &bytes[HEAD_BYTES];

    if (is_command) {
        return is_quiet ? crc32c_over_28_and_172(head, rest) : crc32c_over_172(head, rest);
    }
    return is_quiet ? crc32c_over_28_and_132(head, rest) : crc32c_over_132(head, rest);
}

static bool has_command_reserved_bits(const uint8_t bytes[CARD_FRAME_BYTES])
{
    return has_bits(bytes, CARD_COMMAND_AXIS + 1U, CARD_COMMAND_COMPLEMENT);
}

static bool has_report_reserved_bits(const uint8_t bytes[CARD_FRAME_BYTES])
{
    return has_bits(bytes, CARD_REPORT_STATUS + 1U, CARD_REPORT_LIMITS) ||
           has_bits(bytes, CARD_REPORT_ENCODER + 1U, CARD_REPORT_LAST_EDGE) ||
           has_bits(bytes, CARD_REPORT_UPTIME + 1U, CARD_BOTH_LEGACY_SUM);
}

/* A frame that is being written; its sum is that of the words so far. */
typedef struct {
    uint8_t *bytes;
    uint32_t sum;
} writer_t;

static inline void clear(uint8_t bytes[CARD_FRAME_BYTES], uint32_t first, uint32_t end)
{
    clear_words(&bytes[first * 4U], (end - first) * 4U);
}

static inline void write_word(writer_t *self, uint32_t index, uint32_t word)
{
    frame_word_put(self->bytes, index, word);
    self->sum += word;
}

static inline writer_t begin(uint8_t bytes[CARD_FRAME_BYTES], uint32_t slot, uint32_t type)
{
    writer_t writer = {.bytes = bytes, .sum = 0U};

    write_word(&writer, CARD_BOTH_START, CARD_FRAME_START);
    write_word(&writer, CARD_BOTH_HEADER, header_word(slot, type));
    return writer;
}

static inline void seal(const writer_t *self, uint32_t type, bool is_quiet)
{
    frame_word_put(self->bytes, CARD_BOTH_LEGACY_SUM, ~self->sum);
    frame_word_put(self->bytes, CARD_BOTH_CRC, crc_of(self->bytes, type, is_quiet));
}

/* View of the bytes by the layout of a direction, whatever they hold. */
typedef struct {
    uint32_t type;
    bool has_reserved_bits;
    bool is_quiet;
    uint32_t sum;
} frame_view_t;

static inline card_frame_result_t check_frame(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t slot,
                                              const frame_view_t *view)
{
    const uint32_t slot_mask = 0x00FF0000U;
    const uint32_t header = frame_word_get(bytes, CARD_BOTH_HEADER);
    const uint32_t expected = header_word(slot, view->type);

    if (frame_word_get(bytes, CARD_BOTH_START) != CARD_FRAME_START) {
        return CARD_FRAME_BAD_START;
    }
    if ((header | slot_mask) != (expected | slot_mask)) {
        return CARD_FRAME_BAD_START;
    }
    if (view->has_reserved_bits || (frame_word_get(bytes, CARD_BOTH_LEGACY_SUM) != ~view->sum)) {
        return CARD_FRAME_BAD_CRC;
    }
    if (frame_word_get(bytes, CARD_BOTH_CRC) != crc_of(bytes, view->type, view->is_quiet)) {
        return CARD_FRAME_BAD_CRC;
    }
    if (header != expected) {
        return CARD_FRAME_BAD_SLOT;
    }
    return CARD_FRAME_OK;
}

static bool is_drive_off(const card_drive_t *drive)
{
    return drive->mode == (uint32_t)CARD_DRIVE_OFF;
}

/* Ranges of the drives of a mode. */
typedef struct {
    uint32_t least_duty;
    uint32_t most_duty;
    uint32_t least_amplitude;
    uint32_t most_amplitude;
} drive_range_t;

static inline bool is_drive_valid(const card_drive_t *drive)
{
    static const drive_range_t ranges[DRIVE_MODES] = {
        [CARD_DRIVE_PWM] = {0U, LARGEST_DUTY, 0U, 0U},
        [CARD_DRIVE_NON_PWM] = {0U, LARGEST_DUTY, 0U, 0U},
        [CARD_DRIVE_HIGH_FREQUENCY] = {LIMIT_WAVE_FASTEST_WORD, LIMIT_WAVE_SLOWEST_WORD, 1U,
                                       LARGEST_8_BIT},
        [CARD_DRIVE_ANALOG] = {0U, LARGEST_16_BIT, 0U, 0U},
    };
    if (is_drive_off(drive)) {
        return (drive->direction | drive->duty | drive->amplitude) == 0U;
    }
    if (drive->mode >= DRIVE_MODES) {
        return false;
    }
    const drive_range_t *const range = &ranges[drive->mode];
    return (drive->direction <= 1U) && (drive->duty >= range->least_duty) &&
           (drive->duty <= range->most_duty) && (drive->amplitude >= range->least_amplitude) &&
           (drive->amplitude <= range->most_amplitude);
}

static inline bool has_waves(const card_drive_t *drive)
{
    return drive->mode == (uint32_t)CARD_DRIVE_HIGH_FREQUENCY;
}

/* Table and amplitude of a wave. The two tables decide the direction; the phases between their bits
 * stay zero, so that an amplitude of more than 8 bits is no valid word. */
static uint32_t wave_shape(bool is_leading, uint32_t amplitude)
{
    return (is_leading ? ((uint32_t)1U << 24U) : 0U) | fit(amplitude, LARGEST_16_BIT);
}

static void write_waves(writer_t *writer, uint32_t first, const card_drive_t *drive)
{
    const bool is_upwards = drive->direction != 0U;

    write_word(writer, first, drive->duty);
    write_word(writer, first + 1U, wave_shape(!is_upwards, drive->amplitude));
    write_word(writer, first + 2U, drive->duty);
    write_word(writer, first + 3U, wave_shape(is_upwards, drive->amplitude));
}

/* Takes duty and amplitude of the first wave; the other must be its counterpart. */
static bool read_waves(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t first, card_drive_t *drive)
{
    const uint32_t shape = frame_word_get(bytes, first + 1U);
    const bool is_upwards = drive->direction != 0U;
    const bool has_other_duty = drive->duty != 0U;

    drive->duty = frame_word_get(bytes, first);
    drive->amplitude = shape & LARGEST_16_BIT;
    return !has_other_duty && (shape == wave_shape(!is_upwards, drive->amplitude)) &&
           (frame_word_get(bytes, first + 2U) == drive->duty) &&
           (frame_word_get(bytes, first + 3U) == wave_shape(is_upwards, drive->amplitude));
}

static void write_command_drive(writer_t *writer, const card_drive_t *drive)
{
    write_word(writer, CARD_COMMAND_MODE,
               (fit(drive->mode, LARGEST_8_BIT) << 24U) |
                   (fit(drive->direction, LARGEST_8_BIT) << 16U));
    if (has_waves(drive)) {
        write_waves(writer, CARD_COMMAND_WAVES, drive);
    } else if (drive->mode == (uint32_t)CARD_DRIVE_ANALOG) {
        /* Our own layout: the first converter has the magnitude. One of more than 16 bits stands in
         * the word of the others, where it is refused. */
        const bool fits = drive->duty <= LARGEST_16_BIT;
        write_word(writer, fits ? CARD_COMMAND_CONVERTERS : CARD_COMMAND_DUTY,
                   fits ? (drive->duty << 16U) : drive->duty);
    } else {
        write_word(writer, CARD_COMMAND_DUTY, drive->duty);
    }
}

void card_frame_write_command(const card_command_t *command, uint8_t bytes[CARD_FRAME_BYTES])
{
    const bool is_off = is_drive_off(&command->drive);
    writer_t writer = begin(bytes, command->slot, TYPE_COMMAND);

    write_word(&writer, CARD_COMMAND_SEQUENCE, command->sequence);
    write_word(&writer, CARD_COMMAND_TIME, command->time_us);
    write_word(&writer, CARD_COMMAND_SYSTEM, command->system_state);
    write_word(&writer, CARD_COMMAND_CONTROL, command->control);
    if (!is_off) {
        write_command_drive(&writer, &command->drive);
    }
    write_word(&writer, CARD_COMMAND_WATCHDOG, command->watchdog_us);
    write_word(&writer, CARD_COMMAND_OVERSPEED, command->overspeed_ticks_per_s);
    write_word(&writer, CARD_COMMAND_GUARD_MINIMUM, (uint32_t)command->guard_minimum_ticks);
    write_word(&writer, CARD_COMMAND_GUARD_MAXIMUM, (uint32_t)command->guard_maximum_ticks);
    write_word(&writer, CARD_COMMAND_AXIS, command->axis_id);
    write_word(&writer, CARD_COMMAND_COMPLEMENT, ~command->control);
    seal(&writer, TYPE_COMMAND, is_off);
}

void card_frame_encode_command(const card_command_t *command, uint8_t bytes[CARD_FRAME_BYTES])
{
    clear(bytes, CARD_BOTH_START, CARD_FRAME_WORDS);
    card_frame_write_command(command, bytes);
}

/* Mode, direction and duty share one word here: 4, 4 and 24 bits. Waves have words of their own. */
static uint32_t applied_word(const card_drive_t *drive)
{
    uint32_t word = 0U;

    if (!is_drive_off(drive)) {
        const uint32_t duty = has_waves(drive) ? 0U : fit(drive->duty, LARGEST_24_BIT);
        word = (fit(drive->mode, LARGEST_4_BIT) << 28U) |
               (fit(drive->direction, LARGEST_4_BIT) << 24U) | duty;
    }
    return word;
}

void card_frame_encode_report(const card_report_t *report, uint8_t bytes[CARD_FRAME_BYTES])
{
    writer_t writer = begin(bytes, report->slot, TYPE_REPORT);

    clear(bytes, CARD_REPORT_STATUS + 1U, CARD_BOTH_LEGACY_SUM);
    write_word(&writer, CARD_REPORT_ACCEPTED, report->accepted_sequence);
    write_word(&writer, CARD_REPORT_HEARTBEAT, report->heartbeat);
    write_word(&writer, CARD_REPORT_TIME, report->time_us);
    write_word(&writer, CARD_REPORT_IDENTITY,
               (fit(report->card_type, LARGEST_8_BIT) << 24U) |
                   fit(report->firmware, LARGEST_24_BIT));
    write_word(&writer, CARD_REPORT_SYSTEM, report->system_state);
    write_word(&writer, CARD_REPORT_STATUS, report->status);
    write_word(&writer, CARD_REPORT_LIMITS,
               (fit(report->limits, LARGEST_8_BIT) << 8U) | fit(report->limits_raw, LARGEST_8_BIT));
    write_word(&writer, CARD_REPORT_ENCODER, (uint32_t)report->encoder_count);
    write_word(&writer, CARD_REPORT_LAST_EDGE, report->last_edge_us);
    write_word(&writer, CARD_REPORT_FOURTH_EDGE, report->fourth_edge_us);
    write_word(&writer, CARD_REPORT_EDGES,
               (fit(report->edges, LARGEST_16_BIT) << 16U) |
                   fit(report->illegal_edges, LARGEST_16_BIT));
    write_word(&writer, CARD_REPORT_ADC, report->adc_words[0]);
    write_word(&writer, CARD_REPORT_ADC + 1U, report->adc_words[1]);
    write_word(&writer, CARD_REPORT_TEMPERATURES,
               (fit_int16(report->driver_temperature_dc) << 16U) |
                   fit_int16(report->motor_temperature_dc));
    write_word(&writer, CARD_REPORT_SUPPLY,
               (fit(report->supply_mv, LARGEST_16_BIT) << 16U) |
                   fit(report->current_ma, LARGEST_16_BIT));
    if (has_waves(&report->applied)) {
        write_waves(&writer, CARD_REPORT_WAVES, &report->applied);
    }
    write_word(&writer, CARD_REPORT_APPLIED, applied_word(&report->applied));
    write_word(&writer, CARD_REPORT_CRC_ERRORS, report->rx_crc_errors);
    write_word(&writer, CARD_REPORT_GAPS, report->sequence_gaps);
    write_word(&writer, CARD_REPORT_TRIPS, report->watchdog_trips);
    write_word(&writer, CARD_REPORT_UPTIME, report->uptime_s);
    seal(&writer, TYPE_REPORT, is_report_quiet(bytes));
}

/* The words of a command that only some drives have. */
static card_frame_result_t read_command_drive(const uint8_t bytes[CARD_FRAME_BYTES],
                                              card_drive_t *drive)
{
    const uint32_t word = frame_word_get(bytes, CARD_COMMAND_MODE);
    const uint32_t converters = frame_word_get(bytes, CARD_COMMAND_CONVERTERS);
    const bool is_analog = (word >> 24U) == (uint32_t)CARD_DRIVE_ANALOG;
    bool is_whole = true;

    /* The 16 low bits count as direction: a drive word with anything unknown set is refused. */
    *drive = (card_drive_t){.mode = word >> 24U,
                            .direction =
                                ((word >> 16U) & LARGEST_8_BIT) | ((word & LARGEST_16_BIT) << 8U),
                            .duty = frame_word_get(bytes, CARD_COMMAND_DUTY)};
    if (has_waves(drive)) {
        is_whole = read_waves(bytes, CARD_COMMAND_WAVES, drive);
    } else if (has_bits(bytes, CARD_COMMAND_WAVES, CARD_COMMAND_WAVES + WAVE_WORDS)) {
        return CARD_FRAME_BAD_CRC;
    } else {
        /* It has no waves. */
    }
    if (is_analog) {
        is_whole = (drive->duty == 0U) && ((converters & LARGEST_16_BIT) == 0U);
        drive->duty = converters >> 16U;
    } else if (converters != 0U) {
        return CARD_FRAME_BAD_CRC;
    } else {
        /* It has no converter. */
    }
    return (is_whole && is_drive_valid(drive)) ? CARD_FRAME_OK : CARD_FRAME_BAD_DRIVE;
}

card_frame_result_t card_frame_decode_command(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t slot,
                                              card_command_t *command)
{
    const frame_view_t view = {TYPE_COMMAND, has_command_reserved_bits(bytes),
                               is_command_quiet(bytes), command_sum(bytes)};
    const card_frame_result_t result = check_frame(bytes, slot, &view);
    const uint32_t control = frame_word_get(bytes, CARD_COMMAND_CONTROL);
    card_drive_t drive;
    const card_frame_result_t drive_result = read_command_drive(bytes, &drive);

    if (result != CARD_FRAME_OK) {
        return result;
    }
    if (frame_word_get(bytes, CARD_COMMAND_COMPLEMENT) != ~control) {
        return CARD_FRAME_BAD_COMPLEMENT;
    }
    if (drive_result != CARD_FRAME_OK) {
        return drive_result;
    }
    command->slot = slot;
    command->sequence = frame_word_get(bytes, CARD_COMMAND_SEQUENCE);
    command->time_us = frame_word_get(bytes, CARD_COMMAND_TIME);
    command->system_state = frame_word_get(bytes, CARD_COMMAND_SYSTEM);
    command->control = control;
    command->drive = drive;
    command->watchdog_us = frame_word_get(bytes, CARD_COMMAND_WATCHDOG);
    command->overspeed_ticks_per_s = frame_word_get(bytes, CARD_COMMAND_OVERSPEED);
    command->guard_minimum_ticks =
        frame_word_signed(frame_word_get(bytes, CARD_COMMAND_GUARD_MINIMUM));
    command->guard_maximum_ticks =
        frame_word_signed(frame_word_get(bytes, CARD_COMMAND_GUARD_MAXIMUM));
    command->axis_id = frame_word_get(bytes, CARD_COMMAND_AXIS);
    return CARD_FRAME_OK;
}

/* `has_words`: those of waves are not all zero. */
static inline card_frame_result_t read_applied(const uint8_t bytes[CARD_FRAME_BYTES],
                                               bool has_words, card_drive_t *drive)
{
    const uint32_t word = frame_word_get(bytes, CARD_REPORT_APPLIED);
    bool is_whole = true;

    *drive = (card_drive_t){.mode = word >> 28U,
                            .direction = (word >> 24U) & LARGEST_4_BIT,
                            .duty = word & LARGEST_24_BIT};
    if (has_waves(drive)) {
        is_whole = read_waves(bytes, CARD_REPORT_WAVES, drive);
    } else if (has_words) {
        return CARD_FRAME_BAD_CRC;
    } else {
        /* It has no waves. */
    }
    return (is_whole && is_drive_valid(drive)) ? CARD_FRAME_OK : CARD_FRAME_BAD_DRIVE;
}

static void read_counts(const uint8_t bytes[CARD_FRAME_BYTES], card_report_t *report)
{
    const uint32_t limits = frame_word_get(bytes, CARD_REPORT_LIMITS);
    const uint32_t edges = frame_word_get(bytes, CARD_REPORT_EDGES);

    report->limits_raw = limits & LARGEST_8_BIT;
    report->limits = (limits >> 8U) & LARGEST_8_BIT;
    report->encoder_count = frame_word_signed(frame_word_get(bytes, CARD_REPORT_ENCODER));
    report->last_edge_us = frame_word_get(bytes, CARD_REPORT_LAST_EDGE);
    report->fourth_edge_us = frame_word_get(bytes, CARD_REPORT_FOURTH_EDGE);
    report->edges = edges >> 16U;
    report->illegal_edges = edges & LARGEST_16_BIT;
}

static void read_health(const uint8_t bytes[CARD_FRAME_BYTES], card_report_t *report)
{
    const uint32_t temperatures = frame_word_get(bytes, CARD_REPORT_TEMPERATURES);
    const uint32_t supply = frame_word_get(bytes, CARD_REPORT_SUPPLY);

    report->driver_temperature_dc = from_int16(temperatures >> 16U);
    report->motor_temperature_dc = from_int16(temperatures & LARGEST_16_BIT);
    report->supply_mv = supply >> 16U;
    report->current_ma = supply & LARGEST_16_BIT;
    report->adc_words[0] = frame_word_get(bytes, CARD_REPORT_ADC);
    report->adc_words[1] = frame_word_get(bytes, CARD_REPORT_ADC + 1U);
    report->rx_crc_errors = frame_word_get(bytes, CARD_REPORT_CRC_ERRORS);
    report->sequence_gaps = frame_word_get(bytes, CARD_REPORT_GAPS);
    report->watchdog_trips = frame_word_get(bytes, CARD_REPORT_TRIPS);
    report->uptime_s = frame_word_get(bytes, CARD_REPORT_UPTIME);
}

uint32_t card_frame_heartbeat(const uint8_t bytes[CARD_FRAME_BYTES])
{
    return frame_word_get(bytes, CARD_REPORT_HEARTBEAT);
}

card_frame_result_t card_frame_decode_report(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t slot,
                                             card_report_t *report)
{
    const bool has_words = has_bits(bytes, CARD_REPORT_WAVES, CARD_REPORT_WAVES + WAVE_WORDS);
    const uint32_t waves = has_words ? four_words(bytes, CARD_REPORT_WAVES) : 0U;
    const bool is_quiet = !has_words && !has_bits(bytes, CARD_REPORT_APPLIED, CARD_REPORT_TRIPS);
    const frame_view_t view = {TYPE_REPORT, has_report_reserved_bits(bytes), is_quiet,
                               report_sum(bytes) + waves};
    const card_frame_result_t result = check_frame(bytes, slot, &view);
    const uint32_t identity = frame_word_get(bytes, CARD_REPORT_IDENTITY);
    card_drive_t applied;
    const card_frame_result_t applied_result = read_applied(bytes, has_words, &applied);

    if (result != CARD_FRAME_OK) {
        return result;
    }
    if (applied_result != CARD_FRAME_OK) {
        return applied_result;
    }
    report->slot = slot;
    report->accepted_sequence = frame_word_get(bytes, CARD_REPORT_ACCEPTED);
    report->heartbeat = frame_word_get(bytes, CARD_REPORT_HEARTBEAT);
    report->time_us = frame_word_get(bytes, CARD_REPORT_TIME);
    report->card_type = identity >> 24U;
    report->firmware = identity & LARGEST_24_BIT;
    report->system_state = frame_word_get(bytes, CARD_REPORT_SYSTEM);
    report->status = frame_word_get(bytes, CARD_REPORT_STATUS);
    report->applied = applied;
    read_counts(bytes, report);
    read_health(bytes, report);
    return CARD_FRAME_OK;
}

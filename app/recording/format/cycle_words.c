/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/format/cycle_words.h"

#include "base/crc.h"

#include <string.h>

/* The first word of a frame. */
#define FRAME_AS_IT_IS 0U
#define FRAME_OF_FIELDS 1U

#define CHECK(name, condition) typedef char name[(condition) ? 1 : -1]
CHECK(report_fits, sizeof(card_report_t) <= CARD_FRAME_BYTES);
CHECK(command_fits, sizeof(card_command_t) <= CARD_FRAME_BYTES);
CHECK(snapshot_is_of_words, (sizeof(snapshot_t) % sizeof(uint32_t)) == 0U);
CHECK(board_is_of_words, sizeof(cycle_board_t) == (7U * sizeof(uint32_t)) + CARD_SLOT_COUNT + 2U);
CHECK(inputs_have_no_padding,
      sizeof(controller_inputs_t) ==
          (offsetof(controller_inputs_t, frames) + (CARD_SLOT_COUNT * CARD_FRAME_BYTES)));
CHECK(outputs_have_no_padding,
      sizeof(controller_outputs_t) == (offsetof(controller_outputs_t, snapshot) +
                                       sizeof(snapshot_t) + (CARD_SLOT_COUNT * CARD_FRAME_BYTES)));

static void take_fields(uint32_t words[CYCLE_WORDS_FRAME], const void *fields, size_t size)
{
    words[0] = FRAME_OF_FIELDS;
    (void)memcpy(&words[1], fields, size);
    (void)memset((uint8_t *)&words[1] + size, 0, CARD_FRAME_BYTES - size);
}

static void take_bytes(uint32_t words[CYCLE_WORDS_FRAME], const uint8_t bytes[CARD_FRAME_BYTES])
{
    words[0] = FRAME_AS_IT_IS;
    (void)memcpy(&words[1], bytes, CARD_FRAME_BYTES);
}

static void take_report(uint32_t words[CYCLE_WORDS_FRAME], const uint8_t bytes[CARD_FRAME_BYTES],
                        uint32_t slot)
{
    card_report_t report;
    uint8_t again[CARD_FRAME_BYTES];

    if (card_frame_decode_report(bytes, slot, &report) == CARD_FRAME_OK) {
        card_frame_encode_report(&report, again);
        if (memcmp(again, bytes, sizeof again) == 0) {
            take_fields(words, &report, sizeof report);
            return;
        }
    }
    take_bytes(words, bytes);
}

static void take_command(uint32_t words[CYCLE_WORDS_FRAME], const uint8_t bytes[CARD_FRAME_BYTES],
                         uint32_t slot)
{
    card_command_t command;
    uint8_t again[CARD_FRAME_BYTES];

    if (card_frame_decode_command(bytes, slot, &command) == CARD_FRAME_OK) {
        card_frame_encode_command(&command, again);
        if (memcmp(again, bytes, sizeof again) == 0) {
            take_fields(words, &command, sizeof command);
            return;
        }
    }
    take_bytes(words, bytes);
}

void cycle_words_of_kept(const recorded_cycle_t *cycle, uint32_t words[CYCLE_WORDS_KEPT])
{
    uint32_t *const frames = &words[CYCLE_WORDS_LEVELS];
    uint32_t *const said = &frames[CYCLE_WORDS_FRAMES];

    (void)memcpy(words, &cycle->inputs, CYCLE_WORDS_LEVELS * sizeof(uint32_t));
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        take_report(&frames[slot * CYCLE_WORDS_FRAME], cycle->inputs.frames[slot], slot);
    }
    (void)memcpy(said, &cycle->outputs, CYCLE_WORDS_SAID * sizeof(uint32_t));
    (void)memcpy(&said[CYCLE_WORDS_SAID], &cycle->board, sizeof cycle->board);
}

void cycle_words_of_checked(const controller_outputs_t *outputs,
                            uint32_t words[CYCLE_WORDS_CHECKED])
{
    (void)memcpy(words, &outputs->snapshot, sizeof outputs->snapshot);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        take_command(&words[CYCLE_WORDS_SNAPSHOT + (slot * CYCLE_WORDS_FRAME)],
                     outputs->frames[slot], slot);
    }
}

static void give_report(const uint32_t words[CYCLE_WORDS_FRAME], uint8_t bytes[CARD_FRAME_BYTES],
                        uint32_t slot)
{
    card_report_t report;

    if (words[0] != FRAME_OF_FIELDS) {
        (void)memcpy(bytes, &words[1], CARD_FRAME_BYTES);
        return;
    }
    (void)memcpy(&report, &words[1], sizeof report);
    report.slot = slot;
    card_frame_encode_report(&report, bytes);
}

static void give_command(const uint32_t words[CYCLE_WORDS_FRAME], uint8_t bytes[CARD_FRAME_BYTES],
                         uint32_t slot)
{
    card_command_t command;

    if (words[0] != FRAME_OF_FIELDS) {
        (void)memcpy(bytes, &words[1], CARD_FRAME_BYTES);
        return;
    }
    (void)memcpy(&command, &words[1], sizeof command);
    command.slot = slot;
    card_frame_encode_command(&command, bytes);
}

void cycle_words_to_kept(const uint32_t words[CYCLE_WORDS_KEPT], recorded_cycle_t *cycle)
{
    const uint32_t *const frames = &words[CYCLE_WORDS_LEVELS];
    const uint32_t *const said = &frames[CYCLE_WORDS_FRAMES];

    (void)memcpy(&cycle->inputs, words, CYCLE_WORDS_LEVELS * sizeof(uint32_t));
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        give_report(&frames[slot * CYCLE_WORDS_FRAME], cycle->inputs.frames[slot], slot);
    }
    (void)memcpy(&cycle->outputs, said, CYCLE_WORDS_SAID * sizeof(uint32_t));
    (void)memcpy(&cycle->board, &said[CYCLE_WORDS_SAID], sizeof cycle->board);
}

void cycle_words_to_checked(const uint32_t words[CYCLE_WORDS_CHECKED],
                            controller_outputs_t *outputs)
{
    (void)memcpy(&outputs->snapshot, words, sizeof outputs->snapshot);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        give_command(&words[CYCLE_WORDS_SNAPSHOT + (slot * CYCLE_WORDS_FRAME)],
                     outputs->frames[slot], slot);
    }
}

/* No two fields are alike and none is 0, so that none can take the place of another unseen. */
static const card_command_t any_command = {
    .slot = 3U,
    .sequence = 0x11121314U,
    .time_us = 0x21222324U,
    .system_state = 0x31323334U,
    .control = 0x41424344U,
    .drive = {CARD_DRIVE_HIGH_FREQUENCY, 1U, 0x41525354U, 0x55U},
    .watchdog_us = 0x61626364U,
    .overspeed_ticks_per_s = 0x71727374U,
    .guard_minimum_ticks = -0x01020304,
    .guard_maximum_ticks = 0x05060708,
    .axis_id = 0x090A0B0CU};
static const card_report_t any_report = {
    .slot = 4U,
    .accepted_sequence = 0x11121314U,
    .heartbeat = 0x21222324U,
    .time_us = 0x31323334U,
    .card_type = 0x41U,
    .firmware = 0x424344U,
    .system_state = 0x51525354U,
    .status = 0x61626364U,
    .limits_raw = 0x65U,
    .limits = 0x66U,
    .encoder_count = -0x01020304,
    .last_edge_us = 0x71727374U,
    .fourth_edge_us = 0x75767778U,
    .edges = 0x1516U,
    .illegal_edges = 0x1718U,
    .driver_temperature_dc = -0x2526,
    .motor_temperature_dc = 0x2728,
    .supply_mv = 0x3536U,
    .current_ma = 0x3738U,
    .adc_words = {0x2A2B2C2DU, 0x3A3B3C3DU},
    .applied = {CARD_DRIVE_HIGH_FREQUENCY, 1U, 0x45464748U, 0x49U},
    .rx_crc_errors = 0x05060708U,
    .sequence_gaps = 0x090A0B0CU,
    .watchdog_trips = 0x0D0E0F10U,
    .uptime_s = 0x191A1B1CU};

uint32_t cycle_words_frame_layout(void)
{
    uint8_t frames[2U * CARD_FRAME_BYTES];

    card_frame_encode_command(&any_command, frames);
    card_frame_encode_report(&any_report, &frames[CARD_FRAME_BYTES]);
    return crc32c(frames, sizeof frames);
}

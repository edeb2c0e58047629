/* SPDX-License-Identifier: Apache-2.0 */
/** @file The cards of the simulated box as ones that speak aim32: their words are taken apart and
 * put together here by the public description, not by the codec under test. */
#ifndef BORESIGHT_AIM32_BOX_H
#define BORESIGHT_AIM32_BOX_H

#include "card/card_frame.h"
#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "robot/robot_cards.h"
#include "sim/box.h"

#include <string.h>

static inline uint32_t aim32_word(const uint8_t *bytes, uint32_t index)
{
    const uint8_t *const at = &bytes[index * 4U];
    return ((uint32_t)at[0] << 24U) | ((uint32_t)at[1] << 16U) | ((uint32_t)at[2] << 8U) | at[3];
}

static inline card_drive_t aim32_drive(const uint8_t *bytes, uint32_t card_type)
{
    const uint32_t wave = aim32_word(bytes, 3U);
    card_drive_t drive = {0};
    if (wave != 0U) {
        drive.mode = card_drive_mode_of(card_type);
        drive.direction = 1U - (wave >> 31U);
        drive.duty = wave & 0x3FFFFFFFU;
    }
    if ((wave != 0U) && (drive.mode == (uint32_t)CARD_DRIVE_HIGH_FREQUENCY)) {
        drive.direction = aim32_word(bytes, 4U) >> 24U;
        drive.duty = wave;
        drive.amplitude = aim32_word(bytes, 2U) & 0xFFU;
    }
    return drive;
}

static inline void aim32_answer(const card_report_t *report, uint8_t *bytes)
{
    const bool is_at_switch = report->limits != 0U;
    uint32_t words[32] = {[0] = 0xFEFEFE01U,
                          [2] = is_at_switch ? 0U : 0x00080000U,
                          [3] = (uint32_t)report->encoder_count,
                          [7] = report->adc_words[0],
                          [8] = report->adc_words[1]};
    uint32_t sum = 0U;
    (void)memset(bytes, 0, CARD_FRAME_BYTES);
    for (uint32_t i = 0U; i < 32U; i++) {
        words[31] = 0xFFFFFFFFU - sum;
        sum += words[i];
        for (uint32_t k = 0U; k < 4U; k++) {
            bytes[(i * 4U) + k] = (uint8_t)(words[i] >> (24U - (8U * k)));
        }
    }
}

/** As box_exchange(). */
static inline uint32_t aim32_box_exchange(box_t *box, const controller_outputs_t *outputs,
                                          uint32_t sequence,
                                          uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    uint8_t own[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const uint8_t *const reported = outputs->frames[slot];
        const bool is_on = aim32_word(reported, 14U) != 0U;
        const card_command_t command = {
            .slot = slot,
            .sequence = sequence,
            .control = is_on ? CARD_CONTROL_AMPLIFIER : CARD_CONTROL_CLEAR_FAULT,
            .drive = aim32_drive(reported, robot_cards_type(box->robot, slot)),
            .watchdog_us = LIMIT_CARD_WATCHDOG_US,
            .overspeed_ticks_per_s = INT32_MAX,
            .guard_minimum_ticks = INT32_MIN,
            .guard_maximum_ticks = INT32_MAX};
        card_frame_encode_command(&command, own[slot]);
    }
    const uint32_t answered = box_exchange(box, outputs->frames_to_send,
                                           (const uint8_t(*)[CARD_FRAME_BYTES])own, received);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        card_report_t report = {0};
        /* A damaged one stays as it is, which is as damaged in the other dialect. */
        if ((((answered >> slot) & 1U) != 0U) &&
            (card_frame_decode_report(received[slot], slot, &report) == CARD_FRAME_OK)) {
            aim32_answer(&report, received[slot]);
        }
    }
    return answered;
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The simulated control box in a test: exchanges, drives, and orders by name.
 */
#ifndef BORESIGHT_BOX_WORLD_H
#define BORESIGHT_BOX_WORLD_H

#include "unity.h"
#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "sim/box.h"
#include "sim/model/sim_card.h"

#include <stdio.h>
#include <string.h>

#define ALL_SLOTS 0x3FFU
#define USED_SLOTS 0x0FEU /* 1..7 */

static box_t box;
static card_command_t commands[CARD_SLOT_COUNT];
static uint8_t sent[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static char reply[BOX_REPLY_SIZE];
static uint32_t exchange(uint32_t send);

/* Frames that the cards want to receive first. */
static void begin_sequence(void)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        commands[slot] = (card_command_t){.slot = slot, .control = CARD_CONTROL_CLEAR_FAULT};
    }
    (void)exchange(ALL_SLOTS);
}

static void start(uint32_t seed)
{
    box_init(&box, &robot_neuro, seed);
    begin_sequence();
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        commands[slot] = (card_command_t){.slot = slot,
                                          .sequence = 1U,
                                          .control = CARD_CONTROL_AMPLIFIER,
                                          .watchdog_us = LIMIT_CARD_WATCHDOG_US};
    }
}

static void begin_box(void)
{
    start(1U);
}

static uint32_t exchange(uint32_t send)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        commands[slot].sequence++;
        card_frame_encode_command(&commands[slot], sent[slot]);
    }
    (void)memset(received, 0, sizeof received);
    return box_exchange(&box, send, (const uint8_t(*)[CARD_FRAME_BYTES])sent, received);
}

static void cycles(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        (void)exchange(ALL_SLOTS);
        box_advance(&box, 1000U);
    }
}

static card_report_t report_of(uint32_t axis)
{
    const uint32_t slot = robot_neuro.axes[axis].slot;
    card_report_t report;

    (void)exchange(ALL_SLOTS);
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(received[slot], slot, &report));
    return report;
}

static void drive(uint32_t axis, bool is_upwards)
{
    const axis_config_t *config = &robot_neuro.axes[axis];
    const bool is_pwm = config->card_type == (uint8_t)CARD_TYPE_PWM;

    commands[config->slot].drive =
        (card_drive_t){.mode = is_pwm ? CARD_DRIVE_PWM : CARD_DRIVE_NON_PWM,
                       .direction = (is_upwards != (config->is_motor_inverted != 0U)) ? 1U : 0U,
                       .duty = is_pwm ? config->maximum_duty : 0U};
}

static int position_of(uint32_t axis)
{
    double positions[ROBOT_AXIS_MAX];

    box_true_positions(&box, positions);
    return (int)positions[axis];
}

static void order(const char *line)
{
    TEST_ASSERT_TRUE_MESSAGE(box_command(&box, line, reply, sizeof reply), reply);
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the frames and the conversation that a card's vendor is given are what the codec
 * reads and writes and what the reference card does.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "unit/support/card_vectors.h"
#include "limits/requirement_limits.h"
#include "sim/model/sim_card.h"
#include "sim/model/sim_encoder.h"
#include "sim/model/sim_motor.h"

#include <string.h>

#define SLOT 3U
#define VECTORS (sizeof card_vectors / sizeof card_vectors[0])
#define TURNS (sizeof card_conversation / sizeof card_conversation[0])

static sim_card_t card;
static sim_encoder_t encoder;
static uint8_t frame[CARD_FRAME_BYTES];

void setUp(void)
{
    axis_config_t axis;

    (void)memset(&axis, 0, sizeof axis);
    axis.slot = SLOT;
    axis.card_type = CARD_TYPE_PWM;
    sim_encoder_init(&encoder, &axis, 0.5, 5000, 1U);
    sim_card_init(&card, &axis, &encoder, false, 0U);
}

void tearDown(void)
{
}

static void write_frame(const card_vector_t *vector)
{
    for (uint32_t i = 0U; i < CARD_FRAME_BYTES; i++) {
        frame[i] = (uint8_t)(vector->words[i / 4U] >> (24U - 8U * (i % 4U)));
    }
}

static card_frame_result_t read_frame(const card_vector_t *vector, uint8_t again[CARD_FRAME_BYTES])
{
    card_command_t command;
    card_report_t report;
    card_frame_result_t result = CARD_FRAME_OK;

    if (vector->is_command) {
        result = card_frame_decode_command(frame, SLOT, &command);
    } else {
        result = card_frame_decode_report(frame, SLOT, &report);
    }
    if ((result == CARD_FRAME_OK) && vector->is_command) {
        card_frame_encode_command(&command, again);
    } else if (result == CARD_FRAME_OK) {
        card_frame_encode_report(&report, again);
    } else {
        /* Nothing was read. */
    }
    return result;
}

void test_SWR_CARD_009_each_frame_is_read_or_refused_as_it_says(void)
{
    uint8_t again[CARD_FRAME_BYTES];

    for (uint32_t i = 0U; i < VECTORS; i++) {
        write_frame(&card_vectors[i]);
        TEST_ASSERT_EQUAL_INT_MESSAGE(card_vectors[i].result, read_frame(&card_vectors[i], again),
                                      card_vectors[i].name);
    }
}

void test_SWR_CARD_009_each_good_frame_is_what_the_encoder_writes(void)
{
    uint8_t again[CARD_FRAME_BYTES];

    for (uint32_t i = 0U; i < VECTORS; i++) {
        write_frame(&card_vectors[i]);
        if (read_frame(&card_vectors[i], again) == CARD_FRAME_OK) {
            TEST_ASSERT_EQUAL_HEX8_ARRAY_MESSAGE(frame, again, CARD_FRAME_BYTES,
                                                 card_vectors[i].name);
        }
    }
}

void test_SWR_CARD_009_every_refusal_that_a_frame_alone_can_have_is_shown(void)
{
    uint32_t shown = 0U;

    for (uint32_t i = 0U; i < VECTORS; i++) {
        shown |= (uint32_t)1U << (uint32_t)card_vectors[i].result;
    }
    TEST_ASSERT_EQUAL_HEX32(((uint32_t)1U << (uint32_t)CARD_FRAME_REPEATED) - 1U, shown);
}

static void pass(uint32_t us)
{
    for (uint32_t at = 0U; at < us; at += SIM_STEP_US) {
        sim_encoder_step(&encoder, 0.5, 0.5, card.time_us, false);
        sim_card_step(&card, &encoder, false, true);
    }
}

static card_report_t answer(const card_turn_t *turn)
{
    const uint32_t duty = (turn->mode != (uint32_t)CARD_DRIVE_OFF) ? 50000U : 0U;
    const card_command_t command = {.slot = SLOT,
                                    .sequence = turn->sequence,
                                    .control = turn->control,
                                    .drive = {.mode = turn->mode, .duty = duty},
                                    .watchdog_us = LIMIT_CARD_WATCHDOG_US};
    card_report_t report;

    card_frame_encode_command(&command, frame);
    sim_card_receive(&card, frame);
    pass(turn->wait_us);
    sim_card_report(&card, &encoder, frame);
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(frame, SLOT, &report));
    return report;
}

void test_SWR_CARD_009_the_reference_card_holds_the_conversation(void)
{
    for (uint32_t i = 0U; i < TURNS; i++) {
        const card_turn_t *const turn = &card_conversation[i];
        const card_report_t report = answer(turn);

        TEST_ASSERT_EQUAL_UINT32_MESSAGE(turn->accepted, report.accepted_sequence, turn->says);
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(turn->applied, report.applied.mode, turn->says);
        TEST_ASSERT_EQUAL_HEX32_MESSAGE(turn->faults, report.status & CARD_STATUS_FAULTS,
                                        turn->says);
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(turn->gaps, report.sequence_gaps, turn->says);
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(i + 1U, report.heartbeat, turn->says);
    }
}

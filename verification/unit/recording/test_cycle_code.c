/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: inputs and answers of the controller come back as they were, however wrong they
 * were; values that go on as expected cost nothing; no bytes break the reader.
 */
#include "unity.h"

#include "base/crc.h"
#include "card/card_frame.h"
#include "recording/format/cycle_code.h"
#include "recording/format/cycle_words.h"
#include "recording/format/proof.h"

#include <string.h>

#define SLOT 3U
#define SETTLED 4U /* Cycles until all that counts is expected. */

static cycle_code_t writing;
static cycle_code_t reading;
static prover_t prover;
static recorded_cycle_t cycle;
static recorded_cycle_t read_cycle;
static cycle_known_t known;
static uint8_t bytes[CYCLE_CODE_MAX];
static card_report_t report;
static card_command_t command;
static uint32_t noise;

static uint32_t next_noise(void)
{
    noise = (noise * 1664525U) + 1013904223U;
    return noise >> 8U;
}

void setUp(void)
{
    cycle_code_begin(&writing);
    cycle_code_begin(&reading);
    prover_begin(&prover);
    (void)memset(&cycle, 0, sizeof(cycle));
    report = (card_report_t){.slot = SLOT, .encoder_count = 500, .supply_mv = 24000U};
    command = (card_command_t){.slot = SLOT, .watchdog_us = 10000U};
    noise = 1U;
}

void tearDown(void)
{
}

/* Everything that counts goes on. */
static void go_on(uint32_t elapsed_us)
{
    cycle.inputs.elapsed_us = elapsed_us;
    report.heartbeat++;
    report.accepted_sequence++;
    report.time_us += elapsed_us;
    command.sequence++;
    command.time_us += elapsed_us;
    cycle.board.sampled_us += elapsed_us;
    cycle.board.started_us += elapsed_us;
    cycle.board.finished_us += elapsed_us;
    cycle.outputs.snapshot.cycle++;
    cycle.outputs.snapshot.time_us += elapsed_us;
    card_frame_encode_report(&report, cycle.inputs.frames[SLOT]);
    card_frame_encode_command(&command, cycle.outputs.frames[SLOT]);
}

/* Writes the cycle, reads it again and compares. @return its bytes */
static size_t code(bool is_whole)
{
    const size_t size = cycle_code_encode(&writing, &prover, is_whole, &cycle, bytes);

    TEST_ASSERT_LESS_OR_EQUAL_UINT32(CYCLE_CODE_MAX, size);
    TEST_ASSERT_EQUAL_UINT32(size, cycle_code_decode(&reading, bytes, size, &read_cycle, &known));
    TEST_ASSERT_EQUAL_MEMORY(&cycle.inputs, &read_cycle.inputs, sizeof(cycle.inputs));
    TEST_ASSERT_EQUAL_MEMORY(&cycle.outputs, &read_cycle.outputs,
                             is_whole ? sizeof(cycle.outputs)
                                      : offsetof(controller_outputs_t, snapshot));
    TEST_ASSERT_EQUAL_MEMORY(&cycle.board, &read_cycle.board, sizeof(cycle.board));
    TEST_ASSERT_EQUAL(is_whole, known.is_whole);
    return size;
}

static void settle(void)
{
    for (uint32_t i = 0U; i < SETTLED; i++) {
        go_on(1000U);
        (void)code(i == 0U);
    }
    go_on(1000U);
    TEST_ASSERT_EQUAL_UINT32(1U, code(false));
}

void test_SWR_REC_006_a_cycle_in_which_only_counters_go_on_is_one_byte(void)
{
    settle();
    for (uint32_t i = 0U; i < 20U; i++) {
        go_on(1000U);
        TEST_ASSERT_EQUAL_UINT32(1U, code(false));
        TEST_ASSERT_EQUAL_HEX8(CYCLE_QUIET, bytes[0]);
    }
}

/* Kind, way, difference, end, surprises. */
void test_SWR_REC_006_time_that_passes_otherwise_costs_five_bytes(void)
{
    settle();
    go_on(1011U);
    (void)code(false); /* Now it is seen what is a clock. */
    go_on(1000U);
    (void)code(false);
    go_on(1007U);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(5U, code(false));
    TEST_ASSERT_EQUAL_HEX32(0U, known.proof.surprises);
}

void test_SWR_REC_006_commands_answers_and_events_come_back_whole(void)
{
    settle();
    go_on(1000U);
    cycle.inputs.command_count = 1U;
    (void)memset(cycle.inputs.commands, 0xA5, sizeof(cycle.inputs.commands));
    cycle.outputs.answer_count = CONTROLLER_ANSWERS;
    cycle.outputs.event_count = CONTROLLER_EVENTS;
    (void)memset(cycle.outputs.answers, 0x5A, sizeof(cycle.outputs.answers));
    (void)memset(cycle.outputs.events, 0xFF, sizeof(cycle.outputs.events));
    TEST_ASSERT_GREATER_THAN_UINT32(1U, code(false));
    cycle.inputs.command_count = 0U;
    (void)memset(cycle.inputs.commands, 0, sizeof(cycle.inputs.commands));
    (void)memset(cycle.outputs.answers, 0, sizeof(cycle.outputs.answers));
    (void)memset(cycle.outputs.events, 0, sizeof(cycle.outputs.events));
    go_on(1000U);
    (void)code(false);
}

void test_SWR_REC_006_only_the_part_that_is_not_as_expected_is_hashed(void)
{
    settle();
    go_on(1000U);
    command.drive = (card_drive_t){(uint32_t)CARD_DRIVE_PWM, 1U, 77U, 0U};
    card_frame_encode_command(&command, cycle.outputs.frames[SLOT]);
    (void)code(false);
    TEST_ASSERT_EQUAL_HEX32(1UL << (PROOF_FRAMES + SLOT), known.proof.surprises);
    go_on(1000U);
    cycle.outputs.snapshot.axes[2].position_ticks = 7;
    (void)code(false);
    TEST_ASSERT_EQUAL_HEX32(1UL << PROOF_SNAPSHOT, known.proof.surprises);
}

void test_SWR_REC_006_a_whole_cycle_needs_none_before_it(void)
{
    settle();
    cycle_code_begin(&writing);
    cycle_code_begin(&reading);
    go_on(1000U);
    cycle.outputs.snapshot.robot_crc = 0xFFFFFFFFU;
    (void)code(true);
    cycle_code_begin(&reading);
    TEST_ASSERT_NOT_EQUAL(0U,
                          cycle_code_decode(&reading, bytes, sizeof(bytes), &read_cycle, &known));
    TEST_ASSERT_EQUAL_MEMORY(&cycle.outputs, &read_cycle.outputs, sizeof(cycle.outputs));
}

void test_SWR_REC_009_a_frame_with_any_bit_wrong_comes_back_as_it_was(void)
{
    settle();
    for (uint32_t bit = 0U; bit < (8U * CARD_FRAME_BYTES); bit++) {
        const uint8_t mask = (uint8_t)(1U << (bit % 8U));
        go_on(1000U);
        cycle.inputs.frames[SLOT][bit / 8U] ^= mask;
        cycle.outputs.frames[SLOT][bit / 8U] ^= mask;
        TEST_ASSERT_GREATER_THAN_UINT32(1U, code((bit % 16U) == 0U));
        TEST_ASSERT_BIT_HIGH(PROOF_FRAMES + SLOT,
                             known.is_whole ? UINT32_MAX : known.proof.surprises);
    }
}

/* The codec of the cards looks at no more than the lowest bits of these; its checksums are right.
 */
void test_SWR_REC_009_bits_that_no_field_has_come_back_although_the_checksums_are_right(void)
{
    const size_t limits = 9U * 4U; /* Its upper half says nothing. */
    const size_t sum = 62U * 4U;

    go_on(1000U);
    (void)code(true);
    go_on(1000U);
    cycle.inputs.frames[SLOT][limits] = 1U;
    cycle.inputs.frames[SLOT][sum] = (uint8_t)(cycle.inputs.frames[SLOT][sum] - 1U);
    const uint32_t crc = crc32c(cycle.inputs.frames[SLOT], CARD_FRAME_BYTES - 4U);
    for (size_t i = 0U; i < 4U; i++) {
        cycle.inputs.frames[SLOT][CARD_FRAME_BYTES - 4U + i] = (uint8_t)(crc >> (24U - (8U * i)));
    }
    TEST_ASSERT_EQUAL(CARD_FRAME_OK,
                      card_frame_decode_report(cycle.inputs.frames[SLOT], SLOT, &report));
    (void)code(false);
}

void test_SWR_REC_009_counters_that_jump_come_back_as_they_were(void)
{
    static const uint32_t jumps[] = {0U, 2U, 100U, 0x80000000U, UINT32_MAX};

    settle();
    for (uint32_t i = 0U; i < 5U; i++) {
        go_on(1000U);
        report.heartbeat += jumps[i] - 1U;
        report.time_us -= jumps[i];
        card_frame_encode_report(&report, cycle.inputs.frames[SLOT]);
        TEST_ASSERT_GREATER_THAN_UINT32(1U, code(false));
    }
}

void test_SWR_REC_009_a_frame_of_another_slot_and_none_at_all_come_back(void)
{
    settle();
    go_on(1000U);
    (void)memcpy(cycle.inputs.frames[SLOT + 1U], cycle.inputs.frames[SLOT], CARD_FRAME_BYTES);
    (void)memset(cycle.inputs.frames[SLOT], 0, CARD_FRAME_BYTES);
    (void)memset(cycle.outputs.frames[SLOT], 0, CARD_FRAME_BYTES);
    (void)code(false);
    (void)code(true);
}

void test_SWR_REC_009_noise_comes_back_as_it_was(void)
{
    for (uint32_t i = 0U; i < 50U; i++) {
        for (size_t at = 0U; at < sizeof(cycle.inputs); at++) {
            ((uint8_t *)&cycle.inputs)[at] = (uint8_t)next_noise();
        }
        for (size_t at = 0U; at < sizeof(cycle.outputs); at++) {
            ((uint8_t *)&cycle.outputs)[at] = (uint8_t)next_noise();
        }
        for (size_t at = 0U; at < sizeof(cycle.board); at++) {
            ((uint8_t *)&cycle.board)[at] = (uint8_t)next_noise();
        }
        (void)code((i % 3U) == 0U);
    }
}

void test_SWR_REC_018_what_the_board_said_comes_back_and_costs_nothing_while_it_stays(void)
{
    cycle.board = (cycle_board_t){.sampled_us = UINT32_MAX - 5000U,
                                  .started_us = UINT32_MAX - 6000U,
                                  .finished_us = UINT32_MAX - 5500U,
                                  .levels = 0x7CU,
                                  .valid = 0x7FU};
    settle();
    go_on(1000U);
    cycle.board.dropped = 0x04U;
    cycle.board.error = -5;
    cycle.board.results[CARD_SLOT_COUNT - 1U] = 5U;
    TEST_ASSERT_GREATER_THAN_UINT32(1U, code(false));
    go_on(1000U);
    TEST_ASSERT_EQUAL_UINT32(1U, code(false));
}

void test_SWR_REPLAY_007_a_cycle_cut_anywhere_is_none(void)
{
    settle();
    go_on(1000U);
    report.encoder_count++;
    command.drive = (card_drive_t){(uint32_t)CARD_DRIVE_NON_PWM, 1U, 0U, 0U};
    card_frame_encode_report(&report, cycle.inputs.frames[SLOT]);
    card_frame_encode_command(&command, cycle.outputs.frames[SLOT]);
    const size_t size = code(false);
    for (size_t cut = 0U; cut < size; cut++) {
        cycle_code_t again = reading;
        TEST_ASSERT_EQUAL_UINT32(0U, cycle_code_decode(&again, bytes, cut, &read_cycle, &known));
    }
}

void test_SWR_REPLAY_007_no_bytes_lead_outside_of_a_cycle(void)
{
    static uint8_t guarded[600];

    for (uint32_t i = 0U; i < 20000U; i++) {
        const size_t size = next_noise() % sizeof(guarded);
        uint8_t *const at = &guarded[sizeof(guarded) - size]; /* Its end is that of the object. */
        const uint32_t mask = ((i % 2U) == 0U) ? 0xFFU : 0x07U;
        for (size_t j = 0U; j < size; j++) {
            at[j] = (uint8_t)(next_noise() & mask);
        }
        if (size > 0U) {
            at[0] = (uint8_t)(i % 4U);
        }
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(
            size, cycle_code_decode(&reading, at, size, &read_cycle, &known));
    }
}

void test_SWR_REPLAY_007_a_number_of_too_many_bytes_and_a_place_too_far_are_none(void)
{
    static const uint8_t too_long[] = {CYCLE_CHANGES, 0x81U, 0x80U, 0x80U, 0x80U, 0x80U, 0x01U};
    static const uint8_t too_far[] = {CYCLE_CHANGES, 0xFFU, 0xFFU, 0x7FU, 0x01U, 0x00U, 0x00U};

    TEST_ASSERT_EQUAL_UINT32(
        0U, cycle_code_decode(&reading, too_long, sizeof(too_long), &read_cycle, &known));
    TEST_ASSERT_EQUAL_UINT32(
        0U, cycle_code_decode(&reading, too_far, sizeof(too_far), &read_cycle, &known));
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an input counts as safe only if the board read it, and it was so all the time
 * since the sample before; what a box does not have is not taken for something it says.
 */
#include "unity.h"

#include "control/board_inputs.h"
#include "interface/box_input.h"

#include <string.h>

static board_inputs_t board;
static controller_inputs_t inputs;
static cycle_board_t said;

void setUp(void)
{
    (void)memset(&board, 0, sizeof board);
    (void)memset(&inputs, 0xA5, sizeof inputs);
}

void tearDown(void)
{
}

static void take(uint32_t levels, uint32_t dropped, uint32_t valid)
{
    const bsp_inputs_t sampled = {.levels = levels, .dropped = dropped, .valid = valid};
    board_inputs_take(&board, &sampled, &inputs);
}

static void expect_cut(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.pedal_a);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.pedal_b);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.estop_open);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.scanner_active);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.confirm_pressed);
}

void test_SWR_BSP_001_each_level_has_its_meaning(void)
{
    take(BSP_IN_ALL, 0U, BSP_IN_ALL);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.pedal_a);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.pedal_b);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.estop_open);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.scanner_active);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.has_button);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.confirm_pressed);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.treatment_stopped);
    take(BSP_IN_PEDAL_B | BSP_IN_SCANNER_IDLE | BSP_IN_TREATMENT_MAY, 0U, BSP_IN_ALL);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.pedal_a);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.pedal_b);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.estop_open);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.scanner_active);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.confirm_pressed);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.treatment_stopped);
    TEST_ASSERT_EQUAL_HEX32(0xA5A5A5A5U, inputs.elapsed_us); /* Nothing else is touched. */
    TEST_ASSERT_EQUAL_HEX32(0xA5A5A5A5U, inputs.frames_received);
}

void test_SWR_BSP_001_what_was_low_in_between_is_low(void)
{
    take(BSP_IN_ALL, BSP_IN_ALL, BSP_IN_ALL);
    expect_cut();
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.treatment_stopped);
    take(BSP_IN_ALL, BSP_IN_ESTOP_CHAIN, BSP_IN_ALL);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.estop_open);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.pedal_a);
}

void test_SWR_BSP_001_what_was_not_read_is_as_with_a_cut_wire(void)
{
    take(BSP_IN_ALL, 0U, BSP_IN_ALL);
    take(BSP_IN_ALL, 0U, 0U);
    expect_cut();
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.has_button); /* It is there, and does not answer. */
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.treatment_stopped);
}

void test_SWR_EVENT_031_what_is_not_read_is_named(void)
{
    take(0U, 0U, BSP_IN_ALL);
    TEST_ASSERT_EQUAL_HEX32(0U, inputs.unread); /* All is low, and was read. */
    take(BSP_IN_ALL, 0U, BSP_IN_ALL & ~BSP_IN_PEDAL_B);
    TEST_ASSERT_EQUAL_HEX32(1U << BOX_INPUT_PEDAL, inputs.unread);
    take(BSP_IN_ALL, 0U, BSP_IN_ALL & ~BSP_IN_ESTOP_CHAIN);
    TEST_ASSERT_EQUAL_HEX32(1U << BOX_INPUT_ESTOP, inputs.unread);
    take(BSP_IN_ALL, 0U, BSP_IN_ALL & ~BSP_IN_SCANNER_IDLE);
    TEST_ASSERT_EQUAL_HEX32(1U << BOX_INPUT_SCANNER, inputs.unread);
    take(BSP_IN_ALL, 0U, BSP_IN_ALL & ~BSP_IN_TREATMENT_MAY);
    TEST_ASSERT_EQUAL_HEX32(1U << BOX_INPUT_GATE, inputs.unread);
    take(BSP_IN_ALL, 0U, 0U);
    TEST_ASSERT_EQUAL_HEX32((1U << BOX_INPUT_COUNT) - 1U, inputs.unread);
}

void test_SWR_EVENT_031_a_gate_that_is_not_there_is_not_missed_and_a_pedal_is(void)
{
    take(0U, 0U, 0U);
    TEST_ASSERT_EQUAL_HEX32((1U << BOX_INPUT_PEDAL) | (1U << BOX_INPUT_ESTOP) |
                                (1U << BOX_INPUT_SCANNER),
                            inputs.unread);
}

void test_SWR_BSP_001_a_box_without_button_or_gate_says_nothing_of_them(void)
{
    const uint32_t there = BSP_IN_PEDAL_A | BSP_IN_PEDAL_B | BSP_IN_ESTOP_CHAIN;
    take(there, 0U, there);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.has_button);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.confirm_pressed);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.treatment_stopped);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.scanner_active);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.estop_open);
}

void test_SWR_REC_018_what_the_board_said_is_noted_as_it_was(void)
{
    const bsp_inputs_t sampled = {.sampled_ns = UINT64_C(4294967296999),
                                  .levels = BSP_IN_ALL,
                                  .dropped = BSP_IN_ESTOP_CHAIN,
                                  .valid = BSP_IN_CONFIRM};
    const bsp_exchange_t exchanged = {.started_ns = UINT64_C(7000),
                                      .finished_ns = UINT64_C(417999),
                                      .results = {[2] = BSP_SLOT_OK, [9] = BSP_SLOT_BUS_ERROR},
                                      .error = -110};
    (void)memset(&said, 0xA5, sizeof said);
    board_inputs_note(&sampled, &exchanged, &said);
    TEST_ASSERT_EQUAL_UINT32(0U, said.sampled_us); /* It wraps. */
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ALL, said.levels);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ESTOP_CHAIN, said.dropped);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_CONFIRM, said.valid);
    TEST_ASSERT_EQUAL_UINT32(7U, said.started_us);
    TEST_ASSERT_EQUAL_UINT32(417U, said.finished_us);
    TEST_ASSERT_EQUAL_INT32(-110, said.error);
    TEST_ASSERT_EQUAL_UINT8(BSP_SLOT_OK, said.results[2]);
    TEST_ASSERT_EQUAL_UINT8(BSP_SLOT_BUS_ERROR, said.results[9]);
    TEST_ASSERT_EACH_EQUAL_HEX8(0U, said.reserved, sizeof said.reserved);
}

void test_SWR_CARD_015_what_became_of_a_frame_that_did_not_come_is_reported(void)
{
    const bsp_exchange_t exchanged = {.received = 4U,
                                      .results = {[1] = BSP_SLOT_NO_ANSWER,
                                                  [2] = BSP_SLOT_OK,
                                                  [3] = BSP_SLOT_LATE,
                                                  [4] = BSP_SLOT_NOT_IDLE,
                                                  [9] = BSP_SLOT_BUS_ERROR}};
    board_inputs_receive(&exchanged, &inputs);
    TEST_ASSERT_EQUAL_HEX32(4U, inputs.frames_received);
    TEST_ASSERT_EQUAL_HEX32(0x18U, inputs.frames_late);
    TEST_ASSERT_EQUAL_HEX32(0x200U, inputs.frames_failed);
}

void test_SWR_CTRL_014_each_report_has_the_time_of_its_sample(void)
{
    const bsp_exchange_t exchanged = {
        .received = 6U, .sampled_ns = {[1] = UINT64_C(5000999), [2] = UINT64_C(4294967297000)}};
    board_inputs_receive(&exchanged, &inputs);
    TEST_ASSERT_EQUAL_HEX32(6U, inputs.frames_received);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.samples.sampled_us[0]);
    TEST_ASSERT_EQUAL_UINT32(5000U, inputs.samples.sampled_us[1]);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.samples.sampled_us[2]); /* It wraps. */
}
